// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/counted_malloc.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/unit/solvers/strategies/tension/taken_as_members.hpp"

#include <gtest/gtest.h>

namespace netloft::tension {
namespace {

using test::count_malloc, test::malloc_is_counted;

/// Counts the allocations between each iteration of a method and the next.
template <class Method>
std::vector<long> count_allocations(const Method& method) {
  std::vector<long> between;
  between.reserve(1000);
  long last = count_malloc();
  TakenAsMembers taken(sample::hanging_panel(8, 30), {}, [&](const IterationRecord&) {
    between.push_back(count_malloc() - last);
    last = count_malloc();
  });
  method(taken);
  return between;
}

TEST(TensionAllocations, OfTheInteriorPointAreOverWithTheFirstIteration) {
  if (!malloc_is_counted()) GTEST_SKIP() << "malloc cannot be counted in this build";
  const auto between = count_allocations([](TakenAsMembers& taken) {
    InteriorPoint(defaults<Only>(), taken.problem.interface()).solve(taken.u, 1000);
  });
  ASSERT_GT(between.size(), 5u);
  EXPECT_GT(between[0] + between[1], 0) << "nothing was counted";
  for (std::size_t i = 2; i < between.size(); ++i) EXPECT_EQ(between[i], 0) << "iteration " << i;
}

TEST(TensionAllocations, OfAStageAreOverWithItsFirstIteration) {
  if (!malloc_is_counted()) GTEST_SKIP() << "malloc cannot be counted in this build";
  const auto between = count_allocations([](TakenAsMembers& taken) {
    MixedNewton newton(defaults<FromSoft>(), taken.problem.interface());
    newton.solve({.factor = std::vector<double>(taken.problem.interface().parts, 1e-3),
                  .is_far = true,
                  .damping = 0.2,
                  .farthest_turn = 7,
                  .tolerance = 1e-6,
                  .iterations = 20},
                 taken.u);
  });
  ASSERT_GT(between.size(), 5u);
  EXPECT_GT(between[0] + between[1], 0) << "nothing was counted";
  for (std::size_t i = 2; i < between.size(); ++i) EXPECT_EQ(between[i], 0) << "iteration " << i;
}

}  // namespace
}  // namespace netloft::tension
