// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/files/whole_file.hpp"
#include "io/program/commands/studies.hpp"
#include "io/program/session/memory_room.hpp"
#include "io/program/session/print.hpp"
#include "io/program/session/replaced_file.hpp"
#include "io/program/session/session.hpp"
#include "io/program/session/watchdog.hpp"
#include "io/studies/sweep/scope.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <stdexcept>

namespace netloft::program {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kMostNumbers = 1000;

/// The numbers of "20:200:7"; empty if the text has another form.
std::vector<double> numbers_in(const std::string& text) {
  std::vector<double> numbers;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ':');) {
    const char* end = part.data() + part.size();
    double number = 0;
    const auto [rest, error] = std::from_chars(part.data(), end, number);
    if (error != std::errc{} || rest != end || !std::isfinite(number)) return {};
    numbers.push_back(number);
  }
  return numbers;
}

/// Reads two numbers and, if `may_count`, optionally a third one.
std::vector<double> read_numbers(const char* flag, const std::string& text, bool may_count) {
  const auto numbers = numbers_in(text);
  if (numbers.size() != 2 && !(may_count && numbers.size() == 3))
    throw UsageError{fmt::format("{} = {} is not understood; LO:HI{} is expected", flag, text,
                                 may_count ? " or LO:HI:N" : "")};
  if (!(numbers[0] <= numbers[1]))
    throw UsageError{fmt::format("{} = {}: the first number is above the second", flag, text)};
  return numbers;
}

studies::Interval read_interval(const char* flag, const std::string& text) {
  const auto numbers = read_numbers(flag, text, false);
  return {numbers[0], numbers[1]};
}

/// Evenly spaced values from the first number of the text to the second. Their count is the third number or,
/// if there is none, `number`.
std::vector<double> read_range(const char* flag, const std::string& text, double number) {
  const auto said = read_numbers(flag, text, true);
  if (said.size() == 3) number = said[2];
  if (!(said[0] > 0))
    throw UsageError{fmt::format("{} = {}: the smaller number must be above 0", flag, text)};
  if (!(number >= 2) || number > kMostNumbers || number != std::floor(number))
    throw UsageError{
        fmt::format("{} = {}: the number of values must be whole, from 2 to {}", flag, text, kMostNumbers)};
  std::vector<double> range;
  for (double i = 0; i < number; ++i) range.push_back(said[0] + (said[1] - said[0]) * i / (number - 1));
  return range;
}

studies::ScopeRequest request_of(const ScopeOptions& o) {
  studies::ScopeRequest request;
  request.depths = read_range("--depth", o.depth, 7);
  request.scopes = read_range("--warp", o.warp, 13);
  request.heel = read_interval("--heel", o.heel);
  if (!o.spread.empty()) request.spread = read_interval("--spread", o.spread);
  return request;
}

/// A number with `digits` digits, or "-" if it is not finite.
std::string number(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : "-";
}

/// A sentence that says how many warp lengths have no result, and why the first of them has none; empty if
/// every length has a result.
std::string missing_text(const studies::ScopeRow& row) {
  const auto lacks = [](const studies::ScopePoint& p) { return !p.why_not.empty(); };
  const auto first = std::ranges::find_if(row.points, lacks);
  if (first == row.points.end()) return "";
  return fmt::format("  depth {} m: {} of {} lengths have no stable equilibrium; at {} m: {}\n",
                     number(row.depth, 1), std::ranges::count_if(row.points, lacks), row.points.size(),
                     number(first->warp, 1), first->why_not);
}

bool is_whole(const studies::ScopeRow& row, const studies::ScopeRequest& request) {
  return row.points.size() == request.scopes.size();
}

std::string text_of(const std::vector<studies::ScopeRow>& rows, const studies::ScopeRequest& request) {
  std::string text =
      fmt::format("{:>10}{:>11}{:>9}{:>11}{:>9}{:>13}{:>10}{:>13}{:>11}\n", "depth [m]", "from [m]", "to [m]",
                  "warp [m]", "heel [°]", "boards [m]", "wing [m]", "headline [m]", "pull [kN]");
  for (const studies::ScopeRow& row : rows) {
    text += fmt::format("{:>9}", number(row.depth, 1));
    if (!row.chosen) {
      text += is_whole(row, request)
                  ? std::string("  at none of these lengths do the boards have the wanted heel and spread\n")
                  : fmt::format("  interrupted after {} of {} lengths\n", row.points.size(),
                                request.scopes.size());
      continue;
    }
    const studies::ScopePoint& p = row.points[*row.chosen];
    text += fmt::format("{:>10}{:>10}{:>10}{:>9}{:>12}{:>10}{:>12}{:>11}\n", number(row.warp->low, 1),
                        number(row.warp->high, 1), number(p.warp, 1), number(p.heel, 2), number(p.spread, 2),
                        number(p.wing, 2), number(p.headline, 2), number(1e-3 * p.pull, 2));
  }
  for (const studies::ScopeRow& row : rows) {
    text += missing_text(row);
    for (const auto& event : row.events) text += "  " + event + "\n";
  }
  return text;
}

