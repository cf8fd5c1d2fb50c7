// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/between.hpp"

#include "framework/assembler/workspace.hpp"

#include <Eigen/Dense>

#include <cmath>

namespace netloft {

namespace {

using SpaceVector = Eigen::Vector3d;

double stiffness_at(const netloft_member& m, double l) {
  return (l >= m.rest_length ? m.EA : m.EA_compression) / m.rest_length;
}
double tension_at(const netloft_member& m, double l) { return stiffness_at(m, l) * (l - m.rest_length); }
bool is_taut(const netloft_member& m, double l) { return l >= m.rest_length; }

}  // namespace

/// Lengths on both sides of the rest length add up in the quotient: nothing cancels.
MeanTension mean_tension(const netloft_member& m, double before, double after) {
  const double a = before - m.rest_length, b = after - m.rest_length, k = stiffness_at(m, after);
  if (is_taut(m, before) == is_taut(m, after)) return {0.5 * k * (a + b), 0.5 * k};
  const double mean = 0.5 * (k * b * b - stiffness_at(m, before) * a * a) / (b - a);  // (1)
  return {mean, (k * b - mean) / (b - a)};
}

MeanStiffness mean_stiffness(const netloft_member& m, double before, double after) {
  const double k = stiffness_at(m, after);
  if (is_taut(m, before) == is_taut(m, after)) return {k, 0};
  const double mean = (tension_at(m, after) - tension_at(m, before)) / (after - before);
  return {mean, (k - mean) / (after - before)};
}

namespace {

/// A member in one lane: chords at both ends of the step and in the middle of what was evaluated.
struct Chord {
  Chord(const netloft_member& m, const Assembler::EndsOfTile& tile, std::size_t nodes, std::size_t lane) {
    for (std::size_t p = 0; p < nodes; ++p)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t i = (3 * p + axis) * kLanes + lane;
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

/// A member at both ends of a step and in its middle: rope that is paid out or hauled has other rest lengths.
struct MemberOfStep {
  const netloft_member &before, &middle, &after;
  bool grows() const { return before.rest_length != after.rest_length; }
};

/// T̄ and k of (1) and (4), and the way s that is stretched, with its derivative with l₁.
struct MeanOfMember {
  MeanTension tension;
  MeanStiffness stiffness;
  double way, way_slope;
};

/// Where the rest length L grows from L₀ to L₁, the tension is the mean over the strain λ − 1, λ = l/L. With
/// ψ = L φ(λ), L̄ = ½ (L₀ + L₁) and λ̄, φ̄ alike,
///   T̄ = (φ(λ₁) − φ(λ₀))/(λ₁ − λ₀),  s = L̄ (λ₁ − λ₀)                                     (5)
///   ψ(l₁, L₁) − ψ(l₀, L₀) = T̄ (l₁ − l₀) + (φ̄ − T̄ λ̄)(L₁ − L₀)                            (6)
/// exactly; the second part is the work of the drum. With the rest length of the middle alone, a step that
/// pays out more than the rope is stretched would take it for slack before.
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

/// What is added to the force in the middle and to its slope there, of one member.
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
    mean.slope += half * (s.k * of.way_slope + s.slope * late);  // (4)
  }
  const double sum = w.l0 + w.l1, T = tension_at(m, w.l), over = T / w.l;
  const SpaceVector d = (w.before + w.after) / sum, t1 = w.after / w.l1, t = w.middle / w.l;
  Correction c{mean.T * d - T * t, 2 * (mean.slope - mean.T / sum) * d * t1.transpose()};  // (1), (3)
  c.slope.diagonal().array() += 2 * mean.T / sum - over;
  c.slope -= (stiffness_at(m, w.l) - over) * t * t.transpose();
  return c;
}

/// Takes out of the moves of an element's nodes, [3 nodes] at x, what moves it as a whole.
void take_out_rigid_motion(const double* x, std::size_t nodes, double* moves) {
  using Nodes = Eigen::Matrix<double, 3, Eigen::Dynamic>;
  const Eigen::Map<const Nodes> places(x, 3, static_cast<Eigen::Index>(nodes));
  Eigen::Map<Nodes> all(moves, 3, static_cast<Eigen::Index>(nodes));
  const SpaceVector centre = places.rowwise().mean(), mean = all.rowwise().mean();
  all.colwise() -= mean;
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  SpaceVector turn = SpaceVector::Zero();
  for (Eigen::Index p = 0; p < places.cols(); ++p) {
    const SpaceVector r = places.col(p) - centre, move = all.col(p);
    inertia += r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose();
    turn += r.cross(move);
  }
  if (!(inertia.trace() > 0)) return;
  const SpaceVector omega = inertia.completeOrthogonalDecomposition().solve(turn);
  for (Eigen::Index p = 0; p < places.cols(); ++p) {
    const SpaceVector r = places.col(p) - centre;
    all.col(p) -= omega.cross(r);
  }
}

/// Adds a block of an element's slope to whichever tangent is kept.
void add_slope(std::size_t p, std::size_t q, std::size_t dofs, std::size_t lane, const Eigen::Matrix3d& block,
               double* square, double* triangle) {
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t row = 3 * p + r, column = 3 * q + c;
      const double entry = block(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c));
      if (square) square[(row * dofs + column) * kLanes + lane] += entry;
      if (triangle && column <= row)
        triangle[(packed(row) + column) * kLanes + lane] +=
            0.5 * (entry + block(static_cast<Eigen::Index>(c), static_cast<Eigen::Index>(r)));
    }
}

