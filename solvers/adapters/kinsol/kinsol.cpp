// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/adapters/kinsol/kinsol.hpp"

#include <kinsol/kinsol.h>
#include <sundials/sundials_linearsolver.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "solvers/adapters/common/sundials.hpp"

namespace netloft::kinsol {

namespace {

using namespace sundials;

/// The problem as seen by KINSOL's callbacks. They store exceptions, because none may pass through KINSOL.
struct Host {
  Host(Problem& p, const Kinsol::Parameters& how) : problem(p), parameters(how), residual(p.size()) {}

  Problem& problem;
  const Kinsol::Parameters& parameters;
  std::vector<double> residual;  // residual at the accepted point
  double energy = 0;
  bool stopped = false;        // `progress` returned false
  std::exception_ptr failure;  // exception in a callback
  std::string complaint;       // error message of KINSOL

  std::span<double> view(N_Vector v) const { return {N_VGetArrayPointer_Serial(v), problem.size()}; }
};

int compute_residual(N_Vector u, N_Vector r, void* host) {
  return guarded<Host>(host, [&](Host& h) {
    double energy = 0;
    return h.problem.evaluate(h.view(u), energy, h.view(r)) == Evaluation::ok ? kDone : kRecoverable;
  });
}

/// KINSOL requests the tangent at every accepted point and nowhere else. Therefore this function also reports
/// the point to the host.
int compute_tangent(N_Vector u, N_Vector, SUNMatrix, void* host, N_Vector, N_Vector) {
  return guarded<Host>(host, [&](Host& h) {
    if (h.problem.evaluate(h.view(u), h.energy, h.residual, Matrix::exact) != Evaluation::ok) return kStop;
    h.stopped = !h.problem.progress(h.view(u), h.energy, h.residual);
    return h.stopped ? kStop : kDone;
  });
}

int factorise(SUNLinearSolver solver, SUNMatrix) {
  return guarded<Host>(solver->content, [](Host& h) {
    const Factor factor = h.problem.factorise_indefinite(Matrix::exact, h.parameters.damping);
    return factor == Factor::ok ? kDone : kRecoverable;
  });
}

int solve_with_factor(SUNLinearSolver solver, SUNMatrix, N_Vector x, N_Vector b, realtype) {
  return guarded<Host>(solver->content, [&](Host& h) {
    h.problem.solve(h.view(b), h.view(x));
    return kDone;
  });
}

// Deleters, for owners of KINSOL's objects.
struct FreeMatrix {
  void operator()(SUNMatrix m) const { SUNMatFreeEmpty(m); }
};
struct FreeLinearSolver {
  void operator()(SUNLinearSolver s) const { SUNLinSolFreeEmpty(s); }
};
struct FreeKinsol {
  void operator()(void* k) const { KINFree(&k); }
};
using MatrixHandle = std::unique_ptr<std::remove_pointer_t<SUNMatrix>, FreeMatrix>;
using LinearSolver = std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, FreeLinearSolver>;
using KinsolMemory = std::unique_ptr<void, FreeKinsol>;

Vector make_scale(std::size_t size, double scale, SUNContext context) {
  Vector v(checked(N_VNew_Serial(static_cast<sunindextype>(size), context)));
  N_VConst(scale, v.get());
  return v;
}

/// The host keeps the tangent; KINSOL only needs an object that represents it.
MatrixHandle make_matrix(SUNContext context) {
  MatrixHandle m(checked(SUNMatNewEmpty(context)));
  m->ops->getid = [](SUNMatrix) { return SUNMATRIX_CUSTOM; };
  m->ops->zero = [](SUNMatrix) { return 0; };
  return m;
}

LinearSolver make_linear_solver(Host& host, SUNContext context) {
  LinearSolver s(checked(SUNLinSolNewEmpty(context)));
  s->content = &host;
  s->ops->gettype = [](SUNLinearSolver) { return SUNLINEARSOLVER_DIRECT; };
  s->ops->getid = [](SUNLinearSolver) { return SUNLINEARSOLVER_CUSTOM; };
  s->ops->setup = factorise;
  s->ops->solve = solve_with_factor;
  return s;
}

void check(int status, const Host& host) {
  if (status != KIN_SUCCESS) throw std::runtime_error("KINSOL: " + host.complaint);
}

/// The host alone decides when the residual is small enough; KINSOL's own limits are disabled.
void set_limits(void* kinsol, const Host& host) {
  const auto& p = host.parameters;
  const double n = static_cast<double>(host.problem.size());
  check(KINSetMaxSetupCalls(kinsol, 1), host);  // a new tangent for every step
  check(KINSetFuncNormTol(kinsol, std::numeric_limits<double>::min()), host);
  check(KINSetScaledStepTol(kinsol, p.shortest_step), host);
  check(KINSetMaxNewtonStep(kinsol, p.longest_step * std::sqrt(n)), host);
  check(KINSetNumMaxIters(kinsol, std::numeric_limits<int>::max()), host);
}

Outcome outcome_of(int status, const Host& host) {
  switch (status) {
    case KIN_SUCCESS:
    case KIN_INITIAL_GUESS_OK:
    case KIN_STEP_LT_STPTOL:
    case KIN_LINESEARCH_NONCONV:
    case KIN_LINESEARCH_BCFAIL:
      return Outcome::step_too_short;
    case KIN_LINSOLV_NO_RECOVERY:
    case KIN_LSETUP_FAIL:
    case KIN_LSOLVE_FAIL:
      return Outcome::linear_solve;
    case KIN_SYSFUNC_FAIL:
    case KIN_FIRST_SYSFUNC_ERR:
    case KIN_REPTD_SYSFUNC_ERR:
      return Outcome::left_domain;
    default:
      throw std::runtime_error("KINSOL: " + host.complaint);
  }
}

/// Reports the last point to the host. If KINSOL regards this point as converged, it requests no tangent
/// there, so that compute_tangent has not reported the point.
Outcome report_end(Host& host, Outcome outcome) {
  const auto u = host.problem.u();
  if (host.problem.evaluate(u, host.energy, host.residual) != Evaluation::ok) return Outcome::left_domain;
  return host.problem.progress(u, host.energy, host.residual) ? outcome : Outcome::stopped;
}

int run(Host& host) {
  Problem& problem = host.problem;
  const Context context = make_context();
  const Vector u = make_vector(problem.u(), context.get());
  std::vector<double> unit(problem.size(), 0.0);
  unit[0] = 1;
  const Vector lengths = make_scale(problem.size(), problem.step_length(unit), context.get());
  const Vector forces = make_scale(problem.size(), 1, context.get());
  const MatrixHandle tangent = make_matrix(context.get());
  const LinearSolver linear_solver = make_linear_solver(host, context.get());

  const KinsolMemory kinsol(checked(KINCreate(context.get())));
  KINSetErrHandlerFn(kinsol.get(), keep_complaint<Host>, &host);
  check(KINSetUserData(kinsol.get(), &host), host);
  check(KINInit(kinsol.get(), compute_residual, u.get()), host);
  check(KINSetLinearSolver(kinsol.get(), linear_solver.get(), tangent.get()), host);
  check(KINSetJacFn(kinsol.get(), compute_tangent), host);
  set_limits(kinsol.get(), host);
  const int strategy = host.parameters.strategy == 0 ? KIN_LINESEARCH : KIN_NONE;
  return KINSol(kinsol.get(), u.get(), strategy, lengths.get(), forces.get());
}

}  // namespace

Outcome Kinsol::solve(const Parameters& parameters, Problem& problem) {
  Host host(problem, parameters);
  if (problem.size() == 0) return report_end(host, Outcome::stopped);
  const int status = run(host);
  if (host.failure) std::rethrow_exception(host.failure);
  if (host.stopped) return Outcome::stopped;
  const Outcome outcome = outcome_of(status, host);
  return status >= 0 ? report_end(host, outcome) : outcome;
}

}  // namespace netloft::kinsol
