// SPDX-License-Identifier: BSD-3-Clause
#include "framework/scene/scene_plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/sample_scenes.hpp"
#include "tests/unit/framework/assembler/sketch.hpp"

namespace netloft::test {
namespace {

const TermPlan& term(const ScenePlan& plan, const std::string& type, const std::string& name) {
  for (const auto& family : plan.families)
    for (const auto& t : family.terms)
      if (family.type->type == type && t.name == name) return t;
  throw std::invalid_argument(type + " " + name);
}

TEST(ScenePlan, CountsWhatThereIsToSolve) {
  const ScenePlan plan = make_scene_plan(sample::hanging_panel(4, 34), plugins());
  ASSERT_EQ(plan.families.size(), 1u);
  EXPECT_EQ(plan.families[0].type->type, "priour/triangle");
  EXPECT_EQ(plan.families[0].elements, 32u);
  EXPECT_EQ(plan.nodes, 25u);
  EXPECT_EQ(plan.held_nodes, 5u);
  EXPECT_EQ(plan.unknowns, 60u);
  EXPECT_TRUE(plan.symmetric);
  EXPECT_TRUE(plan.conservative);
}

// A rope may have a stiffness in tension only, in compression only, or none.
TEST(ScenePlan, EvaluatesATermIfOneOfTheParametersThatItNeedsIsSet) {
  const auto elastic = [](double EA, double EA_compression) {
    Sketch s;
    Part& rope = s.rope("rope", {s.node(0, 0, 0, kAllAxes), s.node(1, 0, 0)}, 1, EA);
    rope.parameters["rope.EA_compression"] = EA_compression;
    return term(make_scene_plan(s.scene, plugins()), "rope/bar", "elastic");
  };
  EXPECT_TRUE(elastic(1e4, 0).on);
  EXPECT_TRUE(elastic(0, 1e4).on);
  EXPECT_EQ(elastic(0, 1e4).reason, "rope.EA_compression is set");
  EXPECT_FALSE(elastic(0, 0).on);
  EXPECT_EQ(elastic(0, 0).reason, "rope.EA and rope.EA_compression are zero");
}

TEST(ScenePlan, MakesOneFamilyOfPartsOfOneType) {
  Sketch s;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(1, 0, 0), c = s.node(2, 0, 0);
  s.rope("headline", {a, b}, 1);
  s.part("load", "test/load", {{"z", 1.0}}, {b});
  s.rope("footrope", {b, c}, 1);
  const ScenePlan plan = make_scene_plan(s.scene, plugins());
  ASSERT_EQ(plan.families.size(), 2u);
  EXPECT_EQ(plan.families[0].parts, (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(plan.families[0].elements, 2u);
}

TEST(ScenePlan, MakesAFamilyOfEachChoiceOfLawsInFlowingWater) {
  Sketch s;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(1, 0, 0);
  const double normal[] = {1, 1.1, 1};
  for (int i = 0; i < 3; ++i)
    s.rope("rope-" + std::to_string(i), {a, b}, 1).laws["drag"] = {"hydro/morison", {{"normal", normal[i]}}};
  EXPECT_EQ(make_scene_plan(s.scene, plugins()).families.size(), 1u);
  s.scene.current.samples = {{0, {1, 0, 0}}};
  const ScenePlan plan = make_scene_plan(s.scene, plugins());
  ASSERT_EQ(plan.families.size(), 2u);
  EXPECT_EQ(plan.families[0].parts, (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(plan.families[1].parts, std::vector<std::uint32_t>{1});
}

TEST(ScenePlan, SwitchesWeightOffWithoutGravityAndSaysWhy) {
  Scene scene = sample::hanging_rope(4);
  EXPECT_TRUE(term(make_scene_plan(scene, plugins()), "rope/bar", "weight").on);
  scene.water.gravity = 0;
  const ScenePlan plan = make_scene_plan(scene, plugins());
  EXPECT_FALSE(term(plan, "rope/bar", "weight").on);
  EXPECT_EQ(term(plan, "rope/bar", "weight").reason, "the scene has no gravity");
  EXPECT_TRUE(term(plan, "rope/bar", "elastic").on);
}

TEST(ScenePlan, NamesTheTermThatMakesTheMatrixUnsymmetric) {
  Sketch s;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(1, 0, 0);
  s.rope("rope", {a, b}, 1);
  s.part("push", "test/follower", {{"k", 1.0}}, {a, b}).data["rest_length"] = {1};
  const ScenePlan plan = make_scene_plan(s.scene, plugins());
  EXPECT_FALSE(plan.symmetric);
  EXPECT_FALSE(plan.conservative);
  EXPECT_EQ(plan.unsymmetric_because, "test/follower push");
}

TEST(ScenePlan, KeepsTheMatrixSymmetricBesideAConstantForce) {
  Sketch s;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(1, 0, 0);
  s.rope("rope", {a, b}, 1);
  s.part("load", "test/load", {{"z", 1.0}}, {b});
  EXPECT_TRUE(make_scene_plan(s.scene, plugins()).symmetric);
}

TEST(ScenePlan, ListsPluginsThatNobodyUses) {
  const ScenePlan plan = make_scene_plan(sample::hanging_rope(4), plugins());
  const auto idle = unused_plugins(plan, plugins());
  EXPECT_NE(std::find(idle.begin(), idle.end(), "priour"), idle.end());
  EXPECT_EQ(std::find(idle.begin(), idle.end(), "rope"), idle.end());
}

TEST(ScenePlan, RefusesAnElementThatNoPluginHas) {
  Sketch s;
  s.part("net", "priour/square", {}, {});
  EXPECT_THROW(make_scene_plan(s.scene, plugins()), UnknownComponent);
}

TEST(ScenePlan, WritesTraitsAsWords) {
  EXPECT_EQ(describe_traits(0), "none");
  EXPECT_EQ(describe_traits(NETLOFT_CONSERVATIVE | NETLOFT_SYMMETRIC), "conservative, symmetric");
}

/// The message about a scene whose only fault is in one of its parts.
std::string fault_of(const Scene& scene) {
  try {
    const Assembled a(scene);
    return "";
  } catch (const SceneError& e) {
    EXPECT_EQ(e.faults.size(), 1u);
    return e.faults.front().part + ": " + e.faults.front().message;
  }
}

TEST(Family, NamesThePartWhoseParametersAreWrong) {
  Scene scene = sample::hanging_rope(4);
  scene.parts[0].parameters["rope.EA"] = -1.0;
  EXPECT_NE(fault_of(scene).find("rope: "), std::string::npos);
  EXPECT_NE(fault_of(scene).find("rope.EA"), std::string::npos);
}

TEST(Family, NamesThePartThatLacksADatum) {
  Scene scene = sample::hanging_rope(4);
  scene.parts[0].data.clear();
  EXPECT_NE(fault_of(scene).find("rope: rope/bar needs \"rest_length\""), std::string::npos);
}

TEST(Family, NamesThePartWithTooFewNumbers) {
  Scene scene = sample::hanging_rope(4);
  scene.parts[0].data["rest_length"].pop_back();
  EXPECT_NE(fault_of(scene).find("\"rest_length\" has 3 numbers, but 4 are expected"), std::string::npos);
}

TEST(Family, NamesTheElementThatThePluginRefuses) {
  Scene scene = sample::hanging_rope(4);
  scene.parts[0].data["rest_length"][2] = 0;
  EXPECT_NE(fault_of(scene).find("rope: rope/bar element 2 is refused: "), std::string::npos);
}

}  // namespace
}  // namespace netloft::test
