// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/diff/report_diff.hpp"

#include "io/results/figures/figure_names.hpp"
#include "io/results/text/gear_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <vector>

namespace netloft::results {

namespace {

using Out = std::back_insert_iterator<std::string>;
using Json = nlohmann::ordered_json;

std::string number(double value, const char* format) {
  return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "-";
}

void side_text(const char* which, const Result& result, Out out) {
  fmt::format_to(out, "{:<7} {}", which, result.path);
  if (!result.is_answer())
    fmt::format_to(out, ": {}; its numbers are those of the last point{}{}",
                   result.outcome.empty() ? "the run has not ended" : result.outcome,
                   result.sentence.empty() ? "" : ": ", result.sentence);
  fmt::format_to(out, "\n");
}

// Numbers of changed inputs and of changed figures that are printed without --all. With file names and a
// heading, the report then has about ten lines.
constexpr std::size_t kShownInputs = 3, kShownFigures = 12;

constexpr std::size_t kShownLetters = 100;  // printed of a value, without --all

/// Shortens a text to at most `most` bytes, without cutting a UTF-8 letter.
std::string shortened(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  std::size_t end = most;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) --end;  // within a UTF-8 letter
  return text.substr(0, end) + "...";
}

std::string change_text(const KeyChange& change, std::size_t letters) {
  if (change.after.empty()) return "without " + change.path + " = " + shortened(change.before, letters);
  if (change.before.empty()) return "with " + change.path + " = " + shortened(change.after, letters);
  return change.path + ": " + shortened(change.before, letters) + " -> " + shortened(change.after, letters);
}

void inputs_text(const ResultDiff& diff, bool all, Out out) {
  const auto changes = all ? input_changes(diff) : input_changes(diff, kShownLetters);
  const std::size_t shown = all ? changes.size() : std::min(changes.size(), kShownInputs);
  if (changes.empty())
    fmt::format_to(out, "inputs: {}\n",
                   diff.inputs.other_text ? "the same apart from comments and spaces" : "the same");
  for (std::size_t i = 0; i < shown; ++i)
    fmt::format_to(out, "{:<7} {}{}\n", i == 0 ? "inputs:" : "", changes[i],
                   i + 1 == shown && shown < changes.size()
                       ? fmt::format(" (and {} more: --all)", changes.size() - shown)
                       : "");
}

/// Returns a coordinate, or zero if it is zero up to rounding errors.
double plain(double metres) {
  // Smaller coordinates are zero [m]; no result is nearly as accurate.
  constexpr double kNothing = 1e-9;
  return std::abs(metres) < kNothing ? 0 : metres;
}

std::string move_line(const std::optional<NodeMove>& move) {
  if (!move) return "not known: the results have no nodes in common";
  std::string text = fmt::format(
      "{:.4g} m, {} node {}, from ({:.4g}, {:.4g}, {:.4g}) to ({:.4g}, {:.4g}, {:.4g})", move->distance,
      move->part, move->number, plain(move->before[0]), plain(move->before[1]), plain(move->before[2]),
      plain(move->after[0]), plain(move->after[1]), plain(move->after[2]));
  if (move->distance == 0) text = "none";
  if (move->compared < move->nodes)
    text += fmt::format(" ({} of {} nodes could be compared)", move->compared, move->nodes);
  return text;
}

/// The value of a figure before or after, in the unit that is usual in fisheries.
NamedScalar spoken_figure(const NumberDifference& d, double value, double error) {
  NamedScalar figure{.name = d.name, .unit = d.unit, .doc = "", .value = value};
  figure.solver_error = error;
  figure.mesh_error = 0;
  return in_spoken_unit(figure);
}

/// Converts the name of a number to plain words: "gear/mouth/headline_height" becomes "headline height".
std::string words_of(const std::string& name) {
  const std::string rest = name.substr(name.find('/') + 1);
  const std::string principal = principal_name(rest);
  return principal.empty() ? spoken(rest) : principal;
}

std::string figure_row(const NumberDifference& d) {
  const FigureChange change = figure_change(d);
  return fmt::format("{} {:<26} {:>18} {:>18} {:>14} {:>10}", change.exceeds ? "*" : " ", change.name,
                     change.before, change.after, change.difference, change.percent);
}

/// Writes the figures that changed, the most important first.
void figures_text(const ResultDiff& diff, bool all, Out out) {
  const std::size_t shown = all ? diff.figures.size() : std::min(diff.figures.size(), kShownFigures);
  if (shown > 0)
    fmt::format_to(out, "  {:<26} {:>18} {:>18} {:>14}\n", "figure", "before", "after", "change");
  for (std::size_t i = 0; i < shown; ++i)
    fmt::format_to(out, "{}\n", figure_row(diff.numbers[diff.figures[i]]));
  const auto is_changed = [](const auto& d) { return d.is_changed(); };
  const auto changed = static_cast<std::size_t>(std::ranges::count_if(diff.numbers, is_changed));
  if (changed == 0)
    fmt::format_to(out, "none of {} numbers changed\n", diff.numbers.size());
  else if (!all && changed > shown)
    fmt::format_to(out, "  {} more numbers changed: --all\n", changed - shown);
  if (changed > 0) fmt::format_to(out, "{}\n", errors_line(diff));
}

void row_text(const NumberDifference& d, std::size_t width, Out out) {
  fmt::format_to(out, "{} {:<{}} {:>13} {:>13} {:>12} {:>9} {:>9} {}\n", d.exceeds() ? "*" : " ", d.name,
                 width, number(d.before, "{:.6g}"), number(d.after, "{:.6g}"),
                 number(d.difference(), "{:+.4g}"), number(d.percent(), "{:+.3g} %"),
                 std::isfinite(d.error()) ? fmt::format("{:.1e}", d.error()) : "±?",
                 d.unit == "1" ? "" : d.unit);
}

/// Writes all numbers that changed, by the names that they have in the files.
void numbers_text(const std::vector<NumberDifference>& numbers, Out out) {
  const auto is_changed = [](const auto& d) { return d.is_changed(); };
  if (std::ranges::none_of(numbers, is_changed)) return;
  std::size_t width = 8;
  for (const auto& d : numbers)
    if (d.is_changed()) width = std::max(width, d.name.size());
  fmt::format_to(out, "  {:<{}} {:>13} {:>13} {:>12} {:>9} {:>9}\n", "quantity", width, "before", "after",
                 "difference", "", "error");
  for (const auto& d : numbers)
    if (d.is_changed()) row_text(d, width, out);
  fmt::format_to(out, "{} of {} numbers changed; ±?: the error of the mesh is not known\n",
                 std::ranges::count_if(numbers, is_changed), numbers.size());
}

Json side_json(const Result& result) {
  return {{"file", result.path},
          {"status", result.outcome.empty() ? Json(nullptr) : Json(result.outcome)},
          {"reason", result.sentence},
          {"version", result.origins.version}};
}

Json numbers_json(const std::vector<NumberDifference>& numbers) {
  Json rows = Json::array();
  for (const auto& d : numbers)
    rows.push_back({{"name", d.name},
                    {"unit", d.unit},
                    {"before", d.before},
                    {"after", d.after},
                    {"difference", d.difference()},
                    {"percent", d.percent()},
                    {"error_before", d.error_before},
                    {"error_after", d.error_after},
                    {"error", d.error()},
                    {"exceeds", std::isfinite(d.error()) ? Json(d.exceeds()) : Json(nullptr)}});
  return rows;
}

Json move_json(const std::optional<NodeMove>& move) {
  if (!move) return nullptr;
  return {{"distance", move->distance}, {"part", move->part},   {"node", move->number},
          {"before", move->before},     {"after", move->after}, {"compared", move->compared},
          {"nodes", move->nodes}};
}

/// The text, or null if it is empty: the result then lacks the key or file.
Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

Json keys_json(const std::vector<KeyChange>& keys) {
  Json all = Json::array();
  for (const auto& key : keys)
    all.push_back(
        {{"key", key.path}, {"before", text_or_null(key.before)}, {"after", text_or_null(key.after)}});
  return all;
}

Json files_json(const std::vector<FileDifference>& files) {
  Json all = Json::array();
  for (const auto& file : files)
    all.push_back({{"before", text_or_null(file.before)},
                   {"after", text_or_null(file.after)},
                   {"keys", keys_json(file.keys)}});
  return all;
}

Json figures_json(const ResultDiff& diff) {
  Json names = Json::array();
  for (const std::size_t i : diff.figures) names.push_back(diff.numbers[i].name);
  return names;
}

}  // namespace

