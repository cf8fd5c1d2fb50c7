// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/element_choice.hpp"
#include "io/scenes/reading/gear_steps.hpp"
#include "io/scenes/reading/mesh_parts.hpp"
#include "io/scenes/reading/read_bodies.hpp"

namespace netloft::scenes {

/// Reads parts on nodes of their own, bodies among them. Parts that stand on others are announced, and kept.
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

  /// A scene without a net plan requires at least one part.
  void read_parts(formats::Presence presence);
  /// Parts that make rigid bodies. Their elements are those of `type`; others may stand on them.
  void read_bodies();
  /// Reads a body under its name in the plan. Returns its part; nothing if the body before it has an error.
  std::optional<std::size_t> read_body_of_plan(const std::string& name, const std::string& name_in_plan,
                                               const BodyOfPlan* place);
  /// Names and tables of the parts that stand on others.
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

/// The element type of a part; a part that --set has made by a slip of the pen has none.
std::string read_type_name(const Draft& draft, const std::string& name, formats::TableReader& table);

}  // namespace netloft::scenes
