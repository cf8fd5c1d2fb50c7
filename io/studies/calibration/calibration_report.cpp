// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/calibration/calibration.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace netloft::studies {

namespace {

using Json = nlohmann::ordered_json;
using Out = std::back_insert_iterator<std::string>;

// Limits for warnings. If two parameters have a correlation above kInseparable, the measurements determine
// only a combination of both. If the deviation of a parameter exceeds kUnknown times its prior deviation, the
// measurements do not determine this parameter.
constexpr double kInseparable = 0.95, kUnknown = 0.9;

/// A warning about a strong correlation.
std::string pair_text(const Calibration& c, std::size_t j, std::size_t k) {
  return fmt::format("{} and {} cannot be told apart by these measurements: correlation {:.2f}",
                     c.file.variables[j].variable.name, c.file.variables[k].variable.name,
                     c.fit.correlations[j][k]);
}

std::vector<std::string> warnings(const Calibration& c) {
  std::vector<std::string> all;
  for (std::size_t j = 0; j < c.fit.parameters.size(); ++j) {
    const CalibrationVariable& v = c.file.variables[j];
    if (c.fit.at_end[j])
      all.push_back(v.variable.name +
                    " is at the end of its range, and the measurements would move it beyond");
    if (c.fit.deviations[j] > kUnknown * v.prior_deviation())
      all.push_back("these measurements say little about " + v.variable.name +
                    ": its deviation is nearly that of its prior");
    for (std::size_t k = 0; k < j; ++k)
      if (std::abs(c.fit.correlations[j][k]) > kInseparable) all.push_back(pair_text(c, k, j));
  }
  for (const auto& scene : c.unstable)
    all.push_back(scene + ": its equilibrium is not stable; `netloft run` says where");
  return all;
}

std::size_t count_fitted(const Calibration& c) {
  std::size_t count = 0;
  for (const auto& m : c.file.measured) count += !m.is_held_back;
  return count;
}

const char* status_of(const Calibration& c) {
  return c.fit.converged ? "calibrated" : c.is_interrupted ? "interrupted" : "not converged";
}

void head_text(const Calibration& c, Out out) {
  fmt::format_to(out, "{}: {}\n  {}\n", c.file.name, status_of(c), c.fit.reason);
  if (!c.trouble.empty() && !c.is_interrupted) fmt::format_to(out, "  {}\n", c.trouble);
  fmt::format_to(out, "  {} steps, {} solves of {} scenes, {:.3g} s of CPU\n", c.fit.steps, c.solves,
                 c.file.scenes.size(), c.cpu_seconds);
  if (c.fit.parameters.empty()) return;
  fmt::format_to(out, "  misfit {:.3g} of {} fitted rows, {:.3g} of {} priors, in squared deviations\n",
                 c.fit.misfit, count_fitted(c), c.fit.prior_misfit, c.file.variables.size());
  for (const auto& sentence : warnings(c)) fmt::format_to(out, "  warning: {}\n", sentence);
}

std::string scenes_text(const Calibration& c, const CalibrationVariable& v) {
  std::string text;
  if (v.is_shared) return text;
  for (const std::size_t s : v.scenes) text += (text.empty() ? "of " : ", ") + c.file.scenes[s].name;
  return text;
}

void variables_text(const Calibration& c, Out out) {
  fmt::format_to(out, "{:<24} {:>22} {:>22}   unit   ± deviations\n", "variables", "before", "after");
  for (std::size_t j = 0; j < c.fit.parameters.size(); ++j) {
    const CalibrationVariable& v = c.file.variables[j];
    fmt::format_to(out, "  {:<22} {:>11.5g} ± {:<8.2g} {:>11.5g} ± {:<8.2g}   {:<6} {}\n", v.variable.name,
                   v.prior_mean(), v.prior_deviation(), c.fit.parameters[j], c.fit.deviations[j],
                   v.variable.unit, scenes_text(c, v));
  }
}

/// Writes the correlations of the variables that all scenes share.
void correlations_text(const Calibration& c, Out out) {
  std::vector<std::size_t> shared;
  for (std::size_t j = 0; j < c.fit.parameters.size(); ++j)
    if (c.file.variables[j].is_shared) shared.push_back(j);
  if (shared.size() < 2) return;
  fmt::format_to(out, "correlations\n");
  for (std::size_t j = 1; j < shared.size(); ++j) {
    fmt::format_to(out, "  {:<22}", c.file.variables[shared[j]].variable.name);
    for (std::size_t k = 0; k < j; ++k)
      fmt::format_to(out, " {:>6.2f} {:<16}", c.fit.correlations[shared[j]][shared[k]],
                     c.file.variables[shared[k]].variable.name);
    fmt::format_to(out, "\n");
  }
}

/// Half width of the prediction band for a new measurement.
double band(const Calibration& c, std::size_t row) {
  return c.width() * std::hypot(c.fit.model_deviations[row], c.measured[c.order[row]].deviation);
}

void row_text(const Calibration& c, std::size_t row, Out out) {
  const MeasuredFigure& m = c.file.measured[c.order[row]];
  const Measurement& y = c.measured[c.order[row]];
  const double off = c.fit.predictions[row] - y.value;
  fmt::format_to(out, "  {:<12} {:<36} {:>10.5g} ± {:<8.2g} {:>10.5g} ± {:<8.2g} {:>+7.1f} % {}{}\n",
                 c.file.scenes[m.scene].name, m.figure, y.value, y.deviation, c.fit.predictions[row],
                 band(c, row), 100 * off / std::abs(y.value),
                 c.units[c.order[row]] == "1" ? "" : c.units[c.order[row]],
                 std::abs(off) > band(c, row) ? "   outside its band" : "");
}

void rows_text(const Calibration& c, Out out) {
  const std::size_t fitted = count_fitted(c);
  for (const bool held_back : {false, true}) {
    const std::size_t first = held_back ? fitted : 0, end = held_back ? c.order.size() : fitted;
    if (first == end) continue;
    fmt::format_to(out, "{:<50} {:>21} {:>21}\n", held_back ? "held back, only predicted" : "fitted",
                   "measured ± deviation", fmt::format("model ± {:.0f} % band", 100 * c.file.confidence));
    for (std::size_t row = first; row < end; ++row) row_text(c, row, out);
  }
}

void settings_text(const Calibration& c, Out out) {
  fmt::format_to(out, "the calibrated scenes\n");
  for (std::size_t s = 0; s < c.file.scenes.size(); ++s) {
    fmt::format_to(out, "  netloft run {}", c.file.scenes[s].file);
    for (const auto& word : overrides_of(c.file, s, c.fit.parameters))
      fmt::format_to(out, " --set \"{}\"", word);
    fmt::format_to(out, "\n");
  }
}

Json variables_json(const Calibration& c) {
  Json all = Json::array();
  for (std::size_t j = 0; j < c.fit.parameters.size(); ++j) {
    const CalibrationVariable& v = c.file.variables[j];
    const double half = c.width() * c.fit.deviations[j], mean = c.fit.parameters[j];
    const auto& [low, high] = *v.variable.interval;
    all.push_back({{"name", v.variable.name},
                   {"unit", v.variable.unit},
                   {"prior", {{"mean", v.prior_mean()}, {"deviation", v.prior_deviation()}}},
                   {"mean", mean},
                   {"deviation", c.fit.deviations[j]},
                   {"interval", {std::max(low, mean - half), std::min(high, mean + half)}},
                   {"at_end", bool(c.fit.at_end[j])}});
  }
  return all;
}

Json rows_json(const Calibration& c) {
  Json all = Json::array();
  for (std::size_t row = 0; row < c.fit.predictions.size(); ++row) {
    const MeasuredFigure& m = c.file.measured[c.order[row]];
    const Measurement& y = c.measured[c.order[row]];
    all.push_back({{"scene", c.file.scenes[m.scene].name},
                   {"figure", m.figure},
                   {"unit", c.units[c.order[row]]},
                   {"held_back", m.is_held_back},
                   {"value", y.value},
                   {"deviation", y.deviation},
                   {"model", c.fit.predictions[row]},
                   {"model_deviation", c.fit.model_deviations[row]},
                   {"band", {c.fit.predictions[row] - band(c, row), c.fit.predictions[row] + band(c, row)}}});
  }
  return all;
}

Json settings_json(const Calibration& c) {
  Json all = Json::object();
  for (std::size_t s = 0; s < c.file.scenes.size() && !c.fit.parameters.empty(); ++s)
    all[c.file.scenes[s].name] = {{"scene", c.file.scenes[s].file},
                                  {"set", overrides_of(c.file, s, c.fit.parameters)}};
  return all;
}

}  // namespace

std::string calibration_text(const Calibration& c) {
  std::string text;
  const Out out = std::back_inserter(text);
  head_text(c, out);
  if (!c.fit.parameters.empty()) {
    variables_text(c, out);
    correlations_text(c, out);
    rows_text(c, out);
    settings_text(c, out);
  }
  text.pop_back();
  return text;
}

std::string calibration_json(const Calibration& c) {
  const Json json = {{"name", c.file.name},
                     {"status", c.fit.converged ? "converged" : status_of(c)},
                     {"reason", c.fit.reason},
                     {"trouble", c.trouble},
                     {"confidence", c.file.confidence},
                     {"steps", c.fit.steps},
                     {"solves", c.solves},
                     {"cpu_seconds", c.cpu_seconds},
                     {"misfit", c.fit.misfit},
                     {"prior_misfit", c.fit.prior_misfit},
                     {"warnings", c.fit.parameters.empty() ? std::vector<std::string>{} : warnings(c)},
                     {"variables", variables_json(c)},
                     {"correlations", c.fit.correlations},
                     {"rows", rows_json(c)},
                     {"scenes", settings_json(c)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace netloft::studies
