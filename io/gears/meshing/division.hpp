// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/start_shape.hpp"

namespace netloft::gears {

/// A plan without anything that its division into elements does not depend on: without materials, pieces,
/// positions, tensions, the ship, and places in files.
NetPlan geometry_of(const NetPlan& plan);

/// The input of a division.
struct DivisionInput {
  NetPlan geometry;
  Extent extent = Extent::whole;
  Fineness fineness;
  bool operator==(const DivisionInput&) const;
};

/// A divided gear, and the shapes to begin with.
class Division {
 public:
  explicit Division(DivisionInput input);
  Division(const Division&) = delete;
  Division& operator=(const Division&) = delete;

  const GearMesh& mesh() const { return mesh_; }
  StartShapes& start_shapes() { return shapes_; }

 private:
  DivisionInput input_;
  Gear gear_;  // refers to the input
  GearMesh mesh_;
  StartShapes shapes_;
};

/// Divides gears, and keeps the last few divisions for plans that differ in other things.
class Divisions {
 public:
  std::shared_ptr<Division> of(const NetPlan& plan, Extent extent, const Fineness& fineness);

 private:
  Recent<DivisionInput, Division> recent_{6};
};

}  // namespace netloft::gears
