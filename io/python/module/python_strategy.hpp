// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <pybind11/pybind11.h>

#include <string>

namespace netloft::python {

/// Makes a callable of Python a strategy named `name`. The callable gets a Search, and reports equilibria by
/// Search.answer(). Throws PluginRefused if there is already a plugin of this name.
void add_strategy(const std::string& name, const std::string& doc, pybind11::function run);

}  // namespace netloft::python
