// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/fitting/optimum/quadratic.hpp"

#include <Eigen/Cholesky>

#include <algorithm>

namespace netloft {

namespace {

using Array = Eigen::ArrayXd;

constexpr int kMostIterations = 100;  // a programme takes 10 to 30
constexpr double kPrecise = 1e-14;    // product of slacks and multipliers at which the iteration ends
// A step goes this fraction of the way to the nearest limit. The value is chosen; it changes the number of
// iterations, not the answer.
constexpr double kInside = 0.995;

/// The longest step ≤ 1 along `by` that keeps `at` above zero.
double longest(const Array& at, const Array& by) {
  double step = 1;
  for (Eigen::Index k = 0; k < at.size(); ++k)
    if (by(k) < 0) step = std::min(step, -at(k) / by(k));
  return step;
}

}  // namespace

QuadraticAnswer minimise(const Quadratic& q, Eigen::VectorXd x) {
  const Eigen::Index rows = q.h.size();
  if (rows == 0) return {q.B.ldlt().solve(-q.g), {}};
  Array s = (q.h - q.G * x).array().max(1.0), y = Array::Ones(rows);  // slacks and multipliers
  for (int i = 0; i < kMostIterations; ++i) {
    const Eigen::VectorXd dual = q.B * x + q.g + q.G.transpose() * y.matrix();
    const Array primal = (q.G * x - q.h).array() + s;
    const double gap = (s * y).mean();
    if (gap < kPrecise) break;
    const Eigen::LDLT<Eigen::MatrixXd> factors(q.B + q.G.transpose() * (y / s).matrix().asDiagonal() * q.G);
    Eigen::VectorXd dx;
    Array ds, dy;
    const auto solve = [&](const Array& complement) {
      dx = factors.solve(q.G.transpose() * ((complement - y * primal) / s).matrix() - dual);
      ds = -primal - (q.G * dx).array();
      dy = -(complement + y * ds) / s;
    };
    solve(s * y);  // the predictor
    const double ahead = std::min(longest(s, ds), longest(y, dy));
    const double left = ((s + ahead * ds) * (y + ahead * dy)).mean() / gap;
    solve(s * y + ds * dy - left * left * left * gap);  // the corrector
    const double step = std::min(1.0, kInside * std::min(longest(s, ds), longest(y, dy)));
    if (!dx.allFinite()) break;
    x += step * dx;
    s += step * ds;
    y += step * dy;
  }
  return {std::move(x), y.matrix()};
}

}  // namespace netloft
