// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/mean_of_members.hpp"

#include "framework/assembler/mean_tension.hpp"

#include <Eigen/Dense>

#include <cassert>
#include <utility>

namespace netloft {

namespace {

using SpaceVector = Eigen::Vector3d;

/// Positions of a tile's nodes, [dof][64] [m].
struct PositionsOfTile {
  const double *before, *after, *middle;
};

/// The chords of a member: at both ends of the step, and at the positions at which forces are evaluated.
struct Chord {
  Chord(const netloft_member& m, const PositionsOfTile& tile, std::size_t nodes, std::size_t lane) {
    for (std::size_t p = 0; p < nodes; ++p)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t i = (3 * p + axis) * kTileLanes + lane;
        const auto row = static_cast<Eigen::Index>(axis);
        before[row] += m.c[p] * tile.before[i];
        after[row] += m.c[p] * tile.after[i];
        middle[row] += m.c[p] * tile.middle[i];
      }
    l0 = before.norm();
    l1 = after.norm();
    l = middle.norm();
  }
  bool has_length() const { return l0 + l1 > 0 && l1 > 0 && l > 0; }
  SpaceVector before = SpaceVector::Zero(), after = SpaceVector::Zero(), middle = SpaceVector::Zero();
  double l0, l1, l;
};

/// A member at both ends of a step and in its middle. The three rest lengths are different if the rope is
/// being paid out or hauled in.
struct MemberOfStep {
  const netloft_member &before, &middle, &after;
  bool grows() const { return before.rest_length != after.rest_length; }
};

/// Mean tension T̄, mean stiffness k, and stretch s in a step (mean_of_members.hpp), and the derivative of s
/// with respect to l₁.
struct MeanOfMember {
  MeanTension tension;
  MeanStiffness stiffness;
  double way, way_slope;
};

/// If the rest length changes, (4) of mean_of_members.hpp replaces (1) of mean_tension.hpp. The rest length
/// in the middle of the step must not be used for the whole step: if more rope is paid out than the rope is
/// stretched, it would seem slack at the beginning of the step.
MeanOfMember mean_of(const MemberOfStep& m, double before, double after) {
  if (!m.grows())
    return {mean_tension(m.middle, before, after), mean_stiffness(m.middle, before, after), after - before,
            1};
  netloft_member one = m.middle;
  one.rest_length = 1;
  const double L1 = m.after.rest_length, L = 0.5 * (m.before.rest_length + L1);
  const double early = before / m.before.rest_length, late = after / L1;
  const MeanTension mean = mean_tension(one, early, late);
  const MeanStiffness stiff = mean_stiffness(one, early, late);
  return {{mean.T, mean.slope / L1}, {stiff.k / L, stiff.slope / (L * L1)}, L * (late - early), L / L1};
}

/// The mean force of a member minus its force in the middle of the step, and the same difference of tangents.
struct Correction {
  SpaceVector force;
  Eigen::Matrix3d slope;
};

Correction correct(const MemberOfStep& step, const Chord& w, const StepEnds& ends, double memory) {
  const MeanOfMember of = mean_of(step, w.l0, w.l1);
  const netloft_member& m = step.middle;
  MeanTension mean = of.tension;
  if (ends.damping > 0) {
    const MeanStiffness& s = of.stiffness;
    const double late = of.way - ends.length * memory, half = 0.5 * ends.damping;
    mean.T += half * s.k * late;
    mean.slope += half * (s.k * of.way_slope + s.slope * late);  // (3)
  }
  const double sum = w.l0 + w.l1, T = tension_at(m, w.l), over = T / w.l;
  const SpaceVector d = (w.before + w.after) / sum, t1 = w.after / w.l1, t = w.middle / w.l;
  Correction c{mean.T * d - T * t, 2 * (mean.slope - mean.T / sum) * d * t1.transpose()};  // (1), (2)
  c.slope.diagonal().array() += 2 * mean.T / sum - over;
  c.slope -= (stiffness_at(m, w.l) - over) * t * t.transpose();
  return c;
}

/// Adds the block of corners (p, q) to the tangent of an element. The tangent is either `square` or a packed
/// `triangle`; the other pointer is nullptr.
void add_slope(std::size_t p, std::size_t q, std::size_t dofs, std::size_t lane, const Eigen::Matrix3d& block,
               double* square, double* triangle) {
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t row = 3 * p + r, column = 3 * q + c;
      const double entry = block(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c));
      if (square) square[(row * dofs + column) * kTileLanes + lane] += entry;
      if (triangle && column <= row)
        triangle[(packed(row) + column) * kTileLanes + lane] +=
            0.5 * (entry + block(static_cast<Eigen::Index>(c), static_cast<Eigen::Index>(r)));
    }
}

