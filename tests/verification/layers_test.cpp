// SPDX-License-Identifier: BSD-3-Clause
//
// Two layers of the same netting, sewn to one line, against one layer of double netting. Both hang in still
// water below a panel, so that weight and stiffness alone decide, and these are the sums of the layers.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "io/runs/equilibrium.hpp"
#include "io/runs/prepared_scene.hpp"
#include "tests/folders.hpp"

namespace netloft::test {
namespace {

constexpr const char* kFront = R"([analysis]
strategy = "auto"
[panels.front]
stands = "alone"
mesh = "1.2 m"
twine = { diameter = "10 mm", EA = "10 kN", EA_compression = "1 N", density = 2000 }
fore = 20
depth = 8
outer = "AN"
inner = "AN"
open = ["fore", "outer", "inner"]
sketch = [[0, -8, 0], [0, 8, 0], [0, 8, -7], [0, -8, -7]]
[panels.back]
stands = "alone"
mesh = "1.2 m"
twine = { diameter = "10 mm", EA = "10 kN", EA_compression = "1 N", density = 2000 }
fore = 20
depth = 12
outer = "AN"
inner = "AN"
open = ["aft", "outer", "inner"]
sketch = [[0, -8, -7], [0, 8, -7], [0, 8, -17], [0, -8, -17]]
[[hold]]
on = "front.fore"
)";
constexpr const char* kTwoLayers = R"([panels.liner]
stands = "alone"
mesh = "1.2 m"
twine = { diameter = "10 mm", EA = "10 kN", EA_compression = "1 N", density = 2000 }
fore = 20
depth = 12
outer = "AN"
inner = "AN"
open = ["aft", "outer", "inner"]
sketch = [[0, -8, -7], [0, 8, -7], [0, 8, -17], [0, -8, -17]]
[[join]]
edges = ["front.aft", "back.fore", "liner.fore"]
)";
constexpr const char* kOneLayer = R"([[join]]
edges = ["front.aft", "back.fore"]
)";

struct Hung {
  std::unique_ptr<runs::PreparedScene> scene;
  Solution solution;
  double lowest = 0, held = 0;
};

Hung hung(const std::string& name, const std::string& text, std::vector<std::string> settings) {
  const auto folder = std::filesystem::path(test::build_folder()) / "scratch";
  std::filesystem::create_directories(folder);
  const auto file = folder / (name + ".toml");
  std::ofstream(file) << text;
  Hung one{std::make_unique<runs::PreparedScene>(runs::CaseSource{file, std::move(settings), 1},
                                                 test::shipped_plugins()),
           {}};
  EXPECT_EQ(one.scene->prepare(), runs::PreparedScene::State::ready)
      << one.scene->diagnostics().render(false);
  one.solution = runs::find_equilibrium(*one.scene);
  EXPECT_EQ(one.solution.status, SolveStatus::converged) << one.solution.reason;
  const auto x = one.scene->assembler().node_positions(one.solution.x);
  for (std::size_t d = 2; d < x.size(); d += 3) one.lowest = std::min(one.lowest, x[d]);
  for (std::uint32_t n = 0; n < one.scene->loaded().scene.node_count(); ++n)
    one.held += one.scene->assembler().reaction(n, one.solution.residual)[2];
  return one;
}

TEST(Layers, HangLikeOneLayerOfDoubleNetting) {
  const Hung two = hung("two-layers", std::string(kFront) + kTwoLayers, {"gear.size=2 m"});
  const Hung one =
      hung("one-layer", std::string(kFront) + kOneLayer, {"gear.size=2 m", "panels.back.twines=2"});
  EXPECT_NEAR(two.held, one.held, 1e-9 * one.held);
  EXPECT_NEAR(two.solution.energy, one.solution.energy, 1e-9 * std::abs(one.solution.energy));
  EXPECT_NEAR(two.lowest, one.lowest, 1e-9 * std::abs(one.lowest));
}

}  // namespace
}  // namespace netloft::test
