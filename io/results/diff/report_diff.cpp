// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/diff/report_diff.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
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

// The lines of the summary name at most this many changes, because they are read at a glance.
constexpr std::size_t kShownChanges = 3;

/// Joins the first kShownChanges texts in one line, and says how many more there are.
std::string first_of(const std::vector<std::string>& all) {
  std::string text;
  for (std::size_t i = 0; i < std::min(all.size(), kShownChanges); ++i) text += (i ? "; " : "") + all[i];
  if (all.size() > kShownChanges) text += fmt::format("; and {} more", all.size() - kShownChanges);
  return text;
}

std::string trimmed(const std::string& line) {
  const auto first = line.find_first_not_of(" \t");
  return first == std::string::npos ? "" : line.substr(first);
}

/// Returns KEY of a line "KEY = value"; empty for other lines.
std::string key_of(const std::string& line) {
  const auto equals = line.find('=');
  return equals == std::string::npos || equals == 0 ? "" : line.substr(0, equals);
}

/// Adds new lines to `changes`. If a removed line has the key of a new one, the change is "key = before ->
/// after". Lines with comments do not count.
void add_line_changes(const std::vector<LineChange>& lines, std::vector<std::string>& changes) {
  const auto is_comment = [](const LineChange& line) {
    return trimmed(line.text).empty() || trimmed(line.text).starts_with("#");
  };
  std::set<const LineChange*> replaced;
  for (const auto& line : lines) {
    if (!line.is_new || is_comment(line)) continue;
    const std::string text = trimmed(line.text), key = key_of(text);
    const auto old = std::find_if(lines.begin(), lines.end(), [&](const LineChange& other) {
      return !other.is_new && !key.empty() && !replaced.contains(&other) &&
             key_of(trimmed(other.text)) == key;
    });
    if (old == lines.end()) {
      changes.push_back(text);
      continue;
    }
    replaced.insert(&*old);
    const std::string before = trimmed(old->text);
    changes.push_back(before + " -> " + trimmed(text.substr(text.find('=') + 1)));
  }
  for (const auto& line : lines)
    if (!line.is_new && !is_comment(line) && !replaced.contains(&line))
      changes.push_back("without " + trimmed(line.text));
}

/// The changes of the inputs in one line: new settings, then settings that were removed and not replaced.
std::string inputs_line(const InputDifferences& inputs) {
  std::vector<std::string> changes;
  for (const auto& option : inputs.options_after) changes.push_back(option);
  for (const auto& option : inputs.options_before) changes.push_back("without " + option);
  for (const auto& file : inputs.files) {
    if (file.before.empty() || file.after.empty())
      changes.push_back(file.after.empty() ? "without " + file.before : "with " + file.after);
    add_line_changes(file.lines, changes);
  }
  for (const auto& plugin : inputs.plugins) changes.push_back("plugin " + plugin);
  if (inputs.other_program) changes.push_back("another version of netloft");
  if (changes.empty()) return inputs.none() ? "the same" : "comments alone";
  return first_of(changes);
}

