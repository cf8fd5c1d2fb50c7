// SPDX-License-Identifier: BSD-3-Clause
//
// From the functions of an element to what the host calls. Included by element.hpp; nothing here is for
// authors.
#pragma once
#include <netloft/dual.hpp>
#include <netloft/parameters.hpp>
#include <netloft/state.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdio>
#include <cstring>
#include <exception>
#include <utility>

namespace netloft {

namespace detail {

template <class E>
consteval int count_globals() {
  if constexpr (requires { E::globals; }) return E::globals;
  return 0;
}
/// Those of the stencil, and one for what a part shares.
template <class E>
inline constexpr int nodes_of = (E::stencil & 0xff) + (count_globals<E>() > 0);

template <class E, class T>
concept HasTile = requires(const Family<E>& f, netloft_tile& t) {
  T::tile(f, t);
};
template <class E, class T>
concept HasEvaluate = requires(const typename E::Parameters& p, const typename E::Data& d,
                               const State<nodes_of<E>>& s, Local<nodes_of<E>>& l) {
  T::evaluate(p, d, s, l);
};
template <class E, class T>
concept HasEvaluateWithWhole = requires(const typename E::Parameters& p, const typename E::Data& d,
                                        const typename Family<E>::Whole& w, const State<nodes_of<E>>& s,
                                        Local<nodes_of<E>>& l) {
  T::evaluate(p, d, w, s, l);
};
template <class E, class T>
concept HasEnergy = requires(const typename E::Parameters& p, const typename E::Data& d, const Water& w,
                             const Points<Dual<3 * nodes_of<E>>, nodes_of<E>>& x) {
  T::energy(p, d, w, x);
};

template <class E>
concept HasMembers = requires(const typename E::Parameters& p, const typename E::Data& d) {
  { E::members(p, d, 0.0)[0] } -> std::convertible_to<const Member&>;
};
template <class E>
consteval std::uint32_t count_members() {
  using Members = decltype(E::members(std::declval<const typename E::Parameters&>(),
                                      std::declval<const typename E::Data&>(), 0.0));
  return static_cast<std::uint32_t>(std::tuple_size_v<Members>);
}

inline int say(char* message, std::uint32_t size, const char* text, int status) {
  if (message && size) std::snprintf(message, size, "%s", text);
  return status;
}

/// Runs `body`; no exception leaves the plugin.
template <class F>
int guarded(char* message, std::uint32_t size, F&& body) noexcept {
  try {
    return body();
  } catch (const OutsideDomain& e) {
    return say(message, size, e.what(), NETLOFT_OUTSIDE_DOMAIN);
  } catch (const std::exception& e) {
    return say(message, size, e.what(), NETLOFT_ERROR);
  } catch (...) {
    return say(message, size, "an exception that is no std::exception", NETLOFT_ERROR);
  }
}

template <int Nodes>
void gather(const double* from, std::size_t lane, Points<double, Nodes>& to) {
  if (!from) return;
  for (int n = 0; n < Nodes; ++n)
    for (int axis = 0; axis < 3; ++axis)
      to[static_cast<std::size_t>(n)][axis] = from[static_cast<std::size_t>(3 * n + axis) * kLanes + lane];
}

template <int Nodes>
State<Nodes> gather(const netloft_tile& t, std::size_t lane) {
  State<Nodes> s;
  gather<Nodes>(t.x, lane, s.x);
  gather<Nodes>(t.x_low, lane, s.x_low);
  gather<Nodes>(t.v, lane, s.v);
  gather<Nodes>(t.a, lane, s.a);
  gather<Nodes>(t.current, lane, s.current);
  gather<Nodes>(t.current_dz, lane, s.current_dz);
  if (t.ground) s.ground = {t.ground[0], t.ground[1], t.ground[2]};
  s.water = {t.water_density, t.gravity, t.water_viscosity};
  s.time = t.time, s.cu = t.cu, s.cv = t.cv, s.ca = t.ca;
  s.wants_tangent = t.want & (NETLOFT_WANT_TANGENT | NETLOFT_WANT_CONVEX | NETLOFT_WANT_METRIC);
  return s;
}

template <int Nodes>
void scatter(const Local<Nodes>& local, bool symmetric, std::size_t lane, netloft_tile& t) {
  constexpr int dofs = 3 * Nodes;
  if (t.energy) t.energy[lane] += local.energy;
  if (t.force)
    for (int i = 0; i < dofs; ++i)
      t.force[static_cast<std::size_t>(i) * kLanes + lane] +=
          local.force[static_cast<std::size_t>(i / 3)][i % 3];
  if (!t.tangent) return;
  std::size_t entry = 0;
  for (int r = 0; r < dofs; ++r)
    for (int c = 0; c < (symmetric ? r + 1 : dofs); ++c)
      t.tangent[kLanes * entry++ + lane] += local.tangent[r][c];
}

/// Force and tangent of an energy, by second-order forward differentiation.
template <class E, class T>
void differentiate(const Family<E>& f, std::size_t element, const netloft_tile& t, std::size_t lane,
                   Local<nodes_of<E>>& local) {
  constexpr int N = nodes_of<E>;
  const Water water{t.water_density, t.gravity, t.water_viscosity};
  Points<Dual<3 * N>, N> x;
  for (int i = 0; i < 3 * N; ++i)
    x[static_cast<std::size_t>(i / 3)][i % 3] =
        Dual<3 * N>::variable(t.x[static_cast<std::size_t>(i) * kLanes + lane], i);
  const Dual<3 * N> e = T::energy(f.parameters(element), f.data(element), water, x);
  local.energy = e.value;
  std::size_t k = 0;
  for (int r = 0; r < 3 * N; ++r) {
    local.force[static_cast<std::size_t>(r / 3)][r % 3] = e.gradient[static_cast<std::size_t>(r)];
    for (int c = 0; c <= r; ++c, ++k) local.tangent[r][c] = local.tangent[c][r] = t.cu * e.hessian[k];
  }
}

template <class E, class T>
Status evaluate_one(const Family<E>& f, const netloft_tile& t, std::size_t lane, Local<nodes_of<E>>& local) {
  const std::size_t element = t.first + lane;
  if constexpr (HasEvaluateWithWhole<E, T>) {
    return T::evaluate(f.parameters(element), f.data(element), f.whole(element), gather<nodes_of<E>>(t, lane),
                       local);
  } else if constexpr (HasEvaluate<E, T>) {
    return T::evaluate(f.parameters(element), f.data(element), gather<nodes_of<E>>(t, lane), local);
  } else {
    differentiate<E, T>(f, element, t, lane, local);
    return Status::ok;
  }
}

template <class E, class T, bool Symmetric>
int evaluate_term(const void* self, netloft_tile* t) {
  static_assert(
      HasTile<E, T> || HasEvaluate<E, T> || HasEvaluateWithWhole<E, T> || HasEnergy<E, T>,
      "A term needs one of these static functions: `T energy(const Parameters&, const Data&, const "
      "Water&, const Points<T, N>&)` (a template over T), `Status evaluate(const Parameters&, const "
      "Data&, const State<N>&, Local<N>&)`, or `Status tile(const Family<Element>&, netloft_tile&)`.");
  const auto& family = *static_cast<const Family<E>*>(self);
  return guarded(t->message, t->message_size, [&]() -> int {
    if constexpr (HasTile<E, T>) {
      return static_cast<int>(T::tile(family, *t));
    } else {
      for (std::uint32_t lane = 0; lane < t->count; ++lane) {
        Local<nodes_of<E>> local;
        t->lane_at_fault = lane;
        const Status status = evaluate_one<E, T>(family, *t, lane, local);
        if (status != Status::ok) return static_cast<int>(status);
        scatter(local, Symmetric, lane, *t);
      }
      return NETLOFT_OK;
    }
  });
}

template <class E>
int write_members(const void* self, double time, std::uint32_t first, std::uint32_t count,
                  netloft_member* out) noexcept {
  const auto& family = *static_cast<const Family<E>*>(self);
  try {
    for (std::size_t e = first; e < std::size_t{first} + count; ++e)
      for (const Member& member : E::members(family.parameters(e), family.data(e), time)) *out++ = member;
    return NETLOFT_OK;
  } catch (...) {
    return NETLOFT_ERROR;
  }
}

template <class E>
void fill_family(Family<E>& f, netloft_create& in, const std::vector<std::size_t>& offsets,
                 const std::vector<netloft_datum>& data) {
  for (std::uint32_t p = 0; p < in.part_count; ++p)
    f.parameters_.push_back(OwnParameters<E>::from(in.parameters[p]));
  f.part_.assign(in.part, in.part + in.count);
  if (in.laws) f.laws_.assign(in.laws, in.laws + in.law_count);
  f.wholes_.resize(in.part_count);
  f.data_.resize(in.count);
  if constexpr (requires { typename E::Lanes; }) f.lanes_.resize((in.count + kLanes - 1) / kLanes);
  for (std::uint32_t e = 0; e < in.count; ++e) {
    in.at_fault = e;
    for (std::size_t k = 0; k < data.size(); ++k)
      std::memcpy(reinterpret_cast<char*>(&f.data_[e]) + offsets[k],
                  in.data[k] + std::size_t{e} * data[k].width, data[k].width * sizeof(double));
    if constexpr (requires { E::check(f.parameters(e), f.data_[e]); }) E::check(f.parameters(e), f.data_[e]);
    if constexpr (requires { typename E::Lanes; })
      E::pack(f.parameters(e), f.data_[e], f.lanes_[e / kLanes], e % kLanes);
    if constexpr (requires { typename E::Whole; })
      E::gather(f.parameters(e), f.data_[e], f.wholes_[f.part_[e]]);
  }
  if constexpr (requires { E::check_whole(f.parameters(0), f.wholes_[0]); })
    for (std::uint32_t p = 0; p < in.part_count; ++p) {
      const auto first = std::find(in.part, in.part + in.count, p) - in.part;
      in.at_fault = static_cast<std::uint32_t>(first);
      if (first < in.count) E::check_whole(f.parameters_[p], f.wholes_[p]);
    }
}

}  // namespace detail

}  // namespace netloft
