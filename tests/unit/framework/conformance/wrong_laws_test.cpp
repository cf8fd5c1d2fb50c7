// SPDX-License-Identifier: BSD-3-Clause
//
// The checks find the flaw of each wrong law, and no other check fails. See tests/support/wrong_laws.
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
  expect_what_is_promised(GetParam()->law.doc, [](const auto& o) { return check_law(*GetParam(), o); });
}

INSTANTIATE_TEST_SUITE_P(Each, WrongLaw, testing::ValuesIn(wrong_laws()), test_name<LawType>);

TEST(WrongLaws, ThereIsOneForEveryCheck) {
  EXPECT_EQ(without(law_checks(), wrong_laws(), [](const auto& type) { return type.law.doc; }),
            std::set<std::string>{});
}

}  // namespace
}  // namespace netloft::test
