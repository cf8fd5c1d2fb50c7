// SPDX-License-Identifier: BSD-3-Clause
//
// Forces of water and motion on bars: drag (3), damping (4) and inertia (5) of bars.hpp.
#pragma once
#include <netloft/law.hpp>

#include "plugins/common/bars.hpp"

namespace netloft::bars {

/// An entry of a tile's input; zero if the input is absent.
inline double entry(const double* field, int row, std::size_t lane) {
  return field ? field[at(row, lane)] : 0;
}

/// Index of (node p, axis r; node q, axis c) in a full tangent.
constexpr int place(int p, int r, int q, int c) { return 6 * (3 * p + r) + 3 * q + c; }

/// Fills in the arguments of a law of drag: W and t by (3) of bars.hpp, and the diameter.
inline void fill_flow(const Lanes& p, const Chords& chord, const netloft_tile& t, FlowLanes& flow) {
  const double *current = t.current, *v = t.v;
  const std::size_t count = t.count;
  for (int axis = 0; axis < 3; ++axis) {
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i)
      flow.flow[axis][i] = 0.5 * (entry(current, axis, i) + entry(current, axis + 3, i)) -
                           0.5 * (entry(v, axis, i) + entry(v, axis + 3, i));
    std::copy_n(chord.t[axis], count, flow.direction[axis]);
  }
  std::copy_n(p.diameter, count, flow.diameter);
  std::fill_n(flow.solidity, count, 0.0);
}

/// Computes row r of ½ ∂f/∂W (dc/dz)_q: how f changes if node q moves vertically in a current that varies
/// with depth.
inline void find_shear(const FlowLanes& f, const netloft_tile& t, int r, int q, double* shear) {
  std::fill_n(shear, t.count, 0.0);
  if (!t.current_dz) return;
  for (int c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < t.count; ++i)
      shear[i] += 0.5 * f.d_flow[3 * r + c][i] * t.current_dz[at(3 * q + c, i)];
}

/// Computes row r of ∂f/∂t (I − t tᵀ)/l, how the drag per metre f changes if the bar rotates.
inline void find_turn(const Chords& chord, const FlowLanes& f, std::size_t count, int r,
                      double (&turn)[3][kLanes]) {
  for (std::size_t i = 0; i < count; ++i) {
    double along = 0;  // (∂f/∂t t) of row r
    for (int c = 0; c < 3; ++c) along += f.d_direction[3 * r + c][i] * chord.t[c][i];
    for (int c = 0; c < 3; ++c)
      turn[c][i] = (f.d_direction[3 * r + c][i] - along * chord.t[c][i]) * chord.inverse[i];
  }
}

/// Adds −½ N l₀ ∂f to the rows of both nodes in the tangent, where ∂f is the derivative of the drag per metre
/// with respect to node q. cu and cv are the tile's factors on derivatives with respect to position and
/// velocity; ± is + for the second node:
///   ∂f = cu [½ ∂f/∂W (dc/dz)_q e_zᵀ ± ∂f/∂t (I − t tᵀ)/l] − cv ½ ∂f/∂W
inline void add_drag_tangent(const Lanes& p, const Chords& chord, const FlowLanes& f, netloft_tile& t) {
  const double cu = t.cu, cv = t.cv;
  const std::size_t count = t.count;
  double turn[3][kLanes], shear[kLanes];
  for (int r = 0; r < 3; ++r) {
    find_turn(chord, f, count, r, turn);
    for (int q = 0; q < 2; ++q) {
      find_shear(f, t, r, q, shear);
      for (int c = 0; c < 3; ++c) {
        const double *d_flow = f.d_flow[3 * r + c], sign = q ? 1 : -1, along_z = c == 2 ? 1 : 0;
        double *first = t.tangent + at(place(0, r, q, c), 0), *second = t.tangent + at(place(1, r, q, c), 0);
#pragma GCC ivdep
        for (std::size_t i = 0; i < count; ++i) {
          const double d =
              -0.5 * p.twine[i] * (cu * (sign * turn[c][i] + along_z * shear[i]) - cv * 0.5 * d_flow[i]);
          first[i] += d;
          second[i] += d;
        }
      }
    }
  }
}

