// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/parameters/parameter_values.hpp"
#include "framework/registry/registry.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace netloft {

/// Whether a parameter of a strategy names a solver or another strategy (netloft/strategy.hpp).
bool names_component(const netloft_parameter& parameter);

/// Parameters that a user gives for components, by their types. They override the parameters in a
/// Specification (netloft/strategy.hpp), also if one component calls another.
using GivenValues = std::map<std::string, Values>;

/// Checks the component that a parameter names, such as "auto:restarts=0;slice=100": the component must
/// exist, and its own parameters must be valid. If one of them names another component, that component is
/// checked, too. `callers` are the types of the strategies that name this component, directly or not; none of
/// them may be named again. Throws PluginRefused if a component is missing, std::invalid_argument with a
/// sentence if a value is invalid.
void check_named(const netloft_parameter& parameter, const std::string& specification, Registry& registry,
                 const GivenValues& given = {}, std::set<std::string> callers = {});

/// All strategies that a strategy names in its parameters, directly or through the parameters of a named
/// strategy. `values` are the parameters of `strategy` itself; names and values have been checked.
std::vector<const StrategyType*> strategies_named_by(const StrategyType& strategy, const Values& values,
                                                     Registry& registry, const GivenValues& given);

}  // namespace netloft
