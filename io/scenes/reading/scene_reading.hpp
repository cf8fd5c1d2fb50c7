// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/draft.hpp"
#include "io/scenes/reading/element_choice.hpp"
#include "io/scenes/reading/gear_parts.hpp"
#include "io/scenes/reading/mesh_parts.hpp"

#include <optional>
#include <vector>

namespace netloft::scenes {

/// What those have in common who read one scene: its tables, and what has come of them so far.
struct SceneReading {
  /// `plan`: of a gear that stands in the scene; null without.
  SceneReading(const formats::Value& tables, const gears::NetPlan* net_plan, gears::Divisions& divisions,
               const std::filesystem::path& file, Registry& plugins, formats::Diagnostics& said,
               bool& is_refused)
      : root(tables, said),
        registry(plugins),
        diagnostics(said),
        refused(is_refused),
        elements(plugins, is_refused),
        draft(said),
        meshes(file.parent_path(), said),
        plan(net_plan) {
    draft.out.scene.name = file.stem().string();
    root.has("catalogue");  // read with the parts that are named
    if (plan) gear.emplace(*plan, root, elements, draft, divisions);
  }

  LoadedScene& out() { return draft.out; }
  /// Of every part of the scene, as far as there are any.
  std::vector<int> nodes_per_element() const {
    std::vector<int> counts;
    for (const auto* type : draft.types) counts.push_back(type->nodes());
    for (const auto* type : companions) counts.push_back(type->nodes());
    return counts;
  }

  formats::TableReader root;
  Registry& registry;
  formats::Diagnostics& diagnostics;
  bool& refused;
  ElementChoice elements;
  Draft draft;
  MeshParts meshes;
  const gears::NetPlan* plan;
  std::optional<GearParts> gear;
  std::vector<const ElementType*> companions;  // of parts that follow those of the draft
};

/// One step of reading a scene: has short names for what all of them work with.
class ReadingStep {
 protected:
  explicit ReadingStep(SceneReading& reading)
      : root_(reading.root),
        diagnostics_(reading.diagnostics),
        elements_(reading.elements),
        draft_(reading.draft),
        out_(reading.out()),
        plan_(reading.plan),
        gear_(reading.gear) {}

  formats::TableReader& root_;
  formats::Diagnostics& diagnostics_;
  const ElementChoice& elements_;
  Draft& draft_;
  LoadedScene& out_;  // of the draft
  const gears::NetPlan* plan_;
  std::optional<GearParts>& gear_;
};

}  // namespace netloft::scenes
