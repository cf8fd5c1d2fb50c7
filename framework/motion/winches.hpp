// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"

#include <span>
#include <string>
#include <vector>

namespace netloft {

/// What a winch does at an output.
struct WinchMoment {
  std::string rope;
  double length = 0;   // of rope that is out, unstretched [m]
  double speed = 0;    // of the last step, paying out [m/s]
  double tension = 0;  // of one that holds a tension, mean of the last step at the block [N]
};

/// The winches of a scene that moves. In a step from t₀ that is h long, with the speed w at which a winch
/// pays out, all lengths of its rope are multiplied by
///   σ(t) = σ₀ + (t − t₀) w/L                                                                      (1)
/// One that follows speeds or lengths pays out in each step what its table says. Of one that holds a tension,
/// with T̄ the mean tension at the block in the step and T* what is wanted in its middle, D the dead band, B
/// the band and v the largest speed, w is the solution of
///   w = v clamp(sign(e) max(|e| − D, 0)/B, −1, 1),   e = T̄(w) − T*                                (2)
/// the curve of a drive that follows pressure: it stands while the tension is about right, and runs the
/// faster the more it is off. The drum has no mass. (2) has one solution where a rope that is paid out pulls
/// less. It is looked for by
///   T̄(w + s) = T̄(w) + S s                                                                         (3)
/// over the winches that hold a tension, S by differences once, then after C. G. Broyden (Math. Comput. 19,
/// 1965) from try to try and step to step; each try solves the step again. Steps end where a stage begins.
class Winches {
 public:
  enum class Verdict { settled, again, lost };

  /// `tolerance` is that of the forces of a step, over its loads.
  Winches(const Scene& scene, const Assembler& assembler, double tolerance);

  bool empty() const { return scene_.winches.empty(); }
  /// Times at which stages and their tables have corners.
  void add_corners(std::vector<double>& times) const;
  /// Lets the elements read the lengths of the last step.
  void restore();
  /// A step is tried, at first with the speeds of the last one.
  void begin(double t, double h);
  /// Whether one of them holds a tension in this step, so that tries have to be judged.
  bool hold_tensions() const { return !holding_.empty(); }
  /// What the blocks bear in the try that was made, by the mean forces `residual` over all dofs [N]. If it
  /// says `again`, the elements read other lengths and the step has to be solved with them.
  Verdict judge(std::span<const double> residual);
  /// The step that is settled was accepted.
  void accept();
  /// What the blocks bear before the first step [N].
  void note_rest(std::span<const double> residual);
  /// A sentence about the winch that has hauled in all of its rope; empty: none has.
  std::string obstacle() const;
  std::vector<WinchMoment> moments(double t) const;

  /// All that later steps follow from, and back. Empty: at the start, where factors are one.
  std::vector<double> state() const;
  void set_state(std::span<const double> state);
  /// The state at rest with these factors, one per winch.
  static std::vector<double> state_at_rest(std::span<const double> factors);

 private:
  struct Rope {
    std::span<double> table;            // t, σ at both ends of the step
    double before = 1, now = 1;         // σ at both ends of the last step
    double speed = 0, tension = 0;      // of the last step [m/s], [N]
    double w = 0, T = 0;                // of this try
    double wanted = 0;                  // T* [N]
    const WinchStage* stage = nullptr;  // of this try
  };
  const WinchStage& stage_at(std::size_t k, double t) const;
  std::vector<std::size_t> holding_at(double t) const;
  double given_speed(std::size_t k) const;
  std::vector<double> tensions_of(std::span<const double> residual) const;
  double speed_at(std::size_t k, double tension) const;
  double doubt(std::size_t k) const;
  bool is_settled() const;
  void take(std::span<const double> tensions);
  void improve_slopes(std::span<const double> tensions);
  Verdict measure_slopes(std::span<const double> tensions);
  void solve_all();
  double solve_one(std::size_t k, double others) const;
  double& slope(std::size_t k, std::size_t j) { return slopes_[k * ropes_.size() + j]; }
  double slope(std::size_t k, std::size_t j) const { return slopes_[k * ropes_.size() + j]; }
  void write();

  const Scene& scene_;
  const Assembler& assembler_;
  double tolerance_;
  std::vector<Rope> ropes_;
  std::vector<std::size_t> holding_;  // those that hold a tension in this try
  std::vector<double> slopes_;        // S, row by row, nothing of the others [N s/m]; empty: not known
  std::vector<double> measured_;      // the same while it is measured, column by column
  std::vector<double> last_w_;        // of the try before [m/s]
  double from_ = 0, until_ = 0;       // of the last step [s]
  double t_ = 0, h_ = 0;              // of this try [s]
  int tries_ = 0;
};

}  // namespace netloft
