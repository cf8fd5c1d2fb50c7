// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/motion/time_march.hpp"
#include "io/results/figures/fallen_boards.hpp"
#include "io/results/figures/result.hpp"

#include <optional>
#include <vector>

namespace netloft::results {

/// The findings of a MotionWatch so far. A resumed motion continues from them.
struct MotionFindings {
  // Time of the last output [s]; energy that the time scheme had removed until that output [J].
  double t = 0, numerical = 0;
  std::vector<double> v;  // velocities of the nodes at the last output, three each; empty before the
                          // first output
  std::optional<NumericalLoss> loss;  // nullopt until the second output, or if energies are unknown
  std::vector<FallenBoard> fallen;    // each board once, with the time at which it had fallen
};

/// Compares every output of a motion with the previous one. Finds the energy that the time scheme has removed
/// between the two outputs, and boards that have fallen or are pushed inward.
class MotionWatch {
 public:
  MotionWatch(const Scene& scene, const Assembler& assembler) : scene_(scene), assembler_(assembler) {}

  void note(const Snapshot& at, const std::vector<FallenBoard>& fallen);
  const MotionFindings& findings() const { return found_; }
  /// Continues a watch of an earlier run.
  void go_on_from(MotionFindings findings) { found_ = std::move(findings); }

 private:
  void note_loss(const Snapshot& at);
  void note_fallen(double t, const std::vector<FallenBoard>& fallen);
  std::uint32_t most_changed(const std::vector<double>& v) const;

  const Scene& scene_;
  const Assembler& assembler_;
  MotionFindings found_;
};

}  // namespace netloft::results
