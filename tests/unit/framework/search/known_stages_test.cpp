// SPDX-License-Identifier: BSD-3-Clause
#include "framework/search/known_stages.hpp"

#include <gtest/gtest.h>

namespace netloft::test {
namespace {

/// A stage with ten numbers at its start, ten at its end, and this number of iterations.
KnownStage stage(double start, std::size_t iterations = 0) {
  KnownStage s;
  s.request.by = "newton/newton", s.request.start.assign(10, start);
  s.solution.u.assign(10, start + 1);
  s.solution.run.history.resize(iterations);
  s.solution.cost.statistics.factorisations = 7;
  return s;
}

TEST(KnownStages, TellWhatCameOfTheSameRequestAndOfNoOther) {
  KnownStages known(1000);
  known.keep(stage(1));
  const KnownStage* found = known.find(stage(1).request);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->solution.u.front(), 2);
  EXPECT_EQ(found->solution.cost.statistics.factorisations, 0) << "it costs nothing to be told";
  const auto knows = [&](auto&& change) {
    StageRequest other = stage(1).request;
    change(other);
    return known.find(other) != nullptr;
  };
  EXPECT_TRUE(knows([](StageRequest&) {}));
  EXPECT_FALSE(knows([](StageRequest& r) { r.start.back() = 1 + 1e-15; }));
  EXPECT_FALSE(knows([](StageRequest& r) { r.by_strategy = true; }));
  EXPECT_FALSE(knows([](StageRequest& r) { r.by = "ptc/ptc"; }));
  EXPECT_FALSE(knows([](StageRequest& r) { r.parameters["step"] = 1.0; }));
  EXPECT_FALSE(knows([](StageRequest& r) { r.variant.level = 1; }));
  EXPECT_FALSE(knows([](StageRequest& r) { r.variant.stiffness_cap = 1; }));
  EXPECT_FALSE(knows([](StageRequest& r) { r.tolerance = 1e-3; }));
  EXPECT_FALSE(knows([](StageRequest& r) { r.path = 10; }));
  EXPECT_FALSE(knows([](StageRequest& r) { r.iterations = 5; }));
  EXPECT_FALSE(knows([](StageRequest& r) { r.flags = NETLOFT_COMPENSATED; }));
}

TEST(KnownStages, ForgetWhatWasNotAskedForLongest) {
  KnownStages known(60);  // room for three stages
  for (const double start : {1, 2, 3}) known.keep(stage(start));
  EXPECT_TRUE(known.find(stage(1).request));
  known.keep(stage(4));
  EXPECT_TRUE(known.find(stage(1).request));
  EXPECT_FALSE(known.find(stage(2).request));
  EXPECT_TRUE(known.find(stage(3).request));
  EXPECT_TRUE(known.find(stage(4).request));
}

// A stage of a small scene may have more iterations than the scene has unknowns.
TEST(KnownStages, CountNoHistory) {
  KnownStages known(20);
  known.keep(stage(1, 1000));
  EXPECT_TRUE(known.find(stage(1).request));
}

TEST(KnownStages, KeepTheLastOfOneRequest) {
  KnownStages known(20);
  known.keep(stage(1));
  KnownStage further = stage(1);
  further.solution.u.front() = 5;
  known.keep(further);
  ASSERT_TRUE(known.find(stage(1).request));
  EXPECT_EQ(known.find(stage(1).request)->solution.u.front(), 5);
}

}  // namespace
}  // namespace netloft::test
