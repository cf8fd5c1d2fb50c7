// SPDX-License-Identifier: BSD-3-Clause
//
// The header for authors of time schemes. An integrator is a struct with `Parameters` and
//
//   static Step step(const Parameters&, Motion&);            // fills next_u, next_v, next_a
//   static double order(const Parameters&);                  // power of h in the estimate in `error`
//   static double stable_step(const Parameters&, double w);  // longest stable h at frequency w; 0: any
//
// An integrator solves F(t, u, v, a) = 0 over one step in any way: explicitly from accelerations, or
// implicitly by an algebraic problem that it passes to the solver of the analysis. The host controls the
// length of the step and counts the work.
#pragma once
#include <netloft/ext/integrator.h>
#include <netloft/parameters.hpp>

#include <cstdio>
#include <exception>
#include <span>
#include <stdexcept>

namespace netloft {

/// The result of a step; `shorter` means that the step failed but may succeed with a smaller h.
enum class Step { found = NETLOFT_OK, shorter = NETLOFT_OUTSIDE_DOMAIN };

/// The equation F(t, u, v, a) = 0 as seen by an integrator, at the start of a step of length h.
class Motion {
 public:
  explicit Motion(netloft_motion& m) : m_(m) {}

  std::size_t size() const { return m_.unknowns; }
  double t() const { return m_.t; }
  double h() const { return m_.h; }
  std::span<const double> u() const { return {m_.u, size()}; }
  std::span<const double> v() const { return {m_.v, size()}; }
  std::span<const double> a() const { return {m_.a, size()}; }
  std::span<double> next_u() { return {m_.u_new, size()}; }
  std::span<double> next_v() { return {m_.v_new, size()}; }
  std::span<double> next_a() { return {m_.a_new, size()}; }
  std::span<double> error() { return {m_.error, size()}; }
  /// An array with a number for each unknown, whose values are kept from step to step. Every `index` has its
  /// own array.
  std::span<double> scratch(std::uint32_t index) { return {m_.scratch(m_.host, index), size()}; }

  /// Computes the residual r = F(t, u, v, a) [N].
  Step residual(double t, std::span<const double> u, std::span<const double> v, std::span<const double> a,
                std::span<double> r) {
    return checked(m_.residual(m_.host, t, u.data(), v.data(), a.data(), r.data()));
  }
  /// Finds the acceleration a for which F(t, u, v, a) vanishes.
  Step accelerate(double t, std::span<const double> u, std::span<const double> v, std::span<double> a) {
    return checked(m_.accelerate(m_.host, t, u.data(), v.data(), a.data()));
  }
  /// Finds the u for which F(t, u, v0 + cv u, a0 + ca u) vanishes. The given u is the initial guess.
  Step solve(double t, std::span<const double> v0, double cv, std::span<const double> a0, double ca,
             std::span<double> u) {
    return checked(m_.solve(m_.host, t, v0.data(), cv, a0.data(), ca, u.data()));
  }
  /// Finds the displacements u at the end of the step such that the mean forces over the step balance. The
  /// rates in the middle of the step are v = v0 + cv u and a = a0 + ca u. The comment on netloft_motion
  /// (ext/integrator.h) defines the mean forces, `damping` and `memory`.
  Step solve_between(std::span<const double> v0, double cv, std::span<const double> a0, double ca,
                     double damping, double memory, std::span<double> u) {
    return checked(m_.solve_between(m_.host, v0.data(), cv, a0.data(), ca, damping, memory, u.data()));
  }

 private:
  static Step checked(int status) {
    if (status < 0)
      throw std::runtime_error("");  // an empty message, because the host reports the cause
                                     // itself
    return static_cast<Step>(status);
  }
  netloft_motion& m_;
};

namespace detail {
template <class I>
int run_step(const void* parameters, netloft_motion* motion) noexcept {
  try {
    Motion m(*motion);
    return static_cast<int>(I::step(OwnParameters<I>::from(parameters), m));
  } catch (const std::exception& e) {
    if (motion->message) std::snprintf(motion->message, motion->message_size, "%s", e.what());
  } catch (...) {
  }
  return NETLOFT_ERROR;
}
}  // namespace detail

/// Describes one integrator to the host.
template <class I>
class IntegratorTable : public ParameterTable<typename I::Parameters> {
 public:
  using Offer = netloft_integrators;  // the list in which a plugin offers its integrators
  static constexpr const char* extension = NETLOFT_EXT_INTEGRATOR;

  using Parameters = typename I::Parameters;
  IntegratorTable(const char* name, const char* doc) : name_(name), doc_(doc) {}
  void traits(std::uint32_t traits) { traits_ = traits; }

  netloft_integrator descriptor() const {
    detail::OwnParameters<I>::declare(this->rows());
    netloft_integrator i{};
    i.size = sizeof i;
    i.traits = traits_;
    i.name = name_;
    i.doc = doc_;
    i.parameter_bytes = sizeof(Parameters);
    i.parameter_count = static_cast<std::uint32_t>(this->rows().size());
    i.parameters = this->rows().data();
    i.step = &detail::run_step<I>;
    i.order = [](const void* p) { return I::order(detail::OwnParameters<I>::from(p)); };
    i.stable_step = [](const void* p, double w) {
      return I::stable_step(detail::OwnParameters<I>::from(p), w);
    };
    return i;
  }

 private:
  const char *name_, *doc_;
  std::uint32_t traits_ = 0;
};

}  // namespace netloft

#include <netloft/register.hpp>