std::vector<std::string> input_changes(const ResultDiff& diff, std::size_t most) {
  const InputDifferences& inputs = diff.inputs;
  std::vector<std::string> changes;
  if (!inputs.are_scenes_known)
    changes.push_back("the scenes are not known: a result does not have all of their files");
  for (const auto& key : inputs.keys) changes.push_back(change_text(key, most));
  for (const auto& option : inputs.options_before) changes.push_back("without " + option);
  for (const auto& option : inputs.options_after) changes.push_back("with " + option);
  for (const auto& file : inputs.files) {
    if (file.before.empty() || file.after.empty())
      changes.push_back(file.after.empty() ? "without the file " + file.before
                                           : "with the file " + file.after);
    else if (file.keys.empty())
      changes.push_back("another text of the file " + file.after);
    for (const auto& key : file.keys) changes.push_back(file.after + ": " + change_text(key, most));
  }
  for (const auto& plugin : inputs.plugins) changes.push_back("plugin " + plugin);
  if (inputs.other_program)
    changes.push_back("netloft " + diff.before.origins.version + " -> " + diff.after.origins.version);
  return changes;
}

FigureChange figure_change(const NumberDifference& d) {
  const auto with_unit = [](const std::string& number, const NamedScalar& figure) {
    const std::string unit = unit_text(figure.unit);
    return std::isfinite(figure.value) && !unit.empty() ? number + " " + unit : number;
  };
  const auto text_of = [&](double value, double error) {
    const NamedScalar figure = spoken_figure(d, value, error);
    return with_unit(measured(figure, "{:.5g}"), figure);
  };
  const NamedScalar difference = spoken_figure(d, d.difference(), NumberDifference::kUnknown);
  return {words_of(d.name),
          text_of(d.before, d.error_before),
          text_of(d.after, d.error_after),
          with_unit(number(difference.value, "{:+.3g}"), difference),
          number(d.percent(), "{:+.3g} %"),
          d.exceeds()};
}

