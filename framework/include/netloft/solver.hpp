// SPDX-License-Identifier: BSD-3-Clause
//
// The header for authors of solvers. A solver is a struct with `Parameters` and one function,
//
//   static Outcome solve(const Parameters&, Problem&);
//
// that moves `problem.u()` towards r(u) = 0. Once per iteration it passes u to `progress`, which returns
// whether to continue. If no step was accepted, it passes the same u again. The host, not the solver, counts,
// measures time and decides on convergence.
#pragma once
#include <netloft/ext/solver.h>
#include <netloft/parameters.hpp>

#include <cstdio>
#include <exception>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace netloft {

enum class Outcome {
  stopped = NETLOFT_STOPPED,  // `progress` returned false: converged, or a limit was reached
  step_too_short = NETLOFT_STEP_TOO_SHORT,
  linear_solve = NETLOFT_LINEAR_SOLVE,
  left_domain = NETLOFT_LEFT_DOMAIN,
  not_finite = NETLOFT_NOT_FINITE,
};

enum class Matrix { exact = NETLOFT_EXACT, convex = NETLOFT_CONVEX, none = NETLOFT_NONE };
enum class Factor {
  ok = NETLOFT_FACTOR_OK,
  not_positive = NETLOFT_NOT_POSITIVE,
  singular = NETLOFT_SINGULAR,
  failed = NETLOFT_FACTOR_FAILED
};
enum class Evaluation { ok = NETLOFT_OK, outside_domain = NETLOFT_OUTSIDE_DOMAIN };

/// r(u) = 0 as a solver sees it.
class Problem {
 public:
  explicit Problem(netloft_problem& p) : p_(p) {}

  std::size_t size() const { return p_.unknowns; }
  bool conservative() const { return p_.traits & NETLOFT_CONSERVATIVE; }
  bool symmetric() const { return p_.traits & NETLOFT_SYMMETRIC; }
  std::span<double> u() { return {p_.u, size()}; }

  /// Computes residual [N] and energy [J] at u; the energy is zero if there is none. `keep` selects a matrix
  /// that is also computed and stored.
  Evaluation evaluate(std::span<const double> u, double& energy, std::span<double> residual,
                      Matrix keep = Matrix::none) {
    const std::uint32_t matrix = keep == Matrix::exact    ? std::uint32_t{NETLOFT_WANT_TANGENT}
                                 : keep == Matrix::convex ? std::uint32_t{NETLOFT_WANT_CONVEX}
                                                          : 0u;
    return checked(p_.evaluate(p_.host, NETLOFT_WANT_ENERGY | NETLOFT_WANT_FORCE | matrix, u.data(), &energy,
                               residual.data()));
  }
  Evaluation evaluate(std::span<const double> u, double& energy) {
    return checked(p_.evaluate(p_.host, NETLOFT_WANT_ENERGY, u.data(), &energy, nullptr));
  }
  /// Computes the gradient of the energy: the residual of the conservative forces alone, without drag.
  Evaluation evaluate_gradient(std::span<const double> u, double& energy, std::span<double> gradient) {
    return checked(p_.evaluate(p_.host, NETLOFT_WANT_ENERGY | NETLOFT_WANT_FORCE | NETLOFT_WANT_GRADIENT,
                               u.data(), &energy, gradient.data()));
  }
  /// Computes residual and gradient at once, at little more than the cost of one of them. Residual minus
  /// gradient is the residual of the nonconservative forces.
  Evaluation evaluate_both(std::span<const double> u, double& energy, std::span<double> residual,
                           std::span<double> gradient) {
    return checked(p_.evaluate_both(p_.host, u.data(), &energy, residual.data(), gradient.data()));
  }
  /// Computes and stores the matrix that `keep` selects, and nothing else.
  Evaluation evaluate(std::span<const double> u, Matrix keep) {
    const std::uint32_t want =
        keep == Matrix::exact ? std::uint32_t{NETLOFT_WANT_TANGENT} : std::uint32_t{NETLOFT_WANT_CONVEX};
    return checked(p_.evaluate(p_.host, want, u.data(), nullptr, nullptr));
  }
  /// Factorises matrix + shift x metric. The metric is the linear stiffness.
  Factor factorise(Matrix matrix, double shift) {
    return checked_factor(p_.factorise(p_.host, static_cast<int>(matrix), shift));
  }
  /// Factorises matrix + shift x metric, which need not be positive definite.
  Factor factorise_indefinite(Matrix matrix, double shift) {
    return checked_factor(p_.factorise(p_.host, static_cast<int>(matrix) | NETLOFT_INDEFINITE, shift));
  }
  /// Factorises K + blend (K₊ − K) + shift x metric, with the tangent K and its convex part K₊. Evaluations
  /// at the same point must have stored both matrices.
  Factor factorise_between(double blend, double shift) {
    return checked_factor(p_.factorise_between(p_.host, blend, shift));
  }
  void solve(std::span<const double> rhs, std::span<double> x) {
    check(p_.solve(p_.host, rhs.data(), x.data()));
  }
  /// Solves with the last factor, which may stem from an earlier problem. Returns false if no factor exists.
  bool try_solve(std::span<const double> rhs, std::span<double> x) {
    return p_.solve(p_.host, rhs.data(), x.data()) == NETLOFT_OK;
  }
  /// y = (matrix + shift x metric) x
  void multiply(Matrix matrix, double shift, std::span<const double> x, std::span<double> y) {
    check(p_.multiply(p_.host, static_cast<int>(matrix), shift, x.data(), y.data()));
  }
  /// y[i] = sum of the absolute values in row i of matrix + shift x metric.
  void row_sums(Matrix matrix, double shift, std::span<double> y) {
    check(p_.row_sums(p_.host, static_cast<int>(matrix), shift, y.data()));
  }
  /// Negative eigenvalues of the last matrix given to `factorise_indefinite`; -1 if not known.
  int negative_pivots() { return p_.negative_pivots(p_.host); }
  /// Counts an iteration at an accepted point. If it returns false, the solver must return Outcome::stopped.
  bool progress(std::span<const double> u, double energy, std::span<const double> residual,
                const char* note = "") {
    return p_.progress(p_.host, u.data(), energy, residual.data(), note) == NETLOFT_GO_ON;
  }
  /// Largest displacement of a node in the step du, divided by the length of the longest element.
  double step_length(std::span<const double> du) { return p_.step_length(p_.host, du.data()); }

