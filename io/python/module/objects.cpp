// SPDX-License-Identifier: BSD-3-Clause
#include "io/python/module/objects.hpp"

#include <pybind11/stl.h>

#include <type_traits>
#include <variant>

namespace netloft::python {

namespace py = pybind11;

namespace {

py::object table_object(const formats::Table& table) {
  py::dict all;
  for (const formats::Member& member : table.members) all[py::str(member.key)] = value_object(member.value);
  return all;
}

py::object array_object(const formats::Array& array) {
  py::list all;
  for (const formats::Value& item : array.items) all.append(value_object(item));
  return all;
}

py::tuple number_tuple(const results::NamedScalar& s) {
  return py::make_tuple(s.name, s.value, s.unit, s.doc, s.solver_error, s.mesh_error, s.least, s.largest);
}

}  // namespace

py::object value_object(const formats::Value& value) {
  return std::visit(
      [](const auto& data) -> py::object {
        using Data = std::decay_t<decltype(data)>;
        if constexpr (std::is_same_v<Data, formats::Table>)
          return table_object(data);
        else if constexpr (std::is_same_v<Data, formats::Array>)
          return array_object(data);
        else if constexpr (std::is_same_v<Data, formats::Date>)
          return py::str(data.text);
        else
          return py::cast(data);
      },
      value.data);
}

py::list message_list(const formats::Diagnostics& diagnostics) {
  py::list all;
  for (const formats::Diagnostic& d : diagnostics.sorted()) {
    py::dict message;
    message["severity"] = d.severity == formats::Severity::error ? "error" : "warning";
    message["where"] = diagnostics.where(d.place);
    message["line"] = d.place.line;
    message["column"] = d.place.column;
    message["message"] = d.message;
    message["hint"] = d.hint;
    all.append(message);
  }
  return all;
}

py::list number_list(const std::vector<results::NamedScalar>& numbers) {
  py::list all;
  for (const auto& s : numbers) all.append(number_tuple(s));
  return all;
}

py::list scene_number_list(const std::vector<studies::SceneNumber>& numbers) {
  py::list all;
  for (const auto& n : numbers) all.append(py::make_tuple(n.path, n.value, n.unit, n.doc));
  return all;
}

}  // namespace netloft::python
