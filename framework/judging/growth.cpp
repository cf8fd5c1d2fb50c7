// SPDX-License-Identifier: BSD-3-Clause
#include "framework/judging/growth.hpp"

#include "framework/judging/arnoldi.hpp"
#include "framework/judging/extent.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>

namespace netloft {

namespace {

// The last shift σ of (4) in growth.hpp is not above this one. If K + σC + σ²M is singular, σ is multiplied
// by kOtherSigma. Growth slower than 1e-4/s, which is tenfold in six hours, is not looked for.
constexpr double kLeastSigma = 1e-3, kOtherSigma = 1.3;
// Number of steps of the Arnoldi iteration, doubled once if the result is not clear. If the powers of A
// decide instead, the growth over kSteps powers is measured at most kSteps + 1 times.
constexpr int kSteps = 24;
// Distance from the unit circle beyond which Ritz values are examined. If growth is just above marginal, |μ|
// − 1 is ten times this distance for σ = |s|, and twice this distance if σ and |s| differ by the factor kOff.
// If the growth of powers of A falls by this fraction between two measurements, the growth may be transient.
constexpr double kDistanceFromCircle = (kMarginalGrowth - 1) / kOff;
// The ratio c = Re s/|s| for which (6) in growth.hpp gives |μ| = kMarginalGrowth.
constexpr double kLeastCosine =
    (kMarginalGrowth * kMarginalGrowth - 1) / (kMarginalGrowth * kMarginalGrowth + 1);

using Vector = Eigen::VectorXd;
using Complex = std::complex<double>;

/// A vector that is repeatedly multiplied by the operator A (cayley.hpp) and then scaled to length 1.
class Powers {
 public:
  Powers(Cayley& A, Vector z) : A_(A), z_(std::move(z)) {}

  /// Applies A `powers` times. Returns the average growth of the vector per application.
  double grow(int powers) {
    double logarithm = 0;
    for (int k = 0; k < powers; ++k) {
      z_ = A_ * z_;
      const double length = std::sqrt(z_.dot(A_.weighed(z_)));
      if (!std::isfinite(length)) return std::numeric_limits<double>::infinity();
      if (length == 0) return 0;
      logarithm += std::log(length);
      z_ /= length;
    }
    return std::exp(logarithm / powers);
  }

  GrowthVerdict judge() {
    double before = grow(kSteps), growth = grow(kSteps);
    for (int measure = 1; growth > kMarginalGrowth && measure < kSteps; ++measure) {
      before = std::exchange(growth, grow(kSteps));
      if (growth > (1 - kDistanceFromCircle) * before) return GrowthVerdict::grows;
    }
    return growth > kMarginalGrowth ? GrowthVerdict::marginal : GrowthVerdict::none;
  }
  const Vector& vector() const { return z_; }

