// SPDX-License-Identifier: BSD-3-Clause
//
// The hanging panel of the paper's fig. 6a from a net plan in which every knot is a node, compared with the
// same net modelled twine by twine, as solved by an independent program (lumped_test.cpp). Twines and knots
// are the same; only the weights at the edges differ: a triangle puts a third of its weight on each corner,
// and a bar half of its weight on each end.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "io/runs/equilibrium.hpp"
#include "io/runs/prepared_scene.hpp"
#include "tests/folders.hpp"
#include "tests/verification/reference.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::test {
namespace {

constexpr const char* kPlan = R"([water]
density = 1025
gravity = 9.81
[gear]
nodes = "knots"
[panels.net]
stands = "alone"
mesh = "1.2 m"
twine = { diameter = "10 mm", EA = "10 kN", EA_compression = "1 N", density = 2000 }
fore = 40
depth = 40
outer = "AN"
inner = "AN"
open = ["fore", "aft", "outer", "inner"]
sketch = [[0, -16, 0], [0, 16, 0], [0, 16, -34], [0, -16, -34]]
[[hold]]
on = "net.fore"
[analysis]
strategy = "coarse-to-fine"
)";

class PanelByKnots : public testing::Test {
 protected:
  std::unique_ptr<runs::PreparedScene> opened(std::vector<std::string> overrides) {
    const auto folder = std::filesystem::path(test::build_folder()) / "scratch";
    std::filesystem::create_directories(folder);
    const auto file = folder / "panel-by-knots.toml";
    std::ofstream(file) << kPlan;
    auto one = std::make_unique<runs::PreparedScene>(runs::CaseSource{file, std::move(overrides), 1},
                                                     test::shipped_plugins());
    EXPECT_EQ(one->prepare(), runs::PreparedScene::State::ready) << one->diagnostics().render(false);
    return one;
  }
  static double lowest(runs::PreparedScene& one, const Solution& s) {
    double low = 0;
    const auto x = one.assembler().node_positions(s.x);
    for (std::size_t d = 2; d < x.size(); d += 3) low = std::min(low, x[d]);
    return low;
  }
};

TEST_F(PanelByKnots, HangsTwineByTwineAsTheIndependentProgramSays) {
  const auto one = opened({});
  EXPECT_EQ(one->loaded().scene.node_count(), 41u * 41 + 40 * 40) << "a node for every knot";
  const Solution s = runs::find_equilibrium(*one);
  ASSERT_EQ(s.status, SolveStatus::converged) << s.reason;
  EXPECT_NEAR(lowest(*one, s), kPanelLowestZ, 2e-3);
  EXPECT_NEAR(s.energy, kPanelEnergy, 2e-3 * std::abs(kPanelEnergy));
  double held = 0;
  for (std::uint32_t n = 0; n < one->loaded().scene.node_count(); ++n)
    held += one->assembler().reaction(n, s.residual)[2];
  EXPECT_NEAR(held, kPanelTopReaction, 1e-6 * kPanelTopReaction);
}

// With the same number of nodes, triangles that are not between knots have ten times the error.
TEST_F(PanelByKnots, IsNearerToTheNetThanTrianglesOfAsManyNodes) {
  const auto one = opened({"gear.nodes=3281"});
  const Solution s = runs::find_equilibrium(*one);
  ASSERT_EQ(s.status, SolveStatus::converged) << s.reason;
  EXPECT_GT(std::abs(lowest(*one, s) - kPanelLowestZ), 1e-2);
}

}  // namespace
}  // namespace netloft::test
