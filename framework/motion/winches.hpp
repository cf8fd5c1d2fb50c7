// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"

#include <span>
#include <string>
#include <vector>

namespace netloft {

/// State of a winch at one output time of a motion.
struct WinchMoment {
  std::string rope;
  double length = 0;   // unstretched length of the rope paid out [m]
  double speed = 0;    // speed in the last step, positive when paying out [m/s]
  double tension = 0;  // mean tension at the block in the last step, if the winch holds a tension [N]
};

/// The winches of a moving scene. In a step of length h from t₀, a winch that pays out at the speed w
/// multiplies all lengths of its rope by
///   σ(t) = σ₀ + (t − t₀) w/L                                                                      (1)
/// with σ₀ the factor at t₀ and L the length of the rope at σ = 1. A winch that follows speeds or lengths
/// pays out by its table. The speed of a winch that holds a tension is the solution of
///   w = v clamp(sign(e) max(|e| − D, 0)/B, −1, 1),   e = T̄(w) − T*                                (2)
/// with T̄ the mean tension at the block in the step, T* the required tension in its middle, D the dead band,
/// B the band and v the largest speed. This is the curve of a pressure-controlled drive: it stops while the
/// tension is nearly right, and runs faster the larger the error. The drum has no mass. (2) has one solution
/// if paying out reduces the tension. The speeds of all winches that hold a tension are found together, with
///   T̄(w + s) = T̄(w) + S s                                                                         (3)
/// where S is a matrix, which is measured once by differences and then updated after C. G. Broyden (Math.
/// Comput. 19, 1965) from attempt to attempt and from step to step. Each attempt solves the step again. Steps
/// end when the control of a winch changes (WinchStage).
class Winches {
 public:
  enum class Verdict { settled, again, lost };

  /// `tolerance` is the tolerance of the forces of a step, relative to its loads.
  Winches(const Scene& scene, const Assembler& assembler, double tolerance);

  bool empty() const { return scene_.winches.empty(); }
  /// Adds the times at which stages begin and their tables have corners.
  void add_corners(std::vector<double>& times) const;
  /// Sets the rope lengths that elements read to the lengths of the last step.
  void restore();
  /// Begins an attempted step. In the first attempt, winches keep the speeds of the last step.
  void begin(double t, double h);
  /// Whether some winch holds a tension in this step, so that `judge` has to be called.
  bool hold_tensions() const { return !holding_.empty(); }
  /// Judges the attempt by the tensions at the blocks, from the mean forces `residual` over all dofs [N].
  /// After `again`, the rope lengths have changed and the step has to be solved again.
  Verdict judge(std::span<const double> residual);
  void accept();
  /// Stores the tensions at the blocks before the first step [N].
  void note_rest(std::span<const double> residual);
  /// A sentence about a winch that has hauled in all of its rope; empty if there is none.
  std::string obstacle() const;
  std::vector<WinchMoment> moments(double t) const;

  /// The state that later steps depend on. It is empty at the start, where all factors are one.
  std::vector<double> state() const;
  void set_state(std::span<const double> state);
  /// The state at rest with these factors σ on rope lengths, one per winch.
  static std::vector<double> state_at_rest(std::span<const double> factors);

 private:
  struct Rope {
    std::span<double> table;            // two rows (time t, length factor σ) for the two ends of the step
    double before = 1, now = 1;         // σ at both ends of the last step
    double speed = 0, tension = 0;      // speed and tension in the last step [m/s], [N]
    double w = 0, T = 0;                // speed and tension of this attempt
    double wanted = 0;                  // requested tension T* [N]
    const WinchStage* stage = nullptr;  // stage of its control in this attempt
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
  std::vector<std::size_t> holding_;  // winches that hold a tension in this attempt
  // S by rows, with zeros for winches that hold no tension [N s/m]; empty: unknown.
  std::vector<double> slopes_;
  std::vector<double> measured_;  // while S is measured: tensions of the first attempt, then columns of S
  std::vector<double> last_w_;    // speeds of the previous attempt [m/s]
  double from_ = 0, until_ = 0;   // begin and end of the last step [s]
  double t_ = 0, h_ = 0;          // begin and length of this attempt [s]
  int tries_ = 0;
};

}  // namespace netloft