/// Reads the members of a tile at a time [s]. Returns false if the element fails.
bool read_members(const ElementFamily& f, std::size_t tile, std::size_t count, double time,
                  std::vector<netloft_member>& members) {
  const netloft_element_members& declared = f.type().members;
  members.resize(kTileLanes * declared.count);
  return declared.write(f.self(), time, static_cast<std::uint32_t>(tile * kTileLanes),
                        static_cast<std::uint32_t>(count), members.data()) == NETLOFT_OK;
}

}  // namespace

int add_mean_of_members(const TileOfStep& of, const double* stretch_rates) {
  assert(stretch_rates && "the plan asks for mean forces");
  const ElementFamily& f = of.family;
  const netloft_tile& t = of.tile;
  StepTile& step = of.step;
  const std::size_t tile = t.first / kTileLanes, count = f.type().members.count;
  const double half = 0.5 * of.request.between->length;
  if (!read_members(f, tile, t.count, t.time - half, step.members_before) ||
      !read_members(f, tile, t.count, t.time, step.members) ||
      !read_members(f, tile, t.count, t.time + half, step.members_after))
    return NETLOFT_ERROR;
  const PositionsOfTile ends{step.before.data(), step.after.data(), t.x};
  const auto nodes = static_cast<std::size_t>(f.nodes_per_element());
  double* force = of.open_force();
  double* slope = of.has_slope() ? of.open_slope() : nullptr;
  for (std::size_t lane = 0; lane < t.count; ++lane)
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t at = lane * count + k;
      const netloft_member& m = step.members[at];
      const Chord chord(m, ends, nodes, lane);
      if (!chord.has_length() || (m.EA == 0 && m.EA_compression == 0)) continue;
      const Correction by = correct({step.members_before[at], m, step.members_after[at]}, chord,
                                    *of.request.between, stretch_rates[k * kTileLanes + lane]);
      for (std::size_t p = 0; p < nodes; ++p) {
        for (std::size_t axis = 0; force && axis < 3; ++axis)
          force[(3 * p + axis) * kTileLanes + lane] +=
              m.number * m.c[p] * by.force[static_cast<Eigen::Index>(axis)];
        for (std::size_t q = 0; slope && q < nodes; ++q)
          add_slope(p, q, of.dofs(), lane, t.cu * m.number * m.c[p] * m.c[q] * by.slope,
                    of.symmetric ? nullptr : slope, of.symmetric ? slope : nullptr);
      }
    }
  return NETLOFT_OK;
}

bool remember_stretch_rates(const ElementFamily& f, std::size_t tile, const StepEnds& ends, double memory,
                            double time, StepTile& step, double* stretch_rates) {
  const std::size_t count = f.type().members.count;
  const std::size_t lanes = std::min(kTileLanes, f.size() - tile * kTileLanes);
  if (!read_members(f, tile, lanes, time - ends.length, step.members_before) ||
      !read_members(f, tile, lanes, time, step.members_after))
    return false;
  const PositionsOfTile all{step.before.data(), step.after.data(), step.after.data()};
  for (std::size_t lane = 0; lane < lanes; ++lane)
    for (std::size_t k = 0; k < count; ++k) {
      const netloft_member &m = step.members_after[lane * count + k],
                           &m0 = step.members_before[lane * count + k];
      const Chord chord(m, all, static_cast<std::size_t>(f.nodes_per_element()), lane);
      double& rate = stretch_rates[k * kTileLanes + lane];
      const bool bears = is_taut(m0, chord.l0) && is_taut(m, chord.l1);
      const double way = mean_of({m0, m, m}, chord.l0, chord.l1).way;
      rate = bears ? rate + memory * (way / ends.length - rate) : 0;  // (3)
    }
  return true;
}

}  // namespace netloft
