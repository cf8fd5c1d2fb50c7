// SPDX-License-Identifier: BSD-3-Clause
//
// Laws that are wrong in one place each. The description of a law is the name of the only check that must
// fail: tests/unit/framework/conformance/wrong_laws_test.cpp reads it.
#include <netloft/law.hpp>

using namespace netloft;

namespace {

struct Parameters {
  double C = 0;
};

template <std::uint32_t Kind = NETLOFT_TWINE_LAW>
struct Law {
  static constexpr auto kind = static_cast<netloft_law_kind>(Kind);
  using Parameters = ::Parameters;
};

/// The speed, with a derivative that is not 0/0 at rest.
template <class T>
T speed(const Flow<T>& f) {
  return norm(f.flow) > T(0) ? norm(f.flow) : T(0);
}

/// The correct law. Each wrong law differs from it in one place.
template <class T>
Vec3<T> right(const Parameters& p, const Flow<T>& f) {
  const T k = p.C * f.density * f.diameter * (1.0 + f.solidity);
  return (k * speed(f)) * (f.flow + 0.5 * dot(f.flow, f.direction) * f.direction);
}

struct Right : Law<> {
  template <class T>
  static Vec3<T> force(const Parameters& p, const Flow<T>& f) {
    return right(p, f);
  }
};
struct RightScreen : Law<NETLOFT_SCREEN_LAW> {
  template <class T>
  static Vec3<T> force(const Parameters& p, const Flow<T>& f) {
    return right(p, f);
  }
};

struct GainsEnergy : Law<> {
  template <class T>
  static Vec3<T> force(const Parameters& p, const Flow<T>& f) {
    return -right(p, f);
  }
};
struct PushesInStillWater : Law<> {
  template <class T>
  static Vec3<T> force(const Parameters& p, const Flow<T>& f) {
    Vec3<T> F = right(p, f);
    F.z += p.C * f.density * f.diameter;
    return F;
  }
};
struct KnowsNorth : Law<> {
  template <class T>
  static Vec3<T> force(const Parameters& p, const Flow<T>& f) {
    Vec3<T> F = right(p, f);
    F.x *= 2;
    return F;
  }
};
struct StrongerFromBelow : Law<> {
  template <class T>
  static Vec3<T> force(const Parameters& p, const Flow<T>& f) {
    return right(p, f) + (0.5 * p.C * f.density * f.diameter * f.flow.z) * f.flow;
  }
};
struct TwistsOneWay : Law<> {
  template <class T>
  static Vec3<T> force(const Parameters& p, const Flow<T>& f) {
    return right(p, f) + (p.C * f.density * f.diameter * speed(f)) * cross(f.flow, f.direction);
  }
};
struct KinkAcross : Law<> {
  template <class T>
  static Vec3<T> force(const Parameters& p, const Flow<T>& f) {
    return right(p, f) + (p.C * f.density * f.diameter * abs(dot(f.flow, f.direction))) * f.flow;
  }
};
struct NotANumberAtRest : Law<> {
  template <class T>
  static Vec3<T> force(const Parameters& p, const Flow<T>& f) {
    return (p.C * f.density * f.diameter / norm(f.flow)) * right(p, f);
  }
};
struct Fails : Law<> {
  template <class T>
  static Vec3<T> force(const Parameters&, const Flow<T>&) {
    throw std::runtime_error("the author has not finished this");
  }
};

/// The correct law, whose result Change::lane(flow, lane) changes.
template <class Change>
struct Changed : Law<> {
  static void lanes(const Parameters& p, const netloft_law_tile& f) {
    detail::differentiate_law<Right>(p, f);
    for (std::size_t i = 0; i < f.count; ++i) Change::lane(f, i);
  }
};

void scale(double* values, std::size_t rows, std::size_t lane, double factor) {
  for (std::size_t r = 0; values && r < rows; ++r) values[r * kLanes + lane] *= factor;
}
struct DFlowDoubled {
  static void lane(const netloft_law_tile& f, std::size_t i) { scale(f.d_flow, 9, i, 2); }
};
struct DDirectionForgotten {
  static void lane(const netloft_law_tile& f, std::size_t i) { scale(f.d_direction, 9, i, 0); }
};
struct DSolidityForgotten {
  static void lane(const netloft_law_tile& f, std::size_t i) { scale(f.d_solidity, 3, i, 0); }
};
struct KnowsLane {
  static void lane(const netloft_law_tile& f, std::size_t i) {
    scale(f.force, 3, i, 1 + 1e-12 * static_cast<double>(i));
  }
};
struct ForceFromDerivatives {
  static void lane(const netloft_law_tile& f, std::size_t i) {
    scale(f.force, 3, i, f.d_flow ? 1 + 1e-14 : 1);
  }
};
struct CountsCalls {
  static void lane(const netloft_law_tile& f, std::size_t i) {
    static int calls = 0;
    scale(f.force, 3, i, 1 + 1e-9 * (++calls % 1000));
  }
};
struct WritesPastCount : Law<> {
  static void lanes(const Parameters& p, const netloft_law_tile& f) {
    detail::differentiate_law<Right>(p, f);
    for (std::size_t i = f.count; i < kLanes; ++i) f.force[i] = 0;
  }
};
struct ForgetsAnOutput : Law<> {
  static void lanes(const Parameters& p, const netloft_law_tile& f) {
    netloft_law_tile partly = f;
    double unseen[3 * kLanes];
    if (f.d_solidity) partly.d_solidity = unseen;
    detail::differentiate_law<Right>(p, partly);
  }
};

template <class L>
void add(Plugin& plugin, const char* name, const char* found_by, double fallback = 1) {
  plugin.law<L>(name, found_by)
      .real("C", &Parameters::C, "1", "coefficient", {.lo = 0.1, .hi = 10, .fallback = fallback});
}

}  // namespace

NETLOFT_PLUGIN("wrong_laws", "1", "Laws that are wrong in one place each") {
  add<Right>(plugin, "right", "nothing");
  add<RightScreen>(plugin, "right_screen", "nothing");
  add<Right>(plugin, "bad_default", "defaults-are-allowed", 0);
  add<Fails>(plugin, "fails", "evaluates-without-error");
  add<NotANumberAtRest>(plugin, "not_a_number_at_rest", "outputs-finite");
  add<ForgetsAnOutput>(plugin, "forgets_an_output", "outputs-finite");
  add<WritesPastCount>(plugin, "writes_past_count", "nothing-written-past-count");
  add<Changed<CountsCalls>>(plugin, "counts_calls", "no-hidden-state");
  add<Changed<KnowsLane>>(plugin, "knows_lane", "same-in-any-lane");
  add<Changed<ForceFromDerivatives>>(plugin, "force_from_derivatives", "same-force-without-derivatives");
  add<PushesInStillWater>(plugin, "pushes_in_still_water", "no-force-without-flow");
  add<KinkAcross>(plugin, "kink_across", "no-kink");
  add<Changed<DFlowDoubled>>(plugin, "d_flow_doubled", "d-flow-is-derivative");
  add<Changed<DDirectionForgotten>>(plugin, "d_direction_forgotten", "d-direction-is-derivative");
  add<Changed<DSolidityForgotten>>(plugin, "d_solidity_forgotten", "d-solidity-is-derivative");
  add<GainsEnergy>(plugin, "gains_energy", "never-gains-energy");
  add<KnowsNorth>(plugin, "knows_north", "rotation-turns-the-force");
  add<StrongerFromBelow>(plugin, "stronger_from_below", "odd-in-flow");
  add<TwistsOneWay>(plugin, "twists_one_way", "even-in-direction");
}
