// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/descriptors.hpp"
#include "framework/registry/plugin_call.hpp"

namespace netloft {

/// An integrator with its parameters.
struct IntegratorChoice {
  const IntegratorType* type = nullptr;
  const void* parameters = nullptr;
};

/// Calls an integrator. During a call, its plugin is recorded as running, so that a crash can be explained
/// (plugin_call.hpp).
class StepScheme {
 public:
  explicit StepScheme(IntegratorChoice choice) : type_(*choice.type), parameters_(choice.parameters) {}

  bool is_explicit() const { return type_.is_explicit(); }
  /// The power of h to which the error of one step is proportional.
  double order() const { return type_.integrator.order(parameters_); }
  /// Longest stable step for a motion of angular frequency omega [s]; zero: any step is stable.
  double stable_step(double omega) const {
    const PluginCall call({type_.type.c_str(), "stable_step", nullptr, CallFrame::Kind::method});
    return type_.integrator.stable_step(parameters_, omega);
  }
  bool has_limit() const { return stable_step(1) != 0; }
  int step(netloft_motion& motion) const {
    const PluginCall call({type_.type.c_str(), "step", nullptr, CallFrame::Kind::method});
    return type_.integrator.step(parameters_, &motion);
  }

 private:
  const IntegratorType& type_;
  const void* parameters_;
};

}  // namespace netloft
