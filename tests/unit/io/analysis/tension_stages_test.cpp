// SPDX-License-Identifier: BSD-3-Clause
#include "io/analysis/tension_stages.hpp"

#include "io/analysis/case.hpp"
#include "solvers/factorisation/factorisation.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/verification/solving.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace netloft::io {
namespace {

/// Solved in stages, and by newton from the sketch: the same place, with nothing left for newton to do.
void expect_same_place(const Scene& scene, double size) {
  const StagedSolution staged = solve_in_stages(scene, test::shipped_plugins(), make_factorisation, 1);
  EXPECT_TRUE(staged.arrived);
  Scene there = scene;
  there.positions = staged.positions;
  const test::Solved confirmed = test::solve(there, {{}, {.tolerance = 1e-8}}), direct = test::solve(scene);
  EXPECT_EQ(confirmed.solution.books.iterations, 0);
  ASSERT_EQ(confirmed.solution.status, SolveStatus::converged) << confirmed.solution.reason;
  ASSERT_EQ(direct.solution.status, SolveStatus::converged) << direct.solution.reason;
  double furthest = 0;
  for (std::size_t i = 0; i < direct.solution.x.size(); ++i)
    furthest = std::max(furthest, std::abs(direct.solution.x[i] - confirmed.solution.x[i]));
  EXPECT_LT(furthest, 1e-6 * size);
}

TEST(TensionStages, LeadARopeToWhereItHangs) { expect_same_place(sample::hanging_rope(40), 100); }

TEST(TensionStages, LeadAPanelThatStartsSlackToWhereItHangs) {
  expect_same_place(sample::hanging_panel(8, 30), 48);
}

Solution run(const std::string& continuation) {
  Case one({NETLOFT_SOURCE_DIR "/gear-library/scenes/verification/tractrix-between-rings.toml",
            {"analysis.continuation=" + continuation}},
           test::shipped_plugins());
  EXPECT_EQ(one.open(), Case::State::ready) << one.diagnostics().render(false);
  return one.solve();
}

TEST(TensionStages, AreAContinuationThatScenesMayAskFor) {
  const Solution staged = run("tensions"), as_ever = run("default");
  ASSERT_EQ(staged.status, SolveStatus::converged) << staged.reason;
  ASSERT_EQ(as_ever.status, SolveStatus::converged) << as_ever.reason;
  ASSERT_GT(staged.legs.size(), 2u);
  EXPECT_EQ(staged.legs.front().name, "soft, from the start");
  EXPECT_LT(staged.books.factorisations, as_ever.books.factorisations);
  for (std::size_t i = 0; i < staged.x.size(); ++i) ASSERT_NEAR(staged.x[i], as_ever.x[i], 1e-5);
}

// Ropes, netting in triangles and netting in bars say by the roles of their parameters that they are such; a
// seabed and bending do not.
TEST(AxialMembers, AreThoseOfWhateverHasOneStiffnessInNewtonsAndOneWhenSlack) {
  const auto members_of = [](const std::string& scene, std::vector<std::string> overrides) {
    Case one({NETLOFT_SOURCE_DIR "/gear-library/scenes/" + scene, std::move(overrides)},
             test::shipped_plugins());
    EXPECT_EQ(one.open(), Case::State::ready) << one.diagnostics().render(false);
    std::map<std::string, std::size_t> count;
    for (const AxialMember& m : axial_members(one.loaded().scene, test::shipped_plugins()))
      ++count[one.loaded().scene.parts[m.part].type];
    return count;
  };
  using Count = std::map<std::string, std::size_t>;
  EXPECT_EQ(members_of("dead-weight-panel.toml", {"parts.net.cells=[4,4]"}),
            (Count{{"priour/triangle", 64}}));
  EXPECT_GT(members_of("dead-weight-panel.toml",
                       {"parts.net.cells=[4,4]", "parts.net.type=lumped/net"})["lumped/net"],
            0u);
  EXPECT_EQ(members_of("verification/catenary-on-seabed.toml", {}).count("seabed/plane"), 0u);
  EXPECT_EQ(members_of("verification/cantilever.toml", {}).count("rope/bending"), 0u);
}

TEST(TensionStages, RefuseNodesThatMoveOtherwise) {
  Scene scene = sample::hanging_rope(4);
  scene.frames[0] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  EXPECT_THROW(solve_in_stages(scene, test::shipped_plugins(), make_factorisation, 1), std::invalid_argument);
}

}  // namespace
}  // namespace netloft::io