inline Status add_drag(const Lanes& p, const netloft_bound_law& law, netloft_tile& t) {
  const Chords chord(t, p.l0);
  const std::size_t count = t.count;
  FlowLanes f;
  fill_flow(p, chord, t, f);
  f.call(law, t, t.tangent != nullptr, p.twine);
  if (t.force)
    for (int axis = 0; axis < 3; ++axis) {
      double *first = t.force + at(axis, 0), *second = t.force + at(axis + 3, 0);
#pragma GCC ivdep
      for (std::size_t i = 0; i < count; ++i) {
        const double half = 0.5 * p.twine[i] * f.force[axis][i];  // (3)
        first[i] -= half;
        second[i] -= half;
      }
    }
  if (t.tangent) add_drag_tangent(p, chord, f, t);
  return Status::ok;
}

/// Magnitude of (3) [N]; zero in still water.
inline void drag_of(const Lanes& p, const netloft_bound_law& law, const netloft_tile& t, double* values) {
  std::fill_n(values, t.count, 0.0);
  if (!law.evaluate) return;  // in still water, the part has no law
  const Chords chord(t, p.l0);
  FlowLanes f;
  fill_flow(p, chord, t, f);
  f.call(law, t, false, p.twine);
  for (std::size_t i = 0; i < t.count; ++i)
    values[i] = p.twine[i] * std::hypot(f.force[0][i], f.force[1][i], f.force[2][i]);
}

/// Angle between bar and flow, 0 to π/2 [rad]; zero in still water.
inline void angle_of(const Lanes& p, const netloft_tile& t, double* values) {
  const Chords chord(t, p.l0);
  FlowLanes f;
  fill_flow(p, chord, t, f);
  for (std::size_t i = 0; i < t.count; ++i) {
    const Vec3<double> W{f.flow[0][i], f.flow[1][i], f.flow[2][i]};
    const Vec3<double> s{chord.t[0][i], chord.t[1][i], chord.t[2][i]};
    values[i] = std::atan2(norm(cross(W, s)), std::abs(dot(W, s)));
  }
}

/// One damper for every bar. Its tension is c (dl/dt − g l), where g is the relative growth rate of the
/// unstretched length of the bar.
struct Dampers {
  double c[kLanes] = {}, slope[kLanes] = {};  // c and dc/dl
  double growth[kLanes] = {};                 // rate g [1/s]
};

/// Adds the dampers. With the chord w of a bar, its rate w' = dw/dt and y' = dl/dt − g l, the derivatives are
///  ∂(T_d t)/∂w = (c/l) [t (w' − (t·w') t)ᵀ + y' (I − t tᵀ)] + (dc/dl y' − c g) t tᵀ,  ∂(T_d t)/∂w' = c t tᵀ
inline void add_dampers(const Chords& chord, const Dampers& d, netloft_tile& t) {
  for (std::size_t i = 0; i < t.count; ++i) {
    const double damper = d.c[i], s[3] = {chord.t[0][i], chord.t[1][i], chord.t[2][i]};
    double w[3], along = 0;  // dl/dt
    for (int axis = 0; axis < 3; ++axis) {
      w[axis] = entry(t.v, axis + 3, i) - entry(t.v, axis, i);
      along += s[axis] * w[axis];
    }
    const double rate = along - d.growth[i] * chord.l[i];
    const double direct = t.cu * (d.slope[i] * rate - damper * d.growth[i]) + t.cv * damper;
    for (int r = 0; r < 3; ++r) {
      const double pull = damper * rate * s[r];
      if (t.force) {
        t.force[at(r, i)] -= pull;
        t.force[at(r + 3, i)] += pull;
      }
      if (!t.tangent) continue;
      for (int c = 0; c < 3; ++c) {
        const double turn = s[r] * (w[c] - along * s[c]) + rate * ((r == c ? 1 : 0) - s[r] * s[c]);
        const double a = damper * t.cu * chord.inverse[i] * turn + direct * s[r] * s[c];
        t.tangent[at(place(0, r, 0, c), i)] += a;
        t.tangent[at(place(1, r, 1, c), i)] += a;
        t.tangent[at(place(0, r, 1, c), i)] -= a;
        t.tangent[at(place(1, r, 0, c), i)] -= a;
      }
    }
  }
}

inline Status add_damping(const Lanes& p, netloft_tile& t) {
  Dampers d;
  for (std::size_t i = 0; i < t.count; ++i) d.c[i] = p.damping[i] / p.l0[i];  // (4)
  add_dampers(Chords(t, p.l0), d, t);
  return Status::ok;
}

