// SPDX-License-Identifier: BSD-3-Clause
//
// Scenes that several ranks evaluate, against the same scenes in one process: every bit.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "framework/ranks/rank_team.hpp"
#include "framework/scene/scene_bytes.hpp"
#include "io/case/case.hpp"
#include "tests/unit/solvers/factorisation/ranks_in_threads.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::io {
namespace {

struct Sums {
  bool could = false;
  double energy = 0;
  std::vector<double> residual, gradient, matrix;  // over all dofs, the same; entries of the pattern
  std::vector<double> residual_alone;              // of an evaluation without a gradient
  std::string fault;
};

Sums sums_at(Assembler& assembler, const Scene& scene, const std::vector<double>& x, MatrixKind kind,
             const double* x_low = nullptr) {
  Sums sums;
  for (auto* forces : {&sums.residual, &sums.gradient, &sums.residual_alone}) forces->resize(x.size());
  std::vector<double> values(assembler.value_slots());
  Request request{.energy = &sums.energy,
                  .residual = sums.residual.data(),
                  .gradient = sums.gradient.data(),
                  .matrix = kind};
  if (kind != MatrixKind::none) request.values = values.data();
  request.motion.x_low = x_low;
  sums.could = assembler.evaluate(x, request);
  if (!sums.could) return sums.fault = assembler.fault_sentence(scene), sums;
  const SparsePattern& pattern = assembler.pattern();
  for (std::size_t e = 0; kind != MatrixKind::none && e < pattern.entries(); ++e)
    sums.matrix.push_back(values[pattern.slot_of(e)]);
  request.residual = sums.residual_alone.data(), request.gradient = nullptr;
  EXPECT_TRUE(assembler.evaluate(x, request));
  return sums;
}

bool have_same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return false;
  return a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

void expect_same(const Sums& shared, const Sums& alone) {
  EXPECT_EQ(shared.could, alone.could);
  EXPECT_EQ(shared.fault, alone.fault);
  if (!shared.could || !alone.could) return;
  EXPECT_EQ(shared.energy, alone.energy);
  EXPECT_TRUE(have_same_bits(shared.residual, alone.residual));
  EXPECT_TRUE(have_same_bits(shared.gradient, alone.gradient));
  EXPECT_TRUE(have_same_bits(shared.residual_alone, alone.residual_alone));
  EXPECT_TRUE(have_same_bits(shared.matrix, alone.matrix));
}

std::vector<double> moved(const std::vector<double>& start, double by) {
  std::vector<double> x = start;
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += by * std::sin(1.7 * static_cast<double>(i));
  return x;
}

class SharedScene : public testing::TestWithParam<const char*> {
 protected:
  SharedScene()
      : case_({test::source_folder() + "/gear-library/scenes/" + GetParam(), {}, 1},
              test::shipped_plugins()) {
    EXPECT_EQ(case_.open(), Case::State::ready) << case_.diagnostics().render(false);
  }
  const Scene& scene() { return case_.loaded().scene; }
  Case case_;
};

TEST_P(SharedScene, HasTheBitsOfOneProcess) {
  for (const int ranks : {2, 5}) {
    test::RanksInThreads all(ranks);
    {
      RankTeam team(all.first(), 1);
      const auto alone = std::make_unique<Assembler>(scene(), case_.plan(), 1);
      const auto shared = make_assembler(scene(), case_.plan(), {2, &team});
      for (const MatrixKind kind :
           {MatrixKind::none, MatrixKind::exact, MatrixKind::convex, MatrixKind::metric}) {
        const auto x = moved(alone->start(), 1e-3), low = moved(std::vector<double>(x.size()), 1e-17);
        expect_same(sums_at(*shared, scene(), x, kind), sums_at(*alone, scene(), x, kind));
        expect_same(sums_at(*shared, scene(), x, kind, low.data()),
                    sums_at(*alone, scene(), x, kind, low.data()));
      }
    }
    EXPECT_EQ(all.unread(), 0u);
  }
}

// Friction sticks where elements remember that they were.
TEST_P(SharedScene, RemembersOnAllRanks) {
  test::RanksInThreads all(3);
  RankTeam team(all.first(), 1);
  Assembler alone(scene(), case_.plan(), 1);
  const auto shared = make_assembler(scene(), case_.plan(), {1, &team});
  const auto there = moved(alone.start(), 2e-3), x = moved(there, 1e-4);
  EXPECT_EQ(shared->remember(there), alone.remember(there));
  expect_same(sums_at(*shared, scene(), x, MatrixKind::exact), sums_at(alone, scene(), x, MatrixKind::exact));
  const std::vector<double> past(alone.memory().size());
  shared->set_memory(past), alone.set_memory(past);
  expect_same(sums_at(*shared, scene(), x, MatrixKind::exact), sums_at(alone, scene(), x, MatrixKind::exact));
}

TEST_P(SharedScene, EvaluatesEnergiesOfItsOwnTilesAlone) {
  test::RanksInThreads all(3);
  RankTeam team(all.first(), 1);
  Assembler alone(scene(), case_.plan(), 1);
  const auto shared = make_assembler(scene(), case_.plan(), {1, &team});
  const auto x = moved(alone.start(), 1e-3);
  double one = 0, many = 0;
  EXPECT_TRUE(alone.evaluate(x, {.energy = &one}) && shared->evaluate(x, {.energy = &many}));
  EXPECT_EQ(one, many);
}

TEST_P(SharedScene, TellsTheFaultOfOneProcess) {
  test::RanksInThreads all(4);
  {
    RankTeam team(all.first(), 1);
    Assembler alone(scene(), case_.plan(), 1);
    const auto shared = make_assembler(scene(), case_.plan(), {1, &team});
    for (const int quarters : {4, 1}) {  // all nodes at one point, or those of the last ranks
      std::vector<double> folded = alone.start();
      const auto nodes = static_cast<std::uint32_t>(scene().node_count());
      for (std::uint32_t n = nodes - nodes * quarters / 4; n < nodes; ++n)
        for (int axis = 0; axis < 3; ++axis) folded[alone.numbering().dof(n, axis).at()] = 0;
      const Sums sums = sums_at(alone, scene(), folded, MatrixKind::exact);
      const bool bends = std::string_view(GetParam()).ends_with("cantilever.toml");
      EXPECT_EQ(sums.could, !bends) << "folded bars have no bending";
      expect_same(sums_at(*shared, scene(), folded, MatrixKind::exact), sums);
    }
  }
  EXPECT_EQ(all.unread(), 0u);
}

TEST_P(SharedScene, IsTheSameAfterItsWayAsBytes) {
  const auto bytes = bytes_of(scene());
  const Scene again = scene_of(bytes);
  EXPECT_EQ(bytes_of(again), bytes);
  EXPECT_EQ(again.node_count(), scene().node_count());
  EXPECT_EQ(again.parts.size(), scene().parts.size());
  EXPECT_THROW(scene_of(std::span(bytes).first(bytes.size() - 1)), std::invalid_argument);
  auto longer = bytes;
  longer.push_back({});
  EXPECT_THROW(scene_of(longer), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SharedScene,
                         testing::Values("dead-weight-panel.toml", "codend-from-plan.toml", "four-panel.toml",
                                         "83-112-flume-2.0kn.toml", "83-112-at-sea-66m.toml",
                                         "pelagic-with-doors.toml", "verification/codend-with-catch.toml",
                                         "verification/rope-dragged-over-seabed.toml",
                                         "verification/cantilever.toml"),
                         [](const auto& scene) {
                           std::string name = scene.param;
                           std::erase_if(name,
                                         [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
                           return name;
                         });

// Every tile is evaluated by whoever has one of its nodes, and its energy is counted once.
TEST(Shares, DivideNodesPlacesValuesAndTiles) {
  Case one({test::source_folder() + "/gear-library/scenes/83-112-flume-2.0kn.toml", {}, 1},
           test::shipped_plugins());
  ASSERT_EQ(one.open(), Case::State::ready);
  const Assembler& assembler = one.assembler();
  for (const std::size_t count : {1u, 2u, 7u, 64u}) {
    const auto shares = assembler.shares(count);
    ASSERT_EQ(shares.size(), count);
    std::size_t nodes = 0, slots = 0, places = 0, tiles = 0;
    for (const Share& share : shares) {
      EXPECT_EQ(share.nodes.begin, nodes);
      EXPECT_EQ(share.slots.begin, slots);
      nodes = share.nodes.end, slots = share.slots.end;
      places += share.places[0].size() + share.places[1].size(), tiles += share.own_tiles.size();
    }
    EXPECT_EQ(nodes, assembler.numbering().dofs() / 3);
    EXPECT_EQ(slots, assembler.pattern().slots);
    EXPECT_EQ(places, assembler.numbering().dofs());
    EXPECT_EQ(tiles, assembler.tile_energies().size());
  }
}

TEST(RankTeam, LeavesWhatIsSmallOrMovesToOneProcess) {
  test::RanksInThreads all(2);
  Case one({test::source_folder() + "/gear-library/scenes/dead-weight-panel.toml", {}, 1},
           test::shipped_plugins());
  ASSERT_EQ(one.open(), Case::State::ready);
  const auto unknowns = static_cast<std::int32_t>(one.plan().unknowns);
  EXPECT_TRUE(RankTeam(all.first(), unknowns).open(one.loaded().scene, one.plan()));
  EXPECT_FALSE(RankTeam(all.first(), unknowns + 1).open(one.loaded().scene, one.plan()));
  Plan moves = one.plan();
  moves.kind = AnalysisKind::dynamics;
  EXPECT_FALSE(RankTeam(all.first(), 1).open(one.loaded().scene, moves));
}

std::string fault_of(const Scene& sent, const Case& one) {
  test::RanksInThreads all(3);
  RankTeam team(all.first(), 1);
  auto partners = team.open(sent, one.plan());
  Assembler assembler(one.loaded().scene, one.plan(), 1);
  try {
    assembler.share_with(std::move(partners));
    EXPECT_EQ(assembler.processes(), 3);
    return "";
  } catch (const std::runtime_error& e) {
    EXPECT_EQ(assembler.processes(), 1);
    return e.what();
  }
}

TEST(RankTeam, SaysWhichRankCouldNotMakeTheScene) {
  Case one({test::source_folder() + "/gear-library/scenes/dead-weight-panel.toml", {}, 1},
           test::shipped_plugins());
  ASSERT_EQ(one.open(), Case::State::ready);
  EXPECT_EQ(fault_of(one.loaded().scene, one), "");
  Scene unknown = one.loaded().scene;
  unknown.parts[0].type = "nowhere/triangle";
  const std::string fault = fault_of(unknown, one);
  EXPECT_TRUE(fault.starts_with("rank 1: ")) << fault;
  EXPECT_NE(fault.find("nowhere"), std::string::npos) << fault;
  Scene other = one.loaded().scene;
  other.positions.resize(other.positions.size() + 3), other.held.push_back(0), other.labels.emplace_back();
  EXPECT_EQ(fault_of(other, one), "rank 1: its plugins make another scene than those of rank 0");
}

}  // namespace
}  // namespace netloft::io
