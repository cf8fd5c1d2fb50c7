// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"

#include <netloft/parameters.hpp>

#include <span>

namespace netloft::io {

/// `[analysis]`, but for the tables of solvers.
struct AnalysisKeys {
  std::int64_t kind = 0;
  const char* solver = nullptr;
  std::int64_t continuation = 0;
  double tolerance = 0;
  std::int64_t max_iterations = 0;
  double max_seconds = 0;
  std::int64_t tangent = 0;
};

/// The tables of a scene that belong to no plugin, in the same form as those of plugins: reading, checks,
/// `describe` and the schema all come from here.
std::span<const netloft_parameter> water_keys();
std::span<const netloft_parameter> analysis_keys();

}  // namespace netloft::io
