// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/law_watch.hpp"

#include <gtest/gtest.h>
#include <netloft/law.hpp>

#include <numbers>

namespace netloft::test {
namespace {

struct Numbers {
  double measured_at = 0;
  netloft_table curve{};
};

/// A law with a force of 1 N/m along x.
struct Push {
  static constexpr auto kind = NETLOFT_SCREEN_LAW;
  using Parameters = Numbers;
  static void lanes(const Parameters&, const netloft_law_tile& f) {
    for (std::size_t i = 0; i < f.count; ++i) f.force[i] = 1;
  }
};

/// Returns the law with the ranges of validity that `declare` gives it.
template <class Declare>
LawType law_with(LawTable<Push>& table, Declare&& declare) {
  table.real("measured_at", &Numbers::measured_at, "1", "a number", {.lo = 0, .hi = 10, .fallback = 0});
  table.table("curve", &Numbers::curve, "a curve", {{"x", "1"}, {"y", "1"}});
  declare(table);
  LawType law;
  law.type = "test/push", law.law = table.descriptor();
  law.parameters = table.rows();
  law.validity.assign(law.law.validity, law.law.validity + law.law.validity_count);
  return law;
}

ParameterBlock block_of(const LawType& law, const Values& values = {}) {
  std::vector<std::string> faults;
  ParameterBlock block(law.parameters, law.law.parameter_bytes, values, faults);
  EXPECT_TRUE(faults.empty());
  return block;
}

/// Two screens in a flow of 1 m/s: one of 3 m² with the solidity 0.2, at 30° to the flow, and one of 1 m²
/// with the solidity 0.4, at a right angle to it.
struct Two {
  Two() {
    lanes.flow[0][0] = lanes.flow[0][1] = 1;
    lanes.direction[0][0] = 0.5, lanes.direction[2][0] = std::sqrt(0.75);
    lanes.direction[0][1] = 1;
    lanes.diameter[0] = lanes.diameter[1] = 0.002;
    lanes.solidity[0] = 0.2, lanes.solidity[1] = 0.4;
    f.size = sizeof f, f.count = 2, f.water_viscosity = 1e-6;
    f.flow = lanes.flow[0], f.direction = lanes.direction[0], f.diameter = lanes.diameter;
    f.solidity = lanes.solidity, f.force = lanes.force[0], f.extent = area;
  }
  Two(const Two&) = delete;
  FlowLanes lanes{};
  double area[kLanes] = {3, 1};
  netloft_law_tile f{};
};

LawUse watched(const LawType& law, const ParameterBlock& block, bool is_told = true) {
  Two two;
  LawWatch watch(law, block);
  if (!is_told) two.f.extent = nullptr;
  const netloft_bound_law bound = watch.bound();
  bound.evaluate(bound.parameters, &two.f);  // this call is not watched
  watch.begin();
  bound.evaluate(bound.parameters, &two.f);
  EXPECT_EQ(two.lanes.force[0][1], 1);
  return watch.end();
}

TEST(LawWatch, WeighsWhatLiesOutsideByItsArea) {
  LawTable<Push> table("push", "pushes");
  const LawType law = law_with(table, [](auto& t) { t.valid(Quantity::solidity, 0.1, 0.3, "nobody"); });
  const auto block = block_of(law);
  const LawUse use = watched(law, block);
  ASSERT_EQ(use.ranges.size(), 1u);
  EXPECT_DOUBLE_EQ(use.ranges[0].fraction_outside(), 0.25);
  EXPECT_DOUBLE_EQ(use.ranges[0].least, 0.2);
  EXPECT_DOUBLE_EQ(use.ranges[0].most, 0.4);
  EXPECT_DOUBLE_EQ(watched(law, block, false).ranges[0].fraction_outside(), 0.5) << "every call weighs one";
}

TEST(LawWatch, BeginsAnewEachTime) {
  LawTable<Push> table("push", "pushes");
  const LawType law = law_with(table, [](auto& t) { t.valid(Quantity::solidity, 0.1, 0.3, "nobody"); });
  const auto block = block_of(law);
  LawWatch watch(law, block);
  Two two;
  for (int i = 0; i < 2; ++i) {
    watch.begin();
    watch.bound().evaluate(watch.bound().parameters, &two.f);
    EXPECT_DOUBLE_EQ(watch.end().ranges[0].outside, 1);
  }
}

TEST(LawWatch, HasNothingToSayOfALawWithoutARange) {
  LawTable<Push> table("push", "pushes");
  const LawType law = law_with(table, [](auto& t) {
    t.valid(Quantity::reynolds, 0, 1, "nobody", {.where = "measured_at"});
    t.valid(Quantity::reynolds, 0, 1, "nobody", {.where = "curve"});
  });
  const auto block = block_of(law);
  LawWatch watch(law, block);
  watch.begin();
  Two two;
  EXPECT_EQ(watch.bound().evaluate(watch.bound().parameters, &two.f), NETLOFT_OK);
  EXPECT_TRUE(watch.end().ranges.empty());
}

TEST(LawWatch, KnowsWhichRangesHold) {
  LawTable<Push> table("push", "pushes");
  const LawType law = law_with(table, [](auto& t) {
    t.valid(Quantity::reynolds, 0, 1, "with", {.where = "measured_at"});
    t.valid(Quantity::reynolds, 0, 1, "without", {.unless = "measured_at"});
    t.valid(Quantity::reynolds, 0, 1, "curve", {.where = "curve"});
    t.valid(Quantity::reynolds, 0, 1, "no curve", {.unless = "curve"});
  });
  const auto sources = [&](const Values& values) {
    std::vector<std::string> all;
    for (const auto& range : watched(law, block_of(law, values)).ranges) all.push_back(range.range->source);
    return all;
  };
  EXPECT_EQ(sources({}), (std::vector<std::string>{"without", "no curve"}));
  EXPECT_EQ(sources({{"measured_at", 2.0}}), (std::vector<std::string>{"with", "no curve"}));
  EXPECT_EQ(sources({{"curve", Samples{{0, 1}, {1, 2}}}}), (std::vector<std::string>{"without", "curve"}));
}

TEST(LawWatch, KnowsTheQuantitiesOfAFlow) {
  Two two;
  const auto of = [&](std::uint32_t kind, std::uint32_t quantity) {
    return flow_quantity(kind, quantity, two.f, 0);
  };
  EXPECT_NEAR(of(NETLOFT_SCREEN_LAW, NETLOFT_REYNOLDS), 2000, 1e-9);
  EXPECT_NEAR(of(NETLOFT_SCREEN_LAW, NETLOFT_REYNOLDS_IN_MESHES), 2500, 1e-9);
  EXPECT_NEAR(of(NETLOFT_TWINE_LAW, NETLOFT_REYNOLDS_ACROSS), 2000 * std::sqrt(0.75), 1e-9);
  EXPECT_NEAR(of(NETLOFT_SCREEN_LAW, NETLOFT_ATTACK), std::numbers::pi / 6, 1e-12);
  EXPECT_NEAR(of(NETLOFT_TWINE_LAW, NETLOFT_ATTACK), std::numbers::pi / 3, 1e-12);
  EXPECT_DOUBLE_EQ(of(NETLOFT_SCREEN_LAW, NETLOFT_SOLIDITY), 0.2);
}

}  // namespace
}  // namespace netloft::test
