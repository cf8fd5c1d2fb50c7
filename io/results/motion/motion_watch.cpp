// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/motion/motion_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace netloft::results {

void MotionWatch::note(const Snapshot& at, const std::vector<FallenBoard>& fallen) {
  if (at.budget && at.judge) note_loss(at);
  note_fallen(at.t, fallen);
}

void MotionWatch::note_loss(const Snapshot& at) {
  const double numerical = at.budget->totals().numerical, lost = numerical - found_.numerical;
  const std::vector<double> v = assembler_.node_positions(at.v);
  if (!found_.v.empty()) {
    NumericalLoss& loss = found_.loss ? *found_.loss : found_.loss.emplace();
    loss.lost = -at.judge->made();
    loss.given = at.judge->given();
    loss.negligible = at.judge->negligible();
    if (lost > loss.worst) {
      loss.worst = lost;
      loss.from = found_.t;
      loss.until = at.t;
      loss.node = scene_.node_name(most_changed(v));
    }
  }
  found_.t = at.t;
  found_.numerical = numerical;
  found_.v = v;
}

void MotionWatch::note_fallen(double t, const std::vector<FallenBoard>& fallen) {
  for (const auto& [board, sentence] : fallen)
    if (std::ranges::find(found_.fallen, board, &FallenBoard::board) == found_.fallen.end())
      found_.fallen.push_back({board, fmt::format("at t = {:.6g} s {}", t, sentence)});
}

/// The node whose velocity changed most since the last output.
std::uint32_t MotionWatch::most_changed(const std::vector<double>& v) const {
  double most = -1;
  std::uint32_t which = 0;
  for (std::uint32_t node = 0; node < v.size() / 3; ++node) {
    const std::size_t i = 3 * std::size_t{node};
    const double change =
        std::hypot(v[i] - found_.v[i], v[i + 1] - found_.v[i + 1], v[i + 2] - found_.v[i + 2]);
    if (change > most) {
      most = change;
      which = node;
    }
  }
  return which;
}

}  // namespace netloft::results
