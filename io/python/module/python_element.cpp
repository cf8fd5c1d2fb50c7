// SPDX-License-Identifier: BSD-3-Clause
#include "io/python/module/python_element.hpp"

#include "framework/conformance/conformance.hpp"
#include "framework/registry/element_data.hpp"
#include "io/python/module/module.hpp"
#include "io/python/module/opened_scene.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace netloft::python {

namespace py = pybind11;

namespace {

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Rows = std::vector<std::vector<double>>;  // [row][element]

/// All elements of one type in a scene.
struct PythonElements {
  PythonPlugin* plugin = nullptr;
  const py::function* call = nullptr;  // the callable that the plugin had when the scene was prepared
  Rows parameters, data;
};

/// Reads parameters and data of all elements.
int create_elements(netloft_create* in, void** self) {
  auto elements = std::make_unique<PythonElements>();
  elements->plugin = &plugin_of(in->parameters[0]);
  const PythonPlugin& plugin = *elements->plugin;
  elements->call = &plugin.calls.back();
  for (std::size_t p = 0; p < plugin.parameters.size(); ++p) {
    auto& row = elements->parameters.emplace_back();
    for (std::uint32_t e = 0; e < in->count; ++e)
      row.push_back(static_cast<const double*>(in->parameters[in->part[e]])[1 + p]);
  }
  for (std::size_t d = 0; d < plugin.data_rows.size(); ++d) {
    const std::uint32_t width = plugin.data_rows[d].width;
    for (std::uint32_t k = 0; k < width; ++k) {
      auto& row = elements->data.emplace_back();
      for (std::uint32_t e = 0; e < in->count; ++e) row.push_back(in->data[d][e * width + k]);
    }
  }
  *self = elements.release();
  return NETLOFT_OK;
}

void destroy_elements(void* self) { delete static_cast<PythonElements*>(self); }

/// The columns from `first` to `first` + `count` of some rows, the last one excluded.
Array columns(const Rows& rows, std::uint32_t first, std::uint32_t count) {
  Array all({static_cast<py::ssize_t>(rows.size()), static_cast<py::ssize_t>(count)});
  for (std::size_t r = 0; r < rows.size(); ++r)
    std::copy_n(rows[r].begin() + first, count, all.mutable_data(static_cast<py::ssize_t>(r), 0));
  return all;
}

Array coordinates(const netloft_tile& tile, std::uint32_t dofs) {
  Array all({static_cast<py::ssize_t>(dofs), static_cast<py::ssize_t>(tile.count)});
  for (std::uint32_t d = 0; d < dofs; ++d)
    std::copy_n(tile.x + d * NETLOFT_LANES, tile.count, all.mutable_data(static_cast<py::ssize_t>(d), 0));
  return all;
}

bool are_finite(const Array& values) {
  return std::all_of(values.data(), values.data() + values.size(), [](double v) { return std::isfinite(v); });
}

void require_size(const Array& values, std::size_t size, const char* what) {
  if (static_cast<std::size_t>(values.size()) != size)
    throw std::invalid_argument(std::string(what) + ": " + std::to_string(values.size()) +
                                " numbers instead of " + std::to_string(size));
}

/// Adds the results of the callable to the outputs of the tile.
int add_results(const py::tuple& found, std::uint32_t dofs, netloft_tile& tile) {
  const std::uint32_t n = tile.count;
  const auto energy = found[0].cast<Array>(), force = found[1].cast<Array>();
  require_size(energy, n, "energies");
  require_size(force, std::size_t{dofs} * n, "forces");
  if (!are_finite(energy) || !are_finite(force)) return NETLOFT_OUTSIDE_DOMAIN;
  for (std::uint32_t e = 0; e < n && tile.energy; ++e) tile.energy[e] += energy.data()[e];
  for (std::uint32_t d = 0; d < dofs && tile.force; ++d)
    for (std::uint32_t e = 0; e < n; ++e) tile.force[d * NETLOFT_LANES + e] += force.data()[d * n + e];
  if (!tile.tangent) return NETLOFT_OK;
  const auto tangent = found[2].cast<Array>();
  require_size(tangent, std::size_t{dofs} * dofs * n, "tangents");
  if (!are_finite(tangent)) return NETLOFT_OUTSIDE_DOMAIN;
  for (std::uint32_t r = 0, entry = 0; r < dofs; ++r)
    for (std::uint32_t c = 0; c <= r; ++c, ++entry)
      for (std::uint32_t e = 0; e < n; ++e)
        tile.tangent[entry * NETLOFT_LANES + e] += tile.cu * tangent.data()[(r * dofs + c) * n + e];
  return NETLOFT_OK;
}

int evaluate_elements(const void* self, netloft_tile* tile) {
  const auto& elements = *static_cast<const PythonElements*>(self);
  const std::uint32_t dofs = 3 * (elements.plugin->element.stencil & 0xff);
  const py::gil_scoped_acquire interpreter;
  try {
    const py::tuple found =
        (*elements.call)(coordinates(*tile, dofs), columns(elements.parameters, tile->first, tile->count),
                         columns(elements.data, tile->first, tile->count), tile->tangent != nullptr);
    return add_results(found, dofs, *tile);
  } catch (const std::exception& e) {
    if (tile->message) std::snprintf(tile->message, tile->message_size, "%s", e.what());
    return NETLOFT_ERROR;
  }
}

void describe_element(PythonPlugin& p, unsigned nodes, const std::vector<std::string>& data,
                      bool from_outside) {
  p.data = data;
  for (const std::string& name : p.data) {
    const HostDatum* known = find_datum_on(nodes, name);
    if (!known)
      throw PluginRefused("elements on " + std::to_string(nodes) + " nodes have no data \"" + name + "\"");
    p.data_rows.push_back(
        {sizeof(netloft_datum), known->width, p.data[p.data_rows.size()].c_str(), known->unit, known->doc});
  }
  p.term.size = sizeof p.term;
  p.term.name = "energy";
  p.term.doc = p.doc.c_str();
  p.term.traits = NETLOFT_CONSERVATIVE | NETLOFT_SYMMETRIC | (from_outside ? NETLOFT_FROM_OUTSIDE : 0);
  p.term.evaluate = &evaluate_elements;
  netloft_element& e = p.element;
  e.size = sizeof e;
  e.stencil = nodes;
  e.name = "energy";
  e.doc = p.doc.c_str();
  e.parameter_bytes = p.parameter_bytes();
  e.parameter_count = static_cast<std::uint32_t>(p.rows.size());
  e.parameters = p.rows.data();
  e.data = p.data_rows.data();
  e.datum_count = static_cast<std::uint32_t>(p.data_rows.size());
  e.term_count = 1;
  e.terms = &p.term;
  e.create = &create_elements;
  e.destroy = &destroy_elements;
  p.plugin.elements = &e;
  p.plugin.element_count = 1;
}

/// The checks of a component as tuples: name, "passed", "skipped" or "failed", detail, hint.
py::list check_component(const std::string& type) {
  const ElementType* element = nullptr;
  {
    const ReadingLock lock;
    element = &registry().element(type);
  }
  ConformanceReport report;
  {
    const py::gil_scoped_release others_may_run;
    report = check_element(*element, {.timings = false});
  }
  py::list all;
  for (const CheckResult& c : report.checks)
    all.append(py::make_tuple(c.name,
                              c.skipped  ? "skipped"
                              : c.passed ? "passed"
                                         : "failed",
                              c.detail, c.hint));
  return all;
}

}  // namespace

void add_element(const std::string& name, const std::string& doc, unsigned nodes,
                 std::vector<RealParameter> parameters, const std::vector<std::string>& data,
                 bool acts_from_outside, py::function energy) {
  add_python_plugin(name, doc, std::move(energy), std::move(parameters),
                    [&](PythonPlugin& p) { describe_element(p, nodes, data, acts_from_outside); });
}

void bind_elements(py::module_& module) {
  py::class_<RealParameter>(module, "RealParameter")
      .def(py::init<std::string, std::string, std::string, double, double, double, bool>(), py::arg("name"),
           py::arg("unit"), py::arg("doc"), py::arg("fallback"), py::arg("lo"), py::arg("hi"),
           py::arg("is_required"));
  module.def("add_element", &add_element, py::arg("name"), py::arg("doc"), py::arg("nodes"),
             py::arg("parameters"), py::arg("data"), py::arg("acts_from_outside"), py::arg("energy"));
  module.def("check_component", &check_component, py::arg("type"));
}

}  // namespace netloft::python
