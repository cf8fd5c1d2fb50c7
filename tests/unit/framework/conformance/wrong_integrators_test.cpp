// SPDX-License-Identifier: BSD-3-Clause
//
// Does the suite find what is wrong with an integrator, and nothing else? See
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
  for (const std::uint64_t seed : {1u, 20u}) {
    ConformanceOptions quick;
    quick.timings = false, quick.seed = seed;
    const auto report = check_integrator(*GetParam(), quick);
    EXPECT_EQ(failed_checks(report), promised(GetParam()->integrator.doc)) << "seed " << seed << '\n'
                                                                           << failures(report);
  }
}

INSTANTIATE_TEST_SUITE_P(Each, WrongIntegrator, testing::ValuesIn(wrong_integrators()),
                         test_name<IntegratorType>);

TEST(WrongIntegrators, ThereIsOneForEveryCheck) {
  std::set<std::string> without;
  for (const auto& name : integrator_checks()) without.insert(name);
  for (const auto* type : wrong_integrators()) without.erase(type->integrator.doc);
  EXPECT_EQ(without, std::set<std::string>{});
}

}  // namespace
}  // namespace netloft::test
