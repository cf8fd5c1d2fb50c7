// SPDX-License-Identifier: BSD-3-Clause
//
// The inputs and outputs of elements, for authors of elements. Included by element.hpp.
#pragma once
#include <netloft/ext/laws.h>
#include <netloft/ext/members.h>
#include <netloft/inputs.hpp>
#include <netloft/vec3.hpp>

#include <cstdint>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace netloft {

inline constexpr int kLanes = NETLOFT_LANES;

enum class Status { ok = NETLOFT_OK, outside_domain = NETLOFT_OUTSIDE_DOMAIN };

/// Thrown if the force of a term is not defined at a state, for instance the force of a bar of zero length.
/// The solver then shortens its step.
struct OutsideDomain : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A member is a straight line in an element that bears tension; netloft_member describes its fields and its
/// force.
using Member = netloft_member;

struct Water {
  double density;        // [kg/m3]
  double gravity;        // [m/s2]
  double viscosity = 0;  // kinematic [m2/s]
};

/// The bed of the scene near a place, approximated by a paraboloid with the same height, slopes and
/// curvatures there.
struct Bed {
  bool is_there = false;
  double x = 0, y = 0;                          // coordinates of the place [m]
  double height = 0, slope_x = 0, slope_y = 0;  // z_b [m], its derivatives with respect to x and y
  double xx = 0, xy = 0, yy = 0;                // second derivatives of z_b [1/m]

  /// z_b below a point near the place [m].
  template <class T>
  T below(const Vec3<T>& point) const {
    const T dx = point.x - T(x), dy = point.y - T(y);
    return height + slope_x * dx + slope_y * dy + 0.5 * xx * dx * dx + xy * dx * dy + 0.5 * yy * dy * dy;
  }
};

/// The inputs of one element in `evaluate`. An input is zero if no trait of the term requests it.
template <int Nodes>
struct State {
  Points<double, Nodes> x{}, v{}, a{}, current{}, current_dz{};
  Points<double, Nodes> x_low{};  // digits that rounding removes from x [m]; zero if they are not known
  Vec3<double> ground{};          // velocity of the ground [m/s]; zero if it is at rest
  std::array<Bed, Nodes> bed{};   // the bed below the nodes
  Points<double, Nodes> water_acceleration{};  // [m/s2]
  std::array<double, Nodes> surface{};         // height of the water's surface over the nodes [m]
  Water water{};
  double time = 0;
  double cu = 1, cv = 0, ca = 0;  // factors of dforce/dx, dforce/dv, dforce/da in the tangent
  bool wants_tangent = false;

  /// The vector from one node to another [m], including the digits that rounding removes from the positions,
  /// if they are known.
  Vec3<double> between(std::size_t from, std::size_t to) const {
    return (x[to] - x[from]) + (x_low[to] - x_low[from]);
  }
};

/// The results of `evaluate`: energy [J], force = +dE/dx [N], tangent = dforce/dx [N/m]. Initially zero.
template <int Nodes>
struct Local {
  static constexpr int dofs = 3 * Nodes;
  double energy = 0;
  Points<double, Nodes> force{};
  double tangent[dofs][dofs] = {};
};

/// All elements of one type in a scene, part by part (a part is a named group of elements with the same
/// parameters).
template <class E>
class Family {
 public:
  using Parameters = typename E::Parameters;
  using Data = typename E::Data;

  const Parameters& parameters(std::size_t element) const { return parameters_[part_[element]]; }
  const Data& data(std::size_t element) const { return data_[element]; }
  const auto& whole(std::size_t element) const { return wholes_[part_[element]]; }
  /// Data of the tile's elements as E::pack arranged them, for terms written as `tile`.
  const auto& lanes(const netloft_tile& tile) const { return lanes_[tile.first / NETLOFT_LANES]; }
  std::size_t size() const { return data_.size(); }

  struct None {};
  template <class F, class = void>
  struct LanesOf {
    using type = None;
  };
  template <class F>
  struct LanesOf<F, std::void_t<typename F::Lanes>> {
    using type = typename F::Lanes;
  };
  using Lanes = typename LanesOf<E>::type;
  template <class F, class = void>
  struct WholeOf {
    using type = None;
  };
  template <class F>
  struct WholeOf<F, std::void_t<typename F::Whole>> {
    using type = typename F::Whole;
  };
  using Whole = typename WholeOf<E>::type;

  /// The law that the user chose for a slot; slots are numbered in the order in which they were declared. The
  /// law is called with the arrays of a netloft_law_tile.
  const netloft_bound_law& law(std::size_t slot) const { return laws_[slot]; }

  std::vector<Parameters> parameters_;  // parameters of each part
  std::vector<netloft_bound_law> laws_;
  std::vector<std::uint32_t> part_;
  std::vector<Data> data_;
  std::vector<Lanes> lanes_;
  std::vector<Whole> wholes_;  // data of each part as a whole
};

}  // namespace netloft
