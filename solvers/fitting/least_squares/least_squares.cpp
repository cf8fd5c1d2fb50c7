// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/fitting/least_squares/least_squares.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace netloft {

namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

// Marquardt's rule: damping falls tenfold after an accepted step and grows tenfold after a rejected one.
constexpr double kDamping = 1e-3, kRatio = 10, kMostDamping = 1e8;

constexpr const char* kNoStart = "the model has no answer at the means of the priors";

double squared(double x) { return x * x; }

/// A point θ (the parameters) with its predictions and the two sums of (1) in least_squares.hpp.
struct Point {
  std::vector<double> parameters, predictions;
  double misfit = 0, prior_misfit = 0;
  double sum() const { return misfit + prior_misfit; }
};

class Fitter {
 public:
  Fitter(Model& model, const std::vector<Prior>& priors, const std::vector<Measurement>& measured,
         const FitOptions& options)
      : model_(model), priors_(priors), measured_(measured), options_(options) {}

  Fit run() {
    auto start = evaluate(means());
    if (!start) return model_.is_interrupted() ? interrupted() : ended(false, kNoStart);
    point_ = std::move(*start);
    while (fit_.steps < options_.iterations) {
      if (!find_slopes()) return without_slopes();
      const Outcome outcome = descend();
      if (outcome == Outcome::settled)
        return finish(true, "no step lowers the sum of squares by an amount that matters");
      if (model_.is_interrupted()) return interrupted();
      if (outcome == Outcome::stuck)
        return finish(false, "no step lowers the sum of squares, although its slope says that a step could");
    }
    return find_slopes() ? finish(false, "the limit of steps was reached") : without_slopes();
  }

 private:
  enum class Outcome { stepped, settled, stuck };

  std::vector<double> means() const {
    std::vector<double> means;
    for (const Prior& p : priors_) means.push_back(std::clamp(p.mean, p.low, p.high));
    return means;
  }

  Fit without_slopes() {
    if (model_.is_interrupted()) return interrupted();
    return ended(false, "the model has no answers around the best point, and so no slopes");
  }

  /// Returns the fit at the last point whose slopes are known, or an empty fit if no slopes are known.
  Fit interrupted() {
    if (slopes_.size() == 0) return ended(false, "interrupted");
    point_ = std::move(sloped_);
    return finish(false, "interrupted");
  }

  std::optional<Point> evaluate(std::vector<double> parameters) {
    auto predictions = model_.predict(parameters);
    if (!predictions) return std::nullopt;
    Point p{std::move(parameters), std::move(*predictions)};
    for (std::size_t i = 0; i < measured_.size(); ++i)
      p.misfit += squared((measured_[i].value - p.predictions[i]) / measured_[i].deviation);
    for (std::size_t j = 0; j < priors_.size(); ++j)
      p.prior_misfit += squared(in_deviations(p.parameters, j));
    return p;
  }

  double in_deviations(const std::vector<double>& parameters, std::size_t j) const {
    return (parameters[j] - priors_[j].mean) / priors_[j].deviation;
  }

  /// Computes the derivatives J_f, N and g of (2) and (4) in least_squares.hpp.
  bool find_slopes() {
    const auto slopes = model_.slopes(point_.parameters);
    if (!slopes) return false;
    sloped_ = point_;
    const auto rows = static_cast<Eigen::Index>(slopes->size()),
               columns = static_cast<Eigen::Index>(priors_.size());
    slopes_.resize(rows, columns);
    for (Eigen::Index i = 0; i < rows; ++i)
      for (Eigen::Index j = 0; j < columns; ++j)
        slopes_(i, j) = (*slopes)[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] *
                        priors_[static_cast<std::size_t>(j)].deviation;
    normal_ = Matrix::Identity(columns, columns);
    gradient_.resize(columns);
    for (Eigen::Index j = 0; j < columns; ++j)
      gradient_(j) = in_deviations(point_.parameters, static_cast<std::size_t>(j));
    for (std::size_t i = 0; i < measured_.size(); ++i) {
      const Vector row = -slopes_.row(static_cast<Eigen::Index>(i)).transpose() / measured_[i].deviation;
      normal_ += row * row.transpose();
      gradient_ += row * ((measured_[i].value - point_.predictions[i]) / measured_[i].deviation);
    }
    return true;
  }