/// Adds the damping (1) of loss.hpp, where the growth rate of the unstretched length is subtracted from
/// dl/dt: a rope that runs off a drum at constant strain loses no energy.
inline Status add_loss(const Lanes& p, const double* growth, netloft_tile& t) {
  const Chords chord(t, p.l0);
  Dampers d;
  for (std::size_t i = 0; i < t.count; ++i) {
    const axial::Damper one = axial::damper(p.loss[i], chord.l[i], p.l0[i]);
    d.c[i] = one.c;
    d.slope[i] = one.slope;
    if (growth) d.growth[i] = growth[i];
  }
  add_dampers(chord, d, t);
  return Status::ok;
}

/// Adds the inertia (5) of bars.hpp. Its derivative with respect to the chord w is
///   ∂r_p/∂w = −½ V C_a ρ_w [t (a_p − (t·a_p) t)ᵀ + (t·a_p)(I − t tᵀ)]/l
inline Status add_inertia(const Lanes& p, netloft_tile& t) {
  const Chords chord(t, p.l0);
  for (std::size_t i = 0; i < t.count; ++i) {
    const double half = 0.5 * p.volume[i], added = half * p.added_mass[i] * t.water_density;
    const double across = half * p.density[i] + added, s[3] = {chord.t[0][i], chord.t[1][i], chord.t[2][i]};
    for (int node = 0; node < 2; ++node) {
      double a[3], along = 0;
      for (int axis = 0; axis < 3; ++axis) {
        a[axis] = entry(t.a, 3 * node + axis, i);
        along += s[axis] * a[axis];
      }
      for (int r = 0; r < 3; ++r) {
        if (t.force) t.force[at(3 * node + r, i)] += across * a[r] - added * along * s[r];  // (5)
        if (!t.tangent) continue;
        for (int c = 0; c < 3; ++c) {
          const double one = r == c ? 1 : 0;
          const double turn =
              -added * chord.inverse[i] * (s[r] * (a[c] - along * s[c]) + along * (one - s[r] * s[c]));
          t.tangent[at(place(node, r, 0, c), i)] -= t.cu * turn;
          t.tangent[at(place(node, r, 1, c), i)] += t.cu * turn;
          t.tangent[at(place(node, r, node, c), i)] += t.ca * (across * one - added * s[r] * s[c]);
        }
      }
    }
  }
  return Status::ok;
}

/// Adds the force that the acceleration u′ [m/s²] of the water exerts. It is the inertia (5) of a bar made of
/// water, with the opposite sign:
///   r_p = −½ V [ρ_w (1 + C_a) u′ − C_a ρ_w (t·u′) t]                                                 (6)
/// Part of it is the pressure of the waves on the displaced volume (Froude and Krylov), which, like buoyancy,
/// acts along and across the bar; the terms with C_a are added mass, which acts across the bar.
inline Status add_waves(const Lanes& p, netloft_tile& t) {
  const double* acceleration = water_acceleration_of(t);
  if (!acceleration) return Status::ok;
  const Chords chord(t, p.l0);
  for (std::size_t i = 0; i < t.count; ++i) {
    const double half = 0.5 * p.volume[i] * t.water_density, added = half * p.added_mass[i];
    const double s[3] = {chord.t[0][i], chord.t[1][i], chord.t[2][i]};
    for (int node = 0; node < 2; ++node) {
      double a[3], along = 0;
      for (int axis = 0; axis < 3; ++axis) {
        a[axis] = acceleration[at(3 * node + axis, i)];
        along += s[axis] * a[axis];
      }
      for (int r = 0; r < 3; ++r) {
        if (t.force) t.force[at(3 * node + r, i)] -= (half + added) * a[r] - added * along * s[r];  // (6)
        if (!t.tangent) continue;
        for (int c = 0; c < 3; ++c) {
          const double turn = added * chord.inverse[i] *
                              (s[r] * (a[c] - along * s[c]) + along * ((r == c ? 1 : 0) - s[r] * s[c]));
          t.tangent[at(place(node, r, 0, c), i)] -= t.cu * turn;
          t.tangent[at(place(node, r, 1, c), i)] += t.cu * turn;
        }
      }
    }
  }
  return Status::ok;
}

}  // namespace netloft::bars
