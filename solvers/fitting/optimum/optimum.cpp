// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/fitting/optimum/optimum.hpp"

#include "solvers/fitting/optimum/quadratic.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace netloft {

namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;
using Index = Eigen::Index;

// First, largest and least radius of the trust region, as fractions of the range of a parameter. The search
// ends at the least radius. The values are chosen.
constexpr double kFirstRadius = 0.2, kLargestRadius = 0.5, kLeastRadius = 1e-6;
// The ratio of actual to predicted decrease: a step is accepted from kAccepted on, the radius Δ shrinks below
// kPoor and grows above kGood (Nocedal and Wright, algorithm 4.1, which allows any kAccepted from 0 to 1/4).
constexpr double kAccepted = 1e-3, kPoor = 0.25, kGood = 0.75;
// Noise of the scaled f_0: equilibria have a relative tolerance of 1e-10, and figures lose a digit to
// rounding.
constexpr double kNoise = 1e-9;
// A constraint counts as at its limit within this distance, as a fraction of its size: ten times the
// violation that is allowed by default.
constexpr double kAtLimit = 1e-5;
// A parameter within this distance of an end of its range is set to that end, because an interior-point
// method (quadratic.hpp) approaches the end but never reaches it. The value is chosen.
constexpr double kAtEnd = 1e-8;

Vector vector_of(const std::vector<double>& numbers) {
  return Eigen::Map<const Vector>(numbers.data(), static_cast<Index>(numbers.size()));
}

std::vector<double> numbers_of(const Vector& v) { return {v.data(), v.data() + v.size()}; }

/// f and its slopes in the scaled numbers of (2) in optimum.hpp.
struct Local {
  Vector z;          // parameters as fractions of their ranges, from 0 to 1
  double value = 0;  // f_0, negative if it is maximised
  Vector rows;       // f_1, f_2, …
  Vector gradient;   // ∂f_0/∂z
  Matrix slopes;     // ∂f_j/∂z
  double remainder = std::numeric_limits<double>::infinity();
  Vector multipliers;  // λ
  OptimumPoint point;
};

/// One of the two limits of a constraint or a parameter: the low limit (side −1) or the high limit (1).
struct Limit {
  Index of;
  int side;
};

class Search {
 public:
  Search(Model& model, const OptimumProblem& problem, const OptimumOptions& options,
         const std::function<void(const OptimumPoint&)>& on_point)
      : model_(model),
        problem_(problem),
        options_(options),
        on_point_(on_point),
        low_(static_cast<Index>(problem.parameters.size())),
        range_(low_.size()),
        row_low_(static_cast<Index>(problem.constraints.size())),
        row_high_(row_low_.size()),
        row_size_(row_low_.size()) {
    for (Index i = 0; i < low_.size(); ++i) {
      const Bounds& b = problem.parameters[static_cast<std::size_t>(i)];
      low_(i) = b.low;
      range_(i) = b.high - b.low;
    }
  }

  Optimum run() {
    if (!begin()) return end(false, why_not_begun());
    while (true) {
      if (at_.remainder <= options_.tolerance && at_.point.violation <= options_.feasibility)
        return end(true, "the conditions of an optimum are met");
      if (is_stuck_) return end(false, why_stuck());
      if (static_cast<int>(done_.history.size()) >= options_.evaluations)
        return end(false, "the limit of solves was reached");
      if (!step()) return end(false, model_.is_interrupted() ? "interrupted" : kNoSlopes);
    }
  }

 private:
  static constexpr const char* kNoSlopes = "there are no slopes at the last point";

  std::string why_not_begun() const {
    if (model_.is_interrupted()) return "interrupted";
    return done_.history.front().predictions.empty() ? "the model has no solution at the start" : kNoSlopes;
  }

  std::string why_stuck() const {
    if (at_.point.violation > options_.feasibility)
      return "near the last point, none violates the constraints less: the constraints contradict each other "
             "there";
    return has_failed_ ? "the model has no solution in the direction in which the slopes point"
                       : "no step improves the point, although its slopes promise that: the figures may "
                         "have kinks there";
  }

  Vector parameters_at(const Vector& z) const { return low_ + range_.cwiseProduct(z); }

