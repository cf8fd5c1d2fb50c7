// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "framework/scene/scene.hpp"

#include <string>
#include <vector>

namespace netloft {

/// The decision whether a term of a family acts in this scene, and the reason.
struct TermPlan {
  std::string name, doc;
  std::uint32_t traits = 0;
  bool on = false;
  std::string reason;
  bool when_it_moves = false;  // does not act at rest, but acts if a small disturbance moves the gear
};

/// The law that the elements of a family use in one slot.
struct LawPlan {
  std::string slot;
  const LawType* type = nullptr;
  LawChoice choice;
};

/// The part of the unsymmetric tangent of nonconservative forces (drag) that is used: all, the symmetric
/// part, or none.
enum class TangentChoice { exact, symmetric, elastic };

/// The two kinds of analysis: equilibrium at rest, or motion in time.
enum class AnalysisKind { statics, dynamics };

/// An unknown that all elements of a part share.
struct GlobalPlan {
  std::uint32_t part = 0;  // index of the part in the scene
  std::string name, unit, doc;
};

/// All elements of one type with the same laws.
struct FamilyPlan {
  const ElementType* type = nullptr;
  std::vector<LawPlan> laws;         // law of each slot
  std::vector<std::uint32_t> parts;  // indices of parts in the scene
  std::size_t elements = 0;
  std::vector<TermPlan> terms;
  std::vector<GlobalPlan> globals = {};
  double viscosity_ratio = 1;              // ratio of viscosities, the same for all its parts
  std::optional<std::uint32_t> flow = {};  // index of the scene part that changes the water here, if any
};

/// Whether a flow changes the water for a term. It does for drag that depends only on the velocity of the
/// water relative to the element. The derivative of this drag with respect to the current is minus its
/// derivative with respect to the velocity.
inline bool sees_changed_water(std::uint32_t traits) {
  constexpr std::uint32_t kDragOnMoving = NETLOFT_IS_DRAG | NETLOFT_READS_CURRENT | NETLOFT_READS_VELOCITY;
  return (traits & kDragOnMoving) == kDragOnMoving && !(traits & NETLOFT_SYMMETRIC);
}

/// The families, terms and matrix properties that a scene needs. Nothing else is loaded, evaluated or
/// factorised.
struct ScenePlan {
  std::vector<FamilyPlan> families;
  std::vector<std::string> not_loaded;  // available plugins that are not used, if requested (unused_plugins)
  std::size_t nodes = 0, held_nodes = 0, bodies = 0, unknowns = 0;
  AnalysisKind kind = AnalysisKind::statics;
  TangentChoice tangent = TangentChoice::exact;
  bool symmetric = true, conservative = true;
  bool between = false;               // forces are means over time steps; their matrix is unsymmetric
  std::string unsymmetric_because;    // what makes the matrix unsymmetric: "priour/triangle drag"
  std::array<double, 3> ground = {};  // velocity at which the ground passes the gear [m/s]

  /// Whether some active term depends on the motion of the ground.
  bool reads_ground() const;
};

/// Decides which terms of which families are active in an analysis of the scene, and loads the plugins that
/// the scene names. Throws SceneError for errors in parts, PluginRefused for errors of plugins.
ScenePlan make_scene_plan(const Scene& scene, Registry& registry,
                          TangentChoice tangent = TangentChoice::exact,
                          AnalysisKind kind = AnalysisKind::statics);
/// Adapts the plan to a motion whose integrator uses mean forces over its steps.
void use_mean_forces(ScenePlan& plan, const std::string& integrator);

/// Plugins that are available but not used by any part of a plan; a printed plan lists them as not loaded.
std::vector<std::string> unused_plugins(const ScenePlan& plan, const Registry& registry);

/// Whether a part has a real parameter that is not zero.
bool sets(const Part& part, const ElementType& type, std::string_view parameter);

/// Names the traits: "conservative, symmetric, constant".
std::string describe_traits(std::uint32_t traits);

}  // namespace netloft
