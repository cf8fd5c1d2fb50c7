// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/snes/snes.hpp"

#include <petscsnes.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "solvers/common/petsc.hpp"

namespace netloft::snes {

namespace {

using namespace petsc;
using Operator = Owned<Mat, MatDestroy>;
using Solver = Owned<SNES, SNESDestroy>;

/// The problem as seen by PETSc's callbacks, and the events in them: no exception may pass through PETSc.
struct Host {
  Host(Problem& p, const Snes::Parameters& how) : problem(p), parameters(how), residual(p.size()) {}

  Problem& problem;
  const Snes::Parameters& parameters;
  std::vector<double> residual;                 // at the accepted point
  std::optional<std::vector<double>> reported;  // that point
  int rejected = 0;                             // rejected steps in a row
  bool stopped = false;                         // `progress` said so
  bool refused = false;                         // the tangent could not be factorised
  std::exception_ptr failure;
};

PetscErrorCode compute_residual(SNES snes, Vec u, Vec r, void* host) {
  return guarded<Host>(host, [&](Host& h) {
    double energy = 0;
    if (h.problem.evaluate(ReadEntries(u), energy, Entries(r)) != Evaluation::ok)
      check(SNESSetFunctionDomainError(snes));
  });
}

/// Computes the tangent of an accepted point and reports the point.
SNESConvergedReason report(Host& h, std::span<const double> u) {
  h.rejected = 0;
  h.reported.emplace(u.begin(), u.end());
  double energy = 0;
  if (h.problem.evaluate(u, energy, h.residual, Matrix::exact) != Evaluation::ok)
    return SNES_DIVERGED_FUNCTION_DOMAIN;
  h.stopped = !h.problem.progress(u, energy, h.residual);
  return h.stopped ? SNES_CONVERGED_FNORM_ABS : SNES_CONVERGED_ITERATING;
}

/// SNES tests convergence after every step; the trust region also after rejected steps, which would go on for
/// ever from u = 0.
PetscErrorCode judge(SNES snes, PetscInt, PetscReal, PetscReal, PetscReal, SNESConvergedReason* reason,
                     void* host) {
  constexpr int kMostRejected = 30;
  return guarded<Host>(host, [&](Host& h) {
    Vec solution = nullptr;
    check(SNESGetSolution(snes, &solution));
    const ReadEntries entries(solution);
    const std::span<const double> u = entries;
    if (!h.reported || !std::ranges::equal(u, *h.reported))
      *reason = report(h, u);
    else
      *reason = ++h.rejected < kMostRejected ? SNES_CONVERGED_ITERATING : SNES_DIVERGED_TR_DELTA;
  });
}

/// The host has the tangent of this point already; PETSc only needs to know that the tangent has changed.
PetscErrorCode renew_tangent(SNES, Vec, Mat tangent, Mat, void* host) {
  return guarded<Host>(host, [&](Host&) {
    check(MatAssemblyBegin(tangent, MAT_FINAL_ASSEMBLY));
    check(MatAssemblyEnd(tangent, MAT_FINAL_ASSEMBLY));
  });
}

PetscErrorCode multiply(Mat tangent, Vec x, Vec y) {
  void* host = nullptr;
  MatShellGetContext(tangent, &host);
  return guarded<Host>(host, [&](Host& h) {
    h.problem.multiply(Matrix::exact, h.parameters.damping, ReadEntries(x), Entries(y));
  });
}

PetscErrorCode factorise(PC preconditioner) {
  void* host = nullptr;
  PCShellGetContext(preconditioner, &host);
  const PetscErrorCode code = guarded<Host>(host, [&](Host& h) {
    h.refused = h.problem.factorise_indefinite(Matrix::exact, h.parameters.damping) != Factor::ok;
  });
  return code == 0 && static_cast<Host*>(host)->refused ? PETSC_ERR_MAT_LU_ZRPVT : code;
}

PetscErrorCode solve_with_factor(PC preconditioner, Vec b, Vec x) {
  void* host = nullptr;
  PCShellGetContext(preconditioner, &host);
  return guarded<Host>(host, [&](Host& h) { h.problem.solve(ReadEntries(b), Entries(x)); });
}

void make_tangent(Host& host, Operator& tangent) {
  const auto n = static_cast<PetscInt>(host.problem.size());
  check(MatCreateShell(PETSC_COMM_SELF, n, n, n, n, &host, tangent.address()));
  check(MatShellSetOperation(tangent, MATOP_MULT, reinterpret_cast<void (*)()>(multiply)));
}

/// Our factorisation is applied once per step; KSP has nothing to iterate on.
void set_linear_solver(SNES snes, Host& host) {
  KSP ksp = nullptr;
  PC preconditioner = nullptr;
  check(SNESGetKSP(snes, &ksp));
  check(KSPSetType(ksp, KSPPREONLY));
  check(KSPGetPC(ksp, &preconditioner));
  check(PCSetType(preconditioner, PCSHELL));
  check(PCShellSetContext(preconditioner, &host));
  check(PCShellSetSetUp(preconditioner, factorise));
  check(PCShellSetApply(preconditioner, solve_with_factor));
}

void set_strategy(SNES snes, std::int64_t strategy) {
  enum { kLineSearch, kTrustRegion, kNone };
  check(SNESSetType(snes, strategy == kTrustRegion ? SNESNEWTONTR : SNESNEWTONLS));
  if (strategy == kTrustRegion) return;
  SNESLineSearch search = nullptr;
  check(SNESGetLineSearch(snes, &search));
  check(SNESLineSearchSetType(search, strategy == kLineSearch ? SNESLINESEARCHBT : SNESLINESEARCHBASIC));
}

/// The host alone decides when to stop.
void set_limits(SNES snes, Host& host) {
  constexpr PetscInt kNever = std::numeric_limits<PetscInt>::max();
  check(SNESSetConvergenceTest(snes, judge, &host, nullptr));
  check(SNESSetTolerances(snes, 0, 0, 0, kNever, kNever));
}

Outcome outcome_of(SNESConvergedReason reason) {
  switch (reason) {
    case SNES_DIVERGED_LINEAR_SOLVE:
      return Outcome::linear_solve;
    case SNES_DIVERGED_FUNCTION_DOMAIN:
      return Outcome::left_domain;
    case SNES_DIVERGED_FNORM_NAN:
      return Outcome::not_finite;
    default:
      return Outcome::step_too_short;
  }
}

Outcome run(Host& host) {
  const Vector u(host.problem.u()), r(host.problem.size());
  Operator tangent;
  Solver snes;
  make_tangent(host, tangent);
  check(SNESCreate(PETSC_COMM_SELF, snes.address()));
  set_strategy(snes, host.parameters.strategy);
  check(SNESSetFunction(snes, r, compute_residual, &host));
  check(SNESSetJacobian(snes, tangent, tangent, renew_tangent, &host));
  set_linear_solver(snes, host);
  set_limits(snes, host);
  const PetscErrorCode code = SNESSolve(snes, nullptr, u);
  if (host.failure) std::rethrow_exception(host.failure);
  if (host.refused) return Outcome::linear_solve;
  check(code);
  SNESConvergedReason reason{};
  check(SNESGetConvergedReason(snes, &reason));
  return host.stopped ? Outcome::stopped : outcome_of(reason);
}

}  // namespace

Outcome Snes::solve(const Parameters& parameters, Problem& problem) {
  start();
  Host host(problem, parameters);
  return run(host);
}

}  // namespace netloft::snes
