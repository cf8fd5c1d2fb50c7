// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/diagnostics.hpp"
#include "io/formats/toml/value.hpp"
#include "io/results/figures/result.hpp"
#include "io/studies/sensitivity/sensitivity.hpp"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <vector>

namespace netloft::python {

/// Converts a value of a scene file to dict, list, str, int, float or bool.
pybind11::object value_object(const formats::Value& value);

/// Each message as a dict: severity, where, line, column, message, hint.
pybind11::list message_list(const formats::Diagnostics& diagnostics);

/// Each number as a tuple: name, value, unit, doc, solver_error, mesh_error, least, largest.
pybind11::list number_list(const std::vector<results::NamedScalar>& numbers);

/// Each number as a tuple: path, value, unit, doc.
pybind11::list scene_number_list(const std::vector<studies::SceneNumber>& numbers);

/// A read-only array that uses the memory of `values` and keeps `owner` alive.
template <class T>
pybind11::array view_of(const std::vector<T>& values, std::vector<pybind11::ssize_t> shape,
                        const pybind11::object& owner) {
  pybind11::array_t<T> all(std::move(shape), values.data(), owner);
  all.attr("flags").attr("writeable") = false;
  return all;
}

/// An array with copies of `values`.
template <class T>
pybind11::array copy_of(const std::vector<T>& values) {
  return pybind11::array_t<T>(static_cast<pybind11::ssize_t>(values.size()), values.data());
}

}  // namespace netloft::python
