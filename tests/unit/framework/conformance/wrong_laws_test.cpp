// SPDX-License-Identifier: BSD-3-Clause
//
// Does the suite find what is wrong with a law, and nothing else? See tests/support/wrong_laws.
#include "tests/unit/framework/conformance/wrong_plugins.hpp"

namespace netloft::test {
namespace {

std::vector<const LawType*> wrong_laws() {
  std::vector<const LawType*> all;
  for (const char* plugin : {"wrong_laws", "escaping"})
    for (const auto& law : wrong_plugin(plugin).laws) all.push_back(&law);
  return all;
}

class WrongLaw : public testing::TestWithParam<const LawType*> {};

TEST_P(WrongLaw, FailsTheOneCheckNamedForIt) {
  for (const std::uint64_t seed : {1u, 20u}) {
    ConformanceOptions quick;
    quick.timings = false, quick.seed = seed;
    const auto report = check_law(*GetParam(), quick);
    EXPECT_EQ(failed_checks(report), promised(GetParam()->law.doc)) << "seed " << seed << '\n'
                                                                    << failures(report);
  }
}

INSTANTIATE_TEST_SUITE_P(Each, WrongLaw, testing::ValuesIn(wrong_laws()), test_name<LawType>);

TEST(WrongLaws, ThereIsOneForEveryCheck) {
  std::set<std::string> without;
  for (const auto& name : law_checks()) without.insert(name);
  for (const auto* type : wrong_laws()) without.erase(type->law.doc);
  EXPECT_EQ(without, std::set<std::string>{});
}

}  // namespace
}  // namespace netloft::test
