// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/priour/netting_motion.hpp"

#include "plugins/common/loss.hpp"

namespace netloft::priour {

namespace {

Vec3<double> unit(const Twines& w, std::size_t i) { return {w.t[0][i], w.t[1][i], w.t[2][i]}; }

/// Entry (r, c) of t (y − (t·y) t)ᵀ + (t·y)(I − t tᵀ), with `along` = t·y. For t = w/‖w‖, this is ‖w‖ times
/// the derivative of (t·y) t with respect to w.
double turning(const Vec3<double>& t, const Vec3<double>& y, double along, int r, int c) {
  return t[r] * (y[c] - along * t[c]) + along * ((r == c ? 1 : 0) - t[r] * t[c]);
}

/// Adds the damping of the twines of one direction. `damper(lane, 1/length)` returns the damping coefficient
/// of one twine and its slope.
template <class DamperOf>
void damp(const Triangle::Lanes& p, const double (&c)[3][kLanes], const DamperOf& damper, netloft_tile& t) {
  const Twines twines(t, c, p.l0);
  for (std::size_t i = 0; i < t.count; ++i) {
    const axial::Damper one = damper(i, twines.inverse[i]);
    const double eta = p.bars[i] * one.c, slope = p.bars[i] * one.slope;
    const Vec3<double> s = unit(twines, i);
    Vec3<double> rate;  // rate U′ of U
    for (int q = 0; q < 3; ++q)
      for (int axis = 0; axis < 3; ++axis) rate[axis] += c[q][i] * entry(t.v, 3 * q + axis, i);
    const double along = dot(s, rate);
    for (int corner = 0; corner < 3 && t.force; ++corner)
      for (int r = 0; r < 3; ++r) t.force[at(3 * corner + r, i)] += c[corner][i] * eta * along * s[r];  // (1)
    if (!t.tangent) continue;
    for (int r = 0; r < 3; ++r)
      for (int k = 0; k < 3; ++k) {
        const double turned = twines.inverse[i] * turning(s, rate, along, r, k);
        const double A =
            eta * (t.cu * turned + t.cv * s[r] * s[k]) + t.cu * slope * along * s[r] * s[k];  // (2), (7)
        for (int m = 0; m < 3; ++m)
          for (int q = 0; q < 3; ++q) t.tangent[at(place(m, r, q, k), i)] += c[m][i] * c[q][i] * A;
      }
  }
}

/// Accelerations of all nodes, or of the water at the nodes, and the density of the accelerated mass.
struct Accelerated {
  const double* a;
  double sign, ca;        // factor of the residual; of its derivative with respect to a
  const double* density;  // nullptr: density of the water
};

/// The masses of a corner of every element: `across` is the mass and added mass for motion across the twines,
/// `added` the added mass alone.
struct Inert {
  double across[kLanes], added[kLanes];

  Inert(const Triangle::Lanes& p, const Accelerated& by, const netloft_tile& t) {
    for (std::size_t i = 0; i < t.count; ++i) {
      const double third = by.sign * p.volume[i] / 6;
      added[i] = third * p.added_mass[i] * t.water_density;
      across[i] = third * (by.density ? by.density[i] : t.water_density) + added[i];
    }
  }
};

/// The acceleration of corner m of every element, and its component along the twines.
struct OfCorner {
  double y[3][kLanes], along[kLanes];

  OfCorner(const Twines& w, const double* a, int m, std::size_t lanes) {
    for (int axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < lanes; ++i) y[axis][i] = entry(a, 3 * m + axis, i);
    for (std::size_t i = 0; i < lanes; ++i) along[i] = dot(unit(w, i), at_lane(i));
  }
  Vec3<double> at_lane(std::size_t i) const { return {y[0][i], y[1][i], y[2][i]}; }
};

/// Adds the derivatives of row r of corner m: (4) of netting_motion.hpp for accelerations, and (5) for
/// positions.
void add_slopes(const Twines& w, const Inert& of, const OfCorner& a, const double (&c)[3][kLanes],
                const Accelerated& by, int m, int r, netloft_tile& t) {
  double turned[kLanes];
  for (int k = 0; k < 3; ++k) {
    double* __restrict own = t.tangent + at(place(m, r, m, k), 0);
    for (std::size_t i = 0; i < t.count; ++i)
      own[i] += by.ca * ((r == k ? of.across[i] : 0) - of.added[i] * w.t[r][i] * w.t[k][i]);  // (4)
    if (t.cu == 0) continue;
    for (std::size_t i = 0; i < t.count; ++i)
      turned[i] =
          -t.cu * of.added[i] * w.inverse[i] * turning(unit(w, i), a.at_lane(i), a.along[i], r, k);  // (5)
    for (int q = 0; q < 3; ++q) {
      double* __restrict to = t.tangent + at(place(m, r, q, k), 0);
      for (std::size_t i = 0; i < t.count; ++i) to[i] += c[q][i] * turned[i];
    }
  }
}

/// Adds inertia, (3) of netting_motion.hpp, or the force (6) of waves, for the twines of one direction.
void accelerate(const Triangle::Lanes& p, const double (&c)[3][kLanes], const Accelerated& by,
                netloft_tile& t) {
  const Twines w(t, c, p.l0);
  const Inert of(p, by, t);
  for (int m = 0; m < 3; ++m) {
    const OfCorner a(w, by.a, m, t.count);
    for (int r = 0; r < 3; ++r) {
      for (std::size_t i = 0; i < t.count && t.force; ++i)
        t.force[at(3 * m + r, i)] +=
            of.across[i] * a.y[r][i] - of.added[i] * a.along[i] * w.t[r][i];  // (3), (6)
      if (t.tangent) add_slopes(w, of, a, c, by, m, r, t);
    }
  }
}

}  // namespace

Status Damping::tile(const Family<Triangle>& family, netloft_tile& t) {
  const Triangle::Lanes& p = family.lanes(t);
  const auto damper = [&](std::size_t i, double) { return axial::Damper{p.damping[i] / p.l0[i], 0}; };
  damp(p, p.a, damper, t);
  damp(p, p.b, damper, t);
  return Status::ok;
}

Status Loss::tile(const Family<Triangle>& family, netloft_tile& t) {
  const Triangle::Lanes& p = family.lanes(t);
  const auto damper = [&](std::size_t i, double inverse) {
    return axial::damper(p.loss[i], 1 / inverse, p.l0[i]);
  };
  damp(p, p.a, damper, t);
  damp(p, p.b, damper, t);
  return Status::ok;
}

Status Inertia::tile(const Family<Triangle>& family, netloft_tile& t) {
  const Triangle::Lanes& p = family.lanes(t);
  const Accelerated nodes{t.a, 1, t.ca, p.density};
  accelerate(p, p.a, nodes, t);
  accelerate(p, p.b, nodes, t);
  return Status::ok;
}

Status Waves::tile(const Family<Triangle>& family, netloft_tile& t) {
  const double* acceleration = water_acceleration_of(t);
  if (!acceleration) return Status::ok;
  const Triangle::Lanes& p = family.lanes(t);
  const Accelerated water{acceleration, -1, 0, nullptr};
  accelerate(p, p.a, water, t);
  accelerate(p, p.b, water, t);
  return Status::ok;
}

}  // namespace netloft::priour
