// SPDX-License-Identifier: BSD-3-Clause
#include "io/python/module/python_solver.hpp"

#include <netloft/solver.hpp>

#include "io/python/module/module.hpp"
#include "io/python/module/python_plugin.hpp"

#include <pybind11/numpy.h>

#include <cstring>
#include <memory>

namespace netloft::python {

namespace py = pybind11;

namespace {

using Vector = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// The problem r(u) = 0 as a solver in Python sees it. It is valid only during the call of the solver.
class PythonProblem {
 public:
  explicit PythonProblem(netloft_problem& problem) : problem_(problem) {}
  void end() { is_over_ = true; }

  std::size_t size() const { return problem_.unknowns; }
  Problem& valid() {
    if (is_over_)
      throw std::runtime_error("this Problem ended when its solver returned; keep copies of its vectors");
    return problem_wrapper_;
  }
  std::span<const double> vector(const Vector& values, const char* what) const {
    if (static_cast<std::size_t>(values.size()) != size())
      throw std::invalid_argument(std::string(what) + " has " + std::to_string(values.size()) +
                                  " numbers, and the problem has " + std::to_string(size()) + " unknowns");
    return {values.data(), size()};
  }
  netloft_problem& raw() { return problem_; }

 private:
  netloft_problem& problem_;
  Problem problem_wrapper_{problem_};
  bool is_over_ = false;
};

Vector zeros(std::size_t size) {
  Vector all(static_cast<py::ssize_t>(size));
  std::fill_n(all.mutable_data(), size, 0.0);
  return all;
}

Vector current_point(PythonProblem& p) {
  const auto u = p.valid().u();
  return Vector(static_cast<py::ssize_t>(u.size()), u.data());
}

py::tuple evaluate(PythonProblem& p, const Vector& u, bool tangent) {
  Vector residual = zeros(p.size());
  double energy = 0;
  const auto at = p.vector(u, "u");
  const std::span<double> r(residual.mutable_data(), p.size());
  if (p.valid().evaluate(at, energy, r, tangent ? Matrix::exact : Matrix::none) != Evaluation::ok)
    throw std::domain_error("there are no forces at this point; shorten the step");
  return py::make_tuple(energy, residual);
}

bool factorise(PythonProblem& p, double shift, bool indefinite) {
  Problem& problem = p.valid();
  return (indefinite ? problem.factorise_indefinite(Matrix::exact, shift)
                     : problem.factorise(Matrix::exact, shift)) == Factor::ok;
}

Vector solve_with_factor(PythonProblem& p, const Vector& rhs) {
  Vector x = zeros(p.size());
  if (!p.valid().try_solve(p.vector(rhs, "the right-hand side"), {x.mutable_data(), p.size()}))
    throw std::runtime_error("there is no factor; call factorise() first, after evaluate(u, tangent=True)");
  return x;
}

Vector multiply(PythonProblem& p, const Vector& x, double shift) {
  Vector y = zeros(p.size());
  p.valid().multiply(Matrix::exact, shift, p.vector(x, "x"), {y.mutable_data(), p.size()});
  return y;
}

bool progress(PythonProblem& p, const Vector& u, double energy, const Vector& residual) {
  const bool goes_on = p.valid().progress(p.vector(u, "u"), energy, p.vector(residual, "the residual"));
  std::memcpy(p.raw().u, u.data(), p.size() * sizeof(double));
  return goes_on;
}

void say(netloft_problem& problem, const char* text) {
  if (problem.message) std::snprintf(problem.message, problem.message_size, "%s", text);
}

/// The function `solve` of all solvers in Python. The parameter identifies the solver.
int call_solver_in_python(const void* parameters, netloft_problem* problem) {
  const py::gil_scoped_acquire interpreter;
  auto seen = std::make_shared<PythonProblem>(*problem);
  int outcome = NETLOFT_STOPPED;
  try {
    plugin_of(parameters).calls.back()(seen);
  } catch (const std::exception& e) {
    keep_error(std::current_exception());
    say(*problem, e.what());
    outcome = NETLOFT_SOLVER_ERROR;
  }
  seen->end();
  return outcome;
}

}  // namespace

void add_solver(const std::string& name, const std::string& doc, py::function solve) {
  add_python_plugin(name, doc, std::move(solve), {}, [](PythonPlugin& p) {
    auto& solver = p.solver;
    solver.size = sizeof solver;
    solver.name = p.name.c_str();
    solver.doc = p.doc.c_str();
    solver.parameter_bytes = p.parameter_bytes();
    solver.parameter_count = static_cast<std::uint32_t>(p.rows.size());
    solver.parameters = p.rows.data();
    solver.solve = &call_solver_in_python;
    p.solvers = {sizeof p.solvers, 1, &solver};
  });
}

void bind_problem(py::module_& module) {
  py::class_<PythonProblem, std::shared_ptr<PythonProblem>>(
      module, "Problem", "The equations r(u) = 0 as a solver sees them; valid until the solver returns.")
      .def_property_readonly("size", &PythonProblem::size)
      .def_property_readonly("u", &current_point)
      .def("evaluate", &evaluate, py::arg("u"), py::arg("tangent") = false)
      .def("factorise", &factorise, py::arg("shift") = 0.0, py::arg("indefinite") = false)
      .def("solve", &solve_with_factor, py::arg("rhs"))
      .def("multiply", &multiply, py::arg("x"), py::arg("shift") = 0.0)
      .def("progress", &progress, py::arg("u"), py::arg("energy"), py::arg("residual"));
}

}  // namespace netloft::python
