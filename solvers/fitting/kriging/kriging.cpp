// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/fitting/kriging/kriging.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace netloft {

namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;
using Index = Eigen::Index;

// Number of points used in the likelihood. More points locate its minimum, whose width is 1/√n, better, but
// each evaluation takes n³/3 operations.
constexpr Index kLikelihoodPoints = 150;
// Range of the lengths ℓ over the extent of the points. With shorter lengths, points are uncorrelated; with
// longer ones, the prediction is a parabola.
constexpr double kShortest = 0.02, kLongest = 20;
// Range of ν, the scatter of the values over σ². With less scatter, K is singular in double precision; with
// more, all variation is scatter.
constexpr double kLeastScatter = 1e-10, kMostScatter = 1;
// Steps of the search in ln ℓ and ln ν. The smallest step changes (5) of kriging.hpp by less than one.
constexpr double kFirstStep = 1.6, kLastStep = 0.1;

using Correlation = KrigingScales::Correlation;

double correlation(Correlation kind, double squared_distance) {
  if (kind == Correlation::gaussian) return std::exp(-0.5 * squared_distance);
  const double r = std::sqrt(5 * squared_distance);
  return (1 + r + r * r / 3) * std::exp(-r);  // (2)
}

/// The parameters of kriging.hpp (1) that are searched for: ln ℓ of every coordinate, then ln ν.
struct Scales {
  Correlation kind = Correlation::matern;
  std::vector<double> logs;
  double scatter() const { return std::exp(logs.back()); }
};

/// Returns a row per point: its coordinates, each divided by its length ℓ.
Matrix scaled(const Matrix& points, const Scales& scales) {
  Matrix all = points;
  for (Index j = 0; j < all.cols(); ++j) all.col(j) *= std::exp(-scales.logs[static_cast<std::size_t>(j)]);
  return all;
}

/// Returns a row per point: 1, followed by the coordinates if there are enough points to determine a plane.
Matrix trend_of(const Matrix& points) {
  Matrix plane(points.rows(), points.cols() + 1);
  plane << Vector::Ones(points.rows()), points;
  const bool is_known =
      plane.rows() >= 2 * plane.cols() && plane.colPivHouseholderQr().rank() == plane.cols();
  return is_known ? plane : plane.leftCols(1);
}

/// The factor of K at given scales, and the quantities of (3) to (6) in kriging.hpp that follow from it.
struct Factorised {
  Factorised(const Matrix& points, const Matrix& trend, const Vector& values, const Scales& s)
      : scales(s), at(scaled(points, s)) {
    const Index n = at.rows();
    Matrix k(n, n);
    for (Index j = 0; j < n; ++j)
      for (Index i = j; i < n; ++i) k(i, j) = correlation(s.kind, (at.row(i) - at.row(j)).squaredNorm());
    k.diagonal().array() += s.scatter();
    factor.compute(k);
    solved_trend = factor.solve(trend);
    information.compute(trend.transpose() * solved_trend);
    beta = information.solve(solved_trend.transpose() * values);
    const Vector rest = values - trend * beta;
    weights = factor.solve(rest);
    variance = weights.dot(rest) / static_cast<double>(n - trend.cols());
  }

  /// Returns the quantity (5) of kriging.hpp, which is minimised, or infinity if K has no factor.
  double unlikeliness() const {
    if (factor.info() != Eigen::Success || information.info() != Eigen::Success || !(variance > 0))
      return std::numeric_limits<double>::infinity();
    return static_cast<double>(at.rows() - beta.size()) * std::log(variance) + logarithm(factor) +
           logarithm(information);
  }

  static double logarithm(const Eigen::LLT<Matrix>& llt) {
    return 2 * llt.matrixLLT().diagonal().array().log().sum();
  }

  Scales scales;
  Matrix at;
  Eigen::LLT<Matrix> factor, information;  // factors of K and of Fᵀ K⁻¹ F
  Matrix solved_trend;                     // product K⁻¹ F
  Vector beta, weights;                    // weights: K⁻¹ (y − F β)
  double variance = 0;
};

