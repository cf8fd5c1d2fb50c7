// SPDX-License-Identifier: BSD-3-Clause
//
// Time schemes on scenes of the gear library: orders by halving the step, energies, equilibria by dynamics.
#include "io/runs/equilibrium.hpp"
#include "io/runs/march.hpp"
#include "io/runs/prepared_scene.hpp"
#include "tests/folders.hpp"
#include "tests/verification/solving.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace netloft {
namespace {

const std::string kScenes = test::source_folder() + "/gear-library/scenes/";

std::vector<std::string> joined(std::vector<std::string> a, const std::vector<std::string>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Positions of a scene at the end of its motion.
std::vector<double> end_of(const std::string& scene, const std::vector<std::string>& overrides,
                           const MarchWatch& watch = {}) {
  runs::PreparedScene c({kScenes + scene, overrides, 1}, test::shipped_plugins());
  if (c.prepare() != runs::PreparedScene::State::ready)
    throw std::invalid_argument(c.diagnostics().render(false));
  const MarchResult r = runs::march(c, watch);
  EXPECT_EQ(r.status, MarchStatus::finished) << r.reason;
  return r.u;
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

std::string step(double h) {
  char text[48];
  std::snprintf(text, sizeof text, "analysis.step=%.17g", h);
  return text;
}

struct Motion {
  const char* name;
  std::string scene;
  std::vector<std::string> overrides;
  double h;  // coarsest [s]
};

// Bars are as stiff in compression as in tension, so that a kink in the force does not reduce the order.
const Motion kPendulum{"Pendulum",
                       "dynamics/elastic-pendulum.toml",
                       {"parts.rope.cells=4", "parts.rope.rope.EA=2000",
                        "parts.rope.rope.EA_compression=2000", "analysis.duration=0.2"},
                       4e-4};
const Motion kRope{"SwingingRope",
                   "dynamics/released-rope.toml",
                   {"parts.rope.cells=8", "parts.rope.rope.EA=500", "parts.rope.rope.EA_compression=500",
                    "analysis.duration=1"},
                   5e-3};
const Motion kPanel{"PanelInACurrent",
                    "dynamics/panel-in-current.toml",
                    {"parts.net.cells=[4,4]", "parts.weights.number=5", "parts.net.twine.EA=20",
                     "parts.net.twine.EA_compression=20", "analysis.duration=0.2"},
                    1e-3};

struct Scheme {
  const char* name;
  std::vector<std::string> overrides;
  double order;
};
const Scheme kTrapezoid{"Newmark", {"analysis.integrator=newmark"}, 2};
const Scheme kDamped{"NewmarkOfThePaper", {"analysis.integrator=newmark", "analysis.newmark.chi=-0.3"}, 1};
const Scheme kAlpha{"GeneralizedAlpha", {"analysis.integrator=generalized-alpha"}, 2};
const Scheme kMomentum{"EnergyMomentum", {"analysis.integrator=energy-momentum"}, 2};

class Order : public testing::TestWithParam<std::tuple<Motion, Scheme>> {};

TEST_P(Order, IsSeenByHalvingTheStep) {
  const auto& [motion, scheme] = GetParam();
  const auto overrides =
      joined(joined(motion.overrides, scheme.overrides),
             {"analysis.adaptive=false", "analysis.output_interval=0", "analysis.solver=chord",
              "analysis.tolerance=1e-11", "analysis.energy_budget=false"});
  std::vector<std::vector<double>> ends;
  for (const double h : {motion.h, motion.h / 2, motion.h / 4})
    ends.push_back(end_of(motion.scene, joined(overrides, {step(h)})));
  const double order = std::log2(distance(ends[0], ends[1]) / distance(ends[1], ends[2]));
  EXPECT_NEAR(order, scheme.order, 0.25) << distance(ends[0], ends[1]) << " " << distance(ends[1], ends[2]);
}

INSTANTIATE_TEST_SUITE_P(Schemes, Order,
                         testing::Combine(testing::Values(kPendulum, kRope, kPanel),
                                          testing::Values(kTrapezoid, kDamped, kAlpha, kMomentum)),
                         [](const auto& tested) {
                           return std::string(std::get<0>(tested.param).name) +
                                  std::get<1>(tested.param).name;
                         });

/// The energy budget at the last output.
std::map<std::string, double> budget_of(const Motion& motion, const std::vector<std::string>& overrides) {
  std::map<std::string, double> last;
  MarchWatch watch;
  watch.on_output = [&](const Snapshot& s) {
    const auto names = s.budget->names();
    const auto values = s.budget->values();
    for (std::size_t k = 0; k < names.size(); ++k) last[names[k]] = values[k];
  };
  end_of(motion.scene,
         joined({"analysis.adaptive=false", "analysis.solver=chord"}, joined(motion.overrides, overrides)),
         watch);
  return last;
}

TEST(EnergyBudget, ClosesWithTheSquareOfTheStepOnAPanelInACurrent) {
  double error[2];
  for (const int k : {0, 1}) {
    const auto b = budget_of(
        kPanel, {"analysis.integrator=newmark", step(kPanel.h / (k ? 2 : 1)), "analysis.tolerance=1e-11"});
    error[k] = std::abs(b.at("numerical"));
    EXPECT_GT(std::abs(b.at("drag_work")), 1e-3);
    EXPECT_LT(error[k], 0.01 * std::abs(b.at("drag_work")));
  }
  EXPECT_GT(std::log2(error[0] / error[1]), 1.7) << error[0] << " " << error[1];
}

TEST(EnergyBudget, CountsWhatAWinchDoes) {
  const Motion hauled{"Hauled",
                      "dynamics/elastic-pendulum.toml",
                      {"parts.rope.rope.length_share={t=[0,1],share=[1,0.5]}",
                       "parts.rope.sketch=[[0,0,0],[0,0,-1]]", "analysis.start=equilibrium",
                       "analysis.tolerance=1e-8", "analysis.duration=1", "analysis.output_interval=0.1"},
                      0};
  const auto b = budget_of(hauled, {step(1e-4), "analysis.integrator=generalized-alpha"});
  // Lifting 5 kg by half a metre at half a metre a second takes 5 (9.81 / 2 + 0.5^2 / 2) = 25.15 J; the rope
  // adds the rest.
  EXPECT_NEAR(b.at("work_of_winches"), 25.3, 1.0);
  EXPECT_LT(std::abs(b.at("numerical")), 0.05 * b.at("work_of_winches"));
}

/// A step hauls 250 times the length by which the load stretches the rope.
TEST(EnergyBudget, CountsWhatAWinchDoesInStepsThatHaulFarMoreThanTheRopeStretches) {
  const Motion hauled{
      "HauledSlowly",
      "dynamics/elastic-pendulum.toml",
      {"parts.rope.rope.length_share={t=[0,20],share=[1,0.5]}", "parts.rope.rope.EA=\"1 MN\"",
       "parts.rope.sketch=[[0,0,0],[0,0,-1]]", "analysis.start=equilibrium", "analysis.mass_damping=2",
       "analysis.tolerance=1e-8", "analysis.duration=20", "analysis.output_interval=10"},
      0};
  const auto b = budget_of(hauled, {step(0.5), "analysis.integrator=generalized-alpha"});
  // The work to lift 5 kg by half a metre, against gravity and against the mass damping of 5 kg x 2 / s at
  // 0.025 m/s.
  EXPECT_NEAR(b.at("work_of_winches"), 0.5 * (5 * 9.81 + 10 * 0.025), 0.01 * 24.6);
  EXPECT_LT(std::abs(b.at("numerical")), 1e-3 * b.at("work_of_winches"));
}

/// A pendulum whose rope goes slack and snaps taut all the time: EA_compression = 1e-4 EA.
const Motion kSnapping{"Snapping",
                       "dynamics/elastic-pendulum.toml",
                       {"analysis.integrator=energy-momentum", "analysis.duration=10",
                        "analysis.output_interval=0", "analysis.tolerance=1e-10", step(1e-3)},
                       1e-3};

double given_to(const std::map<std::string, double>& b) { return b.at("kinetic") + b.at("elastic"); }

TEST(EnergyMomentum, KeepsAllEnergyOverTenThousandStepsOfASnappingRope) {
  const auto b =
      budget_of(kSnapping, {"analysis.solver=newton", "analysis.energy-momentum.spectral_radius=1"});
  EXPECT_LT(std::abs(b.at("numerical")), 1e-9 * 5 * 9.81);  // of the potential energy of 5 kg over a height
                                                            // of 1 m
}

TEST(EnergyMomentum, NeverMakesEnergyWhereItDamps) {
  for (const char* radius : {"0.8", "0.3", "0"}) {
    double most = 0;
    MarchWatch watch;
    watch.on_output = [&](const Snapshot& s) {
      most = std::min(most, s.budget->values().back());
      ASSERT_EQ(s.budget->names().back(), "numerical");
    };
    end_of(
        kSnapping.scene,
        joined(kSnapping.overrides, {"analysis.adaptive=false", step(5e-3), "analysis.output_interval=0.05",
                                     std::string("analysis.energy-momentum.spectral_radius=") + radius}),
        watch);
    EXPECT_GT(most, -1e-3 * 5 * 9.81) << radius;  // energy that the filter of (2) keeps for some time
  }
}

/// Hard motions with fixed steps: drag, added mass, contact and friction, a guide that pulls slack and taut,
/// damping by the material, a gust, a winch. Without damping by the scheme, work and energies must agree to
/// the tolerance of the solver for any step length.
struct Hard {
  const char *name, *file;
  double h;
  std::vector<std::string> overrides = {};
};

class Balance : public testing::TestWithParam<Hard> {};

TEST_P(Balance, OfWorkAndEnergyClosesWhateverTheStep) {
  const std::string bench = "../../tests/bench/motions/";
  for (const double h : {GetParam().h, GetParam().h / 2}) {
    double given = 0, numerical = 0;
    MarchWatch watch;
    watch.on_output = [&](const Snapshot& s) {
      const EnergyBudget::Totals totals = s.budget->totals();
      numerical = std::max(numerical, std::abs(totals.numerical));
      given = std::max(given, totals.kinetic);
    };
    end_of(bench + GetParam().file,
           joined({"analysis.adaptive=false", "analysis.solver=newton", "analysis.tolerance=1e-11",
                   "analysis.integrator=energy-momentum", "analysis.energy-momentum.spectral_radius=1",
                   "analysis.duration=0.6", "analysis.output_interval=0.05", step(h)},
                  GetParam().overrides),
           watch);
    EXPECT_GT(given, 1e-3);
    EXPECT_LT(numerical, 1e-7 * given) << h;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, Balance,
    testing::Values(
        Hard{"ASnap", "snap.toml", 5e-3}, Hard{"AChainOnABed", "chain.toml", 2e-3},
        Hard{"ALineThatHeaves", "heave.toml", 1e-2},
        Hard{"ANetInAGust", "gust.toml", 1e-2, {"parts.net.cells=[3,3]", "parts.weights.number=4"}},
        Hard{"AWinch",
             "snap.toml",
             4e-3,
             {"analysis.duration=0.5", "parts.rope.rope.length_share={t=[0,1],share=[1,0.7]}"}}),
    [](const auto& tested) { return std::string(tested.param.name); });

Solution equilibrium_by(const std::string& solver, const std::vector<std::string>& overrides) {
  runs::PreparedScene c(
      {kScenes + "dead-weight-panel.toml",
       joined({"analysis.solver=\"" + solver + "\"", "parts.net.cells=[4,4]"}, overrides), 1},
      test::shipped_plugins());
  if (c.prepare() != runs::PreparedScene::State::ready)
    throw std::invalid_argument(c.diagnostics().render(false));
  return runs::find_equilibrium(c);
}

TEST(Settling, FindsByThePapersSchemeWhereNewtonArrives) {
  const Solution newton = equilibrium_by("newton", {});
  const Solution settled = equilibrium_by("newmark", {"analysis.newmark.corrector=fixed-point",
                                                      "analysis.mass_damping=1", "analysis.tolerance=1e-5"});
  ASSERT_EQ(settled.status, SolveStatus::converged) << settled.reason;
  EXPECT_LT(distance(newton.u, settled.u), 2e-3 * std::sqrt(double(newton.u.size())));
}

TEST(Settling, FindsItByGeneralizedAlphaToo) {
  const Solution newton = equilibrium_by("newton", {});
  const Solution settled = equilibrium_by("generalized-alpha", {"analysis.tolerance=1e-6"});
  ASSERT_EQ(settled.status, SolveStatus::converged) << settled.reason;
  EXPECT_LT(distance(newton.u, settled.u), 1e-3 * std::sqrt(double(newton.u.size())));
}

/// The trapezoidal rule does not damp the vibrations of stiff twines.
TEST(Settling, NamesSchemesThatComeToRestWhereOneDoesNot) {
  const Solution s = equilibrium_by("newmark", {"analysis.duration=20", "analysis.mass_damping=0.01"});
  EXPECT_EQ(s.status, SolveStatus::not_converged);
  EXPECT_NE(s.reason.find("without coming to rest"), std::string::npos) << s.reason;
  EXPECT_NE(s.reason.find("generalized-alpha"), std::string::npos) << s.reason;
}

}  // namespace
}  // namespace netloft
