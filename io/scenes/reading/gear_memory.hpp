// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/division.hpp"
#include "io/scenes/reading/geometry.hpp"

namespace netloft::scenes {

/// All inputs of the parameters of a part of a net plan.
struct PartTable {
  const ElementType* type;
  std::string path;  // name of the part in messages
  formats::Value table;
  bool operator==(const PartTable&) const = default;
};

/// Parameters and laws that were read for a part, and the messages about them.
struct PartTableRead {
  Part part;
  std::vector<formats::Diagnostic> messages;
  bool is_sound = false;
};

/// Data of the panels of a gear that depend only on the division of the gear.
struct DividedPanels {
  std::vector<Geometry> geometries;         // geometries without positions and places in files
  std::map<std::string, SheetPlace> sheet;  // see GearInScene::sheet
};

/// Stored results of expensive steps of reading a scene with a net plan. Each is stored with its inputs, and
/// reused by later instances.
struct GearMemory {
  gears::Divisions divisions;
  /// Parameters of the parts of the plan, by the name of the part.
  std::map<std::string, gears::Recent<PartTable, const PartTableRead>> parts;
  gears::Recent<std::shared_ptr<gears::Division>, const DividedPanels> panels{2};
};

}  // namespace netloft::scenes
