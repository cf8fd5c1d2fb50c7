// SPDX-License-Identifier: BSD-3-Clause
#include "framework/motion/settling.hpp"

#include <algorithm>
#include <cstdio>

namespace netloft {

namespace {

/// Reports the residual of the static equilibrium at u to the host. Returns true if the host stops.
bool report_residual(netloft_problem& problem, std::span<const double> u, std::vector<double>& residual) {
  double energy = 0;
  if (problem.evaluate(problem.host, NETLOFT_WANT_ENERGY | NETLOFT_WANT_FORCE, u.data(), &energy,
                       residual.data()) != NETLOFT_OK)
    return false;
  std::copy(u.begin(), u.end(), problem.u);
  return problem.progress(problem.host, u.data(), energy, residual.data(), "in motion") != NETLOFT_GO_ON;
}

/// The sentence about a march that reached one of its limits without coming to rest.
std::string why_not_at_rest(const MarchResult& r) {
  return r.reason +
         " without coming to rest: use a scheme that damps fast motions, such as generalized-alpha, or "
         "newmark "
         "with chi = -0.3";
}

int settle(const void* parameters, netloft_problem* problem) {
  const Settling& s = *static_cast<const Settling*>(parameters);
  std::vector<double> residual(problem->unknowns);
  MarchWatch watch;
  watch.on_step = [&](const StepRecord& step, std::span<const double> u) {
    return step.steps % s.steps_per_check == 0 && report_residual(*problem, u, residual);
  };
  const MarchState from = state_at_rest(s.scene.assembler, {problem->u, problem->unknowns});
  MarchSettings how = s.march;
  how.judged = false;  // only the equilibrium matters, so that the motion may be wrong
  const MarchResult r = march(s.scene, s.methods, s.limits, how, watch, &from);
  std::copy(r.u.begin(), r.u.end(), problem->u);
  if (r.status == MarchStatus::stopped) return NETLOFT_STOPPED;
  if (r.status == MarchStatus::interrupted) {
    report_residual(*problem, r.u, residual);  // in this call, the host notices and reports the interrupt
    return NETLOFT_STOPPED;
  }
  const bool moved_on = r.status == MarchStatus::finished || r.status == MarchStatus::out_of_time ||
                        r.status == MarchStatus::out_of_work;
  const std::string why = moved_on ? why_not_at_rest(r) : r.reason;
  std::snprintf(problem->message, problem->message_size, "%s", why.c_str());
  return NETLOFT_SOLVER_ERROR;
}

}  // namespace

SolverType Settling::as_solver() const {
  const IntegratorType& stands_for = *methods.integrator.type;
  SolverType type;
  type.type = stands_for.type;
  type.origin = stands_for.origin;
  type.solver.size = sizeof type.solver;
  type.solver.name = stands_for.integrator.name;
  type.solver.doc = stands_for.integrator.doc;
  type.solver.solve = &settle;
  return type;
}

}  // namespace netloft
