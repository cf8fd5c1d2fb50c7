// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/element.hpp>

namespace netloft::wrong {

struct Parameters {
  double EA = 0;
};
struct Data {
  double rest_length = 0;
};

/// The element of one term, on two nodes: every term gets an element, and thereby a table, of its own.
template <class Term>
struct On {
  static constexpr auto stencil = NETLOFT_BAR;
  using Parameters = wrong::Parameters;
  using Data = wrong::Data;
};

/// A correct bar; each wrong element has one flaw.
///   f = T w/l,  T = k (l - l0),  k = EA/l0                   (1)
///   A = k t tᵀ + g (I - t tᵀ),  g = T/l                      (2)
struct Spring {
  Spring(const Parameters& p, const Data& d, const State<2>& s)
      : w(s.x[1] - s.x[0]), l(std::max(norm(w), 1e-9 * d.rest_length)), k(p.EA / d.rest_length) {
    T = k * (norm(w) - d.rest_length);
    energy = 0.5 * T * (norm(w) - d.rest_length);
    geometric = T / l;
  }
  double stiffness(int r, int c) const {
    return (k - geometric) * w[r] * w[c] / (l * l) + (r == c ? geometric : 0);
  }
  Vec3<double> w;
  double l, k, T = 0, energy = 0, geometric = 0;
};

/// Adds −f to the force on the first node, and f to that on the second.
inline void pull(Local<2>& out, const Vec3<double>& f) {
  out.force[0] -= f;
  out.force[1] += f;
}

/// Adds `factor` times the blocks [ A -A; -A A ] to the tangent; A(r, c) returns an entry of A.
template <class Block>
void stiffen(Local<2>& out, double factor, Block&& A) {
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 6; ++c) out.tangent[r][c] += (r / 3 == c / 3 ? factor : -factor) * A(r % 3, c % 3);
}

inline Status evaluate_spring(const Parameters& p, const Data& d, const State<2>& s, Local<2>& out) {
  const Spring spring(p, d, s);
  out.energy = spring.energy;
  pull(out, spring.geometric * spring.w);
  stiffen(out, s.cu, [&](int r, int c) { return spring.stiffness(r, c); });
  return Status::ok;
}

/// Evaluates a linear law f = C w with a diagonal C: force and tangent with the diagonal `force`, but the
/// energy with the diagonal `energy`.
inline Status evaluate_diagonal(const State<2>& s, Local<2>& out, const double (&energy)[3],
                                const double (&force)[3]) {
  const Vec3<double> w = s.x[1] - s.x[0];
  for (int axis = 0; axis < 3; ++axis) out.energy += 0.5 * energy[axis] * w[axis] * w[axis];
  pull(out, {force[0] * w.x, force[1] * w.y, force[2] * w.z});
  stiffen(out, s.cu, [&](int r, int c) { return r == c ? force[r] : 0; });
  return Status::ok;
}

/// Computes a spring in every lane of a tile. `change(lane, local)` changes the result before it is added.
template <class E, class Change>
Status each_lane(const Family<E>& f, netloft_tile& t, bool packed, Change&& change) {
  for (std::size_t lane = 0; lane < t.count; ++lane) {
    Local<2> local;
    evaluate_spring(f.parameters(t.first + lane), f.data(t.first + lane), detail::gather<2>(t, lane), local);
    change(lane, local);
    detail::scatter(local, packed, lane, t);
  }
  return Status::ok;
}

inline void scale(Local<2>& local, double factor) {
  local.energy *= factor;
  for (auto& f : local.force) f = factor * f;
  for (auto& row : local.tangent)
    for (auto& entry : row) entry *= factor;
}

}  // namespace netloft::wrong
