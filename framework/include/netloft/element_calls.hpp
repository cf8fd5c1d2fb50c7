// SPDX-License-Identifier: BSD-3-Clause
//
// Adapts the functions of an element to the C functions that the host calls. Included by element.hpp; authors
// do not use it.
#pragma once
#include <netloft/ext/bodies.h>
#include <netloft/ext/convex.h>
#include <netloft/body.hpp>
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
template <class E>
inline constexpr bool is_on_body = E::stencil == NETLOFT_BODY;
/// Number of nodes: those of the stencil, one more for the rotation of a body, and one more for unknowns that
/// the elements of a part share.
template <class E>
inline constexpr int nodes_of = (E::stencil & 0xff) + is_on_body<E> + (count_globals<E>() > 0);
template <class E>
inline constexpr int dofs_of = 3 * nodes_of<E>;

/// Types of the arguments of `energy`, of `force` and of an output.
template <class E, class T>
using PlacesOf = std::conditional_t<is_on_body<E>, Pose<T>, Points<T, nodes_of<E>>>;
template <class E, class T>
using MotionOf = std::conditional_t<is_on_body<E>, Body<T>, MovingNodes<T, nodes_of<E>>>;
template <class E>
using ViewOf = std::conditional_t<is_on_body<E>, Body<double>, State<nodes_of<E>>>;
/// Type of the result of `force`.
template <class E, class T>
using PushOf = std::conditional_t<is_on_body<E>, Wrench<T>, Points<T, nodes_of<E>>>;

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
                             const PlacesOf<E, Dual<dofs_of<E>>>& x) {
  T::energy(p, d, w, x);
};
template <class E, class T>
concept HasForceWithWhole = requires(const typename E::Parameters& p, const typename E::Data& d,
                                     const typename Family<E>::Whole& w,
                                     const MotionOf<E, Dual<dofs_of<E>, 1>>& m) {
  T::force(p, d, w, m);
};
template <class E, class T>
concept HasForce = HasForceWithWhole<E, T> ||
    requires(const typename E::Parameters& p, const typename E::Data& d,
             const MotionOf<E, Dual<dofs_of<E>, 1>>& m) {
  T::force(p, d, m);
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

/// Runs `body` and converts exceptions to a status and a message, so that no exception leaves the plugin.
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

inline Bed bed_below(const netloft_tile& t, std::size_t node, std::size_t lane) {
  const double* bed = bed_of(t);
  if (!bed) return {};
  const auto at = [&](std::size_t k) { return bed[(6 * node + k) * kLanes + lane]; };
  return {true,
          t.x[3 * node * kLanes + lane],
          t.x[(3 * node + 1) * kLanes + lane],
          at(0),
          at(1),
          at(2),
          at(3),
          at(4),
          at(5)};
}

/// The bed below the nodes. Only the first `of_stencil` nodes are points and have a bed. Later nodes hold the
/// rotation of a body or shared unknowns.
template <std::size_t Nodes>
std::array<Bed, Nodes> beds_below(const netloft_tile& t, std::size_t of_stencil, std::size_t lane) {
  std::array<Bed, Nodes> beds{};
  for (std::size_t n = 0; n < of_stencil; ++n) beds[n] = bed_below(t, n, lane);
  return beds;
}

/// Velocity of the ground; zero if it is at rest.
inline Vec3<double> passing_ground(const netloft_tile& t) {
  const double* g = ground_of(t);
  return g ? Vec3<double>{g[0], g[1], g[2]} : Vec3<double>{};
}

/// All traits. Outputs have all of them, and thus receive every input that some term of the element reads.
inline constexpr std::uint32_t kEveryTrait = ~std::uint32_t{0};

/// Reads the data of extensions for a term with these traits.
template <std::uint32_t Traits, int Nodes>
void gather_inputs(const netloft_tile& t, std::size_t lane, std::size_t of_stencil, State<Nodes>& s) {
  if constexpr (Traits & NETLOFT_READS_WAVES) {
    gather<Nodes>(water_acceleration_of(t), lane, s.water_acceleration);
    if (const double* surface = surface_of(t))
      for (std::size_t n = 0; n < s.surface.size(); ++n) s.surface[n] = surface[n * kLanes + lane];
  }
  if constexpr (Traits & NETLOFT_READS_GROUND) s.ground = passing_ground(t);
  if constexpr (Traits & NETLOFT_READS_BED)
    s.bed = beds_below<static_cast<std::size_t>(Nodes)>(t, of_stencil, lane);
}

template <int Nodes, std::uint32_t Traits = kEveryTrait>
State<Nodes> gather(const netloft_tile& t, std::size_t lane, std::size_t of_stencil = 0) {
  State<Nodes> s;
  gather<Nodes>(t.x, lane, s.x);
  gather<Nodes>(t.x_low, lane, s.x_low);
  gather<Nodes>(t.v, lane, s.v);
  gather<Nodes>(t.a, lane, s.a);
  gather<Nodes>(t.current, lane, s.current);
  gather<Nodes>(t.current_dz, lane, s.current_dz);
  gather_inputs<Traits, Nodes>(t, lane, of_stencil, s);
  s.water = {t.water_density, t.gravity, t.water_viscosity};
  s.time = t.time;
  s.cu = t.cu;
  s.cv = t.cv;
  s.ca = t.ca;
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

/// Reads the degrees of freedom of one element from a field [dof][64] as dual numbers. The derivative of each
/// degree of freedom with respect to itself is `factor`, and its other derivatives are zero. If `field` is
/// nullptr, the values are zero, but the derivatives remain.
template <class T, int Nodes>
Points<T, Nodes> read_dual(const double* field, std::size_t lane, double factor) {
  Points<T, Nodes> to{};
  for (int i = 0; i < 3 * Nodes; ++i) {
    T& entry = to[static_cast<std::size_t>(i / 3)][i % 3];
    entry = T(field ? field[static_cast<std::size_t>(i) * kLanes + lane] : 0);
    if constexpr (!std::is_same_v<T, double>) entry.gradient[static_cast<std::size_t>(i)] = factor;
  }
  return to;
}

/// Reads the velocity of the water at the nodes, with its derivatives with respect to the nodes' heights.
template <class T, int Nodes>
Points<T, Nodes> read_current(const netloft_tile& t, std::size_t lane, const Points<T, Nodes>& x) {
  const auto velocity = read_dual<double, Nodes>(t.current, lane, 0),
             slope = read_dual<double, Nodes>(t.current_dz, lane, 0);
  Points<T, Nodes> to{};
  for (std::size_t n = 0; n < static_cast<std::size_t>(Nodes); ++n) {
    T height = x[n].z;  // height above the node: zero at the node itself, but with derivatives
    if constexpr (std::is_same_v<T, double>)
      height = 0;
    else
      height.value = 0;
    for (int axis = 0; axis < 3; ++axis) to[n][axis] = velocity[n][axis] + slope[n][axis] * height;
  }
  return to;
}

template <class T>
Pose<T> pose_of(const Vec3<T>& x, const Vec3<T>& psi) {
  return {x, turned_axes(psi)};
}

/// Reads the motion of one element as dual numbers. The derivatives of a position, velocity and acceleration
/// with respect to the unknown are the factors cu, cv and ca of the tangent.
template <class E, class T, std::uint32_t Traits>
MotionOf<E, T> read_motion(const netloft_tile& t, std::size_t lane) {
  constexpr int N = nodes_of<E>;
  const auto x = read_dual<T, N>(t.x, lane, t.cu), v = read_dual<T, N>(t.v, lane, t.cv),
             a = read_dual<T, N>(t.a, lane, t.ca), current = read_current<T, N>(t, lane, x);
  MotionOf<E, T> m;
  if constexpr (is_on_body<E>) {
    static_cast<Pose<T>&>(m) = pose_of(x[0], x[1]);
    m.v = v[0];
    m.omega = spin_of(x[1], v[1]);
    m.a = a[0];
    m.alpha = spin_rate_of(x[1], v[1], a[1]);
    m.current = current[0];
    m.current_dz = read_dual<double, N>(t.current_dz, lane, 0)[0];
    if constexpr (Traits & NETLOFT_READS_BED) m.bed = bed_below(t, 0, lane);
  } else {
    m.x = x;
    m.v = v;
    m.a = a;
    m.current = current;
    if constexpr (Traits & NETLOFT_READS_BED)
      m.bed = beds_below<static_cast<std::size_t>(N)>(t, E::stencil & 0xff, lane);
  }
  if constexpr (Traits & NETLOFT_READS_GROUND) m.ground = passing_ground(t);
  m.water = {t.water_density, t.gravity, t.water_viscosity};
  m.time = t.time;
  return m;
}

/// Converts the result of `force` to a residual, which is minus the force. The moment on a body becomes minus
/// the generalised force that does the same work on the rotation vector.
template <class E, class T>
Points<T, nodes_of<E>> residual_of(const PushOf<E, T>& push, const netloft_tile& t, std::size_t lane) {
  Points<T, nodes_of<E>> residual{};
  if constexpr (is_on_body<E>) {
    const auto psi = read_dual<T, nodes_of<E>>(t.x, lane, t.cu)[1];
    residual[0] = -push.force;
    residual[1] = -moment_on_vector(psi, push.moment);
  } else {
    for (std::size_t n = 0; n < residual.size(); ++n) residual[n] = -push[n];
  }
  return residual;
}

/// Residual and tangent of a term with a function `force`, by first-order forward differentiation. The force
/// has the same bits as without derivatives.
template <class E, class T, std::uint32_t Traits = kEveryTrait>
void differentiate_force(const Family<E>& f, std::size_t element, const netloft_tile& t, std::size_t lane,
                         Local<nodes_of<E>>& local) {
  constexpr int dofs = dofs_of<E>;
  using D = Dual<dofs, 1>;
  const auto motion = read_motion<E, D, Traits>(t, lane);
  const auto push = [&] {
    if constexpr (HasForceWithWhole<E, T>)
      return T::force(f.parameters(element), f.data(element), f.whole(element), motion);
    else
      return T::force(f.parameters(element), f.data(element), motion);
  };
  const auto residual = residual_of<E, D>(push(), t, lane);
  for (int r = 0; r < dofs; ++r) {
    const D& entry = residual[static_cast<std::size_t>(r / 3)][r % 3];
    local.force[static_cast<std::size_t>(r / 3)][r % 3] = entry.value;
    for (int c = 0; c < dofs; ++c) local.tangent[r][c] = entry.gradient[static_cast<std::size_t>(c)];
  }
}

/// Residual and tangent of a term with a function `energy`, by second-order forward differentiation.
template <class E, class T>
void differentiate(const Family<E>& f, std::size_t element, const netloft_tile& t, std::size_t lane,
                   Local<nodes_of<E>>& local) {
  constexpr int N = nodes_of<E>;
  using D = Dual<3 * N>;
  const Water water{t.water_density, t.gravity, t.water_viscosity};
  const auto x = read_dual<D, N>(t.x, lane, 1);
  D e;
  if constexpr (is_on_body<E>)
    e = T::energy(f.parameters(element), f.data(element), water, pose_of(x[0], x[1]));
  else
    e = T::energy(f.parameters(element), f.data(element), water, x);
  local.energy = e.value;
  std::size_t k = 0;
  for (int r = 0; r < 3 * N; ++r) {
    local.force[static_cast<std::size_t>(r / 3)][r % 3] = e.gradient[static_cast<std::size_t>(r)];
    for (int c = 0; c <= r; ++c, ++k) local.tangent[r][c] = local.tangent[c][r] = t.cu * e.hessian[k];
  }
}

template <class E>
ViewOf<E> view_of(const netloft_tile& t, std::size_t lane) {
  if constexpr (is_on_body<E>)
    return read_motion<E, double, kEveryTrait>(t, lane);
  else
    return gather<nodes_of<E>, kEveryTrait>(t, lane, E::stencil & 0xff);
}

template <class E, class T, std::uint32_t Traits>
Status evaluate_one(const Family<E>& f, const netloft_tile& t, std::size_t lane, Local<nodes_of<E>>& local) {
  const std::size_t element = t.first + lane;
  if constexpr (HasEvaluateWithWhole<E, T>) {
    return T::evaluate(f.parameters(element), f.data(element), f.whole(element),
                       gather<nodes_of<E>, Traits>(t, lane, E::stencil & 0xff), local);
  } else if constexpr (HasEvaluate<E, T>) {
    return T::evaluate(f.parameters(element), f.data(element),
                       gather<nodes_of<E>, Traits>(t, lane, E::stencil & 0xff), local);
  } else if constexpr (HasForce<E, T>) {
    differentiate_force<E, T, Traits>(f, element, t, lane, local);
    return Status::ok;
  } else {
    differentiate<E, T>(f, element, t, lane, local);
    return Status::ok;
  }
}

template <class E, class T, std::uint32_t Traits>
int evaluate_term(const void* self, netloft_tile* t) {
  static_assert(
      HasTile<E, T> || HasEvaluate<E, T> || HasEvaluateWithWhole<E, T> || HasEnergy<E, T> || HasForce<E, T>,
      "A term needs one of these static functions: `T energy(const Parameters&, const Data&, const "
      "Water&, const Points<T, N>&)` or `Points<T, N> force(const Parameters&, const Data&, const "
      "MovingNodes<T, N>&)` (templates over T; on a body `const Pose<T>&`, and `Wrench<T>` of `const "
      "Body<T>&`), `Status evaluate(const Parameters&, const Data&, const State<N>&, Local<N>&)`, or "
      "`Status tile(const Family<Element>&, netloft_tile&)`.");
  const auto& family = *static_cast<const Family<E>*>(self);
  return guarded(t->message, t->message_size, [&]() -> int {
    if constexpr (HasTile<E, T>) {
      return static_cast<int>(T::tile(family, *t));
    } else {
      for (std::uint32_t lane = 0; lane < t->count; ++lane) {
        Local<nodes_of<E>> local;
        t->lane_at_fault = lane;
        const Status status = evaluate_one<E, T, Traits>(family, *t, lane, local);
        if (status != Status::ok) return static_cast<int>(status);
        scatter(local, (Traits & NETLOFT_SYMMETRIC) != 0, lane, *t);
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

/// Data of an extension that the host gives to `create`; nullptr if it gives none.
template <class Given>
const Given* given(const netloft_create& in, const char* id) {
  return in.extension ? static_cast<const Given*>(in.extension(in.host, id)) : nullptr;
}

template <class E>
void take_laws(Family<E>& f, netloft_create& in) {
  if (const auto* bound = given<netloft_bound_laws>(in, NETLOFT_EXT_LAWS))
    f.laws_.assign(bound->laws, bound->laws + bound->count);
}

template <class E>
void fill_family(Family<E>& f, netloft_create& in, const std::vector<std::size_t>& offsets,
                 const std::vector<netloft_datum>& data) {
  for (std::uint32_t p = 0; p < in.part_count; ++p)
    f.parameters_.push_back(OwnParameters<E>::from(in.parameters[p]));
  f.part_.assign(in.part, in.part + in.count);
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
