// SPDX-License-Identifier: BSD-3-Clause
//
// Shared by the tests of time schemes of other libraries (arkode).
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "framework/conformance/practice_motion.hpp"
#include "io/runs/march.hpp"
#include "io/runs/prepared_scene.hpp"
#include "tests/folders.hpp"
#include "tests/unit/framework/balance/oscillator.hpp"

namespace netloft::test {

/// A practice motion, whose answer is known, after `n` steps that lead to `end` [s].
inline conformance::PracticeMotion after(const Chosen& scheme, int n, double end,
                                         const conformance::PracticeSwing& like) {
  conformance::PracticeMotion motion(like);
  EXPECT_EQ(motion.run(scheme.type.integrator, scheme.block.data(), {end / n}, end), NETLOFT_OK);
  return motion;
}

/// Returns the status of the first step if every function of the host returns `status`.
inline int step_where_the_host_answers(int status, const Chosen& scheme) {
  conformance::PracticeMotion motion({.fails = status});
  return motion.run(scheme.type.integrator, scheme.block.data(), {0.01}, 0.01);
}

/// Returns the order of the error of a damped motion in the step length.
inline double order_in_a_motion_with_damping(const Chosen& scheme) {
  const conformance::PracticeSwing damped{.damping = 0.2};
  return std::log2(after(scheme, 160, 4, damped).error() / after(scheme, 320, 4, damped).error());
}

/// Returns the order of the error estimate of one step in the step length.
inline double order_of_estimates(const Chosen& scheme) {
  return std::log2(after(scheme, 10, 0.5, {}).estimate / after(scheme, 20, 0.5, {}).estimate);
}

/// The final state of a scene of the gear library.
inline MarchResult end_of(const std::string& scene, const std::vector<std::string>& overrides) {
  runs::PreparedScene c({test::source_folder() + "/gear-library/scenes/dynamics/" + scene, overrides, 1},
                        shipped_plugins());
  if (c.prepare() != runs::PreparedScene::State::ready)
    throw std::invalid_argument(c.diagnostics().render(false));
  MarchResult r = runs::march(c, {});
  EXPECT_EQ(r.status, MarchStatus::finished) << r.reason;
  return r;
}

/// The state after 0.5 s of a ball on four bars, which are as stiff in compression as in tension.
inline MarchResult swing(const std::vector<std::string>& overrides) {
  std::vector<std::string> all = {"parts.rope.rope.EA=2000", "parts.rope.rope.EA_compression=2000",
                                  "analysis.duration=0.5",   "analysis.output_interval=0",
                                  "analysis.solver=chord",   "analysis.tolerance=1e-11"};
  all.insert(all.end(), overrides.begin(), overrides.end());
  return end_of("elastic-pendulum.toml", all);
}

inline double largest_distance(std::span<const double> a, std::span<const double> b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

inline double largest_distance(const MarchResult& a, const MarchResult& b) {
  return largest_distance(a.u, b.u);
}

/// Returns the distance from the closed form after 1000 steps of an `Oscillator` released 0.1 m from rest
/// [m].
inline double distance_from_closed_form_of_a_spring(const std::string& integrator) {
  const Oscillator o;
  Moving m(o.scene());
  MarchSettings s;
  s.duration = 20 / o.omega(), s.step = 0.02 / o.omega(), s.adaptive = false;
  MarchState from = state_at_rest(m.assembler);
  from.u[0] = 0.1;
  const MarchResult r = m.run(integrator, {}, s, &from);
  EXPECT_EQ(r.status, MarchStatus::finished) << r.reason;
  return std::abs(r.u[0] - 0.1 * std::cos(o.omega() * s.duration));
}

}  // namespace netloft::test
