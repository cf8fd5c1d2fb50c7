// SPDX-License-Identifier: BSD-3-Clause
//
// Adapts an element that is a flow (ext/flow.h) to the function that the host calls. Included by element.hpp.
// An element with shared unknowns is a flow if it has the two functions
//
//   template <class T> static Vec3<T> water(const Parameters&, const Vec3<T>& current,
//                                           const std::array<T, globals>& unknowns, double reach,
//                                           const Vec3<T>& normal);
//   template <class T> static Vec3<T> weight(const Parameters&, const Vec3<T>& current, double reach,
//                                            int unknown);
//
// `water` returns the velocity of the water at a place [m/s]; `normal` is the unit normal of the netting
// there, of either sign, and zero on ropes. `weight` returns the factor with which the residual of the drag
// at that place enters the equation of an unknown. Both are differentiated automatically.
#pragma once
#include <netloft/ext/flow.h>
#include <netloft/dual.hpp>
#include <netloft/element_calls.hpp>

namespace netloft::detail {

template <class E>
using FlowDual = Dual<6 + count_globals<E>(), 1>;

template <class E>
concept IsFlow = requires(const typename E::Parameters& p, const Vec3<FlowDual<E>>& current,
                          const std::array<FlowDual<E>, count_globals<E>()>& unknowns) {
  E::water(p, current, unknowns, 1.0, current);
  E::weight(p, current, 1.0, 0);
};

/// Writes the values of a vector.
template <class T>
void write_values(const Vec3<T>& vector, std::size_t lane, double* values) {
  for (int r = 0; r < 3; ++r) values[static_cast<std::size_t>(r) * kLanes + lane] = vector[r].value;
}

/// Writes the derivatives of a vector with respect to three consecutive variables. Row 3r + c has the
/// derivative of component r with respect to variable first + c.
template <class T>
void write_derivatives(const Vec3<T>& vector, std::size_t first, std::size_t lane, double* derivatives) {
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c)
      derivatives[(3 * r + c) * kLanes + lane] = vector[static_cast<int>(r)].gradient[first + c];
}

/// Writes the velocity of the water at one place, and the weights.
template <class E>
void write_flow_alone(const typename E::Parameters& p, const netloft_flow_tile& t, std::size_t lane) {
  constexpr std::size_t unknowns = count_globals<E>();
  Vec3<double> current, normal;
  std::array<double, unknowns> a;
  for (int axis = 0; axis < 3; ++axis) {
    current[axis] = t.current[static_cast<std::size_t>(axis) * kLanes + lane];
    normal[axis] = t.normal[static_cast<std::size_t>(axis) * kLanes + lane];
  }
  for (std::size_t k = 0; k < unknowns; ++k) a[k] = t.unknowns[k * kLanes + lane];
  const auto write = [lane](const Vec3<double>& vector, double* values) {
    for (int r = 0; r < 3; ++r) values[static_cast<std::size_t>(r) * kLanes + lane] = vector[r];
  };
  write(E::water(p, current, a, t.reach[lane], normal), t.velocity);
  for (std::size_t k = 0; k < unknowns; ++k)
    write(E::weight(p, current, t.reach[lane], static_cast<int>(k)), t.weight + 3 * k * kLanes);
}

/// Writes the velocity of the water at one place, the weights, and their derivatives.
template <class E>
void write_flow(const typename E::Parameters& p, const netloft_flow_tile& t, std::size_t lane) {
  using T = FlowDual<E>;
  constexpr std::size_t unknowns = count_globals<E>();
  constexpr std::size_t normals = 3 + unknowns;  // index of the first component of the normal
  Vec3<T> current, normal;
  std::array<T, unknowns> a;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t row = static_cast<std::size_t>(axis) * kLanes + lane;
    current[axis] = T::variable(t.current[row], axis);
    normal[axis] = T::variable(t.normal[row], static_cast<int>(normals) + axis);
  }
  for (std::size_t k = 0; k < unknowns; ++k)
    a[k] = T::variable(t.unknowns[k * kLanes + lane], static_cast<int>(3 + k));
  const Vec3<T> water = E::water(p, current, a, t.reach[lane], normal);
  write_values(water, lane, t.velocity);
  write_derivatives(water, 0, lane, t.d_current);
  write_derivatives(water, normals, lane, t.d_normal);
  for (std::size_t k = 0; k < unknowns; ++k) {
    for (int r = 0; r < 3; ++r)
      t.d_unknown[(3 * k + static_cast<std::size_t>(r)) * kLanes + lane] = water[r].gradient[3 + k];
    const Vec3<T> weight = E::weight(p, current, t.reach[lane], static_cast<int>(k));
    write_values(weight, lane, t.weight + 3 * k * kLanes);
    write_derivatives(weight, 0, lane, t.d_weight + 9 * k * kLanes);
  }
}

template <class E>
int evaluate_flow(const void* self, netloft_flow_tile* t) noexcept {
  return guarded(nullptr, 0, [&] {
    const auto& p = static_cast<const Family<E>*>(self)->parameters_[t->part];
    for (std::size_t lane = 0; lane < t->count; ++lane)
      t->d_current ? write_flow<E>(p, *t, lane) : write_flow_alone<E>(p, *t, lane);
    return NETLOFT_OK;
  });
}

}  // namespace netloft::detail
