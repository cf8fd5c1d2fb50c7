// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/compare/report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace netloft::studies {

namespace {

using Out = std::back_insert_iterator<std::string>;

std::string number(double value, const char* format = "{:.2e}") {
  return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "-";
}

std::size_t width_of_methods(const Comparison& c) {
  std::size_t width = 6;
  for (const auto& m : c.methods) width = std::max(width, m.method.specification.size());
  if (c.is_of_motions) width = std::max<std::size_t>(10, width - std::string_view("integrator ").size());
  return width;
}

void trial_text(const Comparison& c, const MethodResult& m, const Trial& t, std::size_t width, Out out) {
  fmt::format_to(out, "{:<{}} {:>9} {:<13} {:>10} {:>10} {:>9} {:>9} {:>7} {:>7} {:>7}\n",
                 m.method.specification, width, fmt::format("{:.0e}", t.tolerance), t.outcome(),
                 number(t.error), number(t.estimate), number(t.cpu_seconds, "{:.4f}"),
                 number(t.cpu_seconds / c.factorisation_seconds, "{:.1f}"), t.statistics.iterations,
                 t.statistics.factorisations, t.statistics.residuals);
}

void reference_text(const MethodResult& m, Out out) {
  if (!m.reference) {
    fmt::format_to(out, "{}: no reference because no other solver converged; its errors are unknown\n",
                   m.method.specification);
    return;
  }
  const ReferenceAnswer& r = *m.reference;
  fmt::format_to(
      out,
      "{}: the reference is {}, converged to {:.0e} and polished to a residual of {:.1e} N (load {:.3g} N)",
      m.method.specification, r.method.specification, r.tolerance, r.answer.residual, r.answer.load);
  if (std::isfinite(r.answer.uncertainty))
    fmt::format_to(out, ", accurate to {:.0e} m", r.answer.uncertainty);
  if (!r.independent) fmt::format_to(out, "; no other solver plugin converged");
  if (r.stability == Stability::neutral)
    fmt::format_to(out, "; the reference has a slack part whose position no force determines");
  fmt::format_to(out, "\n");
}

void other_text(const MethodResult& m, Out out) {
  if (!m.other) return;
  fmt::format_to(out, "{}: found another equilibrium than {}, up to {:.3g} m away", m.method.specification,
                 m.reference->method.specification, m.other->distance);
  if (m.other->has_energy)
    fmt::format_to(out, ", with an energy that differs by {:+.4g} J", m.other->energy_difference);
  fmt::format_to(out, "; this distance is not an error, so no error is given\n");
}

void failure_text(const MethodResult& m, Out out) {
  for (const Trial& t : m.trials)
    if (t.tried && !t.converged())
      fmt::format_to(out, "{}: {} at {:.0e}: {}\n", m.method.specification, t.outcome(), t.tolerance,
                     t.reason);
}

void solvers_text(const Comparison& c, Out out) {
  const std::size_t width = width_of_methods(c);
  fmt::format_to(
      out,
      "solver error: largest node distance to the answer of another solver [m]; estimate: the next "
      "Newton step [m]\n{:<{}} {:>9} {:<13} {:>10} {:>10} {:>9} {:>9} {:>7} {:>7} {:>7}\n",
      "method", width, "tolerance", "status", "error", "estimate", "CPU [s]", "in fact.", "steps", "fact.",
      "resid.");
  for (const auto& m : c.methods)
    for (const Trial& t : m.trials)
      if (t.tried) trial_text(c, m, t, width, out);
  if (c.factorisation_seconds > 0)
    fmt::format_to(out, "in fact.: in units of one numeric factorisation of the same tangent, {:.3g} s\n",
                   c.factorisation_seconds);
  for (const auto& m : c.methods) {
    if (m.reference || !c.is_interrupted) reference_text(m, out);
    other_text(m, out);
    failure_text(m, out);
  }
}

void path_reference_text(const MethodResult& m, Out out) {
  if (!m.reference) {
    fmt::format_to(out, "{}: no reference because no other integrator completed the motion\n",
                   m.method.name());
    return;
  }
  const ReferenceAnswer& r = *m.reference;
  fmt::format_to(out, "{}: the reference is {} at an accuracy of {:.0e}", m.method.name(), r.method.name(),
                 r.tolerance);
  if (!r.is_damped) fmt::format_to(out, ", both without the damping of materials");
  if (std::isfinite(r.answer.uncertainty))
    fmt::format_to(out, "; another integrator's path at that accuracy is {:.1e} m away from it",
                   r.answer.uncertainty);
  if (!r.independent) fmt::format_to(out, "; the reference is an integrator of the same plugin");
  fmt::format_to(out, "\n");
}

void motions_text(const Comparison& c, Out out) {
  const std::size_t width = width_of_methods(c);
  fmt::format_to(out,
                 "error: largest distance of a node at any output to the path of another integrator [m]\n"
                 "{:<{}} {:>9} {:<11} {:>10} {:>9} {:>9} {:>9} {:>9} {:>7} {:>7}\n",
                 "integrator", width, "accuracy", "status", "error", "CPU [s]", "steps", "rejected", "iter.",
                 "fact.", "resid.");
  for (const auto& m : c.methods)
    for (const Trial& t : m.trials)
      fmt::format_to(out, "{:<{}} {:>9} {:<11} {:>10} {:>9} {:>9} {:>9} {:>9} {:>7} {:>7}\n", m.method.name(),
                     width, fmt::format("{:.0e}", t.tolerance), t.outcome(), number(t.error),
                     number(t.cpu_seconds, "{:.4f}"), t.steps, t.rejected, t.statistics.iterations,
                     t.statistics.factorisations, t.statistics.residuals);
  for (const auto& m : c.methods) {
    if (!m.is_absent && (m.reference || !c.is_interrupted)) path_reference_text(m, out);
    failure_text(m, out);
  }
}

std::string trend_text(const Discretisation& d) {
  if (d.steady)
    return fmt::format("largest node distance to the limit of the meshes [m], order {:.2f} observed",
                       d.order);
  return std::string("largest node distance to the finest mesh [m]; ") +
         (std::isfinite(d.order) ? "the observed order is not steady, so nothing was extrapolated"
                                 : "there are too few meshes for an order, or they do not converge");
}

void discretisation_text(const Discretisation& d, Out out) {
  fmt::format_to(out, "discretisation error: {}\n{:>8} {:>9} {:<13} {:>10} {:>10} {:>7} {:>9}\n",
                 trend_text(d), "cells", "unknowns", "status", "error", "solver", "order", "CPU [s]");
  for (const auto& level : d.levels)
    fmt::format_to(out, "{:>8} {:>9} {:<13} {:>10} {:>10} {:>7} {:>9}\n", level.cells, level.unknowns,
                   name_of(level.trial.status), number(level.error), number(level.trial.estimate),
                   number(level.order, "{:.2f}"), number(level.trial.cpu_seconds, "{:.4f}"));
}

}  // namespace

std::string comparison_text(const Comparison& c) {
  std::string text;
  const Out out = std::back_inserter(text);
  fmt::format_to(out, "{}: {}, {} unknowns; the cheapest of {} run{} each\n", c.scene, c.mesh, c.unknowns,
                 c.repeats, c.repeats == 1 ? "" : "s");
  c.is_of_motions ? motions_text(c, out) : solvers_text(c, out);
  if (c.discretisation) discretisation_text(*c.discretisation, out);
  return text;
}

}  // namespace netloft::studies
