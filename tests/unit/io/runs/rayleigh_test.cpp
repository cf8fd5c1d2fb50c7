// SPDX-License-Identifier: BSD-3-Clause
//
// Rayleigh's damping C = α M + β K on one mass and one spring, which has a closed form.
#include "io/runs/march.hpp"
#include "io/runs/prepared_scene.hpp"
#include "tests/folders.hpp"
#include "tests/verification/solving.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace netloft::runs {
namespace {

// A weight of 10 kg on a rope with EA/l = 1000 N/m, released at the unstretched length of the rope.
const std::string kRayleighBounce =
    test::source_folder() + "/io/program/templates/integrator/my_integrator.toml";
constexpr double kOmega = 10, kSag = 9.80665 / (kOmega * kOmega);  // [rad/s], [m]

/// How far the weight has sunk after a time [m].
double sunk(double alpha, double beta, double t, const std::string& more = "analysis.dense=false") {
  PreparedScene one(
      {kRayleighBounce,
       {"analysis.integrator=newmark", "analysis.mass_damping=" + std::to_string(alpha),
        "analysis.stiffness_damping=" + std::to_string(beta), "analysis.duration=" + std::to_string(t),
        "analysis.adaptive=false", "analysis.step=0.001", "analysis.tolerance=1e-9", more},
       1},
      test::shipped_plugins());
  EXPECT_EQ(one.prepare(), PreparedScene::State::ready) << one.diagnostics().render(false);
  const MarchResult r = march(one, {});
  EXPECT_EQ(r.status, MarchStatus::finished) << r.reason;
  std::vector<double> x = one.assembler().start();
  one.assembler().place(r.u, x);
  return -10 - one.assembler().node_positions(x)[5];
}

/// sag (1 − e^(−ζωt) (cos ω't + ζω/ω' sin ω't)),  ζ = α/(2ω) + βω/2,  ω' = ω √(1 − ζ²)
double closed_form(double alpha, double beta, double t) {
  const double zeta = alpha / (2 * kOmega) + beta * kOmega / 2, w = kOmega * std::sqrt(1 - zeta * zeta);
  return kSag * (1 - std::exp(-zeta * kOmega * t) * (std::cos(w * t) + zeta * kOmega / w * std::sin(w * t)));
}

TEST(RayleighDamping, FollowsTheDampedOscillatorInMassInStiffnessAndInBoth) {
  for (const auto& [alpha, beta] : {std::pair{2.0, 0.0}, {0.0, 0.02}, {1.0, 0.03}})
    for (const double t : {0.3, 1.0}) {
      EXPECT_NEAR(sunk(alpha, beta, t), closed_form(alpha, beta, t), 2e-4 * kSag)
          << alpha << ' ' << beta << ' ' << t;
    }
}

TEST(RayleighDamping, LeavesWhatAPartSaysOfItself) {
  const double own = sunk(0, 0.02, 0.3, "parts.rope.rope.damping=300");
  EXPECT_NEAR(own, closed_form(0, 300 / 1e4, 0.3), 2e-4 * kSag);
}

}  // namespace
}  // namespace netloft::runs
