// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/read_bodies.hpp"
#include "io/scenes/reading/scene_reading.hpp"

namespace netloft::scenes {

/// Reads parts on nodes of their own, bodies among them. Parts that stand on others are announced, and kept.
class PartReader : ReadingStep {
 public:
  explicit PartReader(SceneReading& reading) : ReadingStep(reading), meshes_(reading.meshes) {}

  void read_parts();
  /// Parts that make rigid bodies. Their elements are those of `type`; others may stand on them.
  void read_bodies();
  /// Those of a net plan, to starboard and to port.
  void read_bodies_of_plan();
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

  MeshParts& meshes_;
  std::vector<std::pair<std::string, formats::TableReader>> riders_;
};

/// The element type of a part; a part that --set has made by a slip of the pen has none.
std::string read_type_name(const Draft& draft, const std::string& name, formats::TableReader& table);

}  // namespace netloft::scenes
