// SPDX-License-Identifier: BSD-3-Clause
//
// Does the suite find what is wrong with a solver, and nothing else? See tests/support/wrong_solvers.
#include "tests/unit/framework/conformance/wrong_plugins.hpp"

namespace netloft::test {
namespace {

std::vector<const SolverType*> wrong_solvers() {
  std::vector<const SolverType*> all;
  for (const char* plugin : {"wrong_solvers", "escaping_solvers"})
    for (const auto& solver : wrong_plugin(plugin).solvers) all.push_back(&solver);
  return all;
}

class WrongSolver : public testing::TestWithParam<const SolverType*> {};

TEST_P(WrongSolver, FailsTheOneCheckNamedForIt) {
  for (const std::uint64_t seed : {1u, 20u}) {
    ConformanceOptions quick;
    quick.timings = false, quick.seed = seed;
    const auto report = check_solver(*GetParam(), quick);
    EXPECT_EQ(failed_checks(report), promised(GetParam()->solver.doc)) << "seed " << seed << '\n'
                                                                       << failures(report);
  }
}

INSTANTIATE_TEST_SUITE_P(Each, WrongSolver, testing::ValuesIn(wrong_solvers()), test_name<SolverType>);

TEST(WrongSolvers, ThereIsOneForEveryCheck) {
  std::set<std::string> without;
  for (const auto& name : solver_checks()) without.insert(name);
  for (const auto* type : wrong_solvers()) without.erase(type->solver.doc);
  EXPECT_EQ(without, std::set<std::string>{});
}

}  // namespace
}  // namespace netloft::test
