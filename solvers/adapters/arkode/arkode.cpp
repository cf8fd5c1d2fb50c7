// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/adapters/arkode/arkode.hpp"

#include <arkode/arkode_arkstep.h>
#include <sundials/sundials_nonlinearsolver.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "solvers/adapters/common/sundials.hpp"

namespace netloft::arkode {

namespace {

using namespace sundials;

/// A method table of ARKODE, and the power of the step h to which the error (4) of arkode.hpp is
/// proportional. (4) is the difference of two formulas, and the power is the lower of their orders plus one.
struct Method {
  ARKODE_DIRKTableID table;
  double error_order;
};

/// The methods, in the order of the choices of `method`.
constexpr std::array<Method, 3> kMethods = {
    {{ARKODE_ARK324L2SA_DIRK_4_2_3, 3}, {ARKODE_TRBDF2_3_3_2, 3}, {ARKODE_KVAERNO_5_3_4, 4}}};

const Method& method_of(const Arkode::Parameters& p) { return kMethods[static_cast<std::size_t>(p.method)]; }

/// The motion that ARKODE's callbacks evaluate, and the errors that occur in them.
struct Host {
  explicit Host(Motion& m) : motion(m) {}

  Motion& motion;
  std::exception_ptr failure;  // exception in a callback
  std::string complaint;       // error message of ARKODE

