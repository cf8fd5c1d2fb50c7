// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/case/case.hpp"
#include "tests/folders.hpp"
#include "tests/verification/solving.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace netloft::test {

/// A ball of mass m falls by d below its slack rope of length L and no weight to speak of, until the rope
/// catches it: with v² = 2 g d and k = EA/L, energy is kept until the rope is longest, so that its pull there
/// is
///   T = m g + √((m g)² + k m v²)                                                    (1)
/// which tends to √(k m) v for a snap that is large beside the weight.
struct Snap {
  double mass = 5, fall = 0.5, EA = 2e5, length = 1, gravity = 9.81;  // [kg], [m], [N], [m], [m/s²]

  double weight() const { return mass * gravity; }
  double peak() const {
    return weight() + std::sqrt(weight() * weight() + 2 * EA / length * weight() * fall);
  }

  /// Largest pull at outputs, a hundred in a quarter of the period of the taut rope [N].
  double found(const std::vector<std::string>& settings) const {
    const double caught = std::sqrt(2 * fall / gravity), swing = std::sqrt(mass * length / EA);
    std::vector<std::string> all = {"water.density=0",
                                    "parts.rope.cells=1",
                                    "parts.rope.sketch=[[0,0,0],[0,0,-0.5]]",
                                    "parts.rope.rope.EA=" + std::to_string(EA),
                                    "parts.rope.rope.density=1e-3",
                                    "parts.rope.rope.loss_factor=0",
                                    "analysis.dense=true",
                                    "analysis.tolerance=1e-8",
                                    "analysis.duration=" + std::to_string(caught + 4 * swing),
                                    "analysis.output_interval=" + std::to_string(swing / 64)};
    all.insert(all.end(), settings.begin(), settings.end());
    io::Case c({source_folder() + "/tests/bench/motions/snap.toml", all, 1}, shipped_plugins());
    if (c.open() != io::Case::State::ready) throw std::invalid_argument(c.diagnostics().render(false));
    double longest = 0;
    MarchWatch watch;
    const std::uint32_t ball = c.loaded().scene.parts[0].nodes.back();
    watch.on_output = [&](const Snapshot& s) {
      const auto at = c.assembler().node_position(ball, s.x);
      longest = std::max(longest, std::hypot(at[0], at[1], at[2]));
    };
    const MarchResult result = c.march(watch);
    if (result.status != MarchStatus::finished) throw std::runtime_error(result.reason);
    return EA * (longest / length - 1);
  }
};

}  // namespace netloft::test
