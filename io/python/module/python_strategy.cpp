// SPDX-License-Identifier: BSD-3-Clause
#include "io/python/module/python_strategy.hpp"

#include <netloft/strategy.hpp>

#include "io/python/module/module.hpp"
#include "io/python/module/python_plugin.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <memory>

namespace netloft::python {

namespace py = pybind11;

namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// A scene and its easier variants as a strategy in Python sees them. They are valid only during the call of
/// the strategy.
class PythonSearch {
 public:
  explicit PythonSearch(netloft_search& search) : search_(search) {}
  void end() { is_over_ = true; }
  Search& valid() {
    if (is_over_) throw std::runtime_error("this Search ended when its strategy returned");
    return search_;
  }

 private:
  Search search_;
  bool is_over_ = false;
};

Displacements displacements_from(const Numbers& u) { return {u.data(), u.data() + u.size()}; }

Numbers array_from(const Displacements& u) { return Numbers(static_cast<py::ssize_t>(u.size()), u.data()); }

/// The number of meshes. Level 0 is the mesh of the scene.
unsigned count_levels(PythonSearch& search) {
  unsigned levels = 1;
  while (levels < search.valid().levels() && search.valid().size(levels) > 0) ++levels;
  return levels;
}

/// A stage as a dict: u, ending, residual, load, energy, spent, iterations, factorisations, growing.
py::dict stage_dict(const Stage& stage) {
  static constexpr const char* kEndings[] = {"converged",   "unstable",  "not converged",
                                             "out of work", "unsettled", "interrupted"};
  py::dict all;
  all["u"] = array_from(stage.u);
  all["ending"] = kEndings[static_cast<int>(stage.ending)];
  all["residual"] = stage.residual;
  all["load"] = stage.load;
  all["energy"] = stage.energy;
  all["spent"] = stage.spent;
  all["iterations"] = stage.iterations;
  all["factorisations"] = stage.factorisations;
  all["growing"] = array_from(stage.growing);
  return all;
}

/// Solves a variant of the scene from `u` by a solver ("newton:method=classic"; empty: the solver of the
/// scene).
py::dict solve_stage(PythonSearch& search, const Numbers& u, const std::string& name,
                     const std::string& solver, unsigned level, double stiffness_cap, double compression,
                     double current, double tolerance, double work, unsigned iterations) {
  const Specification chosen = specification_of(solver);
  Ask ask;
  ask.name = name.c_str();
  ask.variant = {level, stiffness_cap, compression, current};
  ask.solver = chosen.name.empty() ? nullptr : chosen.name.c_str();
  ask.parameters = chosen.parameters.empty() ? nullptr : chosen.parameters.c_str();
  ask.tolerance = tolerance;
  ask.work = work;
  ask.iterations = iterations;
  return stage_dict(search.valid().solve(ask, displacements_from(u)));
}

int call_strategy_in_python(const void* parameters, netloft_search* search) {
  const py::gil_scoped_acquire interpreter;
  auto seen = std::make_shared<PythonSearch>(*search);
  int status = NETLOFT_OK;
  try {
    plugin_of(parameters).calls.back()(seen);
  } catch (const std::exception& e) {
    keep_error(std::current_exception());
    if (search->message) std::snprintf(search->message, search->message_size, "%s", e.what());
    status = NETLOFT_ERROR;
  }
  seen->end();
  return status;
}

}  // namespace

void add_strategy(const std::string& name, const std::string& doc, py::function run) {
  add_python_plugin(name, doc, std::move(run), {}, [](PythonPlugin& p) {
    auto& strategy = p.strategy;
    strategy.size = sizeof strategy;
    strategy.name = p.name.c_str();
    strategy.doc = p.doc.c_str();
    strategy.parameter_bytes = p.parameter_bytes();
    strategy.parameter_count = static_cast<std::uint32_t>(p.rows.size());
    strategy.parameters = p.rows.data();
    strategy.run = &call_strategy_in_python;
    p.strategies = {sizeof p.strategies, 1, &strategy};
  });
}

void bind_search(py::module_& module) {
  py::class_<PythonSearch, std::shared_ptr<PythonSearch>>(
      module, "Search",
      "A scene and its easier variants as a strategy sees them; valid until the strategy returns.")
      .def_property_readonly("start", [](PythonSearch& s) { return array_from(s.valid().start()); })
      .def_property_readonly("levels", &count_levels)
      .def_property_readonly("conservative", [](PythonSearch& s) { return s.valid().conservative(); })
      .def_property_readonly("gear_size", [](PythonSearch& s) { return s.valid().gear_size(); })
      .def_property_readonly("stiffness", [](PythonSearch& s) { return s.valid().stiffness(); })
      .def_property_readonly("load", [](PythonSearch& s) { return s.valid().load(); })
      .def_property_readonly("work_left", [](PythonSearch& s) { return s.valid().work_left(); })
      .def("solve", &solve_stage, py::arg("u"), py::kw_only(), py::arg("name") = "a stage in Python",
           py::arg("solver") = "", py::arg("level") = 0, py::arg("stiffness_cap") = 0.0,
           py::arg("compression") = 1.0, py::arg("current") = 1.0, py::arg("tolerance") = 0.0,
           py::arg("work") = 0.0, py::arg("iterations") = 0)
      .def(
          "transfer",
          [](PythonSearch& s, unsigned from, const Numbers& u, unsigned to) {
            return array_from(s.valid().transfer(from, displacements_from(u), to));
          },
          py::arg("from_level"), py::arg("u"), py::arg("to_level"))
      .def("answer", [](PythonSearch& s, const Numbers& u) { s.valid().answer(displacements_from(u)); });
  module.def("add_strategy", &add_strategy, py::arg("name"), py::arg("doc"), py::arg("run"));
}

}  // namespace netloft::python
