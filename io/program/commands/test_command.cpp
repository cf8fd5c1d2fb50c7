// SPDX-License-Identifier: BSD-3-Clause
#include "framework/conformance/conformance.hpp"
#include "io/program/commands/plugins.hpp"
#include "io/program/session/find_plugins.hpp"
#include "io/program/session/last_words.hpp"
#include "io/program/session/memory_room.hpp"
#include "io/program/session/print.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>

namespace netloft::program {

namespace {

using Json = nlohmann::ordered_json;

/// The components in a file ("rope.so"), in a plugin ("rope") or of a type ("rope/bar").
struct Targets {
  std::vector<const ElementType*> elements;
  std::vector<const LawType*> laws;
  std::vector<const SolverType*> solvers;
  std::vector<const IntegratorType*> integrators;
  std::vector<const StrategyType*> strategies;
  std::string file;  // file of the components; empty if they are compiled in
};

Targets find_targets(const std::string& target, Registry& registry) {
  const auto slash = target.rfind('/');
  const bool is_file = target.ends_with(".so"), one = !is_file && slash != std::string::npos;
  const PluginContent& plugin =
      is_file ? registry.add_file(target) : registry.plugin(one ? target.substr(0, slash) : target);
  Targets found;
  found.file = plugin.origin.file;
  for (const auto& e : plugin.elements)
    if (!one || e.type == target) found.elements.push_back(&e);
  for (const auto& l : plugin.laws)
    if (!one || l.type == target) found.laws.push_back(&l);
  for (const auto& v : plugin.solvers)
    if (!one || v.type == target) found.solvers.push_back(&v);
  for (const auto& i : plugin.integrators)
    if (!one || i.type == target) found.integrators.push_back(&i);
  for (const auto& s : plugin.strategies)
    if (!one || s.type == target) found.strategies.push_back(&s);
  if (one && found.elements.empty() && found.laws.empty() && found.solvers.empty() &&
      found.integrators.empty() && found.strategies.empty())
    registry.element(target);  // throws with a list of the known types
  return found;
}

std::string verdict(const CheckResult& c) { return c.skipped ? "skipped" : c.passed ? "passed" : "FAILED"; }

void print_check(const CheckResult& c) {
  const std::string figure =
      c.limit == 0 && c.figure == 0 ? "" : fmt::format("{:.2e} of {:.2e}", c.figure, c.limit);
  print_line(fmt::format("  {:<8} {:<32} {:<22} {}", verdict(c), c.name, figure, c.passed ? "" : c.detail));
  if (!c.passed && !c.skipped && !c.hint.empty()) print_line(fmt::format("           usually: {}", c.hint));
}

/// Prints "12 checks do not apply, 3 checks depend on one that failed: --verbose lists them".
void print_number_of_skipped(const ConformanceReport& report) {
  const auto depending = std::ranges::count_if(report.checks, &CheckResult::depends);
  const auto idle = std::ranges::count_if(report.checks, &CheckResult::skipped) - depending;
  std::string text;
  const auto add = [&](auto number, const char* of_one, const char* of_more) {
    if (number > 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", number, number == 1 ? of_one : of_more);
  };
  add(idle, "check does not apply", "checks do not apply");
  add(depending, "check depends on one that failed", "checks depend on one that failed");
  if (!text.empty()) print_line(fmt::format("  {}: --verbose lists them", text));
}

void print_report(const ConformanceReport& report, bool verbose) {
  print_line(fmt::format("{}: {}", report.type, report.passed() ? "conforms" : "does not conform"));
  for (const auto& c : report.checks)
    if (verbose || !c.skipped) print_check(c);
  if (!verbose) print_number_of_skipped(report);
  for (const auto& t : report.timings)
    print_line(fmt::format("  {:>8.1f} ns per {}: {}, {}", t.nanoseconds, t.per, t.term, t.want));
}

Json report_json(const ConformanceReport& report) {
  Json checks = Json::array(), timings = Json::array();
  for (const auto& c : report.checks)
    checks.push_back({{"name", c.name},
                      {"result", verdict(c)},
                      {"figure", c.figure},
                      {"limit", c.limit},
                      {"detail", c.detail},
                      {"hint", c.hint}});
  for (const auto& t : report.timings)
    timings.push_back({{"term", t.term}, {"want", t.want}, {"nanoseconds", t.nanoseconds}, {"per", t.per}});
  return {{"type", report.type}, {"passed", report.passed()}, {"checks", checks}, {"timings", timings}};
}

/// Checks all targets, and prints each report as soon as it is complete, unless JSON is requested.
std::vector<ConformanceReport> check_all(const Targets& found, const TestOptions& options) {
  std::vector<ConformanceReport> reports;
  const auto check = [&](const std::string& type, auto&& make) {
    explain_crashes_of(type, options.seconds);
    reports.push_back(make());
    if (!options.json) print_report(reports.back(), options.verbose);
    std::fflush(stdout);
  };
  if (!found.file.empty()) check(found.file, [&] { return check_file(found.file); });
  for (const auto* e : found.elements) check(e->type, [&] { return check_element(*e); });
  for (const auto* l : found.laws) check(l->type, [&] { return check_law(*l); });
  for (const auto* s : found.solvers) check(s->type, [&] { return check_solver(*s); });
  for (const auto* i : found.integrators) check(i->type, [&] { return check_integrator(*i); });
  for (const auto* s : found.strategies) check(s->type, [&] { return check_strategy(*s); });
  explain_crashes_of("");
  return reports;
}

}  // namespace

int test_command(const TestOptions& options) {
  require_memory_to_solve();
  Registry registry;
  find_plugins(options, registry);
  const auto reports = check_all(find_targets(options.plugin, registry), options);
  const bool passed = std::all_of(reports.begin(), reports.end(), [](const auto& r) { return r.passed(); });
  if (options.json) {
    Json lines = Json::array();
    for (const auto& report : reports) lines.push_back(report_json(report));
    print_line(Json{{"passed", passed}, {"elements", lines}}.dump(2));
  }
  return passed ? kDone : kOther;
}

}  // namespace netloft::program
