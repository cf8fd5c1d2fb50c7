// SPDX-License-Identifier: BSD-3-Clause
#include "io/diff/report_diff.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace netloft::io {

namespace {

using Out = std::back_insert_iterator<std::string>;
using Json = nlohmann::ordered_json;

std::string number(double value, const char* format) {
  return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "-";
}

void result_text(const char* which, const ResultSummary& result, Out out) {
  fmt::format_to(out, "{:<7} {}", which, result.path);
  if (!result.is_answer())
    fmt::format_to(out, ": {}; its numbers are those of the last point{}{}",
                   result.outcome.empty() ? "the run has not ended" : result.outcome,
                   result.sentence.empty() ? "" : ": ", result.sentence);
  fmt::format_to(out, "\n");
}

void row_text(const NumberDifference& d, std::size_t width, Out out) {
  fmt::format_to(out, "{} {:<{}} {:>13} {:>13} {:>12} {:>9} {:>9} {}\n", d.exceeds() ? "*" : " ", d.name,
                 width, number(d.before, "{:.6g}"), number(d.after, "{:.6g}"),
                 number(d.difference(), "{:+.4g}"), number(d.percent(), "{:+.3g} %"),
                 number(d.error, "{:.1e}"), d.unit == "1" ? "" : d.unit);
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
  fmt::format_to(out,
                 "{} of {} numbers changed; * marks a change larger than the known errors (solver and mesh) "
                 "of both results\n",
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
    fmt::format_to(out, "- netloft {}\n+ netloft {}\n", diff.before.version, diff.after.version);
  for (const auto& plugin : inputs.plugins) fmt::format_to(out, "  plugin {}\n", plugin);
}

Json result_json(const ResultSummary& result) {
  return {{"file", result.path},
          {"status", result.outcome.empty() ? Json(nullptr) : Json(result.outcome)},
          {"reason", result.sentence},
          {"version", result.version}};
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
  result_text("before:", diff.before, out);
  result_text("after:", diff.after, out);
  numbers_text(diff.numbers, out);
  inputs_text(diff, out);
  text.pop_back();
  return text;
}

std::string diff_json(const ResultDiff& diff) {
  const InputDifferences& inputs = diff.inputs;
  const Json json = {{"status", diff.both_are_answers() ? "done" : "not converged"},
                     {"before", result_json(diff.before)},
                     {"after", result_json(diff.after)},
                     {"quantities", numbers_json(diff.numbers)},
                     {"inputs",
                      {{"options", {{"before", inputs.options_before}, {"after", inputs.options_after}}},
                       {"files", files_json(inputs.files)},
                       {"plugins", inputs.plugins},
                       {"other_program", inputs.other_program}}}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace netloft::io