  /// The parameters at z. If z is 0 or 1, they are exactly the limits.
  std::vector<double> placed(const Vector& z) const {
    std::vector<double> p = numbers_of(parameters_at(z));
    for (std::size_t i = 0; i < p.size(); ++i)
      if (z(static_cast<Index>(i)) >= 1) p[i] = problem_.parameters[i].high;
    return p;
  }

  bool begin() {
    Local first;
    first.z = (vector_of(problem_.start) - low_).cwiseQuotient(range_).cwiseMax(0).cwiseMin(1);
    first.z = (range_.array() > 0).select(first.z, 0);
    first.point.parameters = problem_.start;
    const auto predictions = model_.predict(problem_.start);
    if (!predictions) {
      keep(first.point);
      return false;
    }
    find_sizes(*predictions);
    take(first, *predictions);
    first.point.is_accepted = true;
    const bool has_slopes = find_slopes(first);
    if (has_slopes) settle(first);
    keep(first.point);
    if (!has_slopes) return false;
    shift_.setZero(row_size_.size());
    bend_ = 1e-3 * Matrix::Identity(low_.size(), low_.size());
    at_ = std::move(first);
    best_ = at_;
    return true;
  }

  /// Computes the sizes by which f is scaled.
  void find_sizes(const std::vector<double>& f) {
    size_ = f[0] != 0 ? std::abs(f[0]) : 1;
    for (Index j = 0; j < row_size_.size(); ++j) {
      const Bounds& b = problem_.constraints[static_cast<std::size_t>(j)];
      double& size = row_size_(j);
      size = 0;
      for (const double limit : {b.low, b.high})
        if (std::isfinite(limit)) size = std::max(size, std::abs(limit));
      if (size == 0) size = std::abs(f[static_cast<std::size_t>(j) + 1]);
      if (size == 0) size = 1;
      row_low_(j) = b.low / size;
      row_high_(j) = b.high / size;
      for (const int side : {-1, 1})
        if (std::isfinite(side < 0 ? b.low : b.high)) limits_.push_back({j, side});
    }
  }

  double sign() const { return problem_.maximise ? -1 : 1; }

  void take(Local& at, const std::vector<double>& f) const {
    at.point.predictions = f;
    at.value = sign() * f[0] / size_;
    at.rows = vector_of(f).tail(row_size_.size()).cwiseQuotient(row_size_);
    at.point.violation = violation(at.rows);
  }

  double violation(const Vector& rows) const {
    if (rows.size() == 0) return 0;
    return std::max(0.0, std::max((row_low_ - rows).maxCoeff(), (rows - row_high_).maxCoeff()));
  }

  bool find_slopes(Local& at) {
    const auto slopes = model_.slopes(at.point.parameters);
    if (!slopes) return false;
    at.point.slopes = *slopes;
    at.slopes.resize(row_size_.size(), range_.size());
    at.gradient = sign() * vector_of((*slopes)[0]).cwiseProduct(range_) / size_;
    for (Index j = 0; j < row_size_.size(); ++j)
      at.slopes.row(j) =
          vector_of((*slopes)[static_cast<std::size_t>(j) + 1]).cwiseProduct(range_).transpose() /
          row_size_(j);
    return at.slopes.allFinite() && at.gradient.allFinite();
  }

  void keep(OptimumPoint point) {
    point.slopes.clear();
    done_.history.push_back(std::move(point));
    if (on_point_) on_point_(done_.history.back());
  }

  double bound(const Limit& limit) const { return (limit.side < 0 ? row_low_ : row_high_)(limit.of); }

  /// Whether a parameter is at the low end (−1) or at the high end (1) of its range, or at neither (0).
  static int end_of(double z) { return z <= 0 ? -1 : z >= 1 ? 1 : 0; }

