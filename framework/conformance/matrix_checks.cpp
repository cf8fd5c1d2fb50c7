// SPDX-License-Identifier: BSD-3-Clause
#include "framework/conformance/checks.hpp"

#include <Eigen/Eigenvalues>

namespace netloft::conformance {

namespace {

Eigen::MatrixXd matrix_of(const Bench& b, const netloft_term& term, const Answer& a, std::size_t lane) {
  const auto n = static_cast<Eigen::Index>(b.dofs());
  Eigen::MatrixXd m(n, n);
  std::size_t entry = 0;
  const bool packed = term.traits & NETLOFT_SYMMETRIC;
  for (Eigen::Index r = 0; r < n; ++r)
    for (Eigen::Index c = 0; c < (packed ? r + 1 : n); ++c) {
      m(r, c) = a.matrix[at(entry++, lane)];
      if (packed) m(c, r) = m(r, c);
    }
  return m;
}

/// Magnitude of the least eigenvalue, relative to the largest entry of `scale`; zero if no eigenvalue is
/// negative.
double negativity(const Eigen::MatrixXd& m, const Eigen::MatrixXd& scale) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(0.5 * (m + m.transpose()),
                                                             Eigen::EigenvaluesOnly);
  return ratio(std::max(0.0, -eigen.eigenvalues()[0]), scale.cwiseAbs().maxCoeff());
}

constexpr double kRounding = 1e-10;

}  // namespace

Finding convex_is_positive(Bench& b) {
  Worst worst(kRounding);
  for (const auto& term : b.type.terms) {
    if (!(term.traits & NETLOFT_HAS_CONVEX)) continue;
    for (const auto& s : b.tiles) {
      const Answer a = b.specimen->evaluate(term, s, NETLOFT_WANT_CONVEX);
      for (std::size_t lane = 0; lane < s.count; ++lane) {
        const auto convex = matrix_of(b, term, a, lane);
        worst.note(negativity(convex, convex),
                   [&] { return b.place(term, s, lane) + ": negative eigenvalue"; });
      }
    }
  }
  return judged(worst, "no term has a convex part");
}

Finding metric_is_constant(Bench& b) {
  Worst worst(1e-12);
  for (const auto& term : b.type.terms) {
    if (!(term.traits & NETLOFT_HAS_METRIC)) continue;
    for (const auto& s : b.tiles) {
      const Answer here = b.specimen->evaluate(term, s, NETLOFT_WANT_METRIC);
      std::vector<double> step(kLanes, 0.0);
      for (std::size_t lane = 0; lane < s.count; ++lane) step[lane] = b.size(s, lane);
      const Answer there = b.specimen->evaluate(term, moved(s, b.random_field(), step), NETLOFT_WANT_METRIC);
      for (std::size_t lane = 0; lane < s.count; ++lane) {
        const auto one = matrix_of(b, term, here, lane), two = matrix_of(b, term, there, lane);
        worst.note(ratio((two - one).cwiseAbs().maxCoeff(), one.cwiseAbs().maxCoeff()),
                   [&] { return b.place(term, s, lane) + ": the metric moves with the nodes"; });
      }
    }
  }
  return judged(worst, "no term has a metric");
}

Finding metric_bounds_convex(Bench& b) {
  Worst worst(kRounding);
  for (const auto& term : b.type.terms) {
    if (!(term.traits & NETLOFT_HAS_METRIC) || !(term.traits & NETLOFT_HAS_CONVEX)) continue;
    for (const auto& s : b.tiles) {
      const Answer metric = b.specimen->evaluate(term, s, NETLOFT_WANT_METRIC);
      const Answer convex = b.specimen->evaluate(term, s, NETLOFT_WANT_CONVEX);
      for (std::size_t lane = 0; lane < s.count; ++lane) {
        const auto m = matrix_of(b, term, metric, lane), c = matrix_of(b, term, convex, lane);
        worst.note(negativity(m - c, m),
                   [&] { return b.place(term, s, lane) + ": stiffer than the metric"; });
      }
    }
  }
  return judged(worst, "no term has both a metric and a convex part");
}

}  // namespace netloft::conformance