/// Rounding of the energies of both ends is worth this many units of them.
constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();

}  // namespace

/// Positions at the ends of the step for a tile, whose own have been gathered.
void Assembler::gather_ends(const FamilyGroup& group, std::size_t tile, const StepEnds& ends,
                            Workspace& w) const {
  gather_positions(group.tiling, tile, ends.before, w.before.data());
  gather_positions(group.tiling, tile, ends.after, w.after.data());
}

int Assembler::add_mean_forces(std::size_t family, std::size_t tile, const netloft_tile& t,
                               const Request& request, Workspace& w) {
  const ElementFamily& f = *families_[family];
  for (const auto& term : f.active_terms()) {
    const bool counts = (term.traits & NETLOFT_CONSERVATIVE) && !(term.traits & NETLOFT_CONSTANT) &&
                        !(term.traits & request.without);
    if (!counts) continue;
    const int status = term.traits & NETLOFT_OF_MEMBERS ? add_mean_of_members(family, tile, t, request, w)
                                                        : add_mean_of_energy(f, term, t, request, w);
    if (status != NETLOFT_OK) return status;
  }
  return NETLOFT_OK;
}

int Assembler::add_mean_of_members(std::size_t family, std::size_t tile, const netloft_tile& t,
                                   const Request& request, Workspace& w) {
  const ElementFamily& f = *families_[family];
  const auto& element = f.type().element;
  const auto dofs = static_cast<std::size_t>(f.type().dofs());
  const auto nodes = static_cast<std::size_t>(f.nodes_per_element());
  const double half = 0.5 * request.between->length;
  for (const auto& [members, time] : {std::pair{&w.members_before, t.time - half},
                                      {&w.members, t.time},
                                      {&w.members_after, t.time + half}}) {
    members->resize(kLanes * element.member_count);
    if (element.members(f.self(), time, t.first, t.count, members->data()) != NETLOFT_OK)
      return NETLOFT_ERROR;
  }
  const EndsOfTile ends{w.before.data(), w.after.data(), t.x};
  double* force = request.residual ? w.force.open(dofs, t.count) : nullptr;
  const bool has_slope = request.values && request.matrix != MatrixKind::metric;
  const bool symmetric = pattern_.symmetric;
  double* slope = has_slope ? w.open_tangent(symmetric, dofs, t.count) : nullptr;
  for (std::size_t lane = 0; lane < t.count; ++lane)
    for (std::size_t k = 0; k < element.member_count; ++k) {
      const std::size_t at = lane * element.member_count + k;
      const netloft_member& m = w.members[at];
      const Chord chord(m, ends, nodes, lane);
      if (!chord.has_length() || (m.EA == 0 && m.EA_compression == 0)) continue;
      const Correction by = correct({w.members_before[at], m, w.members_after[at]}, chord, *request.between,
                                    stretch_rates_[family].kept(tile)[k * kLanes + lane]);
      for (std::size_t p = 0; p < nodes; ++p) {
        for (std::size_t axis = 0; force && axis < 3; ++axis)
          force[(3 * p + axis) * kLanes + lane] +=
              m.number * m.c[p] * by.force[static_cast<Eigen::Index>(axis)];
        for (std::size_t q = 0; slope && q < nodes; ++q)
          add_slope(p, q, dofs, lane, t.cu * m.number * m.c[p] * m.c[q] * by.slope,
                    symmetric ? nullptr : slope, symmetric ? slope : nullptr);
      }
    }
  return NETLOFT_OK;
}