 private:
  Cayley& A_;
  Vector z_;
};

/// Stores y as the mode, rotated such that its largest entry is real.
void take_mode(const Eigen::VectorXcd& y, Growth& g) {
  Eigen::Index largest = 0;
  y.cwiseAbs2().maxCoeff(&largest);
  const Eigen::VectorXcd turned = y / y[largest];
  const double length = turned.real().norm();
  const Vector now = turned.real() / length, later = turned.imag() / length;
  g.mode.assign(now.begin(), now.end());
  if (g.frequency > 0) g.mode_later.assign(later.begin(), later.end());
}

Growth growth_of(const RitzPair& pair, const Cayley& A) {
  const Complex s = A.rate(pair.theta);
  const Eigen::VectorXcd y = pair.vector.head(A.unknowns()).normalized();
  // The powers of A grew, but the motion that belongs to this eigenvalue decays.
  if (!(s.real() > 0)) return {.verdict = GrowthVerdict::marginal};
  Growth g{.verdict = GrowthVerdict::grows};
  const double c = std::min(1.0, s.real() / std::abs(s));
  g.per_power = std::sqrt((1 + c) / (1 - c));  // (6)
  g.rate = s.real();
  g.frequency = std::abs(s.imag());
  take_mode(y, g);
  const bool is_for_damping_to_tell = !A.is_damped() && g.swings();
  if (g.per_power <= kMarginalGrowth || is_for_damping_to_tell || A.is_in_doubt(s, y)) {
    g.verdict = GrowthVerdict::marginal;
    g.per_power = std::min(g.per_power, kMarginalGrowth);
  }
  return g;
}

/// Verdict by the growth of powers of A, used if the largest Ritz value is not accurate enough. Its vector z
/// is where they begin. If growth slows down from 24 powers to the next 24, it may be transient.
Growth growth_by_powers(Cayley& A, Arnoldi& arnoldi, Vector z) {
  Powers powers(A, std::move(z));
  const GrowthVerdict verdict = powers.judge();
  if (verdict != GrowthVerdict::grows) return {.verdict = verdict};
  arnoldi.begin(powers.vector());
  arnoldi.extend(kSteps);
  return growth_of(arnoldi.outermost(kDistanceFromCircle), A);
}

/// Replaces the residual of a Ritz pair by the residual computed with A itself if this is larger. (Rounding
/// errors can make the residual from the recurrence too small.)
RitzPair checked(Cayley& A, RitzPair pair) {
  const Vector real = pair.vector.real(), imaginary = pair.vector.imag();
  Eigen::VectorXcd rest = -pair.theta * pair.vector;
  rest.real() += A * real;
  rest.imag() += A * imaginary;
  const auto square = [&](const Vector& z) { return z.dot(A.weighed(z)); };
  const double ratio = (square(rest.real()) + square(rest.imag())) / (square(real) + square(imaginary));
  pair.residual = ratio >= 0 ? std::max(pair.residual, std::sqrt(ratio)) : RitzPair{}.residual;
  return pair;
}

/// The verdict on growth that A finds with its current shift σ.
Growth growth_by(Cayley& A, Arnoldi& arnoldi) {
  arnoldi.begin(A.start());
  RitzPair pair;
  for (const int steps : {kSteps, 2 * kSteps}) {
    arnoldi.extend(steps);
    pair = arnoldi.outermost(kDistanceFromCircle);
    if (std::isnan(pair.beyond())) return {.verdict = GrowthVerdict::unknown};
    if (pair.beyond() <= kDistanceFromCircle) return {};
    if (pair.is_known() && checked(A, pair).is_known()) return growth_of(pair, A);
  }
  return growth_by_powers(A, arnoldi, pair.vector.real());
}

}  // namespace

Growth find_growth(const SparsePattern& pattern, const LinearMotion& motion, Factors& factors) {
  if (is_stable_by_energy(pattern, motion, factors)) return {};
  Growth most;
  Cayley A(pattern, motion, factors);
  Arnoldi arnoldi(A);
  const auto is_decided = [&] {
    return most.verdict == GrowthVerdict::unknown || (most.grows() && !most.swings());
  };
  bool is_slowest = false;
  // After an oscillation, the loop continues: a divergence takes precedence, even if it is slower.
  for (double sigma = std::max(fastest_growth(pattern, motion, kLeastCosine) / kOff, kLeastSigma);
       !is_slowest && !is_decided(); sigma /= kOff * kOff) {
    Growth growth{.verdict = GrowthVerdict::unknown};
    if (A.set(sigma) || A.set(kOtherSigma * sigma)) growth = growth_by(A, arnoldi);
    is_slowest = sigma <= kLeastSigma || (growth.verdict == GrowthVerdict::none && !arnoldi.sees_slow());
    const bool diverges = growth.grows() && !growth.swings();
    if (growth.verdict > most.verdict || diverges) most = std::move(growth);
  }
  return most;
}

Growth find_growth(Assembler& assembler, const RestPlace& place, Factors& factors, LinearMotion motion) {
  if (!linearise(assembler, place, factors.statistics(), motion)) return {.verdict = GrowthVerdict::unknown};
  Growth growth = find_growth(assembler.pattern(), motion, factors);
  if (growth.grows()) find_extent(assembler, motion, factors, growth);
  return growth;
}

}  // namespace netloft
