// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/priour/drag.hpp"

#include "plugins/priour/slowed.hpp"

#include "plugins/common/surface.hpp"

#include <netloft/law.hpp>

namespace netloft::priour {

namespace {

/// The force F of the water on every element, its derivatives with respect to the flow W (`flow`), and with
/// respect to the position of each corner (`x`), neglecting the shear of the current. The first contribution
/// sets these numbers, later ones add to them.
struct Force {
  double F[3][kLanes], flow[9][kLanes], x[3][9][kLanes];
};

enum class Turn { first, later };

template <Turn turn>
void put(double& to, double number) {
  to = turn == Turn::first ? number : to + number;
}

/// Fills in the relative velocity W, reduced by `slowed`, and the diameter. Laws of twines and of screens
/// both need them.
void fill_flow(const Triangle::Lanes& p, const netloft_tile& t, const Slowing* slowed, FlowLanes& f) {
  const double *current = t.current, *v = t.v;
  const std::size_t count = t.count;
  for (int axis = 0; axis < 3; ++axis)  // (1)
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i)
      f.flow[axis][i] = mean_of_corners(current, axis, i) - mean_of_corners(v, axis, i);
  std::copy_n(p.diameter, count, f.diameter);
  for (int axis = 0; axis < 3 && slowed && current; ++axis)
    for (std::size_t i = 0; i < count; ++i)
      f.flow[axis][i] += (slowed->left[i] - 1) * mean_of_corners(current, axis, i);
}

/// Adds `factor` times the force and the flow derivative of a law.
template <Turn turn>
void add_law(const FlowLanes& f, const double* factor, const netloft_tile& t, Force& out) {
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t i = 0; i < t.count; ++i) put<turn>(out.F[r][i], factor[i] * f.force[r][i]);
  if (!t.tangent) return;
  for (std::size_t k = 0; k < 9; ++k)
    for (std::size_t i = 0; i < t.count; ++i) put<turn>(out.flow[k][i], factor[i] * f.d_flow[k][i]);
}

/// Computes F by (2) and its derivatives by (3) of drag.hpp, for the twines of one direction; `c` is a or b
/// of triangle.hpp.
template <Turn turn>
void add_twines(const netloft_bound_law& law, const Triangle::Lanes& p, const double (&c)[3][kLanes],
                const netloft_tile& t, FlowLanes& f, Force& out) {
  const Twines twines(t, c, p.l0);
  double length[kLanes];
  for (std::size_t i = 0; i < t.count; ++i) {
    for (int axis = 0; axis < 3; ++axis) f.direction[axis][i] = twines.t[axis][i];
    f.solidity[i] = 0;
    length[i] = p.bars[i] * p.l0[i];
  }
  f.call(law, t, t.tangent != nullptr, length);
  add_law<turn>(f, length, t, out);
  if (!t.tangent) return;
  for (int r = 0; r < 3; ++r)
    for (std::size_t i = 0; i < t.count; ++i) {
      const double k = length[i] * twines.inverse[i];
      double along = 0;  // component along Û of row r of the derivative
      for (int a = 0; a < 3; ++a) along += f.d_direction[3 * r + a][i] * twines.t[a][i];
      for (int a = 0; a < 3; ++a) {
        const double across = k * (f.d_direction[3 * r + a][i] - along * twines.t[a][i]);
        for (int q = 0; q < 3; ++q) put<turn>(out.x[q][3 * r + a][i], c[q][i] * across);
      }
    }
}

Vec3<double> corner(const netloft_tile& t, int q, std::size_t i) {
  return {t.x[at(3 * q, i)], t.x[at(3 * q + 1, i)], t.x[at(3 * q + 2, i)]};
}

