// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/result.hpp"

#include <vector>

namespace netloft::results {

/// The most important numbers of a result, at most nine, in the order in which they are shown: height,
/// spreads, area and drag of a gear; the pull of the ship and of its rigging, the largest first; then the
/// [results] of the scene. A figure of the gear is left out if its error is as large as the figure itself.
std::vector<const NamedScalar*> key_figures(const Result& result);

}  // namespace netloft::results
