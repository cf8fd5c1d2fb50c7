// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/conformance/checks.hpp"
#include "framework/registry/plugin_call.hpp"

namespace netloft::conformance {

/// The fixture of the checks of a solver, an integrator or a strategy: its default parameters.
class MethodBench {
 public:
  MethodBench(std::span<const netloft_parameter> table, std::size_t bytes, const ConformanceOptions& o)
      : threads_before(threads_now()),
        parameters(table, bytes, required_of(table, ParameterSampler(table, o.seed).parameters(0)), faults) {}

  Threads threads_before;
  std::vector<std::string> faults;
  std::string thrown;
  ParameterBlock parameters;

 protected:
  /// Returns the result of `call`, or `otherwise` if the plugin broke a rule of the plugin interface.
  template <class Call>
  int guarded(const std::string& type, const char* function, int otherwise, Call&& call) {
    const int result =
        call_plugin({type.c_str(), function, nullptr, CallFrame::Kind::method}, otherwise, call);
    std::string broken = take_broken_rule();
    if (broken.empty()) return result;
    thrown = std::move(broken);
    return otherwise;
  }
};

template <class Bench>
Finding method_defaults_are_allowed(Bench& b) {
  return judged(b.faults.empty() ? "" : b.faults.front());
}
template <class Bench>
Finding method_starts_no_threads(Bench& b) {
  return no_more_threads_than(b.threads_before);
}

}  // namespace netloft::conformance
