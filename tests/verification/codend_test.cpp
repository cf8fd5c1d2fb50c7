// SPDX-License-Identifier: BSD-3-Clause
//
// Tubes of diamond netting: a cod-end inflated by its catch, and a tube stretched between two rings, compared
// with the axisymmetric membrane of the same netting. All start from an approximate cylinder.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "framework/assembler/reports.hpp"
#include "tests/verification/scene_file.hpp"

namespace netloft::test {
namespace {

const double kPi = std::acos(-1.0);

/// Distance of a node from the axis of a tube that runs along x (0) or z (2).
double radius(const SolvedFile& s, std::uint32_t node, int axis) {
  const auto x = s.solved.position(node);
  return axis == 0 ? std::hypot(x[1], x[2]) : std::hypot(x[0], x[1]);
}

/// Mean radius of the nodes V meshes behind the fore edge.
double ring_radius(const SolvedFile& s, const std::string& part, double V, int axis) {
  const scenes::PartGeometry& p = s.part(part);
  double sum = 0, count = 0;
  for (std::size_t own = 0; own < p.nodes.size(); ++own)
    if (std::abs(p.panel[own][1] - V) < 1e-9) sum += radius(s, p.nodes[own], axis), ++count;
  return sum / count;
}

/// Mean x of the ring V meshes behind the fore edge.
double ring_position(const SolvedFile& s, const std::string& part, double V) {
  const scenes::PartGeometry& p = s.part(part);
  double sum = 0, count = 0;
  for (std::size_t own = 0; own < p.nodes.size(); ++own)
    if (std::abs(p.panel[own][1] - V) < 1e-9) sum += s.solved.position(p.nodes[own])[0], ++count;
  return sum / count;
}

// Exact values: quadrature of the meridian of axisymmetric diamond netting under pressure, with the twine's
// strain; 100 meshes round and long, bar 0.06 m, ring of 0.4 m, 1614.375 Pa on the last 50 meshes. The
// tolerances for triangles (24 round 0.3, 2, 1.5 %; 48 round 0.2, 0.7, 0.4 %) are the errors observed with
// Priour's triangles.
struct Codend {
  const char* name;
  double EA;                            // [N]
  double length, largest_radius, drag;  // [m], [m], [N]
  int round;
  double length_error, radius_error, drag_error;
  double neck, neck_error, tension_error;
};
const Codend kCodends[] = {
    {"Stiff24", 1e4, 8.897802, 1.536439, 7275.728, 24, 3e-3, 2e-2, 1.5e-2, 0.2789266, 6e-2, 2e-2},
    {"Stiff48", 1e4, 8.897802, 1.536439, 7275.728, 48, 2e-3, 7e-3, 4e-3, 0.2789266, 1e-2, 1e-2},
    {"Soft24", 1e3, 9.366688, 1.687495, 8415.734, 24, 3e-3, 2e-2, 1.5e-2, 0.2877453, 6e-2, 2e-2},
    {"Soft48", 1e3, 9.366688, 1.687495, 8415.734, 48, 2e-3, 7e-3, 4e-3, 0.2877453, 1e-2, 1e-2},
};

SolvedFile solve_codend(const Codend& c, const std::vector<std::string>& more = {}) {
  std::vector<std::string> overrides{
      "parts.codend.cells=[" + std::to_string(c.round) + ",48]",
      "parts.codend.twine.EA=" + std::to_string(c.EA),
  };
  overrides.insert(overrides.end(), more.begin(), more.end());
  return solve_file("verification/codend-with-catch.toml", overrides);
}

struct Measured {
  double length, largest_radius, drag;
};

Measured measure(const SolvedFile& s) {
  Measured m{s.solved.position(s.node("codend", "aft"))[0], 0, -s.solved.total_reaction()[0]};
  for (const auto node : s.part("codend").nodes)
    m.largest_radius = std::max(m.largest_radius, radius(s, node, 0));
  return m;
}

class CodendWithCatch : public testing::TestWithParam<Codend> {};

TEST_P(CodendWithCatch, SwellsAsTheAxisymmetricMembraneDoes) {
  const Codend& c = GetParam();
  const SolvedFile s = solve_codend(c);
  ASSERT_EQ(s.solved.solution.status, SolveStatus::converged) << s.solved.solution.reason;
  const Measured m = measure(s);
  std::printf("%-8s %3d iterations: length %.6f m (%.2e), largest radius %.6f m (%.2e), drag %.3f N (%.2e)\n",
              c.name, s.solved.solution.cost.statistics.iterations, m.length, relative(m.length, c.length),
              m.largest_radius, relative(m.largest_radius, c.largest_radius), m.drag,
              relative(m.drag, c.drag));
  EXPECT_LT(relative(m.length, c.length), c.length_error);
  EXPECT_LT(relative(m.largest_radius, c.largest_radius), c.radius_error);
  EXPECT_LT(relative(m.drag, c.drag), c.drag_error);
  EXPECT_LE(s.solved.solution.cost.statistics.iterations, 60);
}

/// The drag is the pressure times the opening at the catch front, where no netting balances it.
TEST_P(CodendWithCatch, IsDraggedByThePressureOnTheOpeningAtTheFront) {
  const SolvedFile s = solve_codend(GetParam());
  const double r = ring_radius(s, "codend", 50, 0);
  const double n = GetParam().round, area = 0.5 * n * r * r * std::sin(2 * kPi / n);
  EXPECT_LT(relative(measure(s).drag, 1614.375 * area), 5e-3);
}

TEST_P(CodendWithCatch, TakesTheSameShapeFromAnotherCrudeCylinder) {
  const Measured one = measure(solve_codend(GetParam()));
  const SolvedFile s =
      solve_codend(GetParam(), {"parts.codend.tube={from=[0,0,0],to=[6,0,0],radius=0.4,radius_aft=1.0}"});
  ASSERT_EQ(s.solved.solution.status, SolveStatus::converged) << s.solved.solution.reason;
  const Measured two = measure(s);
  EXPECT_LT(relative(two.length, one.length), 1e-7);
  EXPECT_LT(relative(two.largest_radius, one.largest_radius), 1e-7);
  EXPECT_LT(relative(two.drag, one.drag), 1e-7);
}

/// Mean radius of the narrowest ring of nodes ahead of the catch.
double smallest_ring(const SolvedFile& s) {
  double least = 1e9;
  for (const auto& [U, V] : s.part("codend").panel)
    if (U == 0 && V < 50) least = std::min(least, ring_radius(s, "codend", V, 0));
  return least;
}

/// An output of the catch or of the netting, by element.
std::vector<double> output(const SolvedFile& s, const std::string& type, const std::string& name) {
  for (std::size_t f = 0; f < s.solved.assembler->families().size(); ++f) {
    const ElementType& family = s.solved.assembler->families()[f]->type();
    for (std::size_t k = 0; k < family.outputs.size() && family.type == type; ++k)
      if (family.outputs[k].name == name) {
        std::vector<std::vector<double>> values;
        s.solved.assembler->reports().outputs(s.solved.solution.x, f, values);
        return values[k];
      }
  }
  throw std::invalid_argument("no output " + type + " " + name);
}

/// Tension of the taut twines around the widest ring of nodes [N].
double tension_at_largest(const SolvedFile& s) {
  const scenes::PartGeometry& p = s.part("codend");
  double widest = 0, at = 0;
  for (const auto& [U, V] : p.panel)
    if (U == 0 && ring_radius(s, "codend", V, 0) > widest) widest = ring_radius(s, "codend", V, 0), at = V;
  const auto& family = *s.solved.assembler->families()[0];
  const std::vector<double> tension = output(s, "priour/triangle", "tension");
  double sum = 0, count = 0;
  for (std::size_t e = 0; e < family.size(); ++e)
    for (int c = 0; c < 3; ++c) {
      const auto own = std::find(p.nodes.begin(), p.nodes.end(), family.node(e, c)) - p.nodes.begin();
      if (p.panel[static_cast<std::size_t>(own)][1] == at) sum += tension[e], ++count;
    }
  return sum / count;
}

double volume_of(const SolvedFile& s) {
  double sum = 0;
  for (const double v : output(s, "catch/pressure", "volume")) sum += v;
  return sum;
}
double front_of(const SolvedFile& s) { return output(s, "catch/pressure", "front").front(); }

double farthest(const SolvedFile& a, const SolvedFile& b) {
  double most = 0;
  for (const auto node : a.part("codend").nodes) {
    const auto p = a.solved.position(node), q = b.solved.position(node);
    most = std::max(most, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
  }
  return most;
}

std::vector<std::string> by_volume(double volume) {
  return {"parts.catch.catch={pressure=1614.375,volume=" + std::to_string(volume) + "}"};
}

std::vector<std::string> by_meshes(double meshes) {
  return {"parts.catch.catch={pressure=1614.375,meshes=" + std::to_string(meshes) + "}"};
}

/// The volume in the scene is rounded to six decimals of a cubic metre, 1e-7 of the volume, which moves the
/// front by about 1e-6 meshes.
TEST_P(CodendWithCatch, FindsTheFrontOfTheVolumeThatFiftyMeshesHold) {
  const SolvedFile meshes = solve_codend(GetParam());
  const SolvedFile volume = solve_codend(GetParam(), by_volume(volume_of(meshes)));
  ASSERT_EQ(volume.solved.solution.status, SolveStatus::converged) << volume.solved.solution.reason;
  const Statistics &a = meshes.solved.solution.cost.statistics, &b = volume.solved.solution.cost.statistics;
  std::printf("%-8s %.6f m3: front %.9f meshes, nodes %.1e m apart; %d and %d iterations, %.2f and %.2f s\n",
              GetParam().name, volume_of(meshes), front_of(volume), farthest(meshes, volume), a.iterations,
              b.iterations, a.total_cpu_seconds, b.total_cpu_seconds);
  EXPECT_NEAR(front_of(volume), 50, 1e-5);
  EXPECT_LT(farthest(meshes, volume), 1e-6);
  EXPECT_LE(b.iterations, 80);
}

/// The front is between two rows of nodes, where it cuts triangles.
TEST_P(CodendWithCatch, IsTheSameWithItsFrontGivenAsItWasFound) {
  const double wanted = 7.5;  // [m3]
  const SolvedFile volume = solve_codend(GetParam(), by_volume(wanted));
  ASSERT_EQ(volume.solved.solution.status, SolveStatus::converged) << volume.solved.solution.reason;
  EXPECT_NEAR(volume_of(volume), wanted, 1e-8);
  const SolvedFile meshes = solve_codend(GetParam(), by_meshes(front_of(volume)));
  ASSERT_EQ(meshes.solved.solution.status, SolveStatus::converged) << meshes.solved.solution.reason;
  std::printf("%-8s %.1f m3 fill %.6f meshes; by meshes %.9f m3, nodes %.1e m apart; %d and %d iterations\n",
              GetParam().name, wanted, front_of(volume), volume_of(meshes), farthest(meshes, volume),
              volume.solved.solution.cost.statistics.iterations,
              meshes.solved.solution.cost.statistics.iterations);
  EXPECT_NEAR(volume_of(meshes), wanted, 1e-5);
  EXPECT_LT(farthest(meshes, volume), 1e-6);
}

/// The netting behind a ring of nodes, closed by the polygon of the front, is a polyhedron. Its volume is the
/// sum of the cones over its triangles from the point of the axis at the front.
TEST(CatchVolume, IsThatOfThePolyhedronBehindTheFront) {
  const SolvedFile s = solve_codend(kCodends[0]);
  const scenes::PartGeometry& p = s.part("codend");
  const auto& family = *s.solved.assembler->families()[0];
  const double apex = ring_position(s, "codend", 50);
  double six = 0;
  for (std::size_t e = 0; e < family.size(); ++e) {
    std::array<std::array<double, 3>, 3> x;
    bool behind = true;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto node = family.node(e, static_cast<int>(c));
      const auto own = std::find(p.nodes.begin(), p.nodes.end(), node) - p.nodes.begin();
      behind = behind && p.panel[static_cast<std::size_t>(own)][1] > 50 - 1e-9;
      x[c] = s.solved.position(node), x[c][0] -= apex;
    }
    if (!behind) continue;
    six += x[0][0] * (x[1][1] * x[2][2] - x[1][2] * x[2][1]) +
           x[0][1] * (x[1][2] * x[2][0] - x[1][0] * x[2][2]) +
           x[0][2] * (x[1][0] * x[2][1] - x[1][1] * x[2][0]);
  }
  EXPECT_NEAR(volume_of(s), six / 6, 5e-5 * six / 6);  // the sides are mirror images except for the diagonals
}

/// A volume larger than the netting can hold: the run fails and its message names the front.
TEST(CatchVolume, ThatDoesNotFitIsNotConverged) {
  const SolvedFile s = solve_codend(kCodends[0], by_volume(60));
  std::printf("60 m3: %s\n", s.solved.solution.reason.c_str());
  EXPECT_EQ(s.solved.solution.status, SolveStatus::not_converged);
  EXPECT_NE(s.solved.solution.reason.find("the front of the catch has left its netting"), std::string::npos);
  EXPECT_NE(s.solved.solution.reason.find("may be too small for the volume"), std::string::npos);
}

/// Tension of a bar at the widest ring, where 2N bars of length l bear the pressure on the cross-section,
///   2 N T cos α = p π R²,  sin α = π R/(N l),  l = a (1 + T/EA).
double bar_tension(double R, double EA) {
  double T = 0;
  for (int i = 0; i < 50; ++i) {
    const double sine = kPi * R / (100 * 0.06 * (1 + T / EA));
    T = 1614.375 * kPi * R * R / (200 * std::sqrt(1 - sine * sine));
  }
  return T;
}

TEST(Membrane, HasTheTensionOfTheInextensibleOne) {
  EXPECT_NEAR(bar_tension(1.522510815, 1e99), 97.364010, 1e-5);  // error of the quadrature
}

TEST_P(CodendWithCatch, HasTheNeckAndTheTensionOfTheMembrane) {
  const Codend& c = GetParam();
  const SolvedFile s = solve_codend(c);
  const double neck = smallest_ring(s), bar = tension_at_largest(s),
               want = bar_tension(c.largest_radius, c.EA);
  std::printf("%-8s neck %.6f m (%.2e), bar %.4f N (%.2e)\n", c.name, neck, relative(neck, c.neck), bar,
              relative(bar, want));
  EXPECT_LT(relative(neck, c.neck), c.neck_error);
  EXPECT_LT(relative(bar, want), c.tension_error);
}

/// Its bars start from the same approximate cylinder, with 50 cells round and along.
TEST(LumpedCodend, SwellsAsTheAxisymmetricMembraneDoes) {
  for (const std::size_t which : {1u, 3u}) {
    const Codend& c = kCodends[which];
    const SolvedFile s = solve_codend(c, {"parts.codend.type=lumped/net", "parts.codend.cells=[50,50]"});
    ASSERT_EQ(s.solved.solution.status, SolveStatus::converged) << s.solved.solution.reason;
    const Measured m = measure(s);
    std::printf("lumped, EA %g N, %d iterations: length %.2e, largest radius %.2e, drag %.2e\n", c.EA,
                s.solved.solution.cost.statistics.iterations, relative(m.length, c.length),
                relative(m.largest_radius, c.largest_radius), relative(m.drag, c.drag));
    EXPECT_LT(relative(m.length, c.length), 5e-4);
    EXPECT_LT(relative(m.largest_radius, c.largest_radius), 1e-3);
    EXPECT_LT(relative(m.drag, c.drag), 2e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(AllTwines, CodendWithCatch, testing::ValuesIn(kCodends),
                         [](const auto& c) { return c.param.name; });

// Exact values: quadrature for inextensible twine. Meshes behind the upper ring, radius and depth [m].
struct Ring {
  double V, r, z;
};
const Ring kRings[] = {{5, 1.202471, 0.298398},  {10, 0.926500, 0.712108}, {15, 0.697134, 1.204106},
                       {20, 0.517518, 1.743779}, {25, 0.381324, 2.310781}, {30, 0.279834427, 2.892938238}};

/// Mean radius and depth of each row of nodes, from the upper ring down.
std::vector<Ring> rings_of(const SolvedFile& s, int along) {
  std::vector<Ring> rings;
  const scenes::PartGeometry& p = s.part("net");
  for (int j = 0; j <= along; ++j) {
    const double V = 30.0 * j / along;
    double z = 0, count = 0;
    for (std::size_t own = 0; own < p.nodes.size(); ++own)
      if (std::abs(p.panel[own][1] - V) < 1e-9) z -= s.solved.position(p.nodes[own])[2], ++count;
    rings.push_back({V, ring_radius(s, "net", V, 2), z / count});
  }
  return rings;
}

/// Radius where `coordinate` (V or z) has the value `at`, linear between rings.
double radius_at(const std::vector<Ring>& rings, double Ring::*coordinate, double at) {
  std::size_t k = 1;
  while (k + 1 < rings.size() && rings[k].*coordinate < at) ++k;
  const Ring &a = rings[k - 1], &b = rings[k];
  return a.r + (b.r - a.r) * (at - a.*coordinate) / (b.*coordinate - a.*coordinate);
}

/// Two measures of the error at each exact ring. Shape: the radius of the tube at the depth of the exact
/// ring. Mesh: the radius of the ring of nodes as many meshes behind the upper ring. If cells alternate, this
/// ring of nodes is slightly too high: one triangle of a cell touches the wider ring, the other the narrower
/// one, and across a facet one direction of twines is longer than the other; the longer twines bear the load,
/// and the cell is too short (README.md).
struct Tube {
  int round, along;
  const char* division;
  double shape_error, mesh_error;
};

class Tractrix : public testing::TestWithParam<Tube> {};

TEST_P(Tractrix, IsWhatATubeBetweenTwoRingsTendsTo) {
  const Tube& t = GetParam();
  const std::string n = std::to_string(t.round);
  const SolvedFile s = solve_file("verification/tractrix.toml",
                                  {"parts.net.cells=[" + n + "," + std::to_string(t.along) + "]",
                                   std::string("parts.net.division=") + t.division, "parts.ring.cells=" + n});
  ASSERT_EQ(s.solved.solution.status, SolveStatus::converged) << s.solved.solution.reason;
  std::printf("%3d round, %2d along, %3d iterations\n", t.round, t.along,
              s.solved.solution.cost.statistics.iterations);
  const std::vector<Ring> rings = rings_of(s, t.along);
  for (const auto& ring : kRings) {
    const double shape = relative(radius_at(rings, &Ring::z, std::min(ring.z, rings.back().z)), ring.r);
    const double mesh = relative(radius_at(rings, &Ring::V, ring.V), ring.r);
    std::printf("  radius %.2f m down: %.2e; after %2.0f meshes: %.2e\n", ring.z, shape, ring.V, mesh);
    EXPECT_LT(shape, t.shape_error);
    EXPECT_LT(mesh, t.mesh_error);
  }
  std::printf("  length %.6f m (%.2e)\n", rings.back().z, relative(rings.back().z, kRings[5].z));
  EXPECT_LT(relative(rings.back().z, kRings[5].z), t.shape_error);
}

/// Radius of the circle with the perimeter of a polygon of n corners on a circle of radius r.
double radius_of_equal_perimeter(double r, int n) { return r * std::sin(kPi / n) / (kPi / n); }

// Both rings are held at their exact places, twenty cells along. Linear interpolation between rings of nodes
// contributes up to 0.09 %.
TEST(TractrixBetweenHeldRings, LiesWithinATenthOfAPercentOfEachRingsOwnRadiusWithTwentyCellsAlong) {
  const SolvedFile s = solve_file("verification/tractrix-between-rings.toml");
  ASSERT_EQ(s.solved.solution.status, SolveStatus::converged) << s.solved.solution.reason;
  std::vector<Ring> rings = rings_of(s, 20);
  for (Ring& ring : rings) ring.r = radius_of_equal_perimeter(ring.r, 66);
  EXPECT_NEAR(rings.front().r, 1.5, 1e-9);
  EXPECT_NEAR(rings.back().r, kRings[5].r, 1e-9);
  for (std::size_t k = 0; k + 1 < std::size(kRings); ++k) {
    const Ring& exact = kRings[k];
    const double mesh = relative(radius_at(rings, &Ring::V, exact.V), exact.r);
    const double shape = relative(radius_at(rings, &Ring::z, exact.z), exact.r);
    std::printf("  radius after %2.0f meshes: %.2e; %.2f m from the wide ring: %.2e\n", exact.V, mesh,
                exact.z, shape);
    EXPECT_LT(mesh, 1e-3);
    EXPECT_LT(shape, 1e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(FinerAndFiner, Tractrix,
                         testing::Values(Tube{100, 20, "alternating", 1.1e-2, 1.5e-2},
                                         Tube{100, 30, "alternating", 5e-3, 5e-3},
                                         Tube{200, 60, "alternating", 5e-3 / 4, 5e-3 / 4},
                                         Tube{34, 10, "crossed", 5e-3, 5e-3},
                                         Tube{66, 20, "crossed", 5e-3 / 4, 1e-3}),
                         [](const auto& tube) {
                           return std::to_string(tube.param.round) + "Round" +
                                  std::to_string(tube.param.along) + "Along" + tube.param.division;
                         });

}  // namespace
}  // namespace netloft::test
