// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/statistics.hpp"

#include <functional>
#include <span>
#include <vector>

namespace netloft {

/// The accepted point of the scene with the smallest ratio of residual to load so far. If a solver does not
/// return and the run is stopped from outside, this point becomes the result.
struct KeptPoint {
  std::vector<double> u;           // displacements of the unknowns [m]; empty: no point yet
  double residual = 0, scale = 0;  // [N]
  void keep(std::span<const double> at, double at_residual, double at_scale) {
    if (!u.empty() && !(at_residual * scale < residual * at_scale)) return;
    u.assign(at.begin(), at.end());
    residual = at_residual;
    scale = at_scale;
  }
};

/// Receives a report of every accepted point while a solver works.
struct Observer {
  std::function<void(const IterationRecord&)> on_iteration = {};
  KeptPoint* kept = nullptr;  // nullptr: no point is stored
};

}  // namespace netloft
