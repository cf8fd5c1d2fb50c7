// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/element.hpp>

#include <algorithm>
#include <cmath>

namespace netloft::surface {

/// Drag and buoyancy that twines and ropes lose above the surface of the water. Each node of an element is
/// modelled as a cube of side h; the part of the cube below the surface is wet:
///   h³ = V/N,  w = clamp((h/2 − (z − η))/h, 0, 1)    wet fraction    (1)
///   r_p = −σ (1 − w_p) r_p^drag                drag                (2)
///   r_p = σ (1 − w_p) (V/N) ρ_w g e_z          buoyancy of bars    (3)
/// V [m³] is the volume of the twines or rope of the element, N its number of nodes, r^drag the residual of
/// its drag under water, σ [1] a factor on both losses (0 in water without a surface), η [m] the height of
/// the surface above z = 0 in waves. Source: partial immersion of bars and netting in FEMNET (D. Priour),
/// where netting keeps its weight in water.
struct Cube {
  double side;  // side h of the cube [m]
  double dry(double z) const { return side > 0 ? std::clamp(0.5 + z / side, 0.0, 1.0) : 0; }
  /// Derivative of the dry fraction 1 − w with respect to z [1/m].
  double slope(double z) const { return 2 * std::abs(z) < side ? 1 / side : 0; }
  /// Integral of the dry fraction 1 − w over the height, from below up to z [m].
  double dry_height(double z) const {
    const double emerged = std::clamp(z + 0.5 * side, 0.0, side);
    return side > 0 ? 0.5 * emerged * emerged / side + std::max(z - 0.5 * side, 0.0) : 0;
  }
};

constexpr std::size_t at(int row, std::size_t lane) { return static_cast<std::size_t>(row) * kLanes + lane; }

/// Height of a node over the surface.
inline double above_surface(const netloft_tile& t, int node, std::size_t i) {
  const double* surface = surface_of(t);
  return t.x[at(3 * node + 2, i)] - (surface ? surface[at(node, i)] : 0);
}

/// Whether a node loses no drag and no buoyancy, because its cube is under water or σ is 0. `Lanes` has
/// volume and surface.
template <int N, class Lanes>
bool is_wet(const Lanes& p, const netloft_tile& t, int node, std::size_t i) {
  const double z = above_surface(t, node, i);
  return p.surface[i] == 0 || (!(z > 0) && !(8 * -z * z * z < p.volume[i] / N));
}

/// Whether all nodes of a tile are under water. The losses (2) and (3) are then zero, as in most tiles.
template <int N, class Lanes>
bool is_wet(const Lanes& p, const netloft_tile& t) {
  for (int node = 0; node < N; ++node)
    for (std::size_t i = 0; i < t.count; ++i)
      if (!is_wet<N>(p, t, node, i)) return false;
  return true;
}

/// The drag of a tile of elements with N nodes, computed as if all nodes were under water; `take_from`
/// removes it from dry nodes.
template <int N>
struct Drag {
  static constexpr int dofs = 3 * N;
  double force[dofs * kLanes] = {}, tangent[dofs * dofs * kLanes] = {};

  /// Returns a copy of the tile whose results go into the arrays of this object.
  netloft_tile answer_of(const netloft_tile& t) {
    netloft_tile inner = t;
    inner.energy = nullptr;
    inner.force = force;
    inner.tangent = t.tangent ? tangent : nullptr;
    return inner;
  }
  /// Adds the lost drag (2) for a node. `dry` is σ (1 − w), `slope` its derivative with respect to z.
  void take_from(netloft_tile& t, int node, std::size_t lane, double dry, double slope) const {
    for (int axis = 0; axis < 3; ++axis) {
      const int row = 3 * node + axis;
      if (t.force) t.force[at(row, lane)] -= dry * force[at(row, lane)];
      if (!t.tangent) continue;
      for (int c = 0; c < dofs; ++c)
        t.tangent[at(dofs * row + c, lane)] -= dry * tangent[at(dofs * row + c, lane)];
      t.tangent[at(dofs * row + 3 * node + 2, lane)] -= t.cu * slope * force[at(row, lane)];
    }
  }
};

/// Adds the lost drag (2). `drag_of(tile)` adds the drag of the elements as if they were under water.
template <int N, class Lanes, class UnderWater>
Status take_dry_drag(const Lanes& p, netloft_tile& t, UnderWater&& drag_of) {
  if (is_wet<N>(p, t)) return Status::ok;
  Drag<N> drag;
  netloft_tile inner = drag.answer_of(t);
  drag_of(inner);
  for (int node = 0; node < N; ++node)
    for (std::size_t i = 0; i < t.count; ++i) {
      if (is_wet<N>(p, t, node, i)) continue;
      const Cube cube{std::cbrt(p.volume[i] / N)};
      const double z = above_surface(t, node, i), share = p.surface[i];
      drag.take_from(t, node, i, share * cube.dry(z), share * cube.slope(z));
    }
  return Status::ok;
}

/// Adds the lost buoyancy (3) of bars.
template <class Lanes>
Status take_dry_buoyancy(const Lanes& p, netloft_tile& t) {
  if (is_wet<2>(p, t)) return Status::ok;
  for (int node = 0; node < 2; ++node)
    for (std::size_t i = 0; i < t.count; ++i) {
      if (is_wet<2>(p, t, node, i)) continue;
      const Cube cube{std::cbrt(0.5 * p.volume[i])};
      const int row = 3 * node + 2;
      const double z = above_surface(t, node, i),
                   lift = 0.5 * p.surface[i] * p.volume[i] * t.water_density * t.gravity;
      if (t.energy) t.energy[i] += lift * cube.dry_height(z);
      if (t.force) t.force[at(row, i)] += lift * cube.dry(z);
      if (t.tangent) t.tangent[at(row * (row + 1) / 2 + row, i)] += t.cu * lift * cube.slope(z);
    }
  return Status::ok;
}

}  // namespace netloft::surface
