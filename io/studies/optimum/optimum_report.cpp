// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/units/units.hpp"
#include "io/results/figures/key_figures.hpp"
#include "io/studies/optimum/scene_optimum.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace netloft::studies {

namespace {

using Json = nlohmann::ordered_json;
using Out = std::back_insert_iterator<std::string>;

constexpr double kChosen = 1e-9;  // a price above this fraction of the objective is shown

std::string shown(double value, const std::string& unit) {
  return std::isfinite(value) ? fmt::format("{:.5g}{}", value, unit.empty() || unit == "1" ? "" : " " + unit)
                              : "";
}

/// A row of the report: the value of a figure or variable before and after, and its limits. If the value is
/// at a limit, the row also has the price of this limit. Units are those in which the file states the limits.
struct Row {
  std::string name, unit;
  double before = NAN, after = NAN;
  Bounds bounds = {};
  double price = 0;  // change of the objective, in its unit, per unit of the limit
  double limit() const {
    return std::abs(after - bounds.low) < std::abs(bounds.high - after) ? bounds.low : bounds.high;
  }
};

double figure_value(const std::vector<StudyFigure>& figures, const std::string& name) {
  const auto at = std::ranges::find(figures, name, &StudyFigure::name);
  return at == figures.end() ? NAN : at->value;
}

double price_at(const std::vector<double>& prices, std::size_t k) {
  return k < prices.size() ? prices[k] : 0;
}

Row objective_row(const SceneOptimum& o) {
  const double factor = o.checked.objective_factor;
  return {o.file.objective, o.file.unit, factor * figure_value(o.before, o.file.objective),
          factor * figure_value(o.after, o.file.objective)};
}

std::vector<Row> variable_rows(const SceneOptimum& o) {
  std::vector<Row> rows;
  for (std::size_t v = 0; v < o.file.variables.size(); ++v) {
    const Variable& variable = o.file.variables[v].variable;
    const auto& best = o.found.best.parameters;
    rows.push_back({variable.name,
                    variable.unit,
                    o.checked.problem.start[v],
                    v < best.size() ? best[v] : NAN,
                    {variable.interval->low, variable.interval->high},
                    o.checked.objective_factor * price_at(o.found.parameter_prices, v)});
  }
  return rows;
}

std::vector<Row> constraint_rows(const SceneOptimum& o) {
  std::vector<Row> rows;
  for (std::size_t c = 0; c < o.file.constraints.size(); ++c) {
    const FigureLimits& limits = o.file.constraints[c];
    const std::string& own = o.checked.units[c + 1];
    std::string unit =
        formats::read_as_written(limits.at_least.empty() ? limits.at_most : limits.at_least).unit;
    if (unit.empty()) unit = own;
    const double factor = formats::to_si(formats::format(1, own), unit).value;
    const Bounds& bounds = o.checked.problem.constraints[c];
    rows.push_back({limits.figure,
                    unit,
                    factor * figure_value(o.before, limits.figure),
                    factor * figure_value(o.after, limits.figure),
                    {factor * bounds.low, factor * bounds.high},
                    o.checked.objective_factor * price_at(o.found.constraint_prices, c) / factor});
  }
  return rows;
}

/// The key figures of the scene that are neither objective nor constraint.
std::vector<Row> other_rows(const SceneOptimum& o) {
  results::Result result;
  for (const StudyFigure& f : o.before)
    (f.name.starts_with("results/") ? result.scalars : result.figures)
        .push_back(
            {.name = f.name.substr(f.name.find('/') + 1), .unit = f.unit, .doc = {}, .value = f.value});
  std::vector<Row> rows;
  for (const results::NamedScalar* key : results::key_figures(result)) {
    const bool is_scalar = results::find_scalar(result.scalars, key->name) == key;
    const std::string name = (is_scalar ? "results/" : "gear/") + key->name;
    if (std::ranges::find(o.checked.figures, name) == o.checked.figures.end())
      rows.push_back({name, key->unit, key->value, figure_value(o.after, name)});
  }
  return rows;
}

std::string limits_text(const Row& row) {
  const auto [low, high] = row.bounds;
  if (std::isfinite(low) && std::isfinite(high))
    return fmt::format("{:.5g} to {}", low, shown(high, row.unit));
  return std::isfinite(low) ? "at least " + shown(low, row.unit) : "at most " + shown(high, row.unit);
}

void write_row(const Row& row, const std::string& remark, Out out) {
  fmt::format_to(out, "  {:<40} {:>14} {:>14}   {}\n", row.name, shown(row.before, row.unit),
                 shown(row.after, row.unit), remark);
}

void write_rows(const char* title, const std::vector<Row>& rows, bool have_limits, Out out) {
  if (!rows.empty()) fmt::format_to(out, "{:<42} {:>14} {:>14}\n", title, "before", "after");
  for (const Row& row : rows) write_row(row, have_limits ? limits_text(row) : "", out);
}

void write_head(const SceneOptimum& o, Out out) {
  fmt::format_to(out, "{}: {}\n  {}\n", o.file.name, o.status(), o.found.reason);
  if (!o.trouble.empty()) fmt::format_to(out, "  {}\n", o.trouble);
  fmt::format_to(out, "  {} points, of which {} were solved now, {:.3g} s of CPU\n", o.found.history.size(),
                 o.solves, o.cpu_seconds);
  if (o.found.best.parameters.empty()) return;
  fmt::format_to(out, "  remainder of the conditions of an optimum {:.1e}, violation of constraints {:.1e}\n",
                 o.found.best.remainder, o.found.best.violation);
}

void write_prices(const SceneOptimum& o, Out out) {
  std::vector<Row> rows = constraint_rows(o);
  for (Row& row : variable_rows(o)) rows.push_back(std::move(row));
  const double size = std::abs(objective_row(o).after);
  std::string lines;
  for (const Row& row : rows)
    if (std::abs(row.price * std::max(std::abs(row.limit()), 1e-300)) > kChosen * size)
      fmt::format_to(std::back_inserter(lines), "  {:<40} {:>14} {:>+14.4g} {} per {}\n", row.name,
                     shown(row.limit(), row.unit), row.price, o.file.unit == "1" ? "" : o.file.unit,
                     row.unit.empty() || row.unit == "1" ? "unit" : row.unit);
  if (!lines.empty())
    fmt::format_to(out, "{:<42} {:>14} {:>14}\n{}", "prices", "limit", "of one more", lines);
}

void write_history(const SceneOptimum& o, Out out) {
  fmt::format_to(out, "{:<10} {:>16} {:>12} {:>12}\n", "history", "objective", "violation", "remainder");
  for (std::size_t k = 0; k < o.found.history.size(); ++k) {
    const OptimumPoint& point = o.found.history[k];
    if (point.predictions.empty()) {
      fmt::format_to(out, "  {:<8} no equilibrium: the step is shortened\n", k + 1);
      continue;
    }
    fmt::format_to(out, "  {:<8} {:>16} {:>12.1e} {:>12} {}\n", k + 1,
                   shown(o.checked.objective_factor * point.predictions[0], o.file.unit), point.violation,
                   point.is_accepted ? fmt::format("{:.1e}", point.remainder) : "",
                   point.is_accepted ? "" : "rejected");
  }
}

Json finite_json(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json rows_json(const std::vector<Row>& rows) {
  Json all = Json::array();
  for (const Row& row : rows)
    all.push_back({{"name", row.name},
                   {"unit", row.unit},
                   {"before", finite_json(row.before)},
                   {"after", finite_json(row.after)},
                   {"low", finite_json(row.bounds.low)},
                   {"high", finite_json(row.bounds.high)},
                   {"price", row.price}});
  return all;
}

Json history_json(const SceneOptimum& o) {
  Json all = Json::array();
  for (const OptimumPoint& point : o.found.history)
    all.push_back(
        {{"parameters", point.parameters},
         {"objective",
          point.predictions.empty() ? Json() : Json(o.checked.objective_factor * point.predictions[0])},
         {"violation", point.violation},
         {"accepted", point.is_accepted},
         {"remainder", finite_json(point.remainder)}});
  return all;
}

}  // namespace

std::string SceneOptimum::status() const {
  if (found.converged) return "optimal";
  if (is_interrupted) return "interrupted";
  return !found.best.parameters.empty() && !found.is_feasible ? "infeasible" : "not converged";
}

std::string optimum_text(const SceneOptimum& o) {
  std::string text;
  const Out out = std::back_inserter(text);
  write_head(o, out);
  if (!o.found.best.parameters.empty()) {
    const Row objective = objective_row(o);
    fmt::format_to(out, "{:<42} {:>14} {:>14}\n", o.file.maximise ? "maximised" : "minimised", "before",
                   "after");
    write_row(objective, fmt::format("{:+.2f} %", 100 * (objective.after / objective.before - 1)), out);
    if (o.unrounded)
      fmt::format_to(out, "  {} before variables were rounded to their steps\n",
                     shown(o.checked.objective_factor * *o.unrounded, o.file.unit));
    write_rows("constraints", constraint_rows(o), true, out);
    write_rows("variables", variable_rows(o), true, out);
    write_prices(o, out);
    write_rows("other figures", other_rows(o), false, out);
  }
  write_history(o, out);
  text.pop_back();
  return text;
}

std::string optimum_json(const SceneOptimum& o) {
  Json json{{"name", o.file.name},
            {"status", o.status()},
            {"reason", o.found.reason},
            {"trouble", o.trouble},
            {"points", o.found.history.size()},
            {"solves", o.solves},
            {"remainder", finite_json(o.found.best.remainder)},
            {"violation", o.found.best.violation}};
  json["objective"] = rows_json({objective_row(o)})[0];
  json["objective"]["unrounded"] = o.unrounded ? Json(o.checked.objective_factor * *o.unrounded) : Json();
  json["constraints"] = rows_json(constraint_rows(o));
  json["variables"] = rows_json(variable_rows(o));
  json["figures"] = rows_json(other_rows(o));
  json["history"] = history_json(o);
  json["set"] = overrides_of(o.file, o.found.best.parameters);
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

formats::LinePlot optimum_plot(const SceneOptimum& o) {
  formats::LinePlot plot{o.file.name, "solve", fmt::format("{} [{}]", o.file.objective, o.file.unit), {}};
  plot.x_scale = plot.y_scale = formats::AxisScale::linear;
  plot.hollow = "not accepted, or outside the constraints";
  formats::PlotSeries line{.name = o.file.maximise ? "maximised" : "minimised", .points = {}};
  for (std::size_t k = 0; k < o.found.history.size(); ++k) {
    const OptimumPoint& point = o.found.history[k];
    if (!point.predictions.empty())
      line.points.push_back({static_cast<double>(k + 1), o.checked.objective_factor * point.predictions[0],
                             !point.is_accepted || point.violation > OptimumOptions{}.feasibility});
  }
  plot.series.push_back(std::move(line));
  return plot;
}

}  // namespace netloft::studies
