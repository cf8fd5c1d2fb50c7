// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/element_choice.hpp"
#include "io/scenes/reading/gear_steps.hpp"
#include "io/scenes/reading/mesh_parts.hpp"
#include "io/scenes/reading/read_bodies.hpp"

namespace netloft::scenes {

/// Reads the parts with nodes of their own, including rigid bodies. Tables of riders (parts whose elements
/// are on the nodes or elements of other parts) are kept for later.
class PartReader {
 public:
  PartReader(formats::TableReader& root, const ElementChoice& elements, Draft& draft, MeshParts& meshes,
             const GearSteps& gear)
      : root_(root),
        diagnostics_(root.diagnostics()),
        elements_(elements),
        draft_(draft),
        meshes_(meshes),
        gear_(gear) {}

  /// Reads `[parts]`. `presence`: whether the table is required, as it is in a scene without a net plan.
  void read_parts(formats::Presence presence);
  /// Reads `[bodies]`. A rigid body is a part with one element of its `type`; elements of other parts may be
  /// on its points.
  void read_bodies();
  /// Reads a body of the net plan. For a body of a pair, `name` includes the side ("port-door"), and
  /// `name_in_plan` does not ("door"). Returns the index of the part of the body; after an error, this part
  /// is not sound.
  std::size_t read_body_of_plan(const std::string& name, const std::string& name_in_plan,
                                const BodyOfPlan* place);
  /// The names and tables of riders.
  std::vector<std::pair<std::string, formats::TableReader>>& riders() { return riders_; }

 private:
  enum class Home { parts, bodies };

  void check_part_name(const std::string& name, formats::TableReader& parts);
  void read_part(const std::string& name, formats::TableReader& table, Home home = Home::parts,
                 const BodyOfPlan* place = nullptr);
  const ElementType* find_type(Part& part, formats::TableReader& table, Home home) const;
  Geometry read_geometry(const ElementType& type, const std::string& name, formats::TableReader& table);
  void read_extra_data(const ElementType& type, Geometry& geometry, formats::TableReader& table);
  void check_thickness(const Part& part, const Geometry& geometry, formats::TableReader& table);

  formats::TableReader& root_;
  formats::Diagnostics& diagnostics_;
  const ElementChoice& elements_;
  Draft& draft_;
  MeshParts& meshes_;
  const GearSteps& gear_;
  std::vector<std::pair<std::string, formats::TableReader>> riders_;
};

/// Reads the element type of a part. If it is missing, the part may have been created by a misspelt `--set`;
/// the hint of the error therefore proposes a part with a similar name.
std::string read_type_name(const Draft& draft, const std::string& name, formats::TableReader& table);

}  // namespace netloft::scenes
