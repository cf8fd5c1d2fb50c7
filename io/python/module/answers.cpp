// SPDX-License-Identifier: BSD-3-Clause
#include "io/python/module/answer.hpp"
#include "io/python/module/background.hpp"
#include "io/python/module/module.hpp"
#include "io/python/module/objects.hpp"
#include "io/python/module/report_of.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace netloft::python {

namespace py = pybind11;

namespace {

using AnswerPointer = std::shared_ptr<Answer>;

py::list elements_of(const py::object& self) {
  py::list all;
  for (const PartElements& of : self.cast<const Answer&>().elements()) {
    const auto corners = static_cast<py::ssize_t>(of.corners);
    const auto rows = of.corners ? static_cast<py::ssize_t>(of.nodes.size()) / corners : 0;
    py::dict outputs;
    for (const PartOutput& output : of.outputs)
      outputs[py::str(output.name)] =
          py::make_tuple(view_of(output.values, {static_cast<py::ssize_t>(output.values.size())}, self),
                         output.unit, output.doc);
    all.append(py::make_tuple(of.part, of.type, view_of(of.nodes, {rows, corners}, self), outputs));
  }
  return all;
}

py::tuple tangent_of(Answer& answer) {
  const TangentMatrix K = answer.tangent();
  return py::make_tuple(copy_of(K.values), copy_of(K.pattern.row), copy_of(K.pattern.column_start),
                        K.pattern.symmetric);
}

/// The derivatives of the figures: (figures, [(path, value, unit, why_not, per_unit, depends_on_step)]).
py::tuple sensitivities_of(Answer& answer, const std::vector<std::string>& paths, bool check) {
  const auto found = in_background<studies::Sensitivities>(
      [&](const std::atomic<bool>& flag) { return answer.sensitivities(paths, check, flag); });
  py::list effects;
  for (const studies::NumberEffect& effect : found.effects) {
    py::list marks;
    if (!effect.by_long_step.empty())
      for (std::size_t f = 0; f < found.figures.size(); ++f)
        marks.append(studies::depends_on_step(found, effect, f));
    effects.append(py::make_tuple(effect.number.path, effect.number.value, effect.number.unit, effect.why_not,
                                  copy_of(effect.per_unit), marks));
  }
  return py::make_tuple(number_list(found.figures), effects);
}

py::array points_of(const py::object& self) {
  const auto& points = self.cast<const Answer&>().points();
  return view_of(points, {static_cast<py::ssize_t>(points.size() / 3), 3}, self);
}

py::array displacements_of(const py::object& self) {
  const auto& u = self.cast<const Answer&>().solution().u;
  return view_of(u, {static_cast<py::ssize_t>(u.size())}, self);
}

py::array residual_at(Answer& answer, const std::vector<double>& u) {
  std::vector<double> residual;
  {
    const py::gil_scoped_release others_may_run;
    residual = answer.residual(u);
  }
  return copy_of(residual);
}

py::array solved_by(Answer& answer, const std::vector<double>& b, bool transposed) {
  std::vector<double> found;
  {
    const py::gil_scoped_release others_may_run;
    found = answer.solve(b, transposed);
  }
  return copy_of(found);
}

/// The exception that the solver or strategy in Python raised; None if there was none, or if it came from
/// C++. In the second case, the reason of the answer names it.
py::object raised_by(const Answer& answer) {
  try {
    if (answer.raised()) std::rethrow_exception(answer.raised());
  } catch (py::error_already_set& e) {
    return e.value();
  } catch (const std::exception&) {
    return py::none();
  }
  return py::none();
}

}  // namespace

void bind_answers(py::module_& module) {
  py::class_<Answer, AnswerPointer> answers(module, "Answer");
  answers.def_property_readonly("points", &points_of)
      .def_property_readonly("u", &displacements_of)
      .def_property_readonly("raised", &raised_by)
      .def("elements", &elements_of)
      .def("residual", &residual_at, py::arg("u"))
      .def("tangent", &tangent_of)
      .def("solve", &solved_by, py::arg("b"), py::arg("transposed"))
      .def("sensitivities", &sensitivities_of, py::arg("paths"), py::arg("check"))
      .def("write", &Answer::write, py::arg("path"), py::call_guard<py::gil_scoped_release>());
  add_report(answers, [](const Answer& a) -> const results::Result& { return a.result(); });
}

}  // namespace netloft::python
