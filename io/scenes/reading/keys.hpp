// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"

#include <netloft/parameters.hpp>

#include <span>

namespace netloft::scenes {

/// Defaults of `[analysis]`: the solver of stages and of the steps of a motion, the strategy, and the
/// strategy if only a solver is named.
inline constexpr const char *kSolver = "newton", *kStrategy = "auto", *kStrategyOfNamedSolver = "direct";

/// `[analysis]`, but for the tables of solvers and strategies.
struct AnalysisKeys {
  std::int64_t kind = 0;
  const char *strategy = nullptr, *solver = nullptr;
  double tolerance = 0;
  std::int64_t max_iterations = 0;
  double work = 0, max_seconds = 0;
  std::int64_t tangent = 0, swinging = 0;
};

/// `[water]`, but for the current.
struct WaterKeys : SceneWater {
  double model_scale = 1;        // [1]
  double model_twine_scale = 0;  // [1]; 0: Froude's rule
};

/// `water.waves`.
struct WaveKeys {
  std::int64_t spectrum = 0, components = 0, seed = 0, stretching = 0;
  double height = 0, period = 0;               // [m], [s]
  double direction = 0, phase = 0;             // [rad]
  double depth = 0, ramp = 0, peakedness = 0;  // [m], [s], [1]
};

/// `[tow]`.
struct TowKeys {
  double speed = 0;   // [m/s]
  double leeway = 0;  // [rad]
};

/// The word for every knot a node, in place of the number of nodes of `[gear]`.
inline constexpr const char* kKnots = "knots";

/// `[bed]`.
struct BedKeys {
  double depth = 0, slope_x = 0, slope_y = 0;  // [m]
  netloft_table relief{};                      // x, y, height
  netloft_table bottom{};                      // x, y, stiffness, friction, ploughing
};

/// `[gear]`, but for the table `finer`.
struct GearKeys {
  const char *title = nullptr, *source = nullptr;
  std::int64_t extent = 0;  // whole, half
  std::int64_t nodes = 0;
  double size = 0;
};

/// The kind of what touches the bed. It is there only where a scene has `[elements.contact]`.
inline constexpr const char* kContact = "contact";

/// The elements of a kind of parts of a net plan, `[elements.KIND]`: the key of a part that they take from
/// the plan, and the default type.
struct GearElements {
  const char *kind, *key, *type, *doc;
  std::uint32_t stencil;  // that they are divided into
};
std::span<const GearElements> gear_elements();

/// The tables of a scene that belong to no plugin, in the same form as those of plugins: reading, checks,
/// `describe` and the schema all come from here.
std::span<const netloft_parameter> water_keys();
std::span<const netloft_parameter> wave_keys();
std::span<const netloft_parameter> tow_keys();
std::span<const netloft_parameter> bed_keys();
std::span<const netloft_parameter> analysis_keys();
std::span<const netloft_parameter> gear_keys();

}  // namespace netloft::scenes
