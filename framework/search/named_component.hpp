// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"

#include <string>

namespace netloft {

/// Whether a parameter of a strategy names a solver or another strategy (netloft/strategy.hpp).
bool names_component(const netloft_parameter& parameter);

/// Checks that the component named by a parameter exists and that its own parameters are valid, such as
/// "auto:restarts=0;slice=100". If one of these parameters names a component, that component is checked, too.
/// Throws PluginRefused if a component is missing, std::invalid_argument with a sentence if a value is
/// invalid.
void check_named(const netloft_parameter& parameter, const std::string& specification, Registry& registry);

}  // namespace netloft