  /// Whether a parameter is at an end of its range, and S decreases outwards.
  bool is_pinned(std::size_t j) const {
    const double slope = gradient_(static_cast<Eigen::Index>(j)), at = point_.parameters[j];
    return (at <= priors_[j].low && slope > 0) || (at >= priors_[j].high && slope < 0);
  }

  /// Returns the step δ of (2) in least_squares.hpp for the parameters that are not pinned.
  Vector step() const {
    Matrix damped = normal_;
    Vector right = -gradient_;
    damped.diagonal() *= 1 + damping_;
    for (std::size_t j = 0; j < priors_.size(); ++j) {
      if (!is_pinned(j)) continue;
      const auto k = static_cast<Eigen::Index>(j);
      damped.row(k).setZero();
      damped.col(k).setZero();
      damped(k, k) = 1;
      right(k) = 0;
    }
    return damped.ldlt().solve(right);
  }

  std::vector<double> moved(const Vector& by) const {
    std::vector<double> to = point_.parameters;
    for (std::size_t j = 0; j < to.size(); ++j)
      to[j] = std::clamp(to[j] + by(static_cast<Eigen::Index>(j)) * priors_[j].deviation, priors_[j].low,
                         priors_[j].high);
    return to;
  }

  /// Tries shorter and shorter steps until one lowers the sum S, (1) of least_squares.hpp.
  Outcome descend() {
    while (fit_.steps < options_.iterations && damping_ < kMostDamping) {
      const Vector by = step();
      const double promised = -(gradient_.dot(by) * 2 + by.dot(normal_ * by));
      if (promised < options_.tolerance) return Outcome::settled;
      ++fit_.steps;
      auto next = evaluate(moved(by));
      if (model_.is_interrupted()) return Outcome::stepped;
      if (next && next->sum() < point_.sum()) {
        point_ = std::move(*next);
        damping_ /= kRatio;
        return Outcome::stepped;
      }
      damping_ *= kRatio;
    }
    return damping_ < kMostDamping ? Outcome::stepped : Outcome::stuck;
  }

  Fit ended(bool converged, std::string reason) {
    fit_.converged = converged;
    fit_.reason = std::move(reason);
    return std::move(fit_);
  }

  /// Fills in the posterior (3) and the deviations of predictions (4) of least_squares.hpp.
  Fit finish(bool converged, std::string reason) {
    const Matrix covariance = normal_.ldlt().solve(Matrix::Identity(normal_.rows(), normal_.cols()));
    const std::size_t n = priors_.size();
    const auto at = [&](std::size_t j, std::size_t k) {
      return covariance(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(k));
    };
    for (std::size_t j = 0; j < n; ++j) {
      fit_.deviations.push_back(std::sqrt(at(j, j)) * priors_[j].deviation);
      fit_.at_end.push_back(is_pinned(j));
      std::vector<double>& row = fit_.correlations.emplace_back();
      for (std::size_t k = 0; k < n; ++k) row.push_back(at(j, k) / std::sqrt(at(j, j) * at(k, k)));
    }
    for (Eigen::Index i = 0; i < slopes_.rows(); ++i)
      fit_.model_deviations.push_back(std::sqrt(slopes_.row(i).dot(covariance * slopes_.row(i).transpose())));
    fit_.parameters = point_.parameters;
    fit_.predictions = point_.predictions;
    fit_.misfit = point_.misfit;
    fit_.prior_misfit = point_.prior_misfit;
    return ended(converged, std::move(reason));
  }

  Model& model_;
  const std::vector<Prior>& priors_;
  const std::vector<Measurement>& measured_;
  const FitOptions& options_;
  Point point_, sloped_;  // the best point, and the last point with known slopes
  Matrix slopes_, normal_;
  Vector gradient_;
  double damping_ = kDamping;
  Fit fit_;
};

}  // namespace

Fit fit(Model& model, const std::vector<Prior>& priors, const std::vector<Measurement>& measured,
        const FitOptions& options) {
  return Fitter(model, priors, measured, options).run();
}

}  // namespace netloft
