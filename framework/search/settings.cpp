// SPDX-License-Identifier: BSD-3-Clause
#include "framework/search/settings.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <utility>

namespace netloft {

namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

// Constants of the search for factors. Changes of factors are relative: they are changes of the logarithm.
// Slopes are measured over the change kFirstChange of a factor, which changes a tension by some percent.
// Equilibria are found to 1e-10 of the load, so that this change of tension has 7 correct digits.
constexpr double kFirstChange = 0.01;
// Largest change in one step. If the length of a warp changes by 5 %, Newton's method still converges from
// the previous equilibrium.
constexpr double kLargestChange = 0.05;
constexpr int kMostHalvings = 3;  // number of times a step is halved; 1/8 of 5 % is less than kFirstChange
constexpr int kMostSteps = 60;  // number of steps; 60 steps of 0.05 in the logarithm multiply a factor by 20
constexpr double kForceTolerance =
    1e-9;  // tolerance relative to the required force; ten times the tolerance of equilibria

/// Logarithms y of the factors, the equilibrium for these factors, and the relative errors g of the
/// reactions.
struct Point {
  VectorXd y, off;  // (1)
  Solution solution;
  bool is_there = false;
  double distance() const { return off.cwiseAbs().maxCoeff(); }
};

std::vector<double> factors_at(const VectorXd& y) {
  std::vector<double> factors;
  for (const double logarithm : y) factors.push_back(std::exp(logarithm));
  return factors;
}

/// Finds the factors of the settings of a scene. Each member function is one step of the search.
class SettingSearch {
 public:
  SettingSearch(const Scene& scene, const FindWithFactors& find) : scene_(scene), find_(find) {}

  Solution run(const std::vector<double>& start) {
    VectorXd y(scene_.settings.size());
    for (Eigen::Index k = 0; k < y.size(); ++k)
      y[k] = std::log(scene_.settings[static_cast<std::size_t>(k)].factor);
    Point at = find_at(y, start);
    if (at.is_there && at.distance() > kForceTolerance && measure_slopes(at)) approach(at);
    return finished(std::move(at));
  }

 private:
  Point find_at(const VectorXd& y, const std::vector<double>& start) {
    Point point{y, VectorXd::Constant(y.size(), HUGE_VAL), {}, false};
    auto [solution, reactions] = find_(factors_at(y), start);
    point.is_there = !reactions.empty();
    for (std::size_t k = 0; k < reactions.size(); ++k)
      point.off[static_cast<Eigen::Index>(k)] = reactions[k] / scene_.settings[k].wanted - 1;
    cost_.add(solution.cost);
    is_interrupted_ |= solution.status == SolveStatus::interrupted;
    point.solution = std::move(solution);
    return point;
  }

  /// Measures the slopes J at a point along the columns of directions(). Returns false if there are no
  /// equilibria near the point.
  bool measure_slopes(const Point& at) {
    const MatrixXd along = directions(at.y.size());
    MatrixXd slopes(at.y.size(), at.y.size());
    for (Eigen::Index k = 0; k < at.y.size(); ++k) {
      const double towards = at.off.dot(along.col(k)) < 0 ? kFirstChange : -kFirstChange;
      Point beside;
      for (const double change : {towards, -towards}) {
        if (is_interrupted_ || beside.is_there) break;
        beside = find_at(at.y + change * along.col(k), at.solution.u);
        slopes.col(k) = (beside.off - at.off) / change;
      }
      if (!beside.is_there) return failed_ = beside.solution.reason, false;
    }
    slopes_ = slopes * along.inverse();
    return true;
  }

  /// Directions along which slopes are measured. The first direction changes all factors by the same amount;
  /// each of the others changes one factor in the sense opposite to all previous factors. Slopes along single
  /// factors would be less accurate: with two warps, changing one length alone changes tensions much more
  /// than changing both lengths together.
  static MatrixXd directions(Eigen::Index n) {
    MatrixXd all = MatrixXd::Zero(n, n);
    all.col(0).setOnes();
    for (Eigen::Index k = 1; k < n; ++k) {
      all.col(k).head(k).setConstant(1.0 / static_cast<double>(k));
      all(k, k) = -1;
    }
    return all;
  }