/// (2) of one term.
int Assembler::add_mean_of_energy(const ElementFamily& f, const netloft_term& term, const netloft_tile& t,
                                  const Request& request, Workspace& w) {
  const auto dofs = static_cast<std::size_t>(f.type().dofs());
  const bool has_slope = request.values && request.matrix != MatrixKind::metric;
  std::fill(w.energies.begin(), w.energies.end(), 0.0);
  std::fill(w.forces.begin(), w.forces.end(), 0.0);
  if (has_slope) std::fill_n(w.scratch.begin(), packed(dofs) * kLanes, 0.0);
  const auto call = [&](const double* x, std::size_t which, std::uint32_t want) {
    netloft_tile at = t;
    at.x = x;
    at.x_low = nullptr;
    at.want = want;
    at.cu = 1;
    at.energy = want & NETLOFT_WANT_ENERGY ? &w.energies[which * kLanes] : nullptr;
    at.force = want & NETLOFT_WANT_FORCE ? &w.forces[which * dofs * kLanes] : nullptr;
    at.tangent = want & NETLOFT_WANT_TANGENT ? w.scratch.data() : nullptr;
    return f.evaluate(term, at);
  };
  const bool tells_slope = has_slope && (term.traits & NETLOFT_SYMMETRIC);
  const std::uint32_t slope = tells_slope ? std::uint32_t{NETLOFT_WANT_TANGENT} : 0u;
  for (const int status : {call(w.before.data(), 0, NETLOFT_WANT_ENERGY),
                           call(w.after.data(), 1, NETLOFT_WANT_ENERGY | NETLOFT_WANT_FORCE),
                           call(t.x, 0, NETLOFT_WANT_FORCE | slope)})
    if (status != NETLOFT_OK) return status;
  for (std::size_t lane = 0; lane < t.count; ++lane)
    add_mean_of_lane(f, term, t, request, slope != 0, lane, w);
  return NETLOFT_OK;
}

/// One lane of a term with an energy: where its nodes go, its energies and forces.
Assembler::MeanOfLane Assembler::read_mean(const ElementFamily& f, const netloft_term& term, std::size_t lane,
                                           const Workspace& w) const {
  const auto dofs = static_cast<std::size_t>(f.type().dofs());
  MeanOfLane m;
  double middle[12];
  for (std::size_t d = 0; d < dofs; ++d) {
    const std::size_t i = d * kLanes + lane;
    m.way[d] = w.after[i] - w.before[i];
    middle[d] = 0.5 * (w.after[i] + w.before[i]);
    m.force[d] = w.forces[i];
    m.later[d] = w.forces[dofs * kLanes + i];
    m.g[d] = m.way[d];
    m.work += m.force[d] * m.way[d];
  }
  const double early = w.energies[lane], late = w.energies[kLanes + lane], missing = late - early - m.work;
  if (std::abs(missing) <= kRounding * (std::abs(early) + std::abs(late) + std::abs(m.work))) return m;
  const bool is_inner =
      !(term.traits & NETLOFT_FROM_OUTSIDE) && !f.type().is_on_body() && f.type().globals.empty() && dofs > 3;
  if (is_inner) take_out_rigid_motion(middle, dofs / 3, m.g);
  for (std::size_t d = 0; d < dofs; ++d) m.square += m.g[d] * m.g[d];
  if (m.square > 0) m.mu = missing / m.square;
  return m;
}

