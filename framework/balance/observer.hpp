// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/statistics.hpp"

#include <functional>
#include <span>
#include <vector>

namespace netloft {

/// The accepted point of the scene itself that came closest to balance so far, for whoever has to end a
/// solver that does not come back.
struct KeptPoint {
  std::vector<double> u;           // displacements of the unknowns [m]; empty: there was none
  double residual = 0, scale = 0;  // [N]
  void keep(std::span<const double> at, double at_residual, double at_scale) {
    if (!u.empty() && !(at_residual * scale < residual * at_scale)) return;
    u.assign(at.begin(), at.end());
    residual = at_residual;
    scale = at_scale;
  }
};

/// Who gets a report of every accepted point, while a solver works.
struct Observer {
  std::function<void(const IterationRecord&)> on_iteration = {};
  KeptPoint* kept = nullptr;  // null: points are not kept
};

}  // namespace netloft
