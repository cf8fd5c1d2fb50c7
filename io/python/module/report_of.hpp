// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/python/module/objects.hpp"
#include "io/results/text/result_text.hpp"

#include <pybind11/stl.h>

#include <string>
#include <vector>

namespace netloft::python {

/// Adds to a class of the module the properties that all results have. `result_of` is a function from an
/// object of the class to its results::Result.
template <class Class, class ResultOf>
void add_report(Class& of, ResultOf result_of) {
  using Object = typename Class::type;
  of.def_property_readonly("status", [=](const Object& o) { return result_of(o).outcome; })
      .def_property_readonly("stability", [=](const Object& o) { return result_of(o).stability; })
      .def_property_readonly("reason", [=](const Object& o) { return result_of(o).sentence; })
      .def_property_readonly("at_fault", [=](const Object& o) { return result_of(o).at_fault; })
      .def_property_readonly("warnings", [=](const Object& o) { return result_of(o).warnings; })
      .def("figures", [=](const Object& o) { return number_list(studies::all_figures(result_of(o))); })
      .def("key_figures",
           [=](const Object& o) {
             std::vector<std::string> names;
             const auto all = studies::all_figures(result_of(o));
             for (const std::size_t f : studies::chosen_figures(result_of(o), {}))
               names.push_back(all[f].name);
             return names;
           })
      .def("json", [=](const Object& o) { return results::result_json(result_of(o)); })
      .def("text", [=](const Object& o) { return results::result_text(result_of(o)); });
}

}  // namespace netloft::python