/// Returns a coordinate, with round-off around zero replaced by zero.
double plain(double metres) {
  constexpr double kNothing = 1e-9;  // [m]: far below the accuracy of any result
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

/// Whether a number describes the gear as a whole. Numbers about single parts are left to the tables.
bool is_figure(const std::string& name) {
  return name.starts_with("results/") || name.starts_with("gear/mouth/") ||
         name.starts_with("gear/ground/") || name.starts_with("gear/netting/") || name == "gear/drag/all/x" ||
         name == "gear/weight_in_water/all";
}

/// The figures that changed by more than their errors, the largest relative change first. If no errors are
/// known, all figures that changed.
std::string figures_line(const std::vector<NumberDifference>& numbers) {
  std::vector<const NumberDifference*> figures;
  bool any_error = false;
  for (const auto& d : numbers)
    if (is_figure(d.name)) any_error |= std::isfinite(d.error);
  for (const auto& d : numbers)
    if (is_figure(d.name) && (any_error ? d.exceeds() : d.is_changed())) figures.push_back(&d);
  std::stable_sort(figures.begin(), figures.end(), [](const auto* a, const auto* b) {
    return std::abs(a->percent()) > std::abs(b->percent());
  });
  std::vector<std::string> words;
  for (const auto* d : figures)
    words.push_back(fmt::format("{} {:.4g} -> {:.4g}{} ({})", d->name.substr(d->name.find('/') + 1),
                                d->before, d->after, d->unit == "1" ? "" : " " + d->unit,
                                number(d->percent(), "{:+.3g} %")));
  if (words.empty()) return any_error ? "none beyond its error" : "none";
  return first_of(words) +
         (any_error ? ""
                    : "; errors of the mesh are not known (run --error finds them), so no change is marked");
}

/// Writes three lines of summary.
void summary_text(const ResultDiff& diff, Out out) {
  fmt::format_to(out, "inputs: {}\n", inputs_line(diff.inputs));
  fmt::format_to(out, "largest move of a node: {}\n", move_line(diff.move));
  fmt::format_to(out, "figures that changed: {}\n", figures_line(diff.numbers));
}

void row_text(const NumberDifference& d, std::size_t width, Out out) {
  fmt::format_to(out, "{} {:<{}} {:>13} {:>13} {:>12} {:>9} {:>9} {}\n", d.exceeds() ? "*" : " ", d.name,
                 width, number(d.before, "{:.6g}"), number(d.after, "{:.6g}"),
                 number(d.difference(), "{:+.4g}"), number(d.percent(), "{:+.3g} %"),
                 std::isfinite(d.error) ? fmt::format("{:.1e}", d.error) : "±?", d.unit == "1" ? "" : d.unit);
}

void numbers_text(const std::vector<NumberDifference>& numbers, Out out) {
  const auto changed =
      std::count_if(numbers.begin(), numbers.end(), [](const auto& d) { return d.is_changed(); });
  if (changed == 0) {
    fmt::format_to(out, "none of {} numbers changed\n", numbers.size());
    return;
  }
  std::size_t width = 8;
  for (const auto& d : numbers)
    if (d.is_changed()) width = std::max(width, d.name.size());
  fmt::format_to(out, "  {:<{}} {:>13} {:>13} {:>12} {:>9} {:>9}\n", "quantity", width, "before", "after",
                 "difference", "", "error");
  for (const auto& d : numbers)
    if (d.is_changed()) row_text(d, width, out);
  fmt::format_to(
      out,
      "{} of {} numbers changed; * marks a change larger than the errors (of solver and mesh) of both "
      "results; ±?: the error of the mesh is not known\n",
      changed, numbers.size());
}

void file_text(const FileDifference& file, Out out) {
  if (file.after.empty() || file.before.empty()) {
    fmt::format_to(out, "{} {}, read {} only\n", file.after.empty() ? "-" : "+",
                   file.after.empty() ? file.before : file.after, file.after.empty() ? "before" : "after");
    return;
  }
  for (const auto& line : file.lines)
    fmt::format_to(out, "{} {}:{}: {}\n", line.is_new ? "+" : "-", line.is_new ? file.after : file.before,
                   line.line, line.text);
}

void inputs_text(const ResultDiff& diff, Out out) {
  const InputDifferences& inputs = diff.inputs;
  fmt::format_to(out, "{}\n", inputs.none() ? "the inputs are the same" : "inputs: - before, + after");
  for (const auto& option : inputs.options_before) fmt::format_to(out, "- {}\n", option);
  for (const auto& option : inputs.options_after) fmt::format_to(out, "+ {}\n", option);
  for (const auto& file : inputs.files) file_text(file, out);
  if (inputs.other_program)
    fmt::format_to(out, "- netloft {}\n+ netloft {}\n", diff.before.origins.version,
                   diff.after.origins.version);
  for (const auto& plugin : inputs.plugins) fmt::format_to(out, "  plugin {}\n", plugin);
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
                    {"error", d.error},
                    {"exceeds", std::isfinite(d.error) ? Json(d.exceeds()) : Json(nullptr)}});
  return rows;
}

Json move_json(const std::optional<NodeMove>& move) {
  if (!move) return nullptr;
  return {{"distance", move->distance}, {"part", move->part},   {"node", move->number},
          {"before", move->before},     {"after", move->after}, {"compared", move->compared},
          {"nodes", move->nodes}};
}

Json files_json(const std::vector<FileDifference>& files) {
  const auto path = [](const std::string& name) { return name.empty() ? Json(nullptr) : Json(name); };
  Json all = Json::array();
  for (const auto& file : files) {
    Json lines = Json::array();
    for (const auto& line : file.lines)
      lines.push_back({{"in", line.is_new ? "after" : "before"}, {"line", line.line}, {"text", line.text}});
    all.push_back({{"before", path(file.before)}, {"after", path(file.after)}, {"lines", lines}});
  }
  return all;
}

}  // namespace

std::string diff_text(const ResultDiff& diff) {
  std::string text;
  const Out out = std::back_inserter(text);
  side_text("before:", diff.before, out);
  side_text("after:", diff.after, out);
  summary_text(diff, out);
  numbers_text(diff.numbers, out);
  inputs_text(diff, out);
  text.pop_back();
  return text;
}

std::string diff_json(const ResultDiff& diff) {
  const InputDifferences& inputs = diff.inputs;
  const Json json = {{"status", diff.both_are_answers() ? "done" : "not converged"},
                     {"before", side_json(diff.before)},
                     {"after", side_json(diff.after)},
                     {"largest_move", move_json(diff.move)},
                     {"quantities", numbers_json(diff.numbers)},
                     {"inputs",
                      {{"options", {{"before", inputs.options_before}, {"after", inputs.options_after}}},
                       {"files", files_json(inputs.files)},
                       {"plugins", inputs.plugins},
                       {"other_program", inputs.other_program}}}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace netloft::results
