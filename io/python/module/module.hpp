// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <pybind11/pybind11.h>

namespace netloft::python {

// Each function adds its classes and functions to the module.
void bind_scenes(pybind11::module_& module);
void bind_answers(pybind11::module_& module);
void bind_stored(pybind11::module_& module);
void bind_problem(pybind11::module_& module);
void bind_search(pybind11::module_& module);
void bind_elements(pybind11::module_& module);
void bind_searches(pybind11::module_& module);

}  // namespace netloft::python