/// Computes by (4) of drag.hpp the area of every triangle and, in `f`, its normal and solidity.
void fill_screen(const Triangle::Lanes& p, const netloft_tile& t, double* area, FlowLanes& f) {
  for (std::size_t i = 0; i < t.count; ++i) {
    const Vec3<double> o = corner(t, 0, i), N = cross(corner(t, 1, i) - o, corner(t, 2, i) - o);
    area[i] = std::max(0.5 * norm(N), Drag::kNoArea * 2 * p.bars[i] * p.l0[i] * p.l0[i]);
    for (int axis = 0; axis < 3; ++axis) f.direction[axis][i] = N[axis] / (2 * area[i]);
    f.solidity[i] = 2 * p.bars[i] * p.diameter[i] * p.l0[i] / area[i];
  }
}

/// Computes ∂F/∂x by (6) and (7) of drag.hpp, without the shear of the current.
void set_screen_tangent(const netloft_tile& t, const FlowLanes& f, Force& out) {
  for (std::size_t i = 0; i < t.count; ++i) {
    const Vec3<double> m{f.direction[0][i], f.direction[1][i], f.direction[2][i]};
    for (int r = 0; r < 3; ++r) {
      const Vec3<double> f_m{f.d_direction[3 * r][i], f.d_direction[3 * r + 1][i],
                             f.d_direction[3 * r + 2][i]};
      const double scale = f.force[r][i] - f.solidity[i] * f.d_solidity[r][i] - dot(f_m, m);
      const Vec3<double> G = 0.5 * (scale * m + f_m);
      for (int q = 0; q < 3; ++q) {
        const Vec3<double> row = cross(G, corner(t, (q + 2) % 3, i) - corner(t, (q + 1) % 3, i));
        for (int a = 0; a < 3; ++a) out.x[q][3 * r + a][i] = row[a];
      }
    }
  }
}

void set_screen(const netloft_bound_law& law, const Triangle::Lanes& p, const netloft_tile& t, FlowLanes& f,
                Force& out) {
  double area[kLanes];
  fill_screen(p, t, area, f);
  f.call(law, t, t.tangent != nullptr, area);
  add_law<Turn::first>(f, area, t, out);  // (5)
  if (t.tangent) set_screen_tangent(t, f, out);
}

void compute(const Family<Triangle>& family, const netloft_tile& t, const Slowing* slowed, Force& out) {
  const Triangle::Lanes& p = family.lanes(t);
  const netloft_bound_law& law = family.law(0);
  FlowLanes f;
  fill_flow(p, t, slowed, f);
  if (law.kind == NETLOFT_SCREEN_LAW) return set_screen(law, p, t, f, out);
  add_twines<Turn::first>(law, p, p.a, t, f, out);
  add_twines<Turn::later>(law, p, p.b, t, f, out);
}

/// Computes entry (r, axis) of ⅓ F_W ∂c/∂x_q for corner q, where c is the velocity of the water at the
/// triangle and F_W the derivative of the force with respect to the flow.
void find_shear(const Force& F, const netloft_tile& t, const Slowing* slowed, int r, int q, int axis,
                double* shear) {
  std::fill_n(shear, t.count, 0.0);
  for (int a = 0; a < 3; ++a) {
    const double* flow = F.flow[3 * r + a];
    if (t.current_dz && axis == 2)
      for (std::size_t i = 0; i < t.count; ++i)
        shear[i] += (slowed ? slowed->left[i] : 1) * flow[i] * t.current_dz[at(3 * q + a, i)] / 3;
    if (slowed && t.current && axis < 2)
      for (std::size_t i = 0; i < t.count; ++i)
        shear[i] += flow[i] * mean_of_corners(t.current, a, i) * (axis == 0 ? slowed->x : slowed->y)[i] / 3;
  }
}

/// Computes entry (r, c) of ∂F/∂x for corner q of every element, with the factors cu and cv of the tile.
void find_slope(const Force& F, const Slowing* slowed, const netloft_tile& t, int r, int q, int c,
                double* slope) {
  double shear[kLanes] = {};
  if (c == 2 || slowed) find_shear(F, t, slowed, r, q, c, shear);
  const double *x = F.x[q][3 * r + c], *flow = F.flow[3 * r + c];
  for (std::size_t i = 0; i < t.count; ++i) slope[i] = t.cu * (x[i] + shear[i]) - t.cv * flow[i] / 3;
}