/// Searches for the likeliest scales along one axis after the other, in steps that are halved.
Scales search(const Matrix& points, const Matrix& trend, const Vector& values, Correlation kind) {
  const auto d = static_cast<std::size_t>(points.cols());
  Scales best{kind, std::vector<double>(d + 1, 0.0)};
  best.logs.back() = std::log(1e-6);
  double least = Factorised(points, trend, values, best).unlikeliness();
  for (double step = kFirstStep; step >= kLastStep;) {
    bool moved = false;
    for (std::size_t j = 0; j <= d; ++j)
      for (const double direction : {-1.0, 1.0}) {
        Scales other = best;
        const double low = j < d ? kShortest : kLeastScatter, high = j < d ? kLongest : kMostScatter;
        // a step in ln ν is three times that in ln ℓ, because ν ranges over more orders of magnitude
        other.logs[j] =
            std::clamp(other.logs[j] + direction * step * (j < d ? 1 : 3), std::log(low), std::log(high));
        if (other.logs[j] == best.logs[j]) continue;
        if (const double there = Factorised(points, trend, values, other).unlikeliness(); there < least) {
          best = other;
          least = there;
          moved = true;
        }
      }
    if (!moved) step /= 2;
  }
  return best;
}

/// Returns the indices of at most `most` of n points, chosen at random and the same in every call.
std::vector<Index> choose(Index n, Index most) {
  std::vector<Index> places(static_cast<std::size_t>(n));
  for (Index i = 0; i < n; ++i) places[static_cast<std::size_t>(i)] = i;
  if (n <= most) return places;
  std::mt19937_64 dice(1);
  for (std::size_t i = 0; i < static_cast<std::size_t>(most); ++i)
    std::swap(places[i], places[i + static_cast<std::size_t>(dice() % (places.size() - i))]);
  places.resize(static_cast<std::size_t>(most));
  return places;
}

}  // namespace

