// SPDX-License-Identifier: BSD-3-Clause
//
// Loss factors of materials: at 10 Hz, each swing of a mass on a rope is exp(-π η) times the swing before it.
#include "io/runs/march.hpp"
#include "io/runs/prepared_scene.hpp"
#include "tests/folders.hpp"
#include "tests/verification/solving.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace netloft::runs {
namespace {

// A weight of 10 kg on a rope of 10 m, released at the unstretched length of the rope.
const std::string kBounce = test::source_folder() + "/io/program/templates/integrator/my_integrator.toml";

// Gravity [m/s²]: so large that strains are far above the strain at which damping begins.
constexpr double kGravity = 100;

/// The changes that make the weight oscillate at f [Hz], and `more`.
std::vector<std::string> bounce(double f, const std::vector<std::string>& more) {
  const double omega = 2 * std::numbers::pi * f;
  std::vector<std::string> all = {"analysis.integrator=newmark",
                                  "parts.rope.rope.EA=" + std::to_string(100 * omega * omega),
                                  "water.gravity=" + std::to_string(kGravity),
                                  "analysis.adaptive=false",
                                  "analysis.step=" + std::to_string(1 / (400 * f)),
                                  "analysis.duration=" + std::to_string(6 / f),
                                  "analysis.output_interval=" + std::to_string(1 / (400 * f)),
                                  "analysis.tolerance=1e-10"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// The mean logarithmic decrement of the oscillation, without the first swing, which begins with a slack
/// rope.
double decrement(double f, const std::vector<std::string>& more) {
  const double omega = 2 * std::numbers::pi * f, sag = kGravity / (omega * omega);
  PreparedScene one({kBounce, bounce(f, more), 1}, test::shipped_plugins());
  EXPECT_EQ(one.prepare(), PreparedScene::State::ready) << one.diagnostics().render(false);
  std::vector<double> z, lows;
  MarchWatch watch;
  watch.on_output = [&](const Snapshot& at) {
    z.push_back(-10 - sag - one.assembler().node_positions({at.x.begin(), at.x.end()})[5]);
  };
  const MarchResult r = march(one, watch);
  EXPECT_EQ(r.status, MarchStatus::finished) << r.reason;
  for (std::size_t i = 1; i + 1 < z.size(); ++i)
    if (z[i] > z[i - 1] && z[i] >= z[i + 1]) {
      const double slope = 0.5 * (z[i + 1] - z[i - 1]), bend = z[i + 1] - 2 * z[i] + z[i - 1];
      lows.push_back(z[i] - 0.5 * slope * slope / bend);
    }
  EXPECT_GE(lows.size(), 5u);
  return std::log(lows[1] / lows[4]) / 3;
}

TEST(MaterialDamping, TakesTheLossFactorOutOfEachSwing) {
  for (const double eta : {0.02, 0.05, 0.1}) {
    const double expected = std::numbers::pi * eta;
    EXPECT_NEAR(decrement(10, {"parts.rope.rope.loss_factor=" + std::to_string(eta)}), expected,
                0.01 * expected);
  }
}

TEST(MaterialDamping, IsOfTheFrequencyThatItIsMeantFor) {
  const double expected = std::numbers::pi * 0.05;
  EXPECT_NEAR(decrement(2, {"parts.rope.rope.loss_factor=0.05", "parts.rope.rope.loss_frequency=2"}),
              expected, 0.01 * expected);
  EXPECT_NEAR(decrement(20, {"parts.rope.rope.loss_factor=0.05"}), 2 * expected, 0.02 * expected);
}

TEST(MaterialDamping, IsTurnedOffByOneKey) {
  EXPECT_NEAR(decrement(10, {"parts.rope.rope.loss_factor=0.1", "analysis.material_damping=false"}), 0, 1e-4);
}

std::string said_of(const std::vector<std::string>& more) {
  PreparedScene one({kBounce, bounce(10, more), 1}, test::shipped_plugins());
  EXPECT_EQ(one.prepare(), PreparedScene::State::ready) << one.diagnostics().render(false);
  EXPECT_EQ(one.diagnostics().warnings(), 1);  // the warning about a gravity that does not occur on Earth
  return one.material_damping();
}

TEST(MaterialDamping, IsSaidWithWhatTakesItsPlace) {
  const std::string loss = "parts.rope.rope.loss_factor=0.05";
  EXPECT_EQ(said_of({}), "");
  EXPECT_EQ(said_of({loss}), "loss factor 0.05 of rope at 10 Hz");
  EXPECT_EQ(said_of({loss, "parts.rope.rope.damping=3"}), "");
  EXPECT_EQ(said_of({loss, "analysis.material_damping=false"}), "off: material_damping = false");
  EXPECT_EQ(said_of({loss, "analysis.stiffness_damping=0.01"}), "off: stiffness_damping replaces it");
  EXPECT_EQ(
      said_of({loss, "analysis.integrator=central-difference"}),
      "off: central-difference is stable in short steps only, and material damping would make them shorter");
  EXPECT_EQ(said_of({loss, "analysis.kind=static"}), "loss factor 0.05 of rope at 10 Hz");
}

}  // namespace
}  // namespace netloft::runs
