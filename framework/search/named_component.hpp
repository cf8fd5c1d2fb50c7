// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"

#include <string>

namespace netloft {

/// Whether a parameter of a strategy names a solver or another strategy (netloft/strategy.hpp).
bool names_component(const netloft_parameter& parameter);

/// Looks whether what a parameter names is there, and whether its own parameters are right, down to those
/// that name components in their turn: "auto:restarts=0;slice=100". Throws PluginRefused where a component is
/// missing, std::invalid_argument with a sentence where a value is wrong.
void check_named(const netloft_parameter& parameter, const std::string& specification, Registry& registry);

}  // namespace netloft
