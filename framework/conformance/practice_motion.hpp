// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/ext/integrator.h>

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

namespace netloft::conformance {

/// Properties of a practice motion, which is a small motion with a known solution.
struct PracticeSwing {
  double damping = 0;      // fraction ζ of the critical damping
  double push = 0;         // acceleration f, proportional to time [m/s²]
  int fails = NETLOFT_OK;  // the status that every function of the host returns
  // Number of unknowns, with ω = 1, 1.5, 2 … rad/s, and u = 1, ½, ⅓ … m at the start.
  std::uint32_t unknowns = 3;
};

/// Masses on springs with a known motion, behind the same functions as a scene:
///   F = m (a + 2 ζ ω v + ω² u − f t) = 0,  m = 2 kg                                     (1)
/// for each unknown separately. With f = 0 or ζ = 0:
///   u = e^(−ζωt) (A cos ω't + B sin ω't) + f t/ω²,  ω' = ω √(1 − ζ²)                    (2)
/// Between the ends of a step, the host uses the cubic through positions and velocities. After a quarter of a
/// step
///   u = (27 uₙ + 5 uₙ₊₁)/32 + h (9 vₙ − 3 vₙ₊₁)/64                                         (3)
/// Springs are linear. The mean forces of a step (netloft_motion::solve_between) are therefore (1) at its
/// middle plus the force of the damping χ with the memory ν and the remembered rate r,
///   m ω² χ/2 (uₙ₊₁ − uₙ − h r),  r ← r + ν ((uₙ₊₁ − uₙ)/h − r) at the end of the step        (4)
/// Before a step, its outputs and the scratch memory are NaN. The checks thus notice a missing output, and an
/// integrator that relies on numbers of earlier steps in scratch memory.
class PracticeMotion {
 public:
  explicit PracticeMotion(const PracticeSwing& like);

  netloft_motion& interface() { return interface_; }
  /// Makes steps of these lengths in turn up to `end`. Returns OK or the status of the first step that
  /// failed.
  int run(const netloft_integrator& scheme, const void* parameters, const std::vector<double>& lengths,
          double end);
  /// Largest distance from the exact solution (2) at the current time, relative to the displacement at the
  /// start [m/m].
  double error() const;
  /// Energy divided by the energy at the start.
  double energy() const;
  bool is_finite() const;
  /// Whether no step changed the state from which it started.
  bool left_alone() const { return left_alone_; }

  int solves = 0;
  double t = 0;
  // Largest estimated error of an unknown in the last step, and the sum of these errors over all steps [m].
  double estimate = 0, estimated = 0;
  double error_between = 0;  // largest error within a step, of the cubic (3) [m]
  bool clears_scratch = true;
  std::vector<double> u, v, a;

 private:
  int step(const netloft_integrator& scheme, const void* parameters, double h);
  double omega(std::size_t i) const { return 1 + 0.5 * static_cast<double>(i); }
  double exact(std::size_t i, double time) const;
  void note_quarter(double h);
  double force(std::size_t i, double time, double u_i, double v_i, double a_i) const;
  void forget_scratch();

  int residual(double time, const double* u_at, const double* v_at, const double* a_at, double* r);
  int accelerate(double time, const double* u_at, const double* v_at, double* a_at);
  int solve(double time, const double* v0, double cv, const double* a0, double ca, double* u_at);
  int solve_between(const double* v0, double cv, const double* a0, double ca, double damping, double memory,
                    double* u_at);
  double* scratch(std::uint32_t index);

  template <auto Member, class Result, class... Args>
  static Result call(void* host, Args... args) {
    return (static_cast<PracticeMotion*>(host)->*Member)(args...);
  }

  PracticeSwing like_;
  std::size_t n_;
  netloft_motion interface_{};
  std::vector<double> start_, next_u_, next_v_, next_a_, error_;
  std::vector<double> rates_;  // remembered rates r of (4) [m/s]
  double memory_ = 0;          // memory ν of the current step
  std::deque<std::vector<double>> scratch_;
  bool left_alone_ = true;
  char message_[256] = "";
};

}  // namespace netloft::conformance