 private:
  static Evaluation checked(int status) {
    check(status);
    return static_cast<Evaluation>(status);
  }
  static Factor checked_factor(int status) {
    check(status);
    return static_cast<Factor>(status);
  }
  static void check(int status) {
    if (status < 0)
      throw std::runtime_error("");  // an empty message, because the host reports the cause
                                     // itself
  }
  netloft_problem& p_;
};

namespace detail {
template <class S>
int run_solver(const void* parameters, netloft_problem* problem) noexcept {
  try {
    Problem p(*problem);
    return static_cast<int>(S::solve(OwnParameters<S>::from(parameters), p));
  } catch (const std::exception& e) {
    if (problem->message) std::snprintf(problem->message, problem->message_size, "%s", e.what());
  } catch (...) {
  }
  return NETLOFT_SOLVER_ERROR;
}
}  // namespace detail

/// Describes one solver to the host. `needs` are traits that the problem must have.
template <class S>
class SolverTable : public ParameterTable<typename S::Parameters> {
 public:
  using Offer = netloft_solvers;  // the list in which a plugin offers its solvers
  static constexpr const char* extension = NETLOFT_EXT_SOLVER;

  SolverTable(const char* name, const char* doc) : name_(name), doc_(doc) {}
  void needs(std::uint32_t traits) { needs_ = traits; }

  netloft_solver descriptor() const {
    detail::OwnParameters<S>::declare(this->rows());
    netloft_solver s{};
    s.size = sizeof s;
    s.needs = needs_;
    s.name = name_;
    s.doc = doc_;
    s.parameter_bytes = sizeof(typename S::Parameters);
    s.parameter_count = static_cast<std::uint32_t>(this->rows().size());
    s.parameters = this->rows().data();
    s.solve = &detail::run_solver<S>;
    return s;
  }

 private:
  const char *name_, *doc_;
  std::uint32_t needs_ = 0;
};

}  // namespace netloft

#include <netloft/register.hpp>
