// SPDX-License-Identifier: BSD-3-Clause
#include "io/runs/diagnosis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "io/runs/equilibrium.hpp"
#include "io/runs/prepared_scene.hpp"
#include "tests/folders.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::runs {
namespace {

using Change = std::function<void(scenes::LoadedScene&)>;

Solution solution_of(const std::string& scene, std::vector<std::string> overrides,
                     const Change& change = {}) {
  PreparedScene one({test::source_folder() + "/" + scene, std::move(overrides), 1}, test::shipped_plugins());
  EXPECT_EQ(one.prepare(change), PreparedScene::State::ready) << one.diagnostics().render(false);
  return find_equilibrium(one);
}

bool has_sign(const Solution& s, const char* words) {
  return std::any_of(s.diagnostics.begin(), s.diagnostics.end(),
                     [&](const std::string& sign) { return sign.find(words) != sign.npos; });
}

constexpr const char* kFloat = "tests/stability/scenes/float-on-rope.toml";

// A float straight below its hold, on a rope that acts as a rod: in equilibrium, the rope bears the whole
// buoyancy as compression.
TEST(Diagnosis, NamesWhatStandsByCompression) {
  const auto turned_over = [](scenes::LoadedScene& loaded) {
    for (std::size_t d = 2; d < loaded.scene.positions.size(); d += 3)
      loaded.scene.positions[d] = -400 - loaded.scene.positions[d];
  };
  const Solution s = solution_of(kFloat,
                                 {"analysis.solver=newton", "analysis.newton.method=classic",
                                  "parts.rope.cells=10", "parts.rope.rope.EA_compression=1e5"},
                                 turned_over);
  EXPECT_EQ(s.status, SolveStatus::unstable);
  EXPECT_TRUE(has_sign(s, "rope bears compression in 10 of 10 elements"));
}

// The rope of 150 m between two points 148 m apart is slack at the start; no iteration is allowed.
TEST(Diagnosis, NamesWhatIsSlack) {
  const Solution s = solution_of(kFloat, {"analysis.solver=newton", "analysis.max_iterations=0"});
  EXPECT_EQ(s.status, SolveStatus::not_converged);
  EXPECT_TRUE(has_sign(s, "rope is slack: no force pulls at it"));
}

// The rope of 67 bars turns back at its eleventh node.
TEST(Diagnosis, CountsFolds) {
  const auto folded = [](scenes::LoadedScene& loaded) {
    auto& x = loaded.scene.positions;
    for (std::size_t d = 3 * 11 + 2; d < x.size(); d += 3) x[d] = 2 * x[3 * 10 + 2] - x[d];
  };
  const Solution s = solution_of(kFloat, {"analysis.solver=newton", "analysis.max_iterations=0"}, folded);
  EXPECT_TRUE(has_sign(s, "rope is folded back on itself at 1 place"));
}

// Dynamic relaxation follows the rope as it slides; Newton's method finds that nothing resists that motion.
TEST(Diagnosis, NamesWhatHasGone) {
  const char* sliding = "tests/stability/scenes/sliding-rope.toml";
  const Solution s = solution_of(sliding, {"analysis.solver=relaxation"});
  EXPECT_EQ(s.status, SolveStatus::not_converged);
  EXPECT_TRUE(has_sign(s, "times the size of the gear"));
  const std::string reason = solution_of(sliding, {"analysis.solver=newton"}).reason;
  EXPECT_NE(reason.find("nothing resists some motion of the gear"), std::string::npos) << reason;
}

TEST(Diagnosis, HasNothingToSayOfWhatArrived) {
  EXPECT_TRUE(solution_of(kFloat, {"analysis.solver=newton"}).diagnostics.empty());
}

}  // namespace
}  // namespace netloft::runs
