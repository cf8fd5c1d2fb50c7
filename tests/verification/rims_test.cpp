// SPDX-License-Identifier: BSD-3-Clause
//
// Netting on the rims of rigid bodies: a bag on a hoop, and a tube between a hoop and a grid that hangs from
// it.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "io/runs/equilibrium.hpp"
#include "io/runs/prepared_scene.hpp"
#include "tests/folders.hpp"

namespace netloft::test {
namespace {

constexpr const char* kHoop = R"([panels.net]
mesh = "40 mm"
twine = { diameter = "1.5 mm", EA = "2 kN", density = 1140 }
round = 160
depth = 60
[bodies.hoop]
type = "body/solid"
stands = "middle"
at = [0, 0, -10]
turns = "not"
rim = { edge = "net.fore", width = "1.5 m", height = "1.2 m", at = [0.1, 0, 0.2] }
body = { mass = "20 kg", volume = 0.003, inertia_x = 10, inertia_y = 5, inertia_z = 5 }
[water]
current = ["1 m/s", 0, 0]
[[hold]]
on = "hoop.origin"
[analysis]
strategy = "auto"
)";
constexpr const char* kClosed = R"([[join]]
edges = ["net.aft", "net.aft"]
)";
constexpr const char* kGrid = R"([bodies.grid]
type = "body/solid"
stands = "middle"
at = [1.6, 0, -10]
turns = "about y"
rim = { edge = "net.aft", width = "1 m", height = "1.3 m" }
turned = { trim = "-40 deg" }
body = { mass = "30 kg", volume = 0.006, inertia_x = 10, inertia_y = 5, inertia_z = 5, drag_x = 0.3, drag_z = 0.05 }
)";

class Rims : public testing::Test {
 protected:
  void solve(const std::string& name, const std::string& text) {
    const auto folder = std::filesystem::path(test::build_folder()) / "scratch";
    std::filesystem::create_directories(folder);
    const auto file = folder / (name + ".toml");
    std::ofstream(file) << text;
    scene_ = std::make_unique<runs::PreparedScene>(runs::CaseSource{file, {"gear.nodes=600"}, 1},
                                                   test::shipped_plugins());
    ASSERT_EQ(scene_->prepare(), runs::PreparedScene::State::ready) << scene_->diagnostics().render(false);
    found_ = runs::find_equilibrium(*scene_);
    ASSERT_EQ(found_.status, SolveStatus::converged) << found_.reason;
    x_ = scene_->assembler().node_positions(found_.x);
  }
  std::array<double, 3> at(std::uint32_t node) const {
    return {x_[3 * std::size_t{node}], x_[3 * std::size_t{node} + 1], x_[3 * std::size_t{node} + 2]};
  }
  const RigidBody& body(std::size_t b) const { return scene_->loaded().scene.bodies[b]; }

  std::unique_ptr<runs::PreparedScene> scene_;
  Solution found_;
  std::vector<double> x_;
};

TEST_F(Rims, CarryTheEdgeOfABag) {
  solve("hoop", std::string(kHoop) + kClosed);
  ASSERT_GE(body(0).points.size(), 8u);
  for (const auto& point : body(0).points) {
    const auto [x, y, z] = at(point.node);
    EXPECT_NEAR(x, 0.1, 1e-12);
    EXPECT_NEAR(std::pow(y / 0.75, 2) + std::pow((z + 9.8) / 0.6, 2), 1, 1e-12) << "on the ellipse";
  }
}

// The plane of the grid turns about y as a whole, and the whole of the forces on the gear is that of the
// hold.
TEST_F(Rims, TurnWithAGridThatIsFree) {
  solve("grid", std::string(kHoop) + kGrid);
  const auto origin = at(body(1).origin);
  double turn = 0;
  for (const auto& point : body(1).points) {
    const auto [x, y, z] = at(point.node);
    EXPECT_NEAR(std::hypot(x - origin[0], y - origin[1], z - origin[2]),
                std::hypot(point.r[0], point.r[1], point.r[2]), 1e-9);
    EXPECT_NEAR(y - origin[1], point.r[1], 1e-9) << "it turns about y alone";
    if (std::abs(point.r[2]) > 0.3)
      turn = std::atan2(x - origin[0], z - origin[2]) + (point.r[2] < 0 ? M_PI : 0);
  }
  EXPECT_GT(std::abs(std::sin(turn)), 0.01) << "the water turns the grid";
  double drag = 0;
  for (std::uint32_t n = 0; n < scene_->loaded().scene.node_count(); ++n)
    drag -= scene_->assembler().reaction(n, found_.residual)[0];
  EXPECT_GT(drag, 100) << "all of it is held at the origin of the hoop";
}

TEST_F(Rims, AreNotForSheetsThatAreOpenBelow) {
  std::string text = kHoop;
  text.replace(text.find("round = 160"), 11, "fore = 160\nsides = \"AN\"\nopen = [\"sides\", \"aft\"]");
  const auto file = std::filesystem::path(test::build_folder()) / "scratch" / "open-rim.toml";
  std::ofstream(file) << text;
  runs::PreparedScene scene(runs::CaseSource{file, {}, 1}, test::shipped_plugins());
  EXPECT_NE(scene.prepare(), runs::PreparedScene::State::ready);
  EXPECT_NE(scene.diagnostics().render(false).find("\"net.fore\" does not close to a ring"),
            std::string::npos)
      << scene.diagnostics().render(false);
}

TEST_F(Rims, AreNotLongerThanTheirNettingStretches) {
  std::string text = std::string(kHoop) + kClosed;
  text.replace(text.find("width = \"1.5 m\""), 15, "width = \"3.0 m\"");
  const auto file = std::filesystem::path(test::build_folder()) / "scratch" / "long-rim.toml";
  std::ofstream(file) << text;
  runs::PreparedScene scene(runs::CaseSource{file, {}, 1}, test::shipped_plugins());
  EXPECT_NE(scene.prepare(), runs::PreparedScene::State::ready);
  EXPECT_NE(scene.diagnostics().render(false).find(
                "\"net.fore\" is 6.4 m long when its meshes are stretched, but the rim 6.9"),
            std::string::npos)
      << scene.diagnostics().render(false);
}

}  // namespace
}  // namespace netloft::test
