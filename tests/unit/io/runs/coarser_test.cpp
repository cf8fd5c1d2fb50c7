// SPDX-License-Identifier: BSD-3-Clause
#include "io/runs/coarser.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "io/runs/equilibrium.hpp"
#include "io/runs/meshes.hpp"
#include "io/runs/prepared_scene.hpp"
#include "tests/folders.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::runs {
namespace {

constexpr const char* kPanel = "dead-weight-panel.toml";

std::unique_ptr<PreparedScene> opened(const std::string& scene, std::vector<std::string> overrides) {
  auto one = std::make_unique<PreparedScene>(
      CaseSource{test::source_folder() + "/gear-library/scenes/" + scene, std::move(overrides), 1},
      test::shipped_plugins());
  EXPECT_EQ(one->prepare(), PreparedScene::State::ready) << one->diagnostics().render(false);
  return one;
}

std::vector<std::string> texts_of(const scenes::LoadedScene& loaded) {
  std::vector<std::string> texts;
  for (const auto& change : halved_cells(loaded, Halved::all)) texts.push_back(change.text);
  return texts;
}

TEST(HalvedCells, AreThoseOfEveryPanelUntilTooFewAreLeft) {
  EXPECT_EQ(texts_of(opened(kPanel, {"parts.net.cells=[16,8]"})->loaded()),
            std::vector<std::string>{"parts.net.cells=[8, 4]"});
  EXPECT_TRUE(halved_cells(opened(kPanel, {"parts.net.cells=[16,6]"})->loaded(), Halved::all).empty());
}

TEST(HalvedCells, AreTheGreaterHalfOfAnOddNumber) {
  EXPECT_EQ(texts_of(opened(kPanel, {"parts.net.cells=[7,10]"})->loaded()),
            std::vector<std::string>{"parts.net.cells=[4, 5]"});
  EXPECT_TRUE(halved_cells(opened(kPanel, {"parts.net.cells=[5,7]"})->loaded(), Halved::all).empty());
  EXPECT_TRUE(halved_cells(opened(kPanel, {"parts.net.cells=[7,10]"})->loaded(), Halved::even_only).empty());
}

TEST(HalvedCells, LeaveAPartOfWhichANodeIsCalledByItsNumber) {
  for (const std::string numbered : {R"(hold=[{ on = ["net.fore", "net.node-40"] }])",
                                     R"(join=[{ points = ["net.node-20", "net.node-60"] }])"})
    EXPECT_TRUE(
        halved_cells(opened(kPanel, {"parts.net.cells=[8,8]", numbered})->loaded(), Halved::all).empty());
  const std::string asked = R"(results.z={ of = "net.node-40", take = "min z" })";
  EXPECT_FALSE(halved_cells(opened(kPanel, {"parts.net.cells=[8,8]", asked})->loaded(), Halved::all).empty());
}

TEST(HalvedCells, LeaveAGearOfWhichANodeIsCalledByItsNumber) {
  constexpr const char* kGear = "four-panel.toml";
  EXPECT_EQ(texts_of(opened(kGear, {})->loaded()), std::vector<std::string>{"gear.nodes=250"});
  for (const std::string numbered : {R"(hold=[{ on = ["door", "top.node-12"] }])",
                                     R"(parts.more={ type = "force/constant", on = ["headline.node-1"] })"})
    EXPECT_TRUE(halved_cells(opened(kGear, {numbered})->loaded(), Halved::all).empty()) << numbered;
}

// The energy of an interpolated answer is that of the coarse mesh, except for the few fine triangles that a
// coarse diagonal divides. In these triangles, the mean of two twines replaces both, and it is never longer
// than they are on average.
TEST(CarriedOver, StretchesNothingThatWasNotStretched) {
  auto coarse = opened(kPanel, {"parts.net.cells=[8,8]", "analysis.solver=newton"});
  auto fine = opened(kPanel, {"parts.net.cells=[16,16]"});
  const Solution s = find_equilibrium(*coarse);
  const auto carried =
      carried_over(coarse->loaded(), coarse->assembler().node_positions(s.x), fine->loaded());
  ASSERT_TRUE(carried);
  std::vector<double> x = fine->assembler().start();
  fine->assembler().place(fine->assembler().displacements(*carried), x);
  double energy = 0;
  ASSERT_TRUE(fine->assembler().evaluate(x, {.energy = &energy}));
  EXPECT_LE(energy, s.energy + 1e-9 * std::abs(s.energy));
  EXPECT_NEAR(energy, s.energy, 0.01 * std::abs(s.energy));
}

class CarriedOverItself : public testing::TestWithParam<const char*> {};

TEST_P(CarriedOverItself, GivesBackItsOwnNodes) {
  auto one = opened(GetParam(), {});
  const auto same = carried_over(one->loaded(), one->loaded().scene.positions, one->loaded());
  ASSERT_TRUE(same);
  for (std::size_t d = 0; d < same->size(); ++d)
    EXPECT_NEAR((*same)[d], one->loaded().scene.positions[d], 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Scenes, CarriedOverItself,
                         testing::Values("hanging-rope.toml", kPanel,
                                         "verification/tractrix-between-rings.toml"),
                         [](const auto& scene) {
                           std::string name = scene.param;
                           std::erase_if(name,
                                         [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
                           return name;
                         });

// A panel that is drawn flat has positions that are linear across and along it, so that interpolation is
// exact for every division into cells.
class CrossedCells : public testing::TestWithParam<const char*> {};

TEST_P(CrossedCells, AreCarriedToFinerOnes) {
  auto coarse = opened(kPanel, {"parts.net.cells=[8,8]", GetParam()});
  auto fine = opened(kPanel, {"parts.net.cells=[20,20]", GetParam()});
  const auto carried = carried_over(coarse->loaded(), coarse->loaded().scene.positions, fine->loaded());
  ASSERT_TRUE(carried);
  const auto& places = fine->loaded().scene.positions;
  ASSERT_EQ(carried->size(), std::size_t{3} * (21 * 21 + 20 * 20));
  for (std::size_t d = 0; d < places.size(); ++d) EXPECT_NEAR((*carried)[d], places[d], 1e-9);
}

INSTANTIATE_TEST_SUITE_P(OfBoth, CrossedCells,
                         testing::Values("parts.net.division=crossed", "parts.net.type=lumped/net"),
                         [](const auto& one) { return std::string(one.index ? "Bars" : "Triangles"); });

std::size_t nodes_of(const Scene& scene) { return scene.positions.size() / 3; }

TEST(CoarserMeshes, LeaveOddNumbersWhereHalfOfThemDoesNotFit) {
  const CaseSource source{test::source_folder() + "/tests/unit/io/runs/odd-panels.toml", {}, 1};
  PreparedScene finest(source, test::shipped_plugins());
  ASSERT_EQ(finest.prepare(), PreparedScene::State::ready) << finest.diagnostics().render(false);
  Registry& registry = test::shipped_plugins();
  Meshes meshes(source, finest.loaded(), registry);
  const Scene* const coarse = meshes.scene(1);
  ASSERT_TRUE(coarse);
  EXPECT_EQ(nodes_of(finest.loaded().scene) - nodes_of(*coarse), std::size_t{17 * 17 - 9 * 9});
}

// From 7 to 4 cells only nodes on the edges coincide. On a panel that is drawn flat, interpolation is exact
// nevertheless.
TEST(CoarserMeshes, OfOddNumbersCarryAFlatSketch) {
  const CaseSource source{
      test::source_folder() + "/gear-library/scenes/" + kPanel, {"parts.net.cells=[7,7]"}, 1};
  PreparedScene finest(source, test::shipped_plugins());
  ASSERT_EQ(finest.prepare(), PreparedScene::State::ready) << finest.diagnostics().render(false);
  Registry& registry = test::shipped_plugins();
  Meshes meshes(source, finest.loaded(), registry);
  ASSERT_TRUE(meshes.scene(1));
  EXPECT_EQ(nodes_of(*meshes.scene(1)), std::size_t{25});
  const auto& fine = finest.loaded().scene.positions;
  const auto there = meshes.carry(0, fine, 1), back = meshes.carry(1, there, 0);
  ASSERT_EQ(back.size(), fine.size());
  for (std::size_t d = 0; d < fine.size(); ++d) EXPECT_NEAR(back[d], fine[d], 1e-9);
}

TEST(CoarserMeshes, LeadToACrossedTubeBetweenTwoRings) {
  auto tube = opened("verification/tractrix-between-rings.toml", {});
  const Solution s = find_equilibrium(*tube);
  EXPECT_EQ(s.status, SolveStatus::converged) << s.reason;
}

// Without stiffness in compression the panel has only one equilibrium, which coarser meshes must not change.
TEST(CoarserMeshes, LeadToTheAnswerThatIsFoundWithoutThem) {
  const std::vector<std::string> same{"parts.net.cells=[32,32]", "parts.net.twine.EA_compression=1"};
  auto with = same, without = same;
  with.push_back("analysis.strategy=auto"), without.push_back("analysis.solver=newton");
  auto a = opened(kPanel, with), b = opened(kPanel, without);
  const Solution sa = find_equilibrium(*a), sb = find_equilibrium(*b);
  EXPECT_EQ(sa.status, SolveStatus::converged) << sa.reason;
  ASSERT_GT(sa.cost.stages.size(), 1u);
  EXPECT_EQ(sa.cost.stages.back().unknowns, a->plan().unknowns);
  const auto xa = a->assembler().node_positions(sa.x), xb = b->assembler().node_positions(sb.x);
  for (std::size_t d = 0; d < xa.size(); ++d) EXPECT_NEAR(xa[d], xb[d], 1e-7);
}

}  // namespace
}  // namespace netloft::runs
