// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/start_shape.hpp"

#include <memory>
#include <optional>

namespace netloft::gears {

/// Copies only those data of a plan that its division into elements depends on: without materials, pieces,
/// positions, tensions, the ship, and places in files.
NetPlan geometry_of(const NetPlan& plan);

/// Checks whether all seams together can be sewn: no seam may join points of one edge to each other, or twist
/// the net. The plan must be free of errors.
void check_seams(const NetPlan& plan, formats::Diagnostics& diagnostics);

class Division;

/// The data on which the division of a gear into elements depends.
struct DivisionInput {
  NetPlan geometry;
  Extent extent = Extent::whole;
  Fineness fineness;
  std::shared_ptr<Division> like;  // a division with the topology to be used; nullptr: none
  bool operator==(const DivisionInput&) const;
};

/// A divided gear and its initial shapes. If the gear is divided like another gear, it uses the initial
/// shapes of that gear.
class Division {
 public:
  explicit Division(DivisionInput input);
  Division(const Division&) = delete;
  Division& operator=(const Division&) = delete;

  const GearMesh& mesh() const { return mesh_; }
  StartShapes& start_shapes() { return input_.like ? input_.like->start_shapes() : *shapes_; }

 private:
  DivisionInput input_;
  Gear gear_;  // refers to the input
  GearMesh mesh_;
  std::optional<StartShapes> shapes_;
};

/// Divides gears. Stores the last few divisions and reuses them for plans with the same geometry. Throws
/// CannotDivide, also for half a gear that could not be sewn to its mirror image. `like` must have the same
/// extent; see divide_alike() in gear_mesh.hpp.
class Divisions {
 public:
  std::shared_ptr<Division> of(const NetPlan& plan, Extent extent, const Fineness& fineness,
                               const std::shared_ptr<Division>& like = nullptr);

 private:
  Recent<DivisionInput, Division> recent_{6};
};

}  // namespace netloft::gears
