// SPDX-License-Identifier: BSD-3-Clause
#include "tests/validation/real_gears/plugin/surface.hpp"

#include "plugins/common/bars_in_water.hpp"
#include "plugins/priour/drag.hpp"

namespace netloft::femnet {

namespace {

using surface::at;

/// Elements of N nodes in a tile: their cubes, and the shipped drag on them.
template <int N>
struct Drag {
  static constexpr int dofs = 3 * N;
  double force[dofs * kLanes] = {}, tangent[dofs * dofs * kLanes] = {};

  /// A tile with which the shipped drag writes its result into this object.
  netloft_tile answer_of(const netloft_tile& t) {
    netloft_tile inner = t;
    inner.energy = nullptr, inner.force = force, inner.tangent = t.tangent ? tangent : nullptr;
    return inner;
  }
  void take_from(netloft_tile& t, int node, std::size_t lane, const Cube& cube) const {  // (2)
    const double z = t.x[at(3 * node + 2, lane)], dry = cube.dry(z);
    for (int axis = 0; axis < 3; ++axis) {
      const int row = 3 * node + axis;
      if (t.force) t.force[at(row, lane)] -= dry * force[at(row, lane)];
      if (!t.tangent) continue;
      for (int c = 0; c < dofs; ++c) {
        const int entry = dofs * row + c;
        t.tangent[at(entry, lane)] -= dry * tangent[at(entry, lane)];
      }
      const int own_z = dofs * row + 3 * node + 2;
      t.tangent[at(own_z, lane)] -= t.cu * cube.slope(z) * force[at(row, lane)];
    }
  }
};

template <int N>
Cube cube_of(double volume) {
  return {std::cbrt(volume / N)};
}

/// Whether the cube of a node is under water.
template <int N, class Lanes>
bool is_wet(const Lanes& p, const netloft_tile& t, int node, std::size_t i) {
  const double z = t.x[at(3 * node + 2, i)];
  return !(z > 0) && !(8 * -z * z * z < p.volume[i] / N);
}

/// Most tiles are completely under water; for them, nothing else is computed.
template <int N, class Lanes>
bool is_wet(const Lanes& p, const netloft_tile& t) {
  for (int node = 0; node < N; ++node)
    for (std::size_t i = 0; i < t.count; ++i)
      if (!is_wet<N>(p, t, node, i)) return false;
  return true;
}

template <int N, class Lanes, class Shipped>
Status take_dry_drag(const Lanes& p, netloft_tile& t, Shipped&& shipped) {
  if (is_wet<N>(p, t)) return Status::ok;
  Drag<N> drag;
  netloft_tile inner = drag.answer_of(t);
  shipped(inner);
  for (int node = 0; node < N; ++node)
    for (std::size_t i = 0; i < t.count; ++i)
      if (!is_wet<N>(p, t, node, i)) drag.take_from(t, node, i, cube_of<N>(p.volume[i]));
  return Status::ok;
}

}  // namespace

Status DryNettingDrag::tile(const Family<priour::Triangle>& family, netloft_tile& t) {
  return take_dry_drag<3>(family.lanes(t), t, [&](netloft_tile& in) { priour::Drag::tile(family, in); });
}

Status DryBarDrag::tile(const Family<rope::Bar>& family, netloft_tile& t) {
  return take_dry_drag<2>(family.lanes(t), t, [&](netloft_tile& in) { rope::Bar::Drag::tile(family, in); });
}

Status DryBarBuoyancy::tile(const Family<rope::Bar>& family, netloft_tile& t) {
  const auto& p = family.lanes(t);
  if (is_wet<2>(p, t)) return Status::ok;
  for (int node = 0; node < 2; ++node)
    for (std::size_t i = 0; i < t.count; ++i) {
      if (is_wet<2>(p, t, node, i)) continue;
      const Cube cube = cube_of<2>(p.volume[i]);
      const int row = 3 * node + 2;
      const double z = t.x[at(row, i)], lift = 0.5 * p.volume[i] * t.water_density * t.gravity;
      if (t.energy) t.energy[i] += lift * cube.dry_height(z);
      if (t.force) t.force[at(row, i)] += lift * cube.dry(z);  // (3)
      if (t.tangent) t.tangent[at(row * (row + 1) / 2 + row, i)] += t.cu * lift * cube.slope(z);
    }
  return Status::ok;
}

}  // namespace netloft::femnet