/// Slope of (2) in the middle: g ⊗ [(2 f₁ − 2 f − K Δ)/(g·g) − 4 μ g/(g·g)] + 2 μ P.
void Assembler::add_mean_of_lane(const ElementFamily& f, const netloft_term& term, const netloft_tile& t,
                                 const Request& request, bool has_slope, std::size_t lane, Workspace& w) {
  const auto dofs = static_cast<std::size_t>(f.type().dofs());
  const MeanOfLane m = read_mean(f, term, lane, w);
  if (m.mu == 0) return;
  double* force = request.residual ? w.force.open(dofs, t.count) : nullptr;
  for (std::size_t d = 0; force && d < dofs; ++d) force[d * kLanes + lane] += m.mu * m.g[d];
  if (!has_slope) return;
  double* slope = w.open_tangent(pattern_.symmetric, dofs, t.count);
  const auto entry = [&](std::size_t r, std::size_t c) {
    double turned = 2 * (m.later[c] - m.force[c]);
    for (std::size_t k = 0; k < dofs; ++k)
      turned -= w.scratch[(packed(std::max(k, c)) + std::min(k, c)) * kLanes + lane] * m.way[k];
    return t.cu * (m.g[r] * (turned - 4 * m.mu * m.g[c]) / m.square + (r == c ? 2 * m.mu : 0));
  };
  for (std::size_t r = 0; r < dofs; ++r)
    for (std::size_t c = 0; c < dofs; ++c)
      if (!pattern_.symmetric)
        slope[(r * dofs + c) * kLanes + lane] += entry(r, c);
      else if (c <= r)
        slope[(packed(r) + c) * kLanes + lane] += 0.5 * (entry(r, c) + entry(c, r));
}

bool Assembler::remember_stretch(const StepEnds& ends, double memory, double time) {
  for (std::size_t family = 0; family < families_.size(); ++family) {
    if (stretch_rates_[family].empty()) continue;
    const FamilyGroup& group = group_of(family);
    for (std::size_t tile = 0; tile < group.tiling.tiles; ++tile)
      if (!remember_stretch(family, group, tile, ends, memory, time)) return false;
  }
  return true;
}

bool Assembler::remember_stretch(std::size_t family, const FamilyGroup& group, std::size_t tile,
                                 const StepEnds& ends, double memory, double time) {
  Workspace& w = *workspaces_[0];
  const ElementFamily& f = *families_[family];
  const std::size_t count = f.type().element.member_count;
  const auto lanes = static_cast<std::uint32_t>(std::min(kLanes, f.size() - tile * kLanes));
  gather_ends(group, tile, ends, w);
  for (const auto& [members, at] :
       {std::pair{&w.members_before, time - ends.length}, {&w.members_after, time}}) {
    members->resize(kLanes * count);
    if (f.type().element.members(f.self(), at, static_cast<std::uint32_t>(tile * kLanes), lanes,
                                 members->data()) != NETLOFT_OK)
      return false;
  }
  const EndsOfTile all{w.before.data(), w.after.data(), w.after.data()};
  double* kept = stretch_rates_[family].all().data() + tile * count * kLanes;
  for (std::size_t lane = 0; lane < lanes; ++lane)
    for (std::size_t k = 0; k < count; ++k) {
      const netloft_member &m = w.members_after[lane * count + k], &m0 = w.members_before[lane * count + k];
      const Chord chord(m, all, static_cast<std::size_t>(f.nodes_per_element()), lane);
      double& rate = kept[k * kLanes + lane];
      const bool bears = is_taut(m0, chord.l0) && is_taut(m, chord.l1);
      const double way = mean_of({m0, m, m}, chord.l0, chord.l1).way;
      rate = bears ? rate + memory * (way / ends.length - rate) : 0;  // (4)
    }
  return true;
}

}  // namespace netloft
