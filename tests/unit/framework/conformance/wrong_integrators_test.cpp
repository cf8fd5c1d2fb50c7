// SPDX-License-Identifier: BSD-3-Clause
//
// The checks find the flaw of each wrong integrator, and no other check fails. See
// tests/support/wrong_integrators.
#include "tests/unit/framework/conformance/wrong_plugins.hpp"

namespace netloft::test {
namespace {

std::vector<const IntegratorType*> wrong_integrators() {
  std::vector<const IntegratorType*> all;
  for (const char* plugin : {"wrong_integrators", "escaping_integrators"})
    for (const auto& integrator : wrong_plugin(plugin).integrators) all.push_back(&integrator);
  return all;
}

class WrongIntegrator : public testing::TestWithParam<const IntegratorType*> {};

TEST_P(WrongIntegrator, FailsTheOneCheckNamedForIt) {
  expect_what_is_promised(GetParam()->integrator.doc,
                          [](const auto& o) { return check_integrator(*GetParam(), o); });
}

INSTANTIATE_TEST_SUITE_P(Each, WrongIntegrator, testing::ValuesIn(wrong_integrators()),
                         test_name<IntegratorType>);

TEST(WrongIntegrators, ThereIsOneForEveryCheck) {
  EXPECT_EQ(
      without(integrator_checks(), wrong_integrators(), [](const auto& type) { return type.integrator.doc; }),
      std::set<std::string>{});
}

}  // namespace
}  // namespace netloft::test
