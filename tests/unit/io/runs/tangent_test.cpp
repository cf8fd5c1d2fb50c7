// SPDX-License-Identifier: BSD-3-Clause
#include "io/runs/tangent.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <ostream>

#include "io/runs/equilibrium.hpp"
#include "tests/folders.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::runs {
namespace {

struct Rope : PreparedScene {
  explicit Rope(const std::string& change)
      : PreparedScene({test::source_folder() + "/gear-library/scenes/hanging-rope.toml", {change}, 1},
                      test::shipped_plugins()) {
    EXPECT_EQ(prepare(), State::ready) << diagnostics().render(false);
  }
};

TEST(Topology, IsThatOfTheMeshWhateverTheValues) {
  const Rope rope("water.gravity=9.81"), heavier("parts.rope.rope.density=3000"), finer("parts.rope.cells=8");
  EXPECT_TRUE(have_same_topology(rope, heavier));
  EXPECT_FALSE(have_same_topology(rope, finer));
  EXPECT_FALSE(have_same_topology(finer, rope));
}

TEST(Tangent, IsZeroTowardsTheSameScene) {
  Rope rope("parts.rope.cells=20"), same("parts.rope.cells=20");
  const Solution s = find_equilibrium(rope);
  const auto tangent = Tangent(rope, s.x).towards(same);
  ASSERT_TRUE(tangent);
  for (const double dx : *tangent) EXPECT_NEAR(dx, 0, 1e-12);
}

TEST(Tangent, IsNoneForAnEquilibriumOfASettlingMotion) {
  Rope rope("analysis.solver=newmark"), same("analysis.solver=newmark");
  const auto start = rope.assembler().start();
  EXPECT_FALSE(Tangent(rope, {start.begin(), start.end()}).towards(same));
}

/// The product of the tangent K of a scene at x, or of Kᵀ, with a vector.
std::vector<double> times_tangent(PreparedScene& scene, const std::vector<double>& x,
                                  const std::vector<double>& v) {
  Assembler& assembler = scene.assembler();
  std::vector<double> slots(assembler.value_slots()), product(v.size());
  EXPECT_TRUE(assembler.evaluate(x, {.matrix = MatrixKind::exact, .values = slots.data()}));
  const SparsePattern& p = assembler.pattern();
  for (std::size_t c = 0; c < v.size(); ++c)
    for (auto k = static_cast<std::size_t>(p.column_start[c]);
         k < static_cast<std::size_t>(p.column_start[c + 1]); ++k) {
      const auto r = static_cast<std::size_t>(p.row[k]);
      product[r] += slots[p.slot_of(k)] * v[c];
      if (p.symmetric && r != c) product[c] += slots[p.slot_of(k)] * v[r];
    }
  return product;
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// A scene of the library, and whether it has a net plan, whose number of nodes can be chosen.
struct OfLibrary {
  const char* name;
  bool has_plan;
};
void PrintTo(const OfLibrary& scene, std::ostream* out) { *out << scene.name; }

class Adjoint : public testing::TestWithParam<OfLibrary> {};

// A solve is left after some iterations: the identities hold at any shape with a regular K.
TEST_P(Adjoint, SatisfiesTheDotProductIdentity) {
  std::vector<std::string> set;
  if (GetParam().has_plan) set.push_back("gear.nodes=150");
  PreparedScene scene({test::source_folder() + "/gear-library/scenes/" + GetParam().name + ".toml", set, 1},
                      test::shipped_plugins());
  ASSERT_EQ(scene.prepare(), PreparedScene::State::ready) << scene.diagnostics().render(false);
  const auto unknowns = static_cast<std::size_t>(scene.assembler().numbering().unknowns());
  constexpr int kIterations = 10;
  const std::vector<double> x = continue_equilibrium(scene, std::vector<double>(unknowns), kIterations).x;
  std::vector<double> w(unknowns), v(unknowns);
  for (std::size_t i = 0; i < unknowns; ++i)
    w[i] = std::cos(0.3 * static_cast<double>(i)), v[i] = std::sin(0.7 * static_cast<double>(i));
  Tangent tangent(scene, x);
  const auto adjoint = tangent.adjoint(w), back = tangent.solved(times_tangent(scene, x, v));
  ASSERT_TRUE(adjoint && back);
  const double size = std::sqrt(dot(w, w) * dot(v, v));
  EXPECT_NEAR(dot(*adjoint, times_tangent(scene, x, v)), dot(w, v), 1e-11 * size);
  EXPECT_NEAR(dot(w, *back), dot(w, v), 1e-11 * size);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, Adjoint,
    testing::Values(OfLibrary{"hanging-rope", false}, OfLibrary{"dead-weight-panel", false},
                    OfLibrary{"codend-from-plan", true}, OfLibrary{"83-112-flume-2.0kn", true},
                    OfLibrary{"83-112-flume-4.0kn", true}, OfLibrary{"83-112-at-sea-66m", true},
                    OfLibrary{"gov-like-31m", true}, OfLibrary{"gov-like-111m", true},
                    OfLibrary{"pelagic-with-doors", true}, OfLibrary{"pair-trawl", true},
                    OfLibrary{"two-panel", true}, OfLibrary{"four-panel", true}),
    [](const auto& test) {
      std::string name = test.param.name;
      std::erase_if(name, [](char c) { return c == '-' || c == '.'; });
      return name;
    });

}  // namespace
}  // namespace netloft::runs
