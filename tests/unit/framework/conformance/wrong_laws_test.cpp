// SPDX-License-Identifier: BSD-3-Clause
//
// Does the suite find what is wrong with a law, and nothing else? See tests/support/wrong_laws.
#include "framework/conformance/conformance.hpp"
#include "framework/registry/registry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace {

using netloft::ConformanceOptions;
using netloft::LawType;

std::vector<const LawType*> wrong_laws() {
  static netloft::Registry registry;
  registry.add_folder(NETLOFT_BINARY_DIR "/tests/plugins");
  std::vector<const LawType*> all;
  for (const char* plugin : {"wrong_laws", "escaping"})
    for (const auto& law : registry.plugin(plugin).laws) all.push_back(&law);
  return all;
}

std::set<std::string> failed_checks(const netloft::ConformanceReport& report) {
  std::set<std::string> names;
  for (const auto& check : report.checks)
    if (!check.passed && !check.skipped) names.insert(check.name);
  return names;
}

std::set<std::string> promised(const LawType& type) {
  const std::string name = type.law.doc;
  return name == "nothing" ? std::set<std::string>{} : std::set<std::string>{name};
}

class WrongLaw : public testing::TestWithParam<const LawType*> {};

TEST_P(WrongLaw, FailsTheOneCheckNamedForIt) {
  for (const std::uint64_t seed : {1u, 20u}) {
    ConformanceOptions quick;
    quick.timings = false, quick.seed = seed;
    const auto report = check_law(*GetParam(), quick);
    EXPECT_EQ(failed_checks(report), promised(*GetParam())) << "seed " << seed << '\n' << failures(report);
  }
}

INSTANTIATE_TEST_SUITE_P(Each, WrongLaw, testing::ValuesIn(wrong_laws()),
                         [](const testing::TestParamInfo<const LawType*>& wrong) {
                           std::string name = wrong.param->type;
                           std::replace(name.begin(), name.end(), '/', '_');
                           return name;
                         });

TEST(WrongLaws, ThereIsOneForEveryCheck) {
  std::set<std::string> without;
  for (const auto& name : netloft::law_checks()) without.insert(name);
  for (const auto* type : wrong_laws()) without.erase(type->law.doc);
  EXPECT_EQ(without, std::set<std::string>{});
}

}  // namespace
