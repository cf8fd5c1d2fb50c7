// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/snes/snes.hpp"

#include <petscsnes.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>

namespace netloft::snes {

namespace {

void check(PetscErrorCode code) {
  if (code == 0) return;
  const char* text = nullptr;
  PetscErrorMessage(code, &text, nullptr);
  throw std::runtime_error(std::string("PETSc: ") + (text ? text : "failed"));
}

/// PETSc for as long as the program runs, in this process alone, and out of the way: no signal handlers, no
/// options of other programs, no traces on the terminal, no daemon of MPI's.
void start_petsc() {
  PetscBool running = PETSC_FALSE;
  check(PetscInitialized(&running));
  if (running) return;
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  check(PetscOptionsSetValue(nullptr, "-no_signal_handler", "true"));
  check(PetscOptionsSetValue(nullptr, "-skip_petscrc", "true"));
  check(PetscInitializeNoArguments());
  check(PetscPushErrorHandler(PetscIgnoreErrorHandler, nullptr));
  std::atexit([] { PetscFinalize(); });
}

/// Owns what PETSc makes.
template <class Handle, PetscErrorCode (*Destroy)(Handle*)>
class Owned {
 public:
  Owned() = default;
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  ~Owned() { Destroy(&handle_); }
  operator Handle() const { return handle_; }
  Handle* address() { return &handle_; }

 private:
  Handle handle_ = nullptr;
};
using Vector = Owned<Vec, VecDestroy>;
using Operator = Owned<Mat, MatDestroy>;
using Solver = Owned<SNES, SNESDestroy>;

/// Entries of a vector, for reading or for writing, as long as this lives.
class Entries {
 public:
  explicit Entries(Vec v) : vector_(v) {
    check(VecGetLocalSize(v, &size_));
    check(VecGetArray(v, &begin_));
  }
  Entries(const Entries&) = delete;
  Entries& operator=(const Entries&) = delete;
  ~Entries() { VecRestoreArray(vector_, &begin_); }
  operator std::span<double>() const { return {begin_, static_cast<std::size_t>(size_)}; }

 private:
  Vec vector_;
  PetscInt size_ = 0;
  double* begin_ = nullptr;
};

class ReadEntries {
 public:
  explicit ReadEntries(Vec v) : vector_(v) {
    check(VecGetLocalSize(v, &size_));
    check(VecGetArrayRead(v, &begin_));
  }
  ReadEntries(const ReadEntries&) = delete;
  ReadEntries& operator=(const ReadEntries&) = delete;
  ~ReadEntries() { VecRestoreArrayRead(vector_, &begin_); }
  operator std::span<const double>() const { return {begin_, static_cast<std::size_t>(size_)}; }

 private:
  Vec vector_;
  PetscInt size_ = 0;
  const double* begin_ = nullptr;
};

/// The problem as PETSc's callbacks see it, and what happened in them: no exception may pass through PETSc.
struct Host {
  Host(Problem& p, const Snes::Parameters& how) : problem(p), parameters(how), residual(p.size()) {}

  Problem& problem;
  const Snes::Parameters& parameters;
  std::vector<double> residual;                 // at the accepted point
  std::optional<std::vector<double>> reported;  // that point
  int rejected = 0;                             // steps in a row that did not leave it
  bool stopped = false;                         // `progress` said so
  bool refused = false;                         // the tangent could not be factorised
  std::exception_ptr failure;
};

template <class Work>
PetscErrorCode guarded(void* host, Work&& work) noexcept {
  try {
    work(*static_cast<Host*>(host));
    return 0;
  } catch (...) {
    static_cast<Host*>(host)->failure = std::current_exception();
    return PETSC_ERR_USER;
  }
}

PetscErrorCode compute_residual(SNES snes, Vec u, Vec r, void* host) {
  return guarded(host, [&](Host& h) {
    double energy = 0;
    if (h.problem.evaluate(ReadEntries(u), energy, Entries(r)) != Evaluation::ok)
      check(SNESSetFunctionDomainError(snes));
  });
}

/// Makes the tangent of a point that was accepted and reports it.
SNESConvergedReason report(Host& h, std::span<const double> u) {
  h.rejected = 0;
  h.reported.emplace(u.begin(), u.end());
  double energy = 0;
  if (h.problem.evaluate(u, energy, h.residual, Matrix::exact) != Evaluation::ok)
    return SNES_DIVERGED_FUNCTION_DOMAIN;
  h.stopped = !h.problem.progress(u, energy, h.residual);
  return h.stopped ? SNES_CONVERGED_FNORM_ABS : SNES_CONVERGED_ITERATING;
}

/// SNES asks after every step whether it has arrived; the trust region after steps that were rejected, too,
/// and from u = 0 for ever.
PetscErrorCode judge(SNES snes, PetscInt, PetscReal, PetscReal, PetscReal, SNESConvergedReason* reason,
                     void* host) {
  constexpr int kMostRejected = 30;
  return guarded(host, [&](Host& h) {
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

/// The host has the tangent of this point already; PETSc must only know that it is another one.
PetscErrorCode renew_tangent(SNES, Vec, Mat tangent, Mat, void* host) {
  return guarded(host, [&](Host&) {
    check(MatAssemblyBegin(tangent, MAT_FINAL_ASSEMBLY));
    check(MatAssemblyEnd(tangent, MAT_FINAL_ASSEMBLY));
  });
}

PetscErrorCode multiply(Mat tangent, Vec x, Vec y) {
  void* host = nullptr;
  MatShellGetContext(tangent, &host);
  return guarded(host, [&](Host& h) {
    h.problem.multiply(Matrix::exact, h.parameters.damping, ReadEntries(x), Entries(y));
  });
}

PetscErrorCode factorise(PC preconditioner) {
  void* host = nullptr;
  PCShellGetContext(preconditioner, &host);
  const PetscErrorCode code = guarded(host, [&](Host& h) {
    h.refused = h.problem.factorise_indefinite(Matrix::exact, h.parameters.damping) != Factor::ok;
  });
  return code == 0 && static_cast<Host*>(host)->refused ? PETSC_ERR_MAT_LU_ZRPVT : code;
}

PetscErrorCode solve_with_factor(PC preconditioner, Vec b, Vec x) {
  void* host = nullptr;
  PCShellGetContext(preconditioner, &host);
  return guarded(host, [&](Host& h) { h.problem.solve(ReadEntries(b), Entries(x)); });
}

void make_tangent(Host& host, Operator& tangent) {
  const auto n = static_cast<PetscInt>(host.problem.size());
  check(MatCreateShell(PETSC_COMM_SELF, n, n, n, n, &host, tangent.address()));
  check(MatShellSetOperation(tangent, MATOP_MULT, reinterpret_cast<void (*)()>(multiply)));
}

/// Our factorisation, applied once: KSP has nothing to iterate on.
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

/// The host alone knows when to stop.
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
  const auto n = static_cast<PetscInt>(host.problem.size());
  Vector u, r;
  Operator tangent;
  Solver snes;
  check(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, n, host.problem.u().data(), u.address()));
  check(VecDuplicate(u, r.address()));
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
  start_petsc();
  Host host(problem, parameters);
  return run(host);
}

}  // namespace netloft::snes
