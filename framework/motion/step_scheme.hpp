// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/descriptors.hpp"
#include "framework/registry/plugin_call.hpp"

#include <cstdio>

namespace netloft {

struct IntegratorChoice {
  const IntegratorType* type = nullptr;
  const void* parameters = nullptr;
};

/// Calls an integrator. During a call, the integrator's plugin is recorded as running (plugin_call.hpp), so
/// that the message about a crash can name it.
class StepScheme {
 public:
  explicit StepScheme(IntegratorChoice choice) : type_(*choice.type), parameters_(choice.parameters) {}

  bool is_explicit() const { return type_.is_explicit(); }
  /// The power of h to which the error of one step is proportional.
  double order() const {
    return call_plugin(frame("order"), 1.0, [&] { return type_.integrator.order(parameters_); });
  }
  /// Longest stable step for a motion of angular frequency omega [s]; zero: any step is stable.
  double stable_step(double omega) const {
    return call_plugin(frame("stable_step"), 0.0,
                       [&] { return type_.integrator.stable_step(parameters_, omega); });
  }
  bool has_limit() const { return stable_step(1) != 0; }
  /// Takes a step. Returns OK, OUTSIDE_DOMAIN or ERROR. If the plugin breaks a rule of the plugin interface,
  /// here or in an earlier call of a function without a status, the result is ERROR and the message says so.
  int step(netloft_motion& motion) const {
    netloft_motion seen = motion;
    const int status = call_plugin(frame("step"), int{NETLOFT_ERROR},
                                   [&] { return type_.integrator.step(parameters_, &seen); });
    if (take_broken_rule({motion.message, motion.message_size})) return NETLOFT_ERROR;
    if (status == NETLOFT_OK || status == NETLOFT_OUTSIDE_DOMAIN || status == NETLOFT_ERROR) return status;
    std::snprintf(motion.message, motion.message_size, "%s, step returned %d, which is no status",
                  type_.type.c_str(), status);
    return NETLOFT_ERROR;
  }
  const std::string& name() const { return type_.type; }

 private:
  CallFrame frame(const char* what) const {
    return {type_.type.c_str(), what, nullptr, CallFrame::Kind::method};
  }
  const IntegratorType& type_;
  const void* parameters_;
};

}  // namespace netloft
