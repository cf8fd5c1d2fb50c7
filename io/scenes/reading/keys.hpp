// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"

#include <netloft/parameters.hpp>

#include <span>

namespace netloft::scenes {

/// Defaults of `[analysis]`: the solver, for an equilibrium and for the steps of a motion; the strategy; and
/// the strategy of a scene that names only a solver.
inline constexpr const char *kSolver = "newton", *kStrategy = "auto", *kStrategyOfNamedSolver = "direct";

/// The keys of `[analysis]`, except the tables of solvers and strategies.
struct AnalysisKeys {
  std::int64_t kind = 0;
  const char *strategy = nullptr, *solver = nullptr;
  double tolerance = 0;
  std::int64_t max_iterations = 0;
  double work = 0, max_seconds = 0;
  std::int64_t tangent = 0, swinging = 0;
};

/// The keys of `[water]`, except the current.
struct WaterKeys : SceneWater {
  double model_scale = 1;        // size of the gear divided by that of the model [1]
  double model_twine_scale = 0;  // [1]; 0: the model is scaled by Froude's rule
};

/// The keys of `water.waves`.
struct WaveKeys {
  std::int64_t spectrum = 0, components = 0, seed = 0, stretching = 0;
  double height = 0, period = 0;               // [m], [s]
  double direction = 0, phase = 0;             // [rad]
  double depth = 0, ramp = 0, peakedness = 0;  // [m], [s], [1]
};

/// The keys of `[tow]`.
struct TowKeys {
  double speed = 0;   // [m/s]
  double leeway = 0;  // [rad]
};

/// The value of the key `nodes` in `[gear]` that makes every knot of the netting a node.
inline constexpr const char* kKnots = "knots";

/// The keys of `[bed]`.
struct BedKeys {
  double depth = 0, slope_x = 0, slope_y = 0;  // [m]
  netloft_table relief{};                      // columns x, y, height
  netloft_table bottom{};                      // columns x, y, stiffness, friction, ploughing
};

/// The keys of `[gear]`, except the table `finer`.
struct GearKeys {
  const char *title = nullptr, *source = nullptr;
  std::int64_t extent = 0;  // 0: whole, 1: half
  std::int64_t nodes = 0;
  double size = 0;
};

/// The kind of parts that are contact elements. A scene has such parts only if it has the table
/// `[elements.contact]`.
inline constexpr const char* kContact = "contact";

/// A kind of parts of a net plan, such as ropes. The table `[elements.KIND]` of a scene selects their
/// elements. `key` is the table in the plan with the numbers of such a part; `type` is the default element
/// type.
struct GearElements {
  const char *kind, *key, *type, *doc;
  std::uint32_t stencil;  // shape of its elements: on a node, a bar or a triangle
};
std::span<const GearElements> gear_elements();

/// The keys of those tables of a scene that the program reads itself, described in the same form as the keys
/// of plugins. The reader, the checks, the command `describe` and the schema all use these lists.
std::span<const netloft_parameter> water_keys();
std::span<const netloft_parameter> wave_keys();
std::span<const netloft_parameter> tow_keys();
std::span<const netloft_parameter> bed_keys();
std::span<const netloft_parameter> analysis_keys();
std::span<const netloft_parameter> gear_keys();

}  // namespace netloft::scenes