Json json_of(const studies::ScopePoint& p) {
  return {{"warp", p.warp},
          {"heel", p.heel},
          {"spread", p.spread},
          {"wing", p.wing},
          {"headline", p.headline},
          {"pull", p.pull},
          {"why_not", p.why_not.empty() ? Json() : Json(p.why_not)}};
}

std::string json_of(const std::vector<studies::ScopeRow>& rows, const char* status) {
  Json all = Json::array();
  for (const studies::ScopeRow& row : rows) {
    Json points = Json::array();
    for (const studies::ScopePoint& p : row.points) points.push_back(json_of(p));
    all.push_back({{"depth", row.depth},
                   {"warp", row.warp ? Json{row.warp->low, row.warp->high} : Json()},
                   {"chosen", row.chosen ? json_of(row.points[*row.chosen]) : Json()},
                   {"points", std::move(points)},
                   {"events", row.events}});
  }
  return Json{{"status", status}, {"rows", std::move(all)}}.dump(2, ' ', false,
                                                                 Json::error_handler_t::replace);
}

bool is_page(const std::string& file) { return file.ends_with(".html"); }

bool has_found_all(const std::vector<studies::ScopeRow>& rows) {
  return std::ranges::all_of(rows, [](const studies::ScopeRow& row) {
    return std::ranges::any_of(row.points,
                               [](const studies::ScopePoint& p) { return std::isfinite(p.heel); });
  });
}

void require_lengths_given(const scenes::LoadedScene& loaded) {
  if (loaded.analysis.kind == AnalysisKind::dynamics)
    throw UsageError{"scope compares equilibria, but this scene is a motion; add --set analysis.kind=static"};
  if (!loaded.scene.settings.empty())
    throw UsageError{
        "scope tries lengths of warp, but this scene finds one by ship.warp.tension; leave out "
        "ship.warp.tension"};
}

void print_table(const ScopeOptions& o, const std::vector<studies::ScopeRow>& rows, const char* status,
                 const studies::ScopeRequest& request) {
  print(o.json ? json_of(rows, status) + "\n" : text_of(rows, request));
}

int end_early(const ScopeOptions& o, Session& session, const std::vector<studies::ScopeRow>& rows,
              const studies::ScopeRequest& request) {
  const auto whole =
      std::ranges::count_if(rows, [&](const studies::ScopeRow& row) { return is_whole(row, request); });
  print_table(o, rows, "interrupted", request);
  return end_interrupted(session.terminal(),
                         fmt::format("the table has {} of {} depths{}", whole, request.depths.size(),
                                     o.output.empty() ? "" : ", and " + o.output + " is not written"));
}

int run_scope(const ScopeOptions& o) {
  const studies::ScopeRequest request = request_of(o);
  if (!o.output.empty() && !is_page(o.output) && !o.output.ends_with(".svg"))
    throw UsageError{"-o " + o.output + ": the name of the picture must end in .svg or .html"};
  require_memory_to_solve();
  Session session(o);
  if (const int code = session.open(); code != kDone) return code;
  const scenes::LoadedScene& loaded = session.scene().loaded();
  require_lengths_given(loaded);
  require_place(o.output, paths_of(loaded));
  catch_interrupts();
  Watchdog watchdog(session.terminal(), ending_with_a_sentence(session.terminal(), "the table ends here"));
  const runs::Watch watch{.interrupt = &interrupt_flag(),
                          .on_budget = [&](double seconds) { watchdog.allow(seconds); }};
  const auto on_point = [&](std::size_t solved, const studies::ScopeRow& row, const studies::ScopePoint& p) {
    session.terminal().progress_in_steps("lengths", solved, request.depths.size() * request.scopes.size(),
                                         fmt::format("{:.4g} m at {:.4g} m", p.warp, row.depth));
  };
  const auto rows =
      studies::find_scope(session.scene().source(), session.scene().registry(), request, watch, on_point);
  session.terminal().clear();
  if (interrupt_flag()) return end_early(o, session, rows, request);
  const bool is_done = has_found_all(rows);
  print_table(o, rows, is_done ? "done" : "not converged", request);
  return write_last(session.terminal(), is_done ? kDone : kNotConverged, [&] {
    if (!o.output.empty())
      formats::write_keeping(o.output, studies::draw_scope(loaded.scene.name, rows, is_page(o.output)));
  });
}

}  // namespace

int scope_command(const ScopeOptions& options) {
  try {
    return run_scope(options);
  } catch (const std::invalid_argument& e) {
    throw UsageError{e.what()};
  }
}

}  // namespace netloft::program