  void approach(Point& at) {
    bool just_measured = true;
    for (int step = 0; step < kMostSteps && at.distance() > kForceTolerance && !is_interrupted_; ++step) {
      Point next = best_step(at);
      if (next.is_there && next.distance() < at.distance()) {
        at = std::move(next);
        just_measured = false;
        continue;
      }
      if (!next.is_there) failed_ = next.solution.reason;
      if (just_measured || is_interrupted_ || !measure_slopes(at)) return;
      just_measured = true;
    }
  }

  /// Makes a step by (2) of settings.hpp, and updates the slopes by (3).
  Point best_step(const Point& at) {
    VectorXd s = slopes_.fullPivLu().solve(-at.off);
    if (!s.allFinite()) s.setZero();
    if (const double most = s.cwiseAbs().maxCoeff(); most > kLargestChange) s *= kLargestChange / most;
    Point next;
    for (int halving = 0; halving <= kMostHalvings && s.squaredNorm() > 0 && !is_interrupted_; ++halving) {
      next = find_at(at.y + s, at.solution.u);
      if (next.is_there) slopes_ += (next.off - at.off - slopes_ * s) * s.transpose() / s.squaredNorm();
      if (next.is_there && next.distance() < at.distance()) break;
      s *= 0.5;
    }
    return next;
  }

  Solution finished(Point at) const {
    Solution s = std::move(at.solution);
    s.factors = factors_at(at.y);
    s.cost = cost_;
    if (is_interrupted_) {
      s.status = SolveStatus::interrupted;
      s.reason = "interrupted during the search for " + list_names();
    } else if (at.is_there && at.distance() > kForceTolerance) {
      s.status = SolveStatus::not_converged;
      s.reason = sentence_at(at);
      if (!failed_.empty()) s.reason += "; the next step failed: " + failed_;
    }
    return s;
  }

  std::string list_names() const {
    std::string names;
    for (const Setting& setting : scene_.settings) names += (names.empty() ? "" : ", ") + setting.name;
    return names;
  }

  /// Returns a sentence such as "no length of warp was found at which its end bears 1.2e+04 N; the nearest is
  /// 9.1e+03 N, at 93.2 m"
  std::string sentence_at(const Point& at) const {
    std::string text;
    const auto factors = factors_at(at.y);
    for (std::size_t k = 0; k < factors.size(); ++k) {
      const Setting& setting = scene_.settings[k];
      const double off = at.off[static_cast<Eigen::Index>(k)];
      if (std::abs(off) <= kForceTolerance) continue;
      char line[256];
      std::snprintf(line, sizeof line,
                    "no %s was found at which the tension at its end is %.6g N; the nearest tension is %.6g "
                    "N, at %.6g %s",
                    setting.name.c_str(), setting.wanted, (1 + off) * setting.wanted,
                    amount_of(scene_, setting) / setting.factor * factors[k], setting.unit.c_str());
      text += (text.empty() ? "" : "; ") + std::string(line);
    }
    return text;
  }

  const Scene& scene_;
  const FindWithFactors& find_;
  MatrixXd slopes_;  // slopes J of (2)
  Cost cost_;        // cost of all equilibria
  bool is_interrupted_ = false;
  std::string failed_;  // why the last step found no equilibrium
};

template <class Visit>
void for_data(auto& scene, const Setting& setting, const Visit& visit) {
  for (auto& part : scene.parts) {
    if (part.name != setting.part) continue;
    if (const auto data = part.data.find(setting.datum); data != part.data.end()) visit(part, data->second);
  }
}

}  // namespace

void set_factors(Scene& scene, std::span<const double> factors) {
  for (std::size_t k = 0; k < scene.settings.size(); ++k) {
    Setting& setting = scene.settings[k];
    const double change = factors[k] / setting.factor;
    for_data(scene, setting, [&](Part&, std::vector<double>& data) {
      for (double& value : data) value *= change;
    });
    setting.factor = factors[k];
  }
}

double amount_of(const Scene& scene, const Setting& setting) {
  double amount = 0;
  for_data(scene, setting, [&](const Part& part, const std::vector<double>& data) {
    if (!part.companion) amount += std::accumulate(data.begin(), data.end(), 0.0);
  });
  return amount;
}

Solution find_settings(const Scene& scene, const FindWithFactors& find, const std::vector<double>& start) {
  return SettingSearch(scene, find).run(start);
}

}  // namespace netloft
