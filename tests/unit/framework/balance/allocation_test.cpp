// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "framework/judging/verdict.hpp"
#include "solvers/factorisation/make_factorisation.hpp"
#include "tests/support/counted_malloc.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::test {
namespace {

/// Numbers of allocations between consecutive iterations.
std::vector<long> count_allocations(const Scene& scene, const SolverType& solver, const Values& values,
                                    int threads) {
  std::vector<std::string> faults;
  const ParameterBlock parameters(solver.parameters, solver.solver.parameter_bytes, values, faults);
  const ScenePlan plan = make_scene_plan(scene, shipped_plugins());
  Assembler assembler(scene, plan, threads);
  Limits limits;
  limits.iterations = 100;
  std::vector<long> between;
  between.reserve(1000);
  long last = count_malloc();
  solve_static({scene, assembler, make_factorisation}, {&solver, parameters.data()}, limits, {},
               {.on_iteration = [&](const IterationRecord&) {
                 between.push_back(count_malloc() - last);
                 last = count_malloc();
               }});
  return between;
}
std::vector<long> count_allocations(const Scene& scene, const std::string& method, int threads) {
  return count_allocations(scene, shipped_plugins().solver("newton"), {{"method", method}}, threads);
}

/// `factorisations`: number of factorisations until all memory has been allocated.
void expect_none_after_the_first_iteration(const std::vector<long>& between, std::size_t factorisations = 1) {
  if (!malloc_is_counted()) GTEST_SKIP() << "malloc cannot be counted in this build";
  ASSERT_GT(between.size(), 4u);
  EXPECT_GT(between[0] + between[1], 0) << "until then matrices and factors are made: nothing was counted";
  for (std::size_t i = 1 + factorisations; i < between.size(); ++i)
    EXPECT_EQ(between[i], 0) << "iteration " << i << " of " << between.size() - 1;
}

TEST(Allocations, AreOverWithTheFirstIterationOnNetting) {
  expect_none_after_the_first_iteration(count_allocations(sample::hanging_panel(16, 34), "globalised", 1));
}

TEST(Allocations, AreOverWithTheFirstIterationOfSeveralThreads) {
  expect_none_after_the_first_iteration(count_allocations(sample::hanging_panel(48, 34), "globalised", 3));
}

// The start is longer than the unstretched net. The first tangents are then positive definite, so that the
// convex part is used late.
TEST(Allocations, AreOverWithTheFirstIterationFromAnOverlongSketch) {
  expect_none_after_the_first_iteration(count_allocations(sample::hanging_panel(16, 54), "globalised", 1));
}

TEST(Allocations, AreOverWithTheFirstIterationOnRopes) {
  expect_none_after_the_first_iteration(count_allocations(sample::hanging_rope(100), "globalised", 1));
}

// MUMPS keeps arrays from one factorisation to the next.
TEST(Allocations, AreOverWithTheThirdIterationOfTheClassicMethod) {
  expect_none_after_the_first_iteration(count_allocations(sample::hanging_panel(16, 34), "classic", 1), 3);
}

class AllocationsOf : public testing::TestWithParam<const char*> {};

TEST_P(AllocationsOf, AreOverWithTheFirstIteration) {
  const SolverType& solver = shipped_plugins().solver(GetParam());
  expect_none_after_the_first_iteration(count_allocations(sample::hanging_panel(16, 34), solver, {}, 1));
}

INSTANTIATE_TEST_SUITE_P(OtherSolvers, AllocationsOf, testing::Values("ptc", "relaxation", "lbfgs"),
                         [](const auto& given) { return std::string(given.param); });

}  // namespace
}  // namespace netloft::test
