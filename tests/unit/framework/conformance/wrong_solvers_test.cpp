// SPDX-License-Identifier: BSD-3-Clause
//
// The checks find the flaw of each wrong solver, and no other check fails. See tests/support/wrong_solvers.
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
  expect_what_is_promised(GetParam()->solver.doc, [](const auto& o) { return check_solver(*GetParam(), o); });
}

INSTANTIATE_TEST_SUITE_P(Each, WrongSolver, testing::ValuesIn(wrong_solvers()), test_name<SolverType>);

TEST(WrongSolvers, ThereIsOneForEveryCheck) {
  EXPECT_EQ(without(solver_checks(), wrong_solvers(), [](const auto& type) { return type.solver.doc; }),
            std::set<std::string>{});
}

}  // namespace
}  // namespace netloft::test
