// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/mean_of_energy.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <limits>

namespace netloft {

namespace {

/// A difference of two energies below this fraction of the energies counts as rounding error.
constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();

/// Subtracts the rigid-body motion of an element from `moves`, the displacements of its nodes. `moves` and
/// the positions x have three numbers per node.
void take_out_rigid_motion(const double* x, std::size_t nodes, double* moves) {
  using Nodes = Eigen::Matrix<double, 3, Eigen::Dynamic>;
  const Eigen::Map<const Nodes> places(x, 3, static_cast<Eigen::Index>(nodes));
  Eigen::Map<Nodes> all(moves, 3, static_cast<Eigen::Index>(nodes));
  const Eigen::Vector3d centre = places.rowwise().mean(), mean = all.rowwise().mean();
  all.colwise() -= mean;
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();
  for (Eigen::Index p = 0; p < places.cols(); ++p) {
    const Eigen::Vector3d r = places.col(p) - centre, move = all.col(p);
    inertia += r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose();
    turn += r.cross(move);
  }
  if (!(inertia.trace() > 0)) return;
  const Eigen::Vector3d omega = inertia.completeOrthogonalDecomposition().solve(turn);
  for (Eigen::Index p = 0; p < places.cols(); ++p) {
    const Eigen::Vector3d r = places.col(p) - centre;
    all.col(p) -= omega.cross(r);
  }
}

/// Quantities of (1) in mean_of_energy.hpp for a term of an element. If μ is zero, the force needs no
/// correction.
struct Lane {
  double way[12] = {}, force[12] = {}, later[12] = {}, g[12] = {};  // Δ, ∇E(x), ∇E(x₁), P Δ
  double work = 0, square = 0, mu = 0;                              // ∇E·Δ, g·g, μ
};

/// Whether all forces of a term are between nodes of its element, so that they have no resultant.
bool is_inner(const ElementFamily& f, const netloft_term& term) {
  return !(term.traits & NETLOFT_FROM_OUTSIDE) && !f.type().is_on_body() && f.type().globals.empty() &&
         f.type().dofs() > 3;
}

Lane read_lane(const ElementFamily& f, const netloft_term& term, std::size_t lane, const StepTile& step) {
  const auto dofs = static_cast<std::size_t>(f.type().dofs());
  Lane m;
  double middle[12];
  for (std::size_t d = 0; d < dofs; ++d) {
    const std::size_t i = d * kTileLanes + lane;
    m.way[d] = step.after[i] - step.before[i];
    middle[d] = 0.5 * (step.after[i] + step.before[i]);
    m.force[d] = step.forces[i];
    m.later[d] = step.forces[dofs * kTileLanes + i];
    m.g[d] = m.way[d];
    m.work += m.force[d] * m.way[d];
  }
  const double early = step.energies[lane], late = step.energies[kTileLanes + lane],
               missing = late - early - m.work;
  if (std::abs(missing) <= kRounding * (std::abs(early) + std::abs(late) + std::abs(m.work))) return m;
  if (is_inner(f, term)) take_out_rigid_motion(middle, dofs / 3, m.g);
  for (std::size_t d = 0; d < dofs; ++d) m.square += m.g[d] * m.g[d];
  if (m.square > 0) m.mu = missing / m.square;
  return m;
}

/// Adds the tangent (2) of mean_of_energy.hpp, without its first term K, which is already in the scratch
/// rows.
void add_slope_of_lane(const TileOfStep& of, const Lane& m, std::size_t lane) {
  const std::size_t dofs = of.dofs();
  double* slope = of.open_slope();
  const auto entry = [&](std::size_t r, std::size_t c) {
    double turned = 2 * (m.later[c] - m.force[c]);
    for (std::size_t k = 0; k < dofs; ++k)
      turned -= of.sums.scratch[(packed(std::max(k, c)) + std::min(k, c)) * kTileLanes + lane] * m.way[k];
    return of.tile.cu * (m.g[r] * (turned - 4 * m.mu * m.g[c]) / m.square + (r == c ? 2 * m.mu : 0));
  };
  for (std::size_t r = 0; r < dofs; ++r)
    for (std::size_t c = 0; c < dofs; ++c)
      if (!of.symmetric)
        slope[(r * dofs + c) * kTileLanes + lane] += entry(r, c);
      else if (c <= r)
        slope[(packed(r) + c) * kTileLanes + lane] += 0.5 * (entry(r, c) + entry(c, r));
}

/// Evaluates a term at positions x. Stores energy and force at index `which` of the step's arrays, and the
/// tangent in the scratch rows.
int call(const TileOfStep& of, const netloft_term& term, const double* x, std::size_t which,
         std::uint32_t want) {
  netloft_tile at = of.tile;
  at.x = x;
  at.x_low = nullptr;
  at.want = want;
  at.cu = 1;
  at.energy = want & NETLOFT_WANT_ENERGY ? &of.step.energies[which * kTileLanes] : nullptr;
  at.force = want & NETLOFT_WANT_FORCE ? &of.step.forces[which * of.dofs() * kTileLanes] : nullptr;
  at.tangent = want & NETLOFT_WANT_TANGENT ? of.sums.scratch.data() : nullptr;
  return of.family.evaluate(term, at);
}

}  // namespace

int add_mean_of_energy(const TileOfStep& of, const netloft_term& term) {
  StepTile& step = of.step;
  std::fill(step.energies.begin(), step.energies.end(), 0.0);
  std::fill(step.forces.begin(), step.forces.end(), 0.0);
  const bool has_slope = of.has_slope() && (term.traits & NETLOFT_SYMMETRIC);
  if (has_slope) std::fill_n(of.sums.scratch.begin(), packed(of.dofs()) * kTileLanes, 0.0);
  const std::uint32_t slope = has_slope ? std::uint32_t{NETLOFT_WANT_TANGENT} : 0u;
  for (const int status : {call(of, term, step.before.data(), 0, NETLOFT_WANT_ENERGY),
                           call(of, term, step.after.data(), 1, NETLOFT_WANT_ENERGY | NETLOFT_WANT_FORCE),
                           call(of, term, of.tile.x, 0, NETLOFT_WANT_FORCE | slope)})
    if (status != NETLOFT_OK) return status;
  for (std::size_t lane = 0; lane < of.tile.count; ++lane) {
    const Lane m = read_lane(of.family, term, lane, step);
    if (m.mu == 0) continue;
    double* force = of.open_force();
    for (std::size_t d = 0; force && d < of.dofs(); ++d)
      force[d * kTileLanes + lane] += m.mu * m.g[d];  // (1)
    if (has_slope) add_slope_of_lane(of, m, lane);
  }
  return NETLOFT_OK;
}

}  // namespace netloft
