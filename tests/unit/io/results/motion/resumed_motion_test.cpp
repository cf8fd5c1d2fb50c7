// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/motion/checkpoint.hpp"
#include "tests/unit/framework/balance/oscillator.hpp"

#include <gtest/gtest.h>

namespace netloft::results::test {
namespace {

using netloft::test::Moving;
using netloft::test::Oscillator;

/// A bar along x, whose weight is borne by holds along y and z.
Scene heavy_bar() {
  Scene scene = Oscillator().scene();
  scene.water.gravity = 9.81;
  return scene;
}

struct Watched {
  MarchResult march;
  MotionFindings findings;
  std::string half_way;  // the checkpoint at the middle output
};

/// A motion by a scheme that damps fast modes. It starts with the end of the bar displaced by `u`, or from a
/// checkpoint.
Watched watched(double u, const Checkpoint* from = nullptr, bool check = false) {
  Moving m(heavy_bar());
  MarchSettings settings;
  settings.duration = 1, settings.step = 0.04, settings.adaptive = false, settings.output_interval = 0.1;
  settings.check = check;
  MarchState start = state_at_rest(m.assembler);
  start.u[0] = u;
  MotionWatch watch(m.scene, m.assembler);
  if (from) watch.go_on_from(from->findings);
  Watched all;
  m.watch.on_output = [&](const Snapshot& at) {
    watch.note(
        at, at.t > 0.25 ? std::vector<FallenBoard>{{"door", "door lies over"}} : std::vector<FallenBoard>{});
    if (at.state && at.t > 0.45 && all.half_way.empty())
      all.half_way = pack_checkpoint(*at.state, watch.findings());
  };
  all.march = m.run("generalized-alpha", {{"spectral_radius", 0.0}}, settings, from ? &from->state : &start);
  EXPECT_EQ(all.march.status, MarchStatus::finished) << all.march.reason;
  all.findings = watch.findings();
  return all;
}

void expect_same(const MotionFindings& a, const MotionFindings& b) {
  EXPECT_EQ(a.t, b.t);
  EXPECT_EQ(a.numerical, b.numerical);
  EXPECT_EQ(a.v, b.v);
  ASSERT_TRUE(a.loss && b.loss);
  const auto numbers = [](const NumericalLoss& l) {
    return std::array{l.lost, l.given, l.negligible, l.worst, l.from, l.until};
  };
  EXPECT_EQ(numbers(*a.loss), numbers(*b.loss));
  EXPECT_EQ(a.loss->node, b.loss->node);
  ASSERT_EQ(a.fallen.size(), b.fallen.size());
  for (std::size_t i = 0; i < a.fallen.size(); ++i) EXPECT_EQ(a.fallen[i].sentence, b.fallen[i].sentence);
}

TEST(MotionWatch, FindsALossWithTimeAndPlace) {
  const MotionFindings found = watched(0.1).findings;
  ASSERT_TRUE(found.loss);
  EXPECT_GT(found.loss->lost, 0);
  EXPECT_NEAR(found.loss->lost, found.numerical, 1e-12 * found.loss->given);
  EXPECT_NEAR(found.loss->given, 0.5 * 500 * 0.01, 0.05);         // released from rest
  EXPECT_NEAR(found.loss->until - found.loss->from, 0.1, 1e-12);  // two consecutive outputs
  EXPECT_GE(found.loss->worst, found.loss->lost / 10);            // of ten such pairs
  EXPECT_EQ(found.loss->node, "bar node 1");
}

TEST(MotionWatch, DoesNotCallRoundOffALoss) {
  const NumericalLoss loss = watched(1e-9).findings.loss.value();
  EXPECT_GT(loss.lost, 0.05 * loss.given);  // the scheme could remove any amount, but there is no energy left
  EXPECT_FALSE(loss.is_large());
}

TEST(MotionWatch, TellsOfAFallenBoardOnceWithItsTime) {
  const MotionFindings found = watched(0.1).findings;
  ASSERT_EQ(found.fallen.size(), 1u);
  EXPECT_EQ(found.fallen[0].sentence, "at t = 0.3 s door lies over");
}

TEST(ResumedMotion, EndsWithTheSameReport) {
  const Watched whole = watched(0.1);
  const Checkpoint half = unpack_checkpoint(whole.half_way);
  const Watched again = watched(0, &half);
  expect_same(again.findings, whole.findings);
  const MarchResult &a = again.march, &b = whole.march;
  EXPECT_EQ(a.u, b.u);
  EXPECT_EQ(a.reason, b.reason);
  EXPECT_EQ(std::tuple(a.steps, a.rejected, a.shortest, a.longest),
            std::tuple(b.steps, b.rejected, b.shortest, b.longest));
  EXPECT_GT(a.shortest, 0);
  EXPECT_EQ(std::tuple(a.start.node, a.start.residual, a.start.load),
            std::tuple(b.start.node, b.start.residual, b.start.load));
  EXPECT_EQ(a.start.node, "bar node 1");
  EXPECT_EQ(a.statistics.iterations, b.statistics.iterations);
  EXPECT_EQ(a.statistics.factorisations, b.statistics.factorisations);
  EXPECT_EQ(a.statistics.residuals, b.statistics.residuals);
}

TEST(ResumedMotion, KeepsWhyTheMarchForComparisonFailed) {
  Checkpoint half = unpack_checkpoint(watched(0.1).half_way);
  half.state.path_error = std::numeric_limits<double>::infinity();
  half.state.why_lost = "the step does not settle";
  half.state.remark = "; it began elsewhere";
  half = unpack_checkpoint(pack_checkpoint(half.state, half.findings));
  const MarchResult march = watched(0, &half, true).march;
  EXPECT_EQ(march.accuracy.path_of, "the step does not settle");
  EXPECT_TRUE(march.reason.ends_with(" steps; it began elsewhere")) << march.reason;
}

}  // namespace
}  // namespace netloft::results::test
