// SPDX-License-Identifier: BSD-3-Clause
//
// Several layers of netting in one seam: a funnel within an extension, and a cover round it.
#include "io/gears/meshing/gear_mesh.hpp"
#include "io/gears/meshing/start_shape.hpp"
#include "tests/unit/io/gears/plan/plans.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace netloft::gears {
namespace {

constexpr const char* kFunnel = R"(
[panels.front]
mesh = "41.3 mm"
twine = "pa-twisted-1.5mm"
round = 120
depth = 4
open = "fore"
[panels.back]
mesh = "41.3 mm"
twine = "pa-twisted-1.5mm"
round = 120
depth = 23
open = "aft"
[panels.funnel]
mesh = "38.1 mm"
twine = "pe-twisted-1.8mm"
round = 100
depth = 24
open = "aft"
[[join]]
edges = ["front.aft", "back.fore", "funnel.fore"]
take_up = [1, 0.8333]
)";

class Layers : public testing::TestWithParam<Extent> {
 protected:
  void SetUp() override {
    ASSERT_EQ(checked_.diagnostics.errors(), 0u) << checked_.said();
    Fineness fineness;
    fineness.nodes = 400;
    gear_ = make_gear(checked_.plan, GetParam());
    mesh_ = divide(gear_, fineness);
  }
  const PanelMesh& panel(const std::string& name) const {
    return mesh_.panels[static_cast<std::size_t>(gear_.find_panel(name) - gear_.panels.data())];
  }
  std::vector<std::uint32_t> nodes(const std::string& name, const std::string& edge) const {
    std::vector<std::uint32_t> all;
    for (const auto own : panel(name).sets.at(edge)) all.push_back(panel(name).nodes[own]);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  CheckedPlan checked_ = check_text(kFunnel);
  Gear gear_;
  GearMesh mesh_;
};

TEST_P(Layers, ShareTheNodesOfTheirSeam) {
  const auto seam = nodes("front", "aft");
  EXPECT_GE(seam.size(), 3u);
  EXPECT_EQ(nodes("back", "fore"), seam);
  EXPECT_EQ(nodes("funnel", "fore"), seam);
}

TEST_P(Layers, ShareNoOtherNodes) {
  std::vector<std::uint32_t> back = panel("back").nodes, funnel = panel("funnel").nodes, both;
  for (auto* all : {&back, &funnel}) {
    std::sort(all->begin(), all->end());
    all->erase(std::unique(all->begin(), all->end()), all->end());
  }
  std::set_intersection(back.begin(), back.end(), funnel.begin(), funnel.end(), std::back_inserter(both));
  EXPECT_EQ(both, nodes("front", "aft"));
}

// The funnel has 100 meshes of 38.1 mm, and the netting round it 120 of 41.3 mm.
TEST_P(Layers, StartWithinEachOther) {
  const auto x = StartShapes(gear_, mesh_).with(gear_, {});
  const auto most = [&](const std::string& name, std::size_t axis) {
    double farthest = 0;
    for (const auto node : nodes(name, "aft"))
      farthest = std::max(farthest, std::abs(x[3 * std::size_t{node} + axis]));
    return farthest;
  };
  for (const std::size_t axis : {1u, 2u}) EXPECT_LT(most("funnel", axis), 0.9 * most("back", axis));
}

INSTANTIATE_TEST_SUITE_P(OfAGear, Layers, testing::Values(Extent::whole, Extent::half),
                         [](const auto& of) { return of.param == Extent::whole ? "Whole" : "Half"; });

}  // namespace
}  // namespace netloft::gears
