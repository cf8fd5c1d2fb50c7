// SPDX-License-Identifier: BSD-3-Clause
//
// Adapts an element that is a flow (ext/flow.h) to the function that the host calls. Included by element.hpp.
// An element with shared unknowns is a flow if it has the two functions
//
//   template <class T> static Vec3<T> water(const Parameters&, const Vec3<T>& current,
//                                           const std::array<T, globals>& unknowns, double reach);
//   template <class T> static Vec3<T> weight(const Parameters&, const Vec3<T>& current, double reach,
//                                            int unknown);
//
// `water` returns the velocity of the water at a place [m/s]. `weight` returns the factor with which the
// residual of the drag at that place enters the equation of an unknown. Both are differentiated
// automatically.
#pragma once
#include <netloft/ext/flow.h>
#include <netloft/dual.hpp>
#include <netloft/element_calls.hpp>

namespace netloft::detail {

template <class E>
using FlowDual = Dual<3 + count_globals<E>(), 1>;

template <class E>
concept IsFlow = requires(const typename E::Parameters& p, const Vec3<FlowDual<E>>& current,
                          const std::array<FlowDual<E>, count_globals<E>()>& unknowns) {
  E::water(p, current, unknowns, 1.0);
  E::weight(p, current, 1.0, 0);
};

/// Writes a vector and its derivatives. Row 3r + c has the derivative of component r with respect to
/// component c of the current.
template <class T>
void write_vector(const Vec3<T>& vector, std::size_t lane, double* values, double* derivatives) {
  for (std::size_t r = 0; r < 3; ++r) {
    values[r * kLanes + lane] = vector[static_cast<int>(r)].value;
    for (std::size_t c = 0; c < 3; ++c)
      derivatives[(3 * r + c) * kLanes + lane] = vector[static_cast<int>(r)].gradient[c];
  }
}

/// Writes the velocity of the water at one place, the weights, and their derivatives.
template <class E>
void write_flow(const typename E::Parameters& p, const netloft_flow_tile& t, std::size_t lane) {
  using T = FlowDual<E>;
  constexpr std::size_t unknowns = count_globals<E>();
  Vec3<T> current;
  std::array<T, unknowns> a;
  for (int axis = 0; axis < 3; ++axis)
    current[axis] = T::variable(t.current[static_cast<std::size_t>(axis) * kLanes + lane], axis);
  for (std::size_t k = 0; k < unknowns; ++k)
    a[k] = T::variable(t.unknowns[k * kLanes + lane], static_cast<int>(3 + k));
  const Vec3<T> water = E::water(p, current, a, t.reach[lane]);
  write_vector(water, lane, t.velocity, t.d_current);
  for (std::size_t k = 0; k < unknowns; ++k) {
    for (int r = 0; r < 3; ++r)
      t.d_unknown[(3 * k + static_cast<std::size_t>(r)) * kLanes + lane] = water[r].gradient[3 + k];
    const Vec3<T> weight = E::weight(p, current, t.reach[lane], static_cast<int>(k));
    write_vector(weight, lane, t.weight + 3 * k * kLanes, t.d_weight + 9 * k * kLanes);
  }
}

template <class E>
int evaluate_flow(const void* self, netloft_flow_tile* t) noexcept {
  return guarded(nullptr, 0, [&] {
    const auto& p = static_cast<const Family<E>*>(self)->parameters_[t->part];
    for (std::size_t lane = 0; lane < t->count; ++lane) write_flow<E>(p, *t, lane);
    return NETLOFT_OK;
  });
}

}  // namespace netloft::detail
