// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <pybind11/pybind11.h>

#include <string>

namespace netloft::python {

/// Makes a callable of Python a solver named `name`, as if a plugin of that name offered it. The callable
/// gets a Problem and moves it towards balance. Its return value is ignored, because the host decides whether
/// the last point is an equilibrium. Throws PluginRefused if there is already a plugin or a solver of this
/// name.
void add_solver(const std::string& name, const std::string& doc, pybind11::function solve);

}  // namespace netloft::python