  /// Finds λ and the remainder of a point.
  void settle(Local& at) const {
    std::vector<Limit> active;
    for (const Limit& limit : limits_)
      if (limit.side * (at.rows(limit.of) - bound(limit)) > -kAtLimit) active.push_back(limit);
    const std::size_t rows = active.size();
    for (Index i = 0; i < at.z.size(); ++i)
      if (const int end = end_of(at.z(i))) active.push_back({i, end});
    const auto count = static_cast<Index>(active.size());
    Matrix all(count, at.z.size());  // slopes of all that is at a limit, positive away from the limit
    for (std::size_t k = 0; k < active.size(); ++k) {
      const auto [of, side] = active[k];
      const Vector slope = k < rows ? Vector(at.slopes.row(of)) : Vector::Unit(at.z.size(), of);
      all.row(static_cast<Index>(k)) = -side * slope;
    }
    const Vector found = minimise({all * all.transpose(), -all * at.gradient, -Matrix::Identity(count, count),
                                   Vector::Zero(count)},
                                  Vector::Zero(count))
                             .x;
    at.multipliers.setZero(row_size_.size());
    for (std::size_t k = 0; k < rows; ++k)
      at.multipliers(active[k].of) -= active[k].side * found(static_cast<Index>(k));
    at.remainder = (at.gradient - all.transpose() * found).cwiseAbs().maxCoeff();
    at.point.remainder = at.remainder;
  }

  /// A step d of (4) in optimum.hpp, and the multipliers of the rows of (4).
  struct Step {
    Vector d, multipliers;
  };

  Step find_step() const {
    const Index n = range_.size(), m = static_cast<Index>(limits_.size()), all = 2 * n + 1 + m;
    const Vector rows = at_.rows + shift_;
    Quadratic q{Matrix::Zero(n + 1, n + 1), Vector(n + 1), Matrix::Zero(all, n + 1), Vector(all)};
    q.B.topLeftCorner(n, n) = bend_;
    q.g << at_.gradient, penalty_;
    q.G.topLeftCorner(n, n).setIdentity();
    q.G.block(n, 0, n + 1, n + 1) = -Matrix::Identity(n + 1, n + 1);
    q.h.head(2 * n + 1) << (Vector::Ones(n) - at_.z).cwiseMin(radius_), at_.z.cwiseMin(radius_), 0;
    for (Index k = 0; k < m; ++k) {
      const Limit& limit = limits_[static_cast<std::size_t>(k)];
      q.G.row(2 * n + 1 + k) << limit.side * at_.slopes.row(limit.of), -1;
      q.h(2 * n + 1 + k) = limit.side * (bound(limit) - rows(limit.of));
    }
    const QuadraticAnswer found = minimise(q, Vector::Zero(n + 1));
    Step step{found.x.head(n), Vector::Zero(row_size_.size())};
    for (Index k = 0; k < m; ++k) {
      const Limit& limit = limits_[static_cast<std::size_t>(k)];
      step.multipliers(limit.of) -= limit.side * found.y(2 * n + 1 + k);
    }
    return step;
  }

  double merit(double value, double violated) const { return value + penalty_ * violated; }

  /// Tries a step. A rejected step changes only Δ. Returns false if the search cannot continue.
  bool step() {
    const auto [d, multipliers] = find_step();
    const double length = d.cwiseAbs().maxCoeff();
    const Vector led = at_.rows + shift_ + at_.slopes * d;
    const double promised = merit(at_.value, at_.point.violation) -
                            merit(at_.value + at_.gradient.dot(d) + 0.5 * d.dot(bend_ * d), violation(led));
    if (promised < kNoise * kNoise) {
      is_stuck_ = shift_.isZero(0);
      return is_stuck_ || shorten(0.3 * length);
    }
    Local next;
    next.z = at_.z + d;
    for (double& z : next.z)
      if (std::abs(z - std::round(z)) < kAtEnd) z = std::round(z);
    next.point.parameters = placed(next.z);
    const auto f = model_.predict(next.point.parameters);
    if (model_.is_interrupted()) return false;
    has_failed_ = !f;
    if (!f) {
      keep(next.point);
      return shorten(0.25 * length);
    }
    take(next, *f);
    double gained = merit(at_.value, at_.point.violation) - merit(next.value, next.point.violation);
    if (is_feasible(at_) && is_feasible(next)) gained = std::max(gained, at_.value - next.value);
    const double part = (gained + kNoise) / (std::max(promised, 0.0) + kNoise);
    next.point.is_accepted = part > kAccepted;
    if (!next.point.is_accepted) {
      keep(next.point);
      return reject(next, led, length);
    }
    return accept(std::move(next), part, multipliers, length);
  }

  bool shorten(double radius) {
    radius_ = radius;
    is_stuck_ = radius < kLeastRadius;
    shift_.setZero(row_size_.size());
    return true;
  }