std::string errors_line(const ResultDiff& diff) {
  const auto has_error = [&](std::size_t i) { return std::isfinite(diff.numbers[i].error()); };
  const auto exceeds = [&](std::size_t i) { return diff.numbers[i].exceeds(); };
  if (std::ranges::none_of(diff.figures, has_error))
    return "errors of the mesh are not known (run --error finds them), so no change is marked";
  return std::string(std::ranges::any_of(diff.figures, exceeds)
                         ? "* marks a change larger than the errors (of solver and mesh) of both results"
                         : "no change is larger than the errors (of solver and mesh) of both results") +
         "; smaller changes may be real, too, because similar meshes have similar errors";
}

std::string diff_text(const ResultDiff& diff, bool all) {
  std::string text;
  const Out out = std::back_inserter(text);
  side_text("before:", diff.before, out);
  side_text("after:", diff.after, out);
  inputs_text(diff, all, out);
  figures_text(diff, all, out);
  fmt::format_to(out, "largest move of a node: {}\n", move_line(diff.move));
  if (all) numbers_text(diff.numbers, out);
  text.pop_back();
  return text;
}

std::string diff_json(const ResultDiff& diff) {
  const InputDifferences& inputs = diff.inputs;
  const Json json = {{"status", diff.both_are_answers() ? "done" : "not converged"},
                     {"before", side_json(diff.before)},
                     {"after", side_json(diff.after)},
                     {"largest_move", move_json(diff.move)},
                     {"figures", figures_json(diff)},
                     {"quantities", numbers_json(diff.numbers)},
                     {"inputs",
                      {{"keys", inputs.are_scenes_known ? keys_json(inputs.keys) : Json(nullptr)},
                       {"options", {{"before", inputs.options_before}, {"after", inputs.options_after}}},
                       {"files", files_json(inputs.files)},
                       {"plugins", inputs.plugins},
                       {"other_program", inputs.other_program},
                       {"other_text", inputs.other_text}}}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace netloft::results