/// Adds the tangent. Its rows are the same for all three corners.
void add_tangent(const Force& F, netloft_tile& t) {
  const double third = -1.0 / 3, cu = t.cu, cv = t.cv;
  const std::size_t count = t.count;
  double shear[kLanes] = {};
  for (int r = 0; r < 3; ++r)
    for (int q = 0; q < 3; ++q)
      for (int c = 0; c < 3; ++c) {
        const bool is_sheared = c == 2;
        if (is_sheared) find_shear(F, t, nullptr, r, q, c, shear);
        const double *x = F.x[q][3 * r + c], *flow = F.flow[3 * r + c], counts = is_sheared ? 1 : 0;
        double* row[3];
        for (int p = 0; p < 3; ++p) row[p] = t.tangent + at(place(p, r, q, c), 0);
#pragma GCC ivdep
        for (std::size_t i = 0; i < count; ++i) {
          const double k = third * (cu * (x[i] + counts * shear[i]) - cv * flow[i] / 3);
          row[0][i] += k;
          row[1][i] += k;
          row[2][i] += k;
        }
      }
}

/// Adds the tangent in slowed water minus the tangent in undisturbed water. The difference is computed first,
/// because rounding errors would be larger if the two tangents were added and subtracted one by one.
void add_change_of_tangent(const Force& in_slowed, const Slowing& slowed, const Force& in_all,
                           netloft_tile& t) {
  double with[kLanes] = {}, without[kLanes] = {};
  for (int r = 0; r < 3; ++r)
    for (int q = 0; q < 3; ++q)
      for (int c = 0; c < 3; ++c) {
        find_slope(in_slowed, &slowed, t, r, q, c, with);
        find_slope(in_all, nullptr, t, r, q, c, without);
        for (int p = 0; p < 3; ++p)
          for (std::size_t i = 0; i < t.count; ++i)
            t.tangent[at(place(p, r, q, c), i)] -= (with[i] - without[i]) / 3;
      }
}

void add(const Family<Triangle>& family, netloft_tile& t) {
  Force F;
  compute(family, t, nullptr, F);
  if (t.force)
    for (int axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < t.count; ++i) {
        const double third = F.F[axis][i] / 3;
        for (int p = 0; p < 3; ++p) t.force[at(3 * p + axis, i)] -= third;
      }
  if (t.tangent) add_tangent(F, t);
}

}  // namespace

Status Drag::tile(const Family<Triangle>& family, netloft_tile& t) {
  add(family, t);
  return Status::ok;
}

Status SlowedDrag::tile(const Family<Triangle>& family, netloft_tile& t) {
  const Slowing slowed(family.lanes(t), t, family.law(0).kind);
  if (!slowed.acts) return Status::ok;
  Force with, without;
  compute(family, t, &slowed, with);
  compute(family, t, nullptr, without);
  if (t.force)
    for (int axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < t.count; ++i)
        for (int p = 0; p < 3; ++p)
          t.force[at(3 * p + axis, i)] -= (with.F[axis][i] - without.F[axis][i]) / 3;
  if (t.tangent) add_change_of_tangent(with, slowed, without, t);
  return Status::ok;
}

Status DryDrag::tile(const Family<Triangle>& family, netloft_tile& t) {
  return surface::take_dry_drag<3>(family.lanes(t), t, [&](netloft_tile& in) { Drag::tile(family, in); });
}

void Drag::output(const Family<Triangle>& family, const netloft_tile& t, double* values) {
  std::fill_n(values, t.count, 0.0);
  if (!family.law(0).evaluate) return;  // in still water, a part has no law
  const Slowing slowed(family.lanes(t), t, family.law(0).kind);
  Force F;
  compute(family, t, slowed.acts ? &slowed : nullptr, F);
  for (std::size_t i = 0; i < t.count; ++i) values[i] = std::hypot(F.F[0][i], F.F[1][i], F.F[2][i]);
}

}  // namespace netloft::priour