  /// Handles a rejected step. If the step failed because constraints are curved, a step that also corrects
  /// the violation at the end of the failed step is tried (second-order correction). Otherwise Δ shrinks.
  bool reject(const Local& next, const Vector& led, double length) {
    const bool is_curved = next.point.violation > violation(led) + options_.feasibility;
    if (!is_curved || !shift_.isZero(0)) return shorten(0.3 * length);
    shift_ = next.rows - led;
    return true;
  }

  bool accept(Local next, double part, const Vector& multipliers, double length) {
    const bool has_slopes = find_slopes(next);
    if (has_slopes) {
      learn(next, multipliers);
      settle(next);
    }
    keep(next.point);
    if (!has_slopes) return false;
    if (part < kPoor) radius_ = 0.5 * length;
    if (part > kGood && length > 0.9 * radius_) radius_ = std::min(2 * radius_, kLargestRadius);
    shift_.setZero(row_size_.size());
    at_ = std::move(next);
    if (is_better(at_, best_)) best_ = at_;
    return true;
  }

  bool is_feasible(const Local& at) const { return at.point.violation <= options_.feasibility; }

  bool is_better(const Local& a, const Local& b) const {
    if (is_feasible(a) != is_feasible(b)) return is_feasible(a);
    return is_feasible(a) ? a.value < b.value : a.point.violation < b.point.violation;
  }

  /// Updates B by the slopes at the next point (damped BFGS, Nocedal and Wright, procedure 18.2), and μ by
  /// the multipliers of the step.
  void learn(const Local& next, const Vector& multipliers) {
    penalty_ = std::max(penalty_, 2 * multipliers.cwiseAbs().sum());
    const Vector s = next.z - at_.z;
    Vector y = next.gradient - at_.gradient - (next.slopes - at_.slopes).transpose() * multipliers;
    const double sy = s.dot(y);
    if (!has_bend_ && sy > 0) {
      bend_ = y.dot(y) / sy * Matrix::Identity(s.size(), s.size());
      has_bend_ = true;
    }
    const Vector Bs = bend_ * s;
    const double sBs = s.dot(Bs);
    if (!(sBs > 0)) return;
    if (sy < 0.2 * sBs) {
      const double share = 0.8 * sBs / (sBs - sy);
      y = share * y + (1 - share) * Bs;
    }
    bend_ += y * y.transpose() / s.dot(y) - Bs * Bs.transpose() / sBs;
  }

  Optimum end(bool converged, std::string reason) {
    done_.converged = converged;
    done_.reason = std::move(reason);
    if (at_.gradient.size() == 0) return std::move(done_);
    const bool is_as_good = is_feasible(at_) && at_.value <= best_.value + options_.feasibility;
    const Local& best = converged || is_as_good ? at_ : best_;
    done_.best = best.point;
    done_.is_feasible = is_feasible(best);
    const Vector r = best.gradient - best.slopes.transpose() * best.multipliers;
    for (Index j = 0; j < row_size_.size(); ++j)
      done_.constraint_prices.push_back(sign() * best.multipliers(j) * size_ / row_size_(j));
    for (Index i = 0; i < range_.size(); ++i)
      done_.parameter_prices.push_back(end_of(best.z(i)) * r(i) < 0 ? sign() * r(i) * size_ / range_(i) : 0);
    return std::move(done_);
  }

  Model& model_;
  const OptimumProblem& problem_;
  const OptimumOptions& options_;
  const std::function<void(const OptimumPoint&)>& on_point_;
  Vector low_, range_;
  Vector row_low_, row_high_, row_size_;  // limits of f_j over their sizes, and these sizes
  std::vector<Limit> limits_;             // the finite limits of f_j
  double size_ = 1;                       // size of f_0
  Local at_, best_;                       // the current point, and the best that was accepted
  Matrix bend_;                           // B
  bool has_bend_ = false;                 // whether B has learnt from slopes
  double radius_ = kFirstRadius, penalty_ = 1;
  Vector shift_;
  bool is_stuck_ = false;    // whether no step is left to try
  bool has_failed_ = false;  // whether the model had no solution at the last point
  Optimum done_;
};

}  // namespace

Optimum optimise(Model& model, const OptimumProblem& problem, const OptimumOptions& options,
                 const std::function<void(const OptimumPoint&)>& on_point) {
  return Search(model, problem, options, on_point).run();
}

}  // namespace netloft
