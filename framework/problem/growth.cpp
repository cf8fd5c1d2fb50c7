// SPDX-License-Identifier: BSD-3-Clause
#include "framework/problem/growth.hpp"

#include "framework/problem/arnoldi.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>

namespace netloft {

namespace {

// σ of (4): the least, the most, from one to the next; and by how much another is tried where it is an
// eigenvalue. Growth is seen from two decades off: slower than 1e-5/s, tenfold in three days, nothing is.
constexpr double kLeastSigma = 1e-3, kMostSigma = 1e9, kStep = 100, kAside = 1.3;
// Steps of Arnoldi's, and how many there may be if these do not tell.
constexpr int kSteps = 24, kMostSteps = 48;
// How far beyond the unit circle a Ritz value is looked at: with σ ten times off |s|, the band (6) ends at a
// fifth of what it is at its best, 0.002.
constexpr double kBeyond = 1e-3;
// Powers before growth is measured, and over which it is measured.
constexpr int kPowers = 40, kMeasured = 20;
// Growth that still falls by this from one measure to the next may be passing: so often it is measured again.
constexpr double kFalls = 1e-3;
constexpr int kMeasures = 16;

using Vector = Eigen::VectorXd;
using Complex = std::complex<double>;

/// A vector under powers of A, kept at length 1.
class Powers {
 public:
  Powers(Cayley& A) : A_(A), z_(A.start()) {}

  /// Growth per power, averaged over so many.
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
    grow(kPowers);
    double growth = grow(kMeasured);
    for (int measure = 1; growth > kGrows && measure < kMeasures; ++measure) {
      const double before = std::exchange(growth, grow(kMeasured));
      if (growth > (1 - kFalls) * before) return GrowthVerdict::grows;
    }
    return growth > kGrows ? GrowthVerdict::marginal : GrowthVerdict::none;
  }
  const Vector& vector() const { return z_; }

 private:
  Cayley& A_;
  Vector z_;
};

/// The largest entry of y has no imaginary part then.
void take_mode(const Eigen::VectorXcd& y, Growth& g) {
  Eigen::Index largest = 0;
  y.cwiseAbs2().maxCoeff(&largest);
  const Eigen::VectorXcd turned = y / y[largest];
  const double length = turned.real().norm();
  const Vector now = turned.real() / length, later = turned.imag() / length;
  g.mode.assign(now.begin(), now.end());
  if (g.frequency > 0) g.mode_later.assign(later.begin(), later.end());
}

Growth growth_of(const RitzPair& pair, const Cayley& A, double doubt) {
  const Complex s = A.rate(pair.theta);
  const Eigen::VectorXcd y = pair.vector.head(A.unknowns()).normalized();
  if (!(s.real() > 0)) return {.verdict = GrowthVerdict::marginal};  // powers saw it grow
  Growth g{.verdict = GrowthVerdict::grows};
  const double c = std::min(1.0, s.real() / std::abs(s));
  g.per_power = std::sqrt((1 + c) / (1 - c));  // (6)
  g.rate = s.real(), g.frequency = std::abs(s.imag());
  take_mode(y, g);
  const bool is_for_damping_to_tell = !A.is_damped() && g.swings();
  if (g.per_power <= kGrows || is_for_damping_to_tell || A.is_in_doubt(s, y, doubt))
    g.verdict = GrowthVerdict::marginal, g.per_power = std::min(g.per_power, kGrows);
  return g;
}

/// Where the largest Ritz value is not known.
Growth growth_by_powers(Cayley& A, Arnoldi& arnoldi, double doubt) {
  Powers powers(A);
  const GrowthVerdict verdict = powers.judge();
  if (verdict != GrowthVerdict::grows) return {.verdict = verdict};
  arnoldi.begin(powers.vector());
  arnoldi.extend(kSteps);
  return growth_of(arnoldi.outermost(kBeyond), A, doubt);
}

/// With the residual that A itself leaves: rounding keeps that of the recurrence, which is as small, from
/// holding.
RitzPair checked(Cayley& A, RitzPair pair) {
  const Vector real = pair.vector.real(), imaginary = pair.vector.imag();
  Eigen::VectorXcd rest = -pair.theta * pair.vector;
  rest.real() += A * real, rest.imag() += A * imaginary;
  const auto square = [&](const Vector& z) { return z.dot(A.weighed(z)); };
  const double ratio = (square(rest.real()) + square(rest.imag())) / (square(real) + square(imaginary));
  pair.residual = ratio >= 0 ? std::max(pair.residual, std::sqrt(ratio)) : RitzPair{}.residual;
  return pair;
}

/// For the σ that A has.
Growth growth_by(Cayley& A, Arnoldi& arnoldi, double doubt) {
  arnoldi.begin(A.start());
  for (const int steps : {kSteps, kMostSteps}) {
    arnoldi.extend(steps);
    const RitzPair pair = arnoldi.outermost(kBeyond);
    if (std::isnan(pair.beyond())) return {.verdict = GrowthVerdict::unknown};
    if (pair.beyond() <= kBeyond) return {};
    if (pair.is_known() && checked(A, pair).is_known()) return growth_of(pair, A, doubt);
  }
  return growth_by_powers(A, arnoldi, doubt);
}

/// The greatest σ: so that none is ten times slower than the fastest that an unknown makes by itself.
double largest_sigma(double fastest) {
  double sigma = kLeastSigma;
  while (sigma * std::sqrt(kStep) < fastest && sigma < kMostSigma) sigma *= kStep;
  return sigma;
}

}  // namespace

Growth find_growth(const SparsePattern& pattern, const LinearMotion& motion, const MakeFactorisation& make,
                   double doubt) {
  Growth most;
  Statistics cost;
  if (is_stable_by_energy(pattern, motion, make, cost)) return {.cost = cost};
  const auto factorisation = make(pattern.symmetric ? MatrixClass::symmetric : MatrixClass::unsymmetric);
  factorisation->analyse(pattern);
  Cayley A(pattern, motion, *factorisation, cost);
  Arnoldi arnoldi(A);
  const auto is_decided = [&] {
    return most.verdict == GrowthVerdict::unknown || (most.grows() && !most.swings());
  };
  // What swings does not hide what diverges more slowly.
  for (double sigma = largest_sigma(fastest_rate(pattern, motion)); sigma > kLeastSigma / 2 && !is_decided();
       sigma /= kStep) {
    Growth growth{.verdict = GrowthVerdict::unknown};
    if (A.set(sigma) || A.set(kAside * sigma)) growth = growth_by(A, arnoldi, doubt);
    const bool diverges = growth.grows() && !growth.swings();
    if (growth.verdict > most.verdict || diverges) most = std::move(growth);
  }
  most.cost = cost;
  return most;
}

Growth find_growth(Assembler& assembler, std::span<const double> x, const MakeFactorisation& make,
                   std::span<const double> x_low, double doubt) {
  LinearMotion motion;
  if (!linearise(assembler, x, x_low, motion)) return {.verdict = GrowthVerdict::unknown};
  Growth growth = find_growth(assembler.pattern(), motion, make, doubt);
  growth.cost.matrices += kMatricesOfMotion;
  return growth;
}

}  // namespace netloft
