// SPDX-License-Identifier: BSD-3-Clause
//
// Does the suite find what is wrong with a solver, and nothing else? See tests/support/wrong_solvers.
#include "framework/conformance/conformance.hpp"
#include "framework/registry/registry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace {

using netloft::ConformanceOptions;
using netloft::SolverType;

std::vector<const SolverType*> wrong_solvers() {
  static netloft::Registry registry;
  registry.add_folder(NETLOFT_BINARY_DIR "/tests/plugins");
  std::vector<const SolverType*> all;
  for (const char* plugin : {"wrong_solvers", "escaping_solvers"})
    for (const auto& solver : registry.plugin(plugin).solvers) all.push_back(&solver);
  return all;
}

std::set<std::string> failed_checks(const netloft::ConformanceReport& report) {
  std::set<std::string> names;
  for (const auto& check : report.checks)
    if (!check.passed && !check.skipped) names.insert(check.name);
  return names;
}

std::set<std::string> promised(const SolverType& type) {
  const std::string name = type.solver.doc;
  return name == "nothing" ? std::set<std::string>{} : std::set<std::string>{name};
}

class WrongSolver : public testing::TestWithParam<const SolverType*> {};

TEST_P(WrongSolver, FailsTheOneCheckNamedForIt) {
  for (const std::uint64_t seed : {1u, 20u}) {
    ConformanceOptions quick;
    quick.timings = false, quick.seed = seed;
    const auto report = check_solver(*GetParam(), quick);
    EXPECT_EQ(failed_checks(report), promised(*GetParam())) << "seed " << seed << '\n' << failures(report);
  }
}

INSTANTIATE_TEST_SUITE_P(Each, WrongSolver, testing::ValuesIn(wrong_solvers()),
                         [](const testing::TestParamInfo<const SolverType*>& wrong) {
                           std::string name = wrong.param->type;
                           std::replace(name.begin(), name.end(), '/', '_');
                           return name;
                         });

TEST(WrongSolvers, ThereIsOneForEveryCheck) {
  std::set<std::string> without;
  for (const auto& name : netloft::solver_checks()) without.insert(name);
  for (const auto* type : wrong_solvers()) without.erase(type->solver.doc);
  EXPECT_EQ(without, std::set<std::string>{});
}

}  // namespace
