// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/ts/ts.hpp"

#include <petscts.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "solvers/common/petsc.hpp"

namespace netloft::ts {

namespace {

using namespace petsc;
using Integration = Owned<TS, TSDestroy>;

/// The steps that TS is asked to take, one after another.
enum class Task { stay_at_rest, take_over_acceleration, move };

/// (1)
struct Constants {
  double alpha_m = 0, alpha_f = 0, gamma = 0, beta = 0;
};

/// (3) in the form of TS, for the last uₙ₊₁ at which it evaluated F.
struct Stage {
  double t = 0;
  Vec u = nullptr, v = nullptr, a = nullptr;
};

/// The motion as seen by PETSc's callbacks, and the events in them.
struct Host {
  explicit Host(Motion& m) : motion(m) {}

  Motion& motion;
  Task task = Task::stay_at_rest;
  Constants constants;
  Stage stage;
  Step found = Step::found;
  std::exception_ptr failure;
};

/// TS would evaluate F here. This only stores the point at which it would.
PetscErrorCode keep_stage(TS, PetscReal t, Vec u, Vec v, Vec a, Vec, void* host) {
  return guarded<Host>(host, [&](Host& h) { h.stage = {t, u, v, a}; });
}

/// Copies stage, velocity and acceleration of TS for uₙ₊₁.
void update_stage(SNES snes, Vec next_u) {
  Vec residual = nullptr;
  check(SNESGetFunction(snes, &residual, nullptr, nullptr));
  check(SNESComputeFunction(snes, next_u, residual));
}

/// (2) and (5): finds uₙ₊₁ from uₙ, to which the stage belongs.
void find_next_u(Host& host, std::span<double> next_u) {
  Motion& m = host.motion;
  const auto& [alpha_m, alpha_f, gamma, beta] = host.constants;
  const double h = m.h(), cv = gamma / (beta * h), ca = alpha_m / (alpha_f * beta * h * h);
  const ReadEntries of_u(host.stage.u), of_v(host.stage.v), of_a(host.stage.a);
  const std::span<const double> u = of_u, v = of_v, a = of_a;
  const auto v0 = m.scratch(0), a0 = m.scratch(1), stage_u = m.scratch(2);
  for (std::size_t i = 0; i < m.size(); ++i) {
    v0[i] = v[i] - cv * u[i];
    a0[i] = a[i] - ca * u[i];
    stage_u[i] = m.u()[i] + alpha_f * h * m.v()[i];
  }
  host.found = m.solve(host.stage.t, v0, cv, a0, ca, stage_u);
  for (std::size_t i = 0; i < m.size(); ++i) next_u[i] = m.u()[i] + (stage_u[i] - m.u()[i]) / alpha_f;
}

/// (4), from rest.
void move_by_acceleration(const Host& host, std::span<double> next_u) {
  const Motion& m = host.motion;
  for (std::size_t i = 0; i < m.size(); ++i) next_u[i] = host.constants.beta * m.h() * m.h() * m.a()[i];
}

void do_task(Host& host, SNES snes, Vec next_u) {
  switch (host.task) {
    case Task::stay_at_rest:
      return check(VecZeroEntries(next_u));
    case Task::take_over_acceleration:
      return move_by_acceleration(host, Entries(next_u));
    case Task::move:
      update_stage(snes, next_u);
      return find_next_u(host, Entries(next_u));
  }
}

/// The function that TS uses as its nonlinear solver.
PetscErrorCode solve_stage(SNES snes, Vec next_u) {
  Host* host = nullptr;
  SNESShellGetContext(snes, &host);
  return guarded<Host>(host, [&](Host& h) {
    do_task(h, snes, next_u);
    if (h.found != Step::found) return check(SNESSetConvergedReason(snes, SNES_DIVERGED_INNER));
    update_stage(snes, next_u);
  });
}

void set_stage_solver(TS ts, Host& host) {
  SNES snes = nullptr;
  check(TSGetSNES(ts, &snes));
  check(SNESSetType(snes, SNESSHELL));
  check(SNESShellSetContext(snes, &host));
  check(SNESShellSetSolve(snes, solve_stage));
}

/// The host chooses the steps and judges their errors.
void leave_steps_to_host(TS ts) {
  constexpr PetscInt kNeverReached = 10;
  TSAdapt adapt = nullptr;
  check(TSGetAdapt(ts, &adapt));
  check(TSAdaptSetType(adapt, TSADAPTNONE));
  check(TSSetErrorIfStepFails(ts, PETSC_FALSE));
  check(TSSetMaxSteps(ts, kNeverReached));
  check(TSSetExactFinalTime(ts, TS_EXACTFINALTIME_STEPOVER));
}

void make_step(TS ts, Host& host, Task task) {
  host.task = task;
  check(TSSetTime(ts, host.motion.t()));
  check(TSSetTimeStep(ts, host.motion.h()));
  const PetscErrorCode code = TSStep(ts);
  if (host.failure) std::rethrow_exception(host.failure);
  check(code);
  TSConvergedReason reason{};
  check(TSGetConvergedReason(ts, &reason));
  if (reason < 0 && host.found == Step::found)
    throw std::runtime_error(std::string("PETSc: ") + TSConvergedReasons[reason]);
}

/// (3), (6)
void keep_acceleration(Host& host) {
  Motion& m = host.motion;
  const ReadEntries of_a(host.stage.a);
  const std::span<const double> a = of_a;
  const double error = std::abs(host.constants.beta - 1.0 / 6) * m.h() * m.h();
  for (std::size_t i = 0; i < m.size(); ++i) {
    const double change = (a[i] - m.a()[i]) / host.constants.alpha_m;
    m.next_a()[i] = m.a()[i] + change;
    m.error()[i] = error * std::abs(change);
  }
}

void run(Host& host, double spectral_radius) {
  Motion& m = host.motion;
  auto& [alpha_m, alpha_f, gamma, beta] = host.constants;
  std::ranges::fill(m.next_u(), 0.0);
  std::ranges::fill(m.next_v(), 0.0);
  const Vector u(m.next_u()), v(m.next_v()), residual(m.size());

  Integration ts;
  check(TSCreate(PETSC_COMM_SELF, ts.address()));
  check(TSSetType(ts, TSALPHA2));
  check(TSAlpha2SetRadius(ts, spectral_radius));
  check(TSAlpha2GetParams(ts, &alpha_m, &alpha_f, &gamma, &beta));
  check(TS2SetSolution(ts, u, v));
  check(TSSetI2Function(ts, residual, keep_stage, &host));
  set_stage_solver(ts, host);
  leave_steps_to_host(ts);

  make_step(ts, host, Task::stay_at_rest);
  make_step(ts, host, Task::take_over_acceleration);
  std::ranges::copy(m.u(), m.next_u().begin());
  std::ranges::copy(m.v(), m.next_v().begin());
  make_step(ts, host, Task::move);
  if (host.found == Step::found) keep_acceleration(host);
}

}  // namespace

Step Ts::step(const Parameters& parameters, Motion& motion) {
  if (motion.size() == 0) return Step::found;
  start();
  Host host(motion);
  run(host, parameters.spectral_radius);
  return host.found;
}

}  // namespace netloft::ts
