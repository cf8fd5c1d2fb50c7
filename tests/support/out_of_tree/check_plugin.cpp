// SPDX-License-Identifier: BSD-3-Clause
//
// check_plugin FILE.so: runs the conformance suite over a plugin and prints the results. The exit code is 1
// if a check fails.
#include "framework/conformance/conformance.hpp"
#include "framework/registry/registry.hpp"

#include <cstdio>

namespace {

const char* verdict(const netloft::CheckResult& c) {
  return c.skipped ? "skipped" : c.passed ? "passed" : "FAILED";
}

bool check(const netloft::ElementType& type) {
  const auto report = netloft::check_element(type);
  std::printf("%s\n", report.type.c_str());
  for (const auto& c : report.checks)
    std::printf("  %-7s %-30s %10.2g of %-8.2g %s\n", verdict(c), c.name.c_str(), c.figure, c.limit,
                c.detail.c_str());
  for (const auto& t : report.timings)
    std::printf("  %s, %s: %.0f ns per element\n", t.term.c_str(), t.want.c_str(), t.nanoseconds);
  std::fputs(failures(report).c_str(), stdout);
  return report.passed();
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) throw std::runtime_error("usage: check_plugin FILE.so");
  netloft::Registry registry;
  bool passed = true;
  for (const auto& type : registry.add_file(argv[1]).elements) passed = check(type) && passed;
  return passed ? 0 : 1;
} catch (const std::exception& e) {
  std::fprintf(stderr, "%s\n", e.what());
  return 2;
}