  std::span<double> u(N_Vector y) const { return {N_VGetArrayPointer_Serial(y), motion.size()}; }
  std::span<double> v(N_Vector y) const {
    return {N_VGetArrayPointer_Serial(y) + motion.size(), motion.size()};
  }
};

void check(int status, const Host& host) {
  if (status != ARK_SUCCESS) throw std::runtime_error("ARKODE: " + host.complaint);
}

/// Gives y' at the start of the step. ARKODE computes y' of the later stages by (3) of arkode.hpp.
int give_rate(double t, N_Vector, N_Vector rate, void* host) {
  return guarded<Host>(host, [&](Host& h) {
    if (t != h.motion.t()) throw std::runtime_error("ARKODE asks for a rate within its step");
    std::copy(h.motion.v().begin(), h.motion.v().end(), h.u(rate).begin());
    std::copy(h.motion.a().begin(), h.motion.a().end(), h.v(rate).begin());
    return int{kDone};
  });
}

/// A stage in ARKODE's form: the k of (1) in arkode.hpp is predicted + known.
struct Stage {
  Stage(void* arkode, const Host& host) {
    N_Vector state = nullptr, rate = nullptr;
    void* user = nullptr;
    check(ARKStepGetNonlinearSystemData(arkode, &t, &predicted, &state, &rate, &gamma, &known, &user), host);
  }
  double t = 0, gamma = 0;
  N_Vector predicted = nullptr, known = nullptr;
};

/// Solves (2) of arkode.hpp for a stage. `correction` becomes y minus the prediction.
Step find_stage(const Stage& stage, N_Vector correction, Host& host) {
  Motion& m = host.motion;
  const auto predicted_u = host.u(stage.predicted), predicted_v = host.v(stage.predicted);
  const auto known_u = host.u(stage.known), known_v = host.v(stage.known);
  const auto v0 = m.scratch(0), a0 = m.scratch(1), u = m.scratch(2);
  const double g = 1 / stage.gamma;
  for (std::size_t i = 0; i < m.size(); ++i) {
    const double ku = predicted_u[i] + known_u[i], kv = predicted_v[i] + known_v[i];
    v0[i] = -g * ku;
    a0[i] = g * (v0[i] - kv);
    u[i] = ku + stage.gamma * m.v()[i];
  }
  if (m.solve(stage.t, v0, g, a0, g * g, u) != Step::found) return Step::shorter;
  for (std::size_t i = 0; i < m.size(); ++i) {
    host.u(correction)[i] = u[i] - predicted_u[i];
    host.v(correction)[i] = v0[i] + g * u[i] - predicted_v[i];
    m.next_a()[i] = a0[i] + g * g * u[i];
  }
  return Step::found;
}

int solve_stage(SUNNonlinearSolver solver, N_Vector, N_Vector correction, N_Vector, realtype, booleantype,
                void* arkode) {
  return guarded<Host>(solver->content, [&](Host& h) {
    return find_stage(Stage(arkode, h), correction, h) == Step::found ? SUN_NLS_SUCCESS : SUN_NLS_CONV_RECVR;
  });
}

struct FreeArkode {
  void operator()(void* a) const { ARKStepFree(&a); }
};
struct FreeStageSolver {
  void operator()(SUNNonlinearSolver s) const { SUNNonlinSolFreeEmpty(s); }
};
using ArkodeMemory = std::unique_ptr<void, FreeArkode>;
using StageSolver = std::unique_ptr<std::remove_pointer_t<SUNNonlinearSolver>, FreeStageSolver>;

StageSolver make_stage_solver(Host& host, SUNContext context) {
  StageSolver s(checked(SUNNonlinSolNewEmpty(context)));
  s->content = &host;
  s->ops->gettype = [](SUNNonlinearSolver) { return SUNNONLINEARSOLVER_ROOTFIND; };
  s->ops->setsysfn = [](SUNNonlinearSolver, SUNNonlinSolSysFn) { return SUN_NLS_SUCCESS; };
  s->ops->solve = solve_stage;
  return s;
}

/// Makes ARKODE take one step of h and accept any error, because the host controls the step. (With its own
/// fixed steps, ARKODE gives no estimate of the error.)
void ask_for_one_step(void* arkode, double h, const Host& host) {
  constexpr double kAnyError = 1e100;
  check(ARKStepSStolerances(arkode, 0, kAnyError), host);
  check(ARKStepSetInitStep(arkode, h), host);
  check(ARKStepSetMaxConvFails(arkode, 1), host);
  check(ARKStepSetMaxErrTestFails(arkode, 1), host);
}

void keep_error(void* arkode, N_Vector room, Host& host) {
  check(ARKStepGetEstLocalErrors(arkode, room), host);
  for (std::size_t i = 0; i < host.motion.size(); ++i) host.motion.error()[i] = std::abs(host.u(room)[i]);
}

/// Takes a step by (1) to (4) of arkode.hpp. Returns ARKODE's status; y becomes the state at the end of the
/// step.
int run(const Method& method, Host& host, std::span<double> y) {
  const double t = host.motion.t(), h = host.motion.h();
  const Context context = make_context();
  const Vector state = make_vector(y, context.get());
  const StageSolver stage_solver = make_stage_solver(host, context.get());

  const ArkodeMemory arkode(checked(ARKStepCreate(nullptr, give_rate, t, state.get(), context.get())));
  check(ARKStepSetErrHandlerFn(arkode.get(), keep_complaint<Host>, &host), host);
  check(ARKStepSetUserData(arkode.get(), &host), host);
  check(ARKStepSetTableNum(arkode.get(), method.table, ARKODE_ERK_NONE), host);
  check(ARKStepSetNonlinearSolver(arkode.get(), stage_solver.get()), host);
  check(ARKStepSetDeduceImplicitRhs(arkode.get(), SUNTRUE), host);
  ask_for_one_step(arkode.get(), h, host);

  double reached = t;
  const int status = ARKStepEvolve(arkode.get(), t + h, state.get(), &reached, ARK_ONE_STEP);
  if (status == ARK_SUCCESS) {
    const Vector error(checked(N_VClone(state.get())));
    keep_error(arkode.get(), error.get(), host);
  }
  return status;
}

}  // namespace

Step Arkode::step(const Parameters& parameters, Motion& m) {
  if (m.size() == 0) return Step::found;
  Host host(m);
  std::vector<double> y(m.u().begin(), m.u().end());
  y.insert(y.end(), m.v().begin(), m.v().end());
  const int status = run(method_of(parameters), host, y);
  if (host.failure) std::rethrow_exception(host.failure);
  if (status == ARK_CONV_FAILURE || status == ARK_ERR_FAILURE) return Step::shorter;
  check(status, host);
  const auto middle = y.begin() + static_cast<std::ptrdiff_t>(m.size());
  std::copy(y.begin(), middle, m.next_u().begin());
  std::copy(middle, y.end(), m.next_v().begin());
  return Step::found;
}

double Arkode::order(const Parameters& parameters) { return method_of(parameters).error_order; }

}  // namespace netloft::arkode
