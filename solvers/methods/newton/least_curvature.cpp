// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/methods/newton/least_curvature.hpp"

#include <netloft/vectors.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace netloft::newton {

namespace {

using Few = std::array<double, LeastCurvature::kSteps>;

// Lanczos's iteration ends when a longer basis increases the eigenvalue θ by less than this fraction.
constexpr double kFound = 0.01;

/// The upper left n × n block of a symmetric tridiagonal matrix T with the diagonal a and the off-diagonal b.
struct Tridiagonal {
  std::span<const double> a, b;
  std::size_t n() const { return a.size(); }

  /// Computes the pivots of θ − T. Returns whether all are positive, which means that θ exceeds the largest
  /// eigenvalue of T.
  bool find_pivots(double theta, Few& pivots) const {
    for (std::size_t i = 0; i < n(); ++i) {
      pivots[i] = theta - a[i] - (i > 0 ? b[i - 1] * b[i - 1] / pivots[i - 1] : 0);
      if (!(pivots[i] > 0)) return false;
    }
    return true;
  }

  /// Returns an upper bound of the largest eigenvalue, by bisection between the largest entry and
  /// Gershgorin's bound.
  double largest_eigenvalue() const {
    double low = *std::max_element(a.begin(), a.end()), high = low * (1 + 1e-12);
    for (std::size_t i = 0; i + 1 < n(); ++i) high += 2 * std::abs(b[i]);
    Few pivots{};
    for (int i = 0; i < 100 && high - low > 1e-14 * high; ++i) {
      const double middle = 0.5 * (low + high);
      (find_pivots(middle, pivots) ? high : low) = middle;
    }
    return high;
  }

  /// Returns the eigenvector of the eigenvalue θ, by inverse iteration just above θ.
  Few eigenvector(double theta) const {
    Few y{}, pivots{};
    std::fill_n(y.begin(), n(), 1.0);
    while (!find_pivots(theta, pivots)) theta *= 1 + 1e-14;
    for (int round = 0; round < 3; ++round) {
      for (std::size_t i = 1; i < n(); ++i) y[i] += b[i - 1] / pivots[i - 1] * y[i - 1];
      for (std::size_t i = n(); i-- > 0;) y[i] = (y[i] + (i + 1 < n() ? b[i] * y[i + 1] : 0)) / pivots[i];
      scale(1 / norm(y), y);
    }
    return y;
  }
};

}  // namespace

LeastCurvature::LeastCurvature(std::size_t size) : size_(size) {
  basis_.reserve(kSteps * size);
  images_.reserve(kSteps * size);
  w_.reserve(size);
}

double LeastCurvature::find(Problem& problem, double shift) {
  start(problem);
  double theta = std::numeric_limits<double>::quiet_NaN(), lambda = theta;
  std::size_t lengthened = 0;
  for (bool is_found = false; lengthened < length_ && !is_found; ++lengthened) {
    lengthen(problem);
    const double before = theta;
    theta = Tridiagonal{{a_.data(), lengthened + 1}, b_}.largest_eigenvalue();
    lambda = 1 / theta - shift;  // (C2)
    is_found = lambda < 0 && theta <= before * (1 + kFound);
  }
  if (lengthened == 0) return lambda;
  const Few y = Tridiagonal{{a_.data(), lengthened}, b_}.eigenvector(theta);
  combine({y.data(), lengthened});
  return lambda;
}

/// Computes the sum of y[i] times basis vector i.
void LeastCurvature::combine(std::span<const double> y) {
  std::fill(w_.begin(), w_.end(), 0.0);
  for (std::size_t i = 0; i < y.size(); ++i) axpy(y[i], basis(i), w_);
}

void LeastCurvature::start(Problem& problem) {
  w_.resize(size_);
  basis_.resize(kSteps * size_);
  images_.resize(kSteps * size_);
  length_ = 0;
  scatter(w_);
  problem.multiply(Matrix::none, 1, w_, image(0));
  problem.solve(image(0), w_);
  keep_orthogonal(problem);
}

/// One step of Lanczos for (C2) of the header: adds an entry to the diagonal a and, if there is space, a
/// vector to the basis and an entry to the off-diagonal b.
void LeastCurvature::lengthen(Problem& problem) {
  const std::size_t last = length_ - 1;
  problem.solve(image(last), w_);
  a_[last] = dot(w_, image(last));
  if (length_ < kSteps) keep_orthogonal(problem);
}

/// Makes w orthogonal to the basis and appends it to the basis. The orthogonalisation is done twice, because
/// rounding leaves a remainder after the first time.
void LeastCurvature::keep_orthogonal(Problem& problem) {
  for (int time = 0; time < 2; ++time)
    for (std::size_t i = 0; i < length_; ++i) axpy(-dot(w_, image(i)), basis(i), w_);
  problem.multiply(Matrix::none, 1, w_, image(length_));
  const double norm = std::sqrt(dot(w_, image(length_)));
  if (!(norm > 0) || !std::isfinite(norm)) return;
  if (length_ > 0) b_[length_ - 1] = norm;
  for (double& v : image(length_)) v /= norm;
  std::transform(w_.begin(), w_.end(), basis(length_).begin(), [&](double v) { return v / norm; });
  ++length_;
}

}  // namespace netloft::newton
