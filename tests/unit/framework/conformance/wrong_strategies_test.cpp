// SPDX-License-Identifier: BSD-3-Clause
//
// The checks find the flaw of each wrong strategy, and no other check fails. See
// tests/support/wrong_strategies.
#include "tests/unit/framework/conformance/wrong_plugins.hpp"

namespace netloft::test {
namespace {

std::vector<const StrategyType*> wrong_strategies() {
  std::vector<const StrategyType*> all;
  for (const char* plugin : {"wrong_strategies", "escaping_strategies"})
    for (const auto& strategy : wrong_plugin(plugin).strategies) all.push_back(&strategy);
  return all;
}

class WrongStrategy : public testing::TestWithParam<const StrategyType*> {};

TEST_P(WrongStrategy, FailsTheOneCheckNamedForIt) {
  expect_what_is_promised(GetParam()->strategy.doc,
                          [](const auto& o) { return check_strategy(*GetParam(), o); });
}

INSTANTIATE_TEST_SUITE_P(Each, WrongStrategy, testing::ValuesIn(wrong_strategies()), test_name<StrategyType>);

TEST(WrongStrategies, ThereIsOneForEveryCheck) {
  EXPECT_EQ(
      without(strategy_checks(), wrong_strategies(), [](const auto& type) { return type.strategy.doc; }),
      std::set<std::string>{});
}

}  // namespace
}  // namespace netloft::test
