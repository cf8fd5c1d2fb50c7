// SPDX-License-Identifier: BSD-3-Clause
#include "framework/conformance/conformance.hpp"
#include "io/cli/commands.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>

namespace netloft::io {

namespace {

using Json = nlohmann::ordered_json;

/// The elements that PLUGIN.so, "rope" or "rope/bar" stands for.
std::vector<const ElementType*> find_elements(const std::string& target, Registry& registry) {
  const auto slash = target.rfind('/');
  const bool is_file = target.ends_with(".so");
  if (!is_file && slash != std::string::npos) return {&registry.element(target)};
  const PluginContent& plugin = is_file ? registry.add_file(target) : registry.plugin(target);
  std::vector<const ElementType*> elements;
  for (const auto& e : plugin.elements) elements.push_back(&e);
  return elements;
}

std::string verdict(const CheckResult& c) { return c.skipped ? "skipped" : c.passed ? "passed" : "FAILED"; }

void print_report(const ConformanceReport& report) {
  std::puts(fmt::format("{}: {}", report.type, report.passed() ? "conforms" : "does not conform").c_str());
  for (const auto& c : report.checks) {
    const std::string figure =
        c.limit == 0 && c.figure == 0 ? "" : fmt::format("{:.2e} of {:.2e}", c.figure, c.limit);
    std::puts(fmt::format("  {:<8} {:<32} {:<22} {}", verdict(c), c.name, figure, c.passed ? "" : c.detail)
                  .c_str());
    if (!c.passed && !c.skipped && !c.hint.empty())
      std::puts(fmt::format("           usually: {}", c.hint).c_str());
  }
  for (const auto& t : report.timings)
    std::puts(fmt::format("  {:>8.1f} ns per element: {}, {}", t.nanoseconds, t.term, t.want).c_str());
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
    timings.push_back({{"term", t.term}, {"want", t.want}, {"nanoseconds", t.nanoseconds}});
  return {{"type", report.type}, {"passed", report.passed()}, {"checks", checks}, {"timings", timings}};
}

}  // namespace

int test_command(const Options& options) {
  Registry registry;
  find_plugins(options, registry);
  const auto elements = find_elements(options.target, registry);
  Json reports = Json::array();
  bool passed = true;
  for (const auto* element : elements) {
    const ConformanceReport report = check_element(*element);
    passed &= report.passed();
    if (options.json)
      reports.push_back(report_json(report));
    else
      print_report(report);
  }
  if (options.json)
    std::puts(Json{{"passed", passed}, {"elements", reports}}.dump(2).c_str());
  else if (elements.empty())
    std::puts("there is no element in this plugin to check");
  return passed ? kDone : kOther;
}

}  // namespace netloft::io