/// The model in scaled numbers: coordinates from zero to one, values with mean zero and deviation one.
class Kriging::Model {
 public:
  Model(const std::vector<std::vector<double>>& points, const std::vector<double>& values,
        const KrigingScales* known) {
    const auto n = static_cast<Index>(points.size()), d = static_cast<Index>(points.front().size());
    Matrix x(n, d);
    for (Index i = 0; i < n; ++i)
      for (Index j = 0; j < d; ++j)
        x(i, j) = points[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
    low_ = x.colwise().minCoeff();
    extent_ = x.colwise().maxCoeff() - low_;
    x = (x.rowwise() - low_).array().rowwise() / extent_.array();
    Vector y = Eigen::Map<const Vector>(values.data(), n);
    mean_ = y.mean();
    deviation_ = std::sqrt((y.array() - mean_).square().mean());
    y = (y.array() - mean_) / deviation_;
    process_ =
        std::make_unique<Factorised>(x, trend_of(x), y, known ? by_logarithms(*known) : likeliest(x, y));
  }

  KrigingValue at(const std::vector<double>& point) const {
    const Factorised& p = *process_;
    const auto [trend, near] = seen_from(point);
    const Vector lack = trend - p.solved_trend.transpose() * near;
    const double rest =
        1 + p.scales.scatter() - near.dot(p.factor.solve(near)) + lack.dot(p.information.solve(lack));  // (4)
    return {value_of(trend, near), deviation_ * std::sqrt(p.variance * std::max(rest, 0.0))};
  }

  double value_at(const std::vector<double>& point) const {
    const auto [trend, near] = seen_from(point);
    return value_of(trend, near);
  }

  KrigingScales scales() const {
    KrigingScales scales{process_->scales.kind, {}, process_->scales.scatter()};
    for (Index j = 0; j < low_.size(); ++j)
      scales.lengths.push_back(std::exp(process_->scales.logs[static_cast<std::size_t>(j)]));
    return scales;
  }

  std::vector<double> residuals_without(const std::vector<std::size_t>& group) const {
    const Factorised& p = *process_;
    const auto g = static_cast<Index>(group.size());
    assert(g > 0 && g < p.at.rows());
    Matrix unit = Matrix::Zero(p.at.rows(), g);
    for (Index k = 0; k < g; ++k) unit(static_cast<Index>(group[static_cast<std::size_t>(k)]), k) = 1;
    const Matrix trend = unit.transpose() * p.solved_trend;
    const Vector weights = unit.transpose() * p.weights;
    const Matrix q = unit.transpose() * p.factor.solve(unit) - trend * p.information.solve(trend.transpose());
    const Vector residual = deviation_ * q.ldlt().solve(weights);  // (6)
    return {residual.data(), residual.data() + residual.size()};
  }

 private:
  /// Returns the row f of a point, and its correlations κ with the given points.
  std::pair<Vector, Vector> seen_from(const std::vector<double>& point) const {
    const Factorised& p = *process_;
    Eigen::RowVectorXd x = Eigen::Map<const Eigen::RowVectorXd>(point.data(), low_.size());
    x = ((x - low_).array() / extent_.array()).matrix();
    const Matrix here = scaled(x, p.scales);
    Vector near(p.at.rows());
    for (Index i = 0; i < near.size(); ++i)
      near[i] = correlation(p.scales.kind, (p.at.row(i) - here.row(0)).squaredNorm());
    Vector trend = Vector::Ones(p.beta.size());
    if (trend.size() > 1) trend.tail(x.size()) = x.transpose();
    return {std::move(trend), std::move(near)};
  }

  double value_of(const Vector& trend, const Vector& near) const {
    return mean_ + deviation_ * (trend.dot(process_->beta) + near.dot(process_->weights));  // (3)
  }

  static Scales by_logarithms(const KrigingScales& known) {
    Scales scales{known.correlation, {}};
    for (const double length : known.lengths) scales.logs.push_back(std::log(length));
    scales.logs.push_back(std::log(known.scatter));
    return scales;
  }

  static Scales likeliest(const Matrix& x, const Vector& y) {
    const std::vector<Index> chosen = choose(x.rows(), kLikelihoodPoints);
    const Matrix points = x(chosen, Eigen::all);
    const Vector values = y(chosen);
    const Matrix trend = trend_of(points);
    Scales best;
    double least = std::numeric_limits<double>::infinity();
    for (const Correlation kind : {Correlation::matern, Correlation::gaussian}) {
      const Scales scales = search(points, trend, values, kind);
      const double there = Factorised(points, trend, values, scales).unlikeliness();
      if (best.logs.empty() || there < least) {
        best = scales;
        least = there;
      }
    }
    return best;
  }

  Eigen::RowVectorXd low_, extent_;
  double mean_ = 0, deviation_ = 1;
  std::unique_ptr<Factorised> process_;
};

Kriging::Kriging(const std::vector<std::vector<double>>& points, const std::vector<double>& values,
                 const KrigingScales* known)
    : mean_(values.front()) {
  assert(points.size() == values.size() && points.size() > 1);
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  if (*least < *most) model_ = std::make_unique<Model>(points, values, known);
}
Kriging::~Kriging() = default;

KrigingValue Kriging::at(const std::vector<double>& point) const {
  return model_ ? model_->at(point) : KrigingValue{mean_, 0};
}

double Kriging::value_at(const std::vector<double>& point) const {
  return model_ ? model_->value_at(point) : mean_;
}

std::optional<KrigingScales> Kriging::scales() const {
  return model_ ? std::optional(model_->scales()) : std::nullopt;
}

std::vector<double> Kriging::residuals_without(const std::vector<std::size_t>& group) const {
  return model_ ? model_->residuals_without(group) : std::vector<double>(group.size(), 0.0);
}

}  // namespace netloft
