// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/ext/solver.h>
#include <netloft/ext/strategy.h>
#include <netloft/plugin.h>

#include <pybind11/pybind11.h>

#include <deque>
#include <exception>
#include <functional>
#include <string>
#include <vector>

namespace netloft::python {

/// A real parameter of a component that is written in Python.
struct RealParameter {
  std::string name, unit, doc;
  double fallback = 0, lo = 0, hi = 0;
  bool is_required = false;
  bool operator==(const RealParameter&) const = default;
};

/// A plugin with one solver, strategy or element that is a callable of Python. It lives as long as the
/// process, as plugins do. The first parameter of its component is the number of the plugin. All these
/// plugins share the functions of the plugin interface, which find the callable by this number. Further
/// parameters are real numbers.
struct PythonPlugin {
  std::string name, doc;
  std::deque<pybind11::function> calls;  // the last callable is in use; earlier ones were replaced
  std::vector<RealParameter> parameters;
  std::vector<std::string> data;  // names of the data of an element

  std::vector<netloft_parameter> rows;
  std::vector<netloft_datum> data_rows;
  netloft_term term{};
  netloft_element element{};
  netloft_solver solver{};
  netloft_solvers solvers{};
  netloft_strategy strategy{};
  netloft_strategies strategies{};
  netloft_plugin plugin{};

  std::uint32_t parameter_bytes() const { return static_cast<std::uint32_t>(8 * rows.size()); }
};

/// Makes a plugin and opens it. `describe` describes its component. If there is already a callable of this
/// name with the same description (except for sentences), the new one replaces it in scenes that are solved
/// from then on. Throws PluginRefused if another plugin has that name, or if the description is wrong.
void add_python_plugin(const std::string& name, const std::string& doc, pybind11::function call,
                       std::vector<RealParameter> parameters,
                       const std::function<void(PythonPlugin&)>& describe);

/// keep_error() stores an exception that a component in Python raised in this thread, which runs the search
/// that called the component; take_error() returns the exception and removes it. nullptr means none.
void keep_error(std::exception_ptr error);
std::exception_ptr take_error();

/// The plugin to which the parameters of a component belong.
PythonPlugin& plugin_of(const void* parameters);

}  // namespace netloft::python
