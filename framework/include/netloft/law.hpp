// SPDX-License-Identifier: BSD-3-Clause
//
// The header for authors of hydrodynamic laws. A law is a struct with `Parameters`, the kind of body to which
// it applies (`kind`), and one of two functions. `force` is quicker to write, `lanes` runs faster:
//
//   template <class T> static Vec3<T> force(const Parameters&, const Flow<T>&);
//   static void lanes(const Parameters&, const netloft_law_tile&);
//
// `force` is differentiated automatically; `lanes` computes up to 64 flows at a time, with derivatives if
// these are requested.
#pragma once
#include <netloft/element.hpp>

namespace netloft {

/// The flow at one twine, or at one piece of netting that is treated as a screen.
template <class T>
struct Flow {
  Vec3<T> flow;                       // velocity of the water relative to the twine or netting [m/s]
  Vec3<T> direction;                  // unit vector along the twine, or normal to the screen
  T solidity{};                       // area of the twines over area of the netting; zero for a rope
  double diameter = 0;                // diameter of the twine [m]
  double density = 0, viscosity = 0;  // properties of the water [kg/m3], [m2/s]
};

/// Arrays with the flows of 64 elements, in the layout of tiles, for one call of a law.
struct FlowLanes {
  double flow[3][kLanes], direction[3][kLanes], diameter[kLanes], solidity[kLanes];
  double force[3][kLanes], d_flow[9][kLanes], d_direction[9][kLanes], d_solidity[3][kLanes];

  /// Calls the law on lanes below `count`. `extent` [kLanes]: metres of twine or square metres of netting
  /// that each lane represents; reports use them as weights.
  void call(const netloft_bound_law& law, const netloft_tile& t, bool derivatives,
            const double* extent = nullptr) {
    netloft_law_tile f{};
    f.size = sizeof f;
    f.count = t.count;
    f.water_density = t.water_density;
    f.water_viscosity = t.water_viscosity;
    f.flow = flow[0];
    f.direction = direction[0];
    f.diameter = diameter;
    f.solidity = solidity;
    f.force = force[0];
    f.extent = extent;
    if (derivatives) {
      f.d_flow = d_flow[0];
      f.d_direction = d_direction[0];
      f.d_solidity = d_solidity[0];
    }
    if (law.evaluate(law.parameters, &f) != NETLOFT_OK)
      throw std::runtime_error("the hydrodynamic law failed");
  }
};

namespace detail {

template <class L>
void differentiate_law(const typename L::Parameters& p, const netloft_law_tile& f) {
  using T = Dual<7, 1>;
  for (std::size_t i = 0; i < f.count; ++i) {
    Flow<T> in;
    for (int a = 0; a < 3; ++a) {
      in.flow[a] = T::variable(f.flow[static_cast<std::size_t>(a) * kLanes + i], a);
      in.direction[a] = T::variable(f.direction[static_cast<std::size_t>(a) * kLanes + i], 3 + a);
    }
    in.solidity = T::variable(f.solidity[i], 6);
    in.diameter = f.diameter[i];
    in.density = f.water_density;
    in.viscosity = f.water_viscosity;
    const Vec3<T> force = L::force(p, in);
    for (std::size_t r = 0; r < 3; ++r) {
      const T& value = force[static_cast<int>(r)];
      f.force[r * kLanes + i] = value.value;
      if (!f.d_flow) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        f.d_flow[(3 * r + c) * kLanes + i] = value.gradient[c];
        f.d_direction[(3 * r + c) * kLanes + i] = value.gradient[3 + c];
      }
      f.d_solidity[r * kLanes + i] = value.gradient[6];
    }
  }
}

template <class L>
int evaluate_law(const void* parameters, const netloft_law_tile* flow) noexcept {
  return guarded(nullptr, 0, [&] {
    const typename L::Parameters p = OwnParameters<L>::from(parameters);
    if constexpr (requires { L::lanes(p, *flow); })
      L::lanes(p, *flow);
    else
      differentiate_law<L>(p, *flow);
    return NETLOFT_OK;
  });
}

}  // namespace detail

/// Quantities for which a law may be valid in a limited range only. W is the velocity of the water relative
/// to the twine, D the diameter, ν the viscosity, S the solidity.
enum class Quantity : std::uint32_t {
  reynolds = NETLOFT_REYNOLDS,                // Reynolds number ‖W‖ D/ν
  reynolds_across = NETLOFT_REYNOLDS_ACROSS,  // as `reynolds`, but with the component of W across the twine
  reynolds_in_meshes = NETLOFT_REYNOLDS_IN_MESHES,  // Reynolds number ‖W‖ D/(ν (1 − S))
  solidity = NETLOFT_SOLIDITY,
  attack = NETLOFT_ATTACK,  // angle between flow and twine or netting [rad]
};

/// Conditions for a range of validity, by names of parameters. A parameter counts as given unless it is a
/// real number equal to zero, an empty table or the first word of a choice.
struct Condition {
  const char* where = nullptr;   // the range applies only if this parameter is given
  const char* unless = nullptr;  // the range does not apply if this parameter is given
};

/// Describes one law to the host.
template <class L>
class LawTable : public ParameterTable<typename L::Parameters> {
 public:
  using Offer = netloft_laws;  // the list in which a plugin offers its laws
  static constexpr const char* extension = NETLOFT_EXT_LAWS;

  LawTable(const char* name, const char* doc) : name_(name), doc_(doc) {}

  /// States that the law was measured for lo ≤ quantity ≤ hi. The law must return forces outside this range,
  /// too; reports then state which fraction of the gear is outside.
  void valid(Quantity quantity, double lo, double hi, const char* source, Condition condition = {}) {
    netloft_validity v{};
    v.size = sizeof v;
    v.quantity = static_cast<std::uint32_t>(quantity);
    v.lo = lo;
    v.hi = hi;
    v.source = source;
    v.where = condition.where;
    v.unless = condition.unless;
    validity_.push_back(v);
  }

  netloft_law descriptor() const {
    detail::OwnParameters<L>::declare(this->rows());
    netloft_law l{};
    l.size = sizeof l;
    l.kind = L::kind;
    l.name = name_;
    l.doc = doc_;
    l.parameter_bytes = sizeof(typename L::Parameters);
    l.parameter_count = static_cast<std::uint32_t>(this->rows().size());
    l.parameters = this->rows().data();
    l.evaluate = &detail::evaluate_law<L>;
    l.validity = validity_.data();
    l.validity_count = static_cast<std::uint32_t>(validity_.size());
    return l;
  }

 private:
  const char *name_, *doc_;
  std::vector<netloft_validity> validity_;
};

}  // namespace netloft
