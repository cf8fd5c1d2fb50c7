// SPDX-License-Identifier: BSD-3-Clause
//
// Shared by the tests of deliberately wrong elements, laws, solvers, integrators and strategies: the doc of
// each names the check that must find it, or "nothing".
#pragma once
#include "framework/conformance/conformance.hpp"
#include "framework/registry/registry.hpp"
#include "tests/folders.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace netloft::test {

inline const PluginContent& wrong_plugin(const std::string& name) {
  static Registry registry;
  registry.add_folder(test::build_folder() + "/tests/plugins");
  return registry.plugin(name);
}

inline std::set<std::string> failed_checks(const ConformanceReport& report) {
  std::set<std::string> names;
  for (const auto& check : report.checks)
    if (!check.passed && !check.skipped) names.insert(check.name);
  return names;
}

/// The checks that must find a wrong component, from its doc.
inline std::set<std::string> promised(const std::string& doc) {
  return doc == "nothing" ? std::set<std::string>{} : std::set<std::string>{doc};
}

/// Expects that `check(options)` finds the flaw with any seed, and nothing else.
template <class Check>
void expect_what_is_promised(const std::string& doc, Check&& check) {
  for (const std::uint64_t seed : {1u, 20u}) {
    ConformanceOptions quick;
    quick.timings = false, quick.seed = seed;
    const ConformanceReport report = check(quick);
    EXPECT_EQ(failed_checks(report), promised(doc)) << "seed " << seed << '\n' << failures(report);
  }
}

/// Checks for which no wrong component exists.
template <class Wrong, class Doc>
std::set<std::string> without(const std::vector<std::string>& checks, const Wrong& wrong, Doc&& doc) {
  std::set<std::string> names(checks.begin(), checks.end());
  for (const auto* type : wrong) names.erase(doc(*type));
  return names;
}

/// wrong/energy -> wrong_energy
template <class Type>
std::string test_name(const testing::TestParamInfo<const Type*>& wrong) {
  std::string name = wrong.param->type;
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

}  // namespace netloft::test
