// SPDX-License-Identifier: BSD-3-Clause
#include "tests/unit/io/gears/plan/divided.hpp"

#include <numbers>
#include <numeric>
#include <random>

namespace netloft::gears {
namespace {

/// Draws random plans of three panels that can be sewn together, with any cuttings.
class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}

  NetPlan plan() {
    const Standing stands = std::array{Standing::middle, Standing::pair, Standing::alone}[whole(0, 2)];
    const double depth = real(2, 120);
    NetPlan plan;
    plan.panels = {panel("upper", stands, depth), panel("lower", stands, depth),
                   panel("behind", stands, real(2, 60))};
    plan.joins.push_back({{{"upper.outer"}, {"lower.outer"}}, {}, 0, {}, {}});
    plan.joins.push_back({{{"upper.aft"}, {"behind.fore"}}, {}, 0, {}, {}});
    plan.ropes.push_back(rope(stands));
    plan.hangings.push_back({"upper.fore", "rope", 0, real(0.3, 0.8), {}, {}, {}});
    return plan;
  }

  Extent extent() { return whole(0, 1) ? Extent::whole : Extent::half; }
  std::size_t nodes() { return whole(30, 600); }

 private:
  std::size_t whole(std::size_t least, std::size_t most) {
    return std::uniform_int_distribution<std::size_t>(least, most)(random_);
  }
  double real(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random_);
  }

  Panel panel(const std::string& name, Standing stands, double depth) {
    Panel panel;
    panel.name = name, panel.stands = stands, panel.depth = depth;
    panel.mesh = real(0.03, 0.3);
    panel.orientation = std::array{"diamond", "t90", "square"}[whole(0, 2)];
    panel.fore = {{"fore", real(1, 100), {}}};
    do {
      panel.outer = side("outer", depth);
      if (stands != Standing::middle) panel.inner = side("inner", depth);
    } while (narrowest(panel) < 0.5);
    panel.aft = {{"aft", aft_by_cuttings(panel), {}}};
    panel.outline = outline_of(panel);
    return panel;
  }

  /// Draws up to three cuts; the second of three may go across only.
  std::vector<Cut> side(const std::string& name, double depth) {
    std::vector<Cut> cuts;
    const std::size_t n = whole(1, 3);
    for (std::size_t k = 0; k < n; ++k) {
      Cut cut;
      cut.name = name + (k ? std::to_string(k) : "");
      cut.goes = whole(0, 1) ? 1 : -1;
      cut.across = real(0, 30);
      cut.deep = k == 1 && n == 3 && whole(0, 3) == 0 ? 0 : depth * real(0.02, 1);
      cuts.push_back(cut);
    }
    const double deep = std::accumulate(cuts.begin(), cuts.end(), 0.0,
                                        [](double sum, const Cut& cut) { return sum + cut.deep; });
    for (auto& cut : cuts) cut.deep *= depth / deep;
    return cuts;
  }

  /// Number of meshes across at the narrowest place.
  static double narrowest(const Panel& panel) {
    std::vector<std::pair<double, double>> gains{{0, 0}};
    const double sides = panel.stands == Standing::middle ? 2 : 1;
    double least = panel.count(panel.fore);
    for (const auto* at : {&panel.outer, &panel.inner}) {
      double y = 0;
      for (const auto& cut : *at)
        for (const double fraction : {0.0, 1.0})
          least = std::min(least, panel.count(panel.fore) +
                                      sides * gain(panel.outer, y + fraction * cut.deep, fraction) +
                                      gain(panel.inner, y + fraction * cut.deep, fraction)),
          y += fraction * cut.deep;
    }
    return least;
  }

  /// The number of meshes by which a side is wider at y than at its fore end. A cut at y that only goes
  /// across counts by the fraction `taken`.
  static double gain(const std::vector<Cut>& side, double y, double taken) {
    double sum = 0;
    for (const auto& cut : side) {
      const double fraction = cut.deep > 0 ? std::clamp(y / cut.deep, 0.0, 1.0) : y < 0 ? 0 : taken;
      sum += cut.goes * cut.across * fraction;
      y -= cut.deep;
    }
    return sum;
  }

  static Rope rope_of(const std::string& name, Standing stands, double length) {
    Rope rope;
    rope.name = name, rope.stands = stands, rope.length = length;
    return rope;
  }
  Rope rope(Standing stands) { return rope_of("rope", stands, real(0.5, 30)); }

  std::mt19937 random_;
};

TEST(RandomGears, AreFilledOnceAndSewnWithoutHoles) {
  for (unsigned seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    Draw draw(seed);
    const NetPlan plan = draw.plan();
    const Gear gear = make_gear(plan, draw.extent());
    Fineness fineness;
    fineness.nodes = draw.nodes();
    const GearMesh mesh = divide(gear, fineness);
    expect_areas(gear, mesh);
    expect_closed_and_oriented(gear, mesh);
    for (std::size_t r = 0; r < gear.ropes.size(); ++r) {
      const auto& lengths = mesh.ropes[r].rest_lengths;
      EXPECT_NEAR(std::accumulate(lengths.begin(), lengths.end(), 0.0), gear.ropes[r].length,
                  1e-9 * gear.ropes[r].length);
    }
    if (testing::Test::HasFailure()) break;
  }
}

}  // namespace
}  // namespace netloft::gears
