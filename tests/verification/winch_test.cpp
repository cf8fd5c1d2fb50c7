// SPDX-License-Identifier: BSD-3-Clause
//
// Winches that hold a tension in a motion, compared with closed forms, and their work in the energy budget.
#include "io/runs/march.hpp"
#include "io/runs/prepared_scene.hpp"
#include "tests/folders.hpp"
#include "tests/verification/solving.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace netloft {
namespace {

constexpr double kMass = 5, kGravity = 9.81, kLength = 30;  // [kg], [m/s2], [m]

/// A ball on a light rope that hangs from a winch, in air.
std::vector<std::string> hanging_ball(std::vector<std::string> more) {
  std::vector<std::string> all = {"parts.rope.length=\"30 m\"",
                                  "parts.rope.sketch=[[0,0,0],[0,0,-30]]",
                                  "parts.rope.rope.density=0.1",
                                  "parts.rope.rope.EA=\"5 MN\"",
                                  "analysis.integrator=energy-momentum",
                                  "analysis.start=equilibrium",
                                  "analysis.solver=chord",
                                  "analysis.tolerance=1e-9",
                                  "analysis.duration=2",
                                  "analysis.output_interval=0.25"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// The scene with a winch at the start of its rope.
std::unique_ptr<runs::PreparedScene> open_with(const std::string& scene,
                                               const std::vector<std::string>& overrides, Winch winch,
                                               bool at_end = false) {
  auto c = std::make_unique<runs::PreparedScene>(
      runs::CaseSource{test::source_folder() + "/" + scene, overrides, 1}, test::shipped_plugins());
  const auto state = c->prepare([&](scenes::LoadedScene& loaded) {
    Part& rope = loaded.scene.parts[0];
    winch.part = rope.name, winch.parameter = "rope.length_share",
    winch.block = at_end ? rope.nodes.back() : rope.nodes.front();
    rope.parameters[winch.parameter] = Samples{{0, 1}, {1, 1}};
    loaded.scene.winches.push_back(winch);
  });
  if (state != runs::PreparedScene::State::ready) throw std::invalid_argument(c->diagnostics().render(false));
  return c;
}

struct Moment {
  double t, length, speed, tension, z, numerical, given;
};
struct Marched {
  std::vector<Moment> moments;
  std::vector<MarchState> states;
  MarchResult result;
};

Marched march(runs::PreparedScene& c, const MarchState* from = nullptr) {
  Marched m;
  MarchWatch watch;
  watch.on_output = [&](const Snapshot& s) {
    const WinchMoment& w = s.winches[0];
    const auto place = c.assembler().node_position(c.loaded().scene.parts[0].nodes.back(), s.x);
    double given = 0;
    for (const double g : s.budget->totals().given) given += std::abs(g);
    m.moments.push_back({s.t, w.length, w.speed, w.tension, place[2], s.budget->totals().numerical, given});
    if (s.state) m.states.push_back(*s.state);
  };
  m.result = runs::march(c, watch, {}, from);
  EXPECT_EQ(m.result.status, MarchStatus::finished) << m.result.reason;
  return m;
}

using Follows = WinchStage::Follows;
using Rows = std::vector<std::array<double, 2>>;

/// A winch that holds a tension.
Winch holding(double length, Rows tension, double max_speed, double band, double dead_band = 0) {
  return {"", "", 0, length, {{Follows::tension, 0, std::move(tension), max_speed, band, dead_band}}};
}
Winch winch_of(double tension, double max_speed, double band, double dead_band = 0) {
  return holding(kLength, {{0, tension}}, max_speed, band, dead_band);
}

const std::string kBall = "gear-library/scenes/dynamics/elastic-pendulum.toml";

/// m dv/dt = W − T* − B v/v_max: with τ = m v_max/B, v = (W − T*)/m τ (1 − exp(−t/τ)).
class BallOnAWinch : public testing::TestWithParam<double> {};

TEST_P(BallOnAWinch, FallsAndRisesAsTheForcesOnItSay) {
  const double tension = GetParam() * kMass * kGravity, max_speed = 10, band = 2,
               tau = kMass * max_speed / band;
  const auto c =
      open_with(kBall, hanging_ball({"analysis.accuracy=1e-4"}), winch_of(tension, max_speed, band));
  const double a = kGravity - tension / kMass, start = c->loaded().scene.positions[2];
  const Marched m = march(*c);
  ASSERT_EQ(m.moments.size(), 9u);
  for (const Moment& at : m.moments) {
    const double v = a * tau * (1 - std::exp(-at.t / tau)), way = a * tau * at.t - tau * v;
    EXPECT_NEAR(start - kLength - at.z, way, 2e-3 * (1 + std::abs(way))) << at.t;
    EXPECT_NEAR(at.length - kLength, way, 2e-3 * (1 + std::abs(way))) << at.t;
    if (at.t > 0.5) EXPECT_NEAR(at.tension, tension, band);
  }
}
INSTANTIATE_TEST_SUITE_P(Tensions, BallOnAWinch, testing::Values(0.8, 1.0, 1.15));

TEST(Winches, RunNoFasterThanTheyCan) {
  const auto c = open_with(kBall, hanging_ball({}), winch_of(0.5 * kMass * kGravity, 0.1, 2));
  for (const Moment& at : march(*c).moments) {
    if (at.t == 0) continue;
    EXPECT_DOUBLE_EQ(at.speed, 0.1);
    EXPECT_NEAR(at.length, kLength + 0.1 * at.t, 1e-9);
  }
}

TEST(Winches, StandWithinTheirDeadBand) {
  const auto c = open_with(kBall, hanging_ball({}), winch_of(kMass * kGravity + 1, 2, 2, 1.5));
  for (const Moment& at : march(*c).moments) EXPECT_EQ(at.length, kLength);
}

/// A line from the bed to a block that heaves.
std::unique_ptr<runs::PreparedScene> heaving(const Winch& winch, const std::vector<std::string>& more) {
  std::vector<std::string> all = {"parts.line.sketch=[[0,0,-30],[0,0,0]]",
                                  "parts.line.length=29.86",
                                  "parts.line.cells=8",
                                  "water.current=[0,0,0]",
                                  "hold[1].displacement={t=[0,1,2,3,4,5,6],z=[0,0.5,0,-0.5,0,0.5,0]}",
                                  "analysis.start=equilibrium",
                                  "analysis.integrator=energy-momentum",
                                  "analysis.duration=6",
                                  "analysis.output_interval=0.25"};
  all.insert(all.end(), more.begin(), more.end());
  return open_with("tests/bench/motions/heave.toml", all, winch, true);
}

/// The winch compensates the motion of the ship: T = T* + B w/v_max with the velocity w of the block, and the
/// length of the line is the distance from the bed to the block at that tension.
TEST(Winches, GiveAndTakeWhatAShipHeaves) {
  const double wanted = 2000, max_speed = 3, band = 300, EA = 424e3;
  const auto c = heaving(holding(29.86, {{0, wanted}}, max_speed, band), {"analysis.accuracy=1e-3"});
  double shortest = 100, longest = 0;
  for (const Moment& at : march(*c).moments) {
    if (at.t == 0) continue;
    EXPECT_NEAR(at.tension, wanted + band * at.speed / max_speed, 2e-3 * band) << at.t;
    EXPECT_NEAR(at.length, (30 + at.z) / (1 + at.tension / EA), 5e-3) << at.t;
    shortest = std::min(shortest, at.length), longest = std::max(longest, at.length);
  }
  EXPECT_NEAR(longest - shortest, 1, 0.02);
}

/// Without damping by the scheme, the work of winch and block goes into the line and the water, for any step
/// length.
TEST(Winches, DoWorkThatTheBudgetHas) {
  for (const char* step : {"analysis.step=0.05", "analysis.step=0.025"}) {
    const auto c = heaving(holding(29.86, {{0, 2500}}, 3, 300),
                           {"analysis.adaptive=false", "analysis.solver=newton", "analysis.tolerance=1e-11",
                            "analysis.energy-momentum.spectral_radius=1", step});
    const Moment end = march(*c).moments.back();
    EXPECT_GT(end.given, 100) << step;
    EXPECT_LT(std::abs(end.numerical), 1e-6 * end.given) << step;
  }
}

TEST(Winches, GoOnToTheSameBits) {
  const auto make = [] { return heaving(holding(29.86, {{0, 1800}, {3, 2400}}, 3, 300, 50), {}); };
  const auto whole = make(), half = make();
  const Marched all = march(*whole);
  ASSERT_GT(all.states.size(), 10u);
  const Marched rest = march(*half, &all.states[8]);
  EXPECT_EQ(rest.result.u, all.result.u);
  EXPECT_EQ(rest.moments.back().length, all.moments.back().length);
  EXPECT_EQ(rest.moments.back().tension, all.moments.back().tension);
}

/// Tables of a length over time have corners where a winch starts and stops. Steps must end there, and errors
/// must fall as the required accuracy increases.
TEST(TablesInTime, HaveCornersAtWhichStepsEnd) {
  std::vector<std::vector<double>> ends;
  for (const char* accuracy : {"1e-1", "1e-2", "1e-3", "1e-5"}) {
    runs::PreparedScene c(
        {test::source_folder() + "/" + kBall,
         {"parts.rope.rope.length_share={t=[0.333,0.777],share=[1,0.8]}",
          "parts.rope.sketch=[[0,0,0],[0.2,0,-1]]", "parts.rope.rope.EA=500",
          "parts.rope.rope.loss_factor=0.2", "analysis.integrator=energy-momentum", "analysis.duration=1.3",
          "analysis.output_interval=0", std::string("analysis.accuracy=") + accuracy},
         1},
        test::shipped_plugins());
    ASSERT_EQ(c.prepare(), runs::PreparedScene::State::ready) << c.diagnostics().render(false);
    int at_corners = 0;
    MarchWatch watch;
    watch.on_step = [&](const StepRecord& step, std::span<const double>) {
      at_corners += step.t == 0.333 || step.t == 0.777;
      return false;
    };
    ends.push_back(runs::march(c, watch).u);
    EXPECT_EQ(at_corners, 2) << accuracy;
  }
  std::vector<double> errors;
  for (std::size_t k = 0; k < 3; ++k) {
    double square = 0;
    for (std::size_t i = 0; i < ends[k].size(); ++i)
      square += (ends[k][i] - ends[3][i]) * (ends[k][i] - ends[3][i]);
    errors.push_back(std::sqrt(square));
  }
  EXPECT_LT(errors[1], 0.3 * errors[0]) << errors[0] << " " << errors[1];
  EXPECT_LT(errors[2], 0.1 * errors[1]) << errors[1] << " " << errors[2];
}

/// Speeds that are linear between times, with a known path; corners of the table are between outputs.
TEST(Winches, PayOutWhatATableOfSpeedsSays) {
  Winch winch{
      "", "", 0, kLength, {{.follows = Follows::speed, .rows = {{0, 0}, {0.3, 1}, {1.1, 1}, {1.7, -2}}}}};
  const auto c = open_with(kBall, hanging_ball({}), winch);
  const auto way = [](double t) {
    if (t < 0.3) return t * t / 0.6;
    if (t < 1.1) return 0.15 + t - 0.3;
    const double s = std::min(t, 1.7) - 1.1;
    return 0.95 + s - 2.5 * s * s;
  };
  for (const Moment& at : march(*c).moments) EXPECT_NEAR(at.length - kLength, way(at.t), 1e-9) << at.t;
}

/// A line that heaves: a tension is held, then rope is hauled, then the tension is held again.
Winch changing() {
  Winch winch = holding(29.86, {{0, 2500}}, 3, 300);
  winch.stages.push_back({Follows::speed, 2.1, {{2.1, 0}, {2.3, -0.2}, {3.3, -0.2}, {3.5, 0}}});
  winch.stages.push_back({Follows::tension, 4.2, {{4.2, 2500}}, 3, 300});
  return winch;
}

TEST(Winches, ChangeFromTensionToSpeedAndBack) {
  const auto c = heaving(changing(), {});
  const Marched m = march(*c);
  const auto length_at = [&](double t) {
    for (const Moment& at : m.moments)
      if (std::abs(at.t - t) < 1e-9) return at.length;
    return std::nan("");
  };
  EXPECT_NEAR(length_at(3.75) - length_at(4), 0, 1e-12);
  EXPECT_NEAR(length_at(3.25) - length_at(2.5), -0.2 * 0.75, 1e-12);
  for (const Moment& at : m.moments)
    if (at.t > 0 && (at.t < 2.1 || at.t > 4.4)) EXPECT_NEAR(at.tension, 2500, 300) << at.t;
  // the winch pays out the rope that it had hauled
  EXPECT_GT(std::abs(length_at(4.5) - length_at(4.0)), 0.05);
  const Moment end = m.moments.back();
  EXPECT_LT(std::abs(end.numerical), 1e-2 * end.given);
}

TEST(Winches, ThatChangeGoOnToTheSameBits) {
  const auto whole = heaving(changing(), {});
  const Marched all = march(*whole);
  for (const std::size_t k : {6u, 11u, 15u, 18u}) {
    const auto half = heaving(changing(), {});
    const Marched rest = march(*half, &all.states[k]);
    EXPECT_EQ(rest.result.u, all.result.u) << k;
    EXPECT_EQ(rest.moments.back().length, all.moments.back().length) << k;
  }
}

TEST(Winches, SayThatARopeIsHauledIn) {
  const auto c =
      open_with(kBall, hanging_ball({"analysis.duration=60"}), winch_of(2 * kMass * kGravity, 1, 2));
  const MarchResult r = runs::march(*c, {});
  EXPECT_EQ(r.status, MarchStatus::failed);
  EXPECT_NE(r.reason.find("has hauled in all of its rope"), std::string::npos) << r.reason;
}

}  // namespace
}  // namespace netloft
