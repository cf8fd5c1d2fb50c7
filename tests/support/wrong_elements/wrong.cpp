// SPDX-License-Identifier: BSD-3-Clause
//
// Elements that are wrong in one place each. The description of an element is the name of the only check that
// must fail: tests/unit/framework/conformance/wrong_elements_test.cpp reads it.
#include "tests/support/wrong_elements/drag_by_law.hpp"
#include "tests/support/wrong_elements/flows.hpp"
#include "tests/support/wrong_elements/spring.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

using namespace netloft;
using namespace netloft::wrong;

namespace {

constexpr auto kPotential = conservative | symmetric;
constexpr auto kWater = reads_current | reads_velocity | needs_flow;

struct ForceSign {
  static Status evaluate(const Parameters& p, const Data& d, const State<2>& s, Local<2>& out) {
    evaluate_spring(p, d, s, out);
    const double energy = out.energy;
    scale(out, -1);
    out.energy = energy;
    return Status::ok;
  }
};

struct ComponentDoubled {
  static Status evaluate(const Parameters& p, const Data&, const State<2>& s, Local<2>& out) {
    return evaluate_diagonal(s, out, {p.EA, p.EA, p.EA}, {p.EA, p.EA, 2 * p.EA});
  }
};

struct EnergyDoubled {
  static Status evaluate(const Parameters& p, const Data& d, const State<2>& s, Local<2>& out) {
    evaluate_spring(p, d, s, out);
    out.energy *= 2;
    return Status::ok;
  }
};

struct EnergyJumps {  // the energy jumps by a constant where the bar goes slack
  static Status evaluate(const Parameters& p, const Data& d, const State<2>& s, Local<2>& out) {
    evaluate_spring(p, d, s, out);
    if (Spring(p, d, s).T < 0) out.energy += 0.2 * p.EA * d.rest_length;
    return Status::ok;
  }
};

struct NoGeometricPart {
  static Status evaluate(const Parameters& p, const Data& d, const State<2>& s, Local<2>& out) {
    const Spring spring(p, d, s);
    out.energy = spring.energy;
    pull(out, spring.geometric * spring.w);
    stiffen(out, s.cu,
            [&](int r, int c) { return spring.k * spring.w[r] * spring.w[c] / (spring.l * spring.l); });
    return Status::ok;
  }
};

struct IgnoresFactor {
  static Status evaluate(const Parameters& p, const Data& d, const State<2>& s, Local<2>& out) {
    State<2> unscaled = s;
    unscaled.cu = 1;
    return evaluate_spring(p, d, unscaled, out);
  }
};

struct Asymmetric {  // f = k w_z² w: a force along the bar, symmetric about z, but not the gradient of an
                     // energy
  static Status evaluate(const Parameters& p, const Data&, const State<2>& s, Local<2>& out) {
    const Vec3<double> w = s.x[1] - s.x[0];
    const double g = p.EA * w.z * w.z;
    pull(out, g * w);
    stiffen(out, s.cu, [&](int r, int c) { return (r == c ? g : 0) + (c == 2 ? 2 * p.EA * w.z * w[r] : 0); });
    return Status::ok;
  }
};

struct NotConstant {
  static Status evaluate(const Parameters& p, const Data& d, const State<2>& s, Local<2>& out) {
    return evaluate_spring(p, d, s, out);
  }
};

struct ConvexNotPositive {  // gives the exact tangent, which is negative across a slack bar
  static Status evaluate(const Parameters& p, const Data& d, const State<2>& s, Local<2>& out) {
    return evaluate_spring(p, d, s, out);
  }
};

/// A spring with a convex part, and with the metric of a spring of the stiffness k·`Metric::of(spring)` in
/// all directions.
template <class Metric>
struct WithMetric {
  static Status tile(const Family<On<WithMetric>>& f, netloft_tile& t) {
    return each_lane(f, t, true, [&](std::size_t lane, Local<2>& local) {
      const Spring spring(f.parameters(t.first + lane), f.data(t.first + lane), detail::gather<2>(t, lane));
      if (!(t.want & (NETLOFT_WANT_CONVEX | NETLOFT_WANT_METRIC))) return;
      Spring part = spring;
      if (t.want & NETLOFT_WANT_METRIC) part.k = part.geometric = spring.k * Metric::of(spring);
      part.geometric = std::max(part.geometric, 0.0);
      local = {};
      stiffen(local, t.cu, [&](int r, int c) { return part.stiffness(r, c); });
    });
  }
};
struct One {
  static double of(const Spring&) { return 1; }
};
struct Half {
  static double of(const Spring&) { return 0.5; }
};
struct Growing {
  static double of(const Spring& s) { return 1 + s.l; }
};

struct CountsCalls {
  static Status evaluate(const Parameters& p, const Data& d, const State<2>& s, Local<2>& out) {
    static int calls = 0;
    evaluate_spring(p, d, s, out);
    scale(out, 1 + 1e-3 * (++calls % 1000));
    return Status::ok;
  }
};

struct WritesPastCount {
  static Status tile(const Family<On<WritesPastCount>>& f, netloft_tile& t) {
    each_lane(f, t, true, [](std::size_t, Local<2>&) {});
    for (std::size_t lane = t.count; lane < kLanes && t.force; ++lane) t.force[lane] = 0;
    return Status::ok;
  }
};

struct Overwrites {
  static Status tile(const Family<On<Overwrites>>& f, netloft_tile& t) {
    for (std::size_t i = 0; i < 6 * kLanes && t.force; ++i)
      if (i % kLanes < t.count) t.force[i] = 0;
    return each_lane(f, t, true, [](std::size_t, Local<2>&) {});
  }
};

struct KnowsLane {
  static Status tile(const Family<On<KnowsLane>>& f, netloft_tile& t) {
    return each_lane(f, t, true, [](std::size_t lane, Local<2>& l) { scale(l, lane % 2 ? 1 : 1.001); });
  }
};

struct ForceFromTangent {
  static Status tile(const Family<On<ForceFromTangent>>& f, netloft_tile& t) {
    return each_lane(f, t, true, [&](std::size_t, Local<2>& l) {
      for (auto& force : l.force) force = (t.tangent ? 1 + 1e-14 : 1) * force;
    });
  }
};

struct SloppyEnergy {
  static Status tile(const Family<On<SloppyEnergy>>& f, netloft_tile& t) {
    return each_lane(f, t, true, [&](std::size_t, Local<2>& l) { l.energy *= t.force ? 1 : 1 + 1e-14; });
  }
};

struct SharedScratch {
  /// If another thread called this function last, waits until a thread calls it again, so that threads
  /// alternate even on a busy machine.
  static void let_another_write() {
    static std::atomic<std::thread::id> writer;
    const auto self = std::this_thread::get_id();
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(20);
    if (writer.exchange(self) == self) return;
    while (writer == self && std::chrono::steady_clock::now() < end) std::this_thread::yield();
  }

  static Status evaluate(const Parameters& p, const Data& d, const State<2>& s, Local<2>& out) {
    static volatile double length;
    thread_local std::size_t calls = 0;
    length = d.rest_length + 1e-3 * s.x[0].x;
    if (calls++ % kLanes == 0) let_another_write();
    evaluate_spring(p, {d.rest_length + 1e-3 * (length - d.rest_length - 1e-3 * s.x[0].x)}, s, out);
    return Status::ok;
  }
};

struct StartsThread {
  static Status tile(const Family<On<StartsThread>>& f, netloft_tile& t) {
    std::thread([] {}).join();
    return each_lane(f, t, true, [](std::size_t, Local<2>&) {});
  }
};

struct KeepsThread : On<KeepsThread> {  // keeps a thread as long as the family lives
  struct Lanes {
    std::jthread worker;
  };
  static void pack(const Parameters&, const Data&, Lanes& lanes, std::size_t) {
    if (lanes.worker.joinable()) return;
    lanes.worker = std::jthread([](const std::stop_token& stop) {
      while (!stop.stop_requested()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    });
  }
  static Status evaluate(const Parameters& p, const Data& d, const State<2>& s, Local<2>& out) {
    return evaluate_spring(p, d, s, out);
  }
};

struct NeedsVelocity {
  static Status tile(const Family<On<NeedsVelocity>>& f, netloft_tile& t) {
    return each_lane(f, t, false, [&](std::size_t, Local<2>& l) { scale(l, t.v ? 1 : 2); });
  }
};

struct Anisotropic {
  static Status evaluate(const Parameters& p, const Data&, const State<2>& s, Local<2>& out) {
    const double k[3] = {2 * p.EA, p.EA, p.EA};
    return evaluate_diagonal(s, out, k, k);
  }
};

struct StifferUpright {
  static Status evaluate(const Parameters& p, const Data&, const State<2>& s, Local<2>& out) {
    const double k[3] = {p.EA, p.EA, 2 * p.EA};
    return evaluate_diagonal(s, out, k, k);
  }
};

struct Lopsided {  // the force on the second node is only half as large
  static Status evaluate(const Parameters& p, const Data& d, const State<2>& s, Local<2>& out) {
    evaluate_spring(p, d, s, out);
    out.force[1] = 0.5 * out.force[1];
    for (int r = 3; r < 6; ++r)
      for (double& entry : out.tangent[r]) entry *= 0.5;
    return Status::ok;
  }
};

struct LowDigitsTwice {
  static Status tile(const Family<On<LowDigitsTwice>>& f, netloft_tile& t) {
    netloft_tile there = t;
    double x[6 * kLanes];
    for (std::size_t i = 0; i < 6 * kLanes; ++i) x[i] = t.x[i] + (t.x_low ? 2 * t.x_low[i] : 0);
    there.x = x;
    return each_lane(f, there, true, [](std::size_t, Local<2>&) {});
  }
};

struct Anchored {
  template <class T>
  static T energy(const Parameters& p, const Data&, const Water&, const Points<T, 2>& x) {
    return (0.5 * p.EA) * (dot(x[1] - x[0], x[1] - x[0]) + dot(x[0], x[0]));
  }
};

struct Throws {
  static Status evaluate(const Parameters&, const Data&, const State<2>&, Local<2>&) {
    throw std::runtime_error("the author has not finished this");
  }
};

struct NotANumber {
  static Status evaluate(const Parameters& p, const Data& d, const State<2>& s, Local<2>& out) {
    evaluate_spring(p, d, s, out);
    out.force[1].y = std::sqrt(-1 - s.x[0].x * s.x[0].x);
    return Status::ok;
  }
};

struct NotANumberAtRest {
  static Status evaluate(const Parameters& p, const Data& d, const State<2>& s, Local<2>& out) {
    evaluate_spring(p, d, s, out);
    const double elongation = norm(s.x[1] - s.x[0]) - d.rest_length;
    scale(out, elongation / elongation);
    return Status::ok;
  }
};

struct InfiniteWhenCollapsed {
  template <class T>
  static T energy(const Parameters& p, const Data&, const Water&, const Points<T, 2>& x) {
    return p.EA / norm(x[1] - x[0]);
  }
};

/// Linear drag k (c - v) on both nodes, k = EA/1000. `Sign` +1 is right: the residual is minus the force.
template <int Sign, bool Moves>
struct Drag {
  static Status evaluate(const Parameters& p, const Data&, const State<2>& s, Local<2>& out) {
    const double k = Sign * 1e-3 * p.EA;
    for (std::size_t n = 0; n < 2; ++n) {
      const Vec3<double> slip = Moves ? s.current[n] - s.v[n] : s.current[n];
      out.force[n] = -k * slip;
      for (int axis = 0; axis < 3; ++axis) {
        const auto dof = 3 * n + static_cast<std::size_t>(axis);
        out.tangent[dof][3 * n + 2] -= s.cu * k * s.current_dz[n][axis];
        out.tangent[dof][dof] += Moves ? s.cv * k : 0;
      }
    }
    return Status::ok;
  }
};

/// Drag whose tangent lacks the derivative with respect to velocity if nothing moves.
struct UndampedAtRest {
  static Status tile(const Family<On<UndampedAtRest>>& f, netloft_tile& t) {
    for (std::size_t lane = 0; lane < t.count; ++lane) {
      Local<2> local;
      auto s = detail::gather<2>(t, lane);
      if (!t.v) s.cv = 0;
      Drag<1, true>::evaluate(f.parameters(t.first + lane), f.data(t.first + lane), s, local);
      detail::scatter(local, false, lane, t);
    }
    return Status::ok;
  }
};

struct GrowsWithTime {
  static Status evaluate(const Parameters& p, const Data& d, const State<2>& s, Local<2>& out) {
    evaluate_spring(p, d, s, out);
    scale(out, 1 + 0.1 * s.time);
    return Status::ok;
  }
};

struct DragAtRest {
  static Status evaluate(const Parameters& p, const Data& d, const State<2>& s, Local<2>& out) {
    return Drag<1, true>::evaluate(p, d, s, out);
  }
};

struct RefusesAll {
  static constexpr auto stencil = NETLOFT_BAR;
  using Parameters = wrong::Parameters;
  using Data = wrong::Data;
  static void check(const Parameters&, const Data&) { throw std::invalid_argument("nothing is good enough"); }
};

template <class E>
ElementTable<E>& bar(Plugin& plugin, const char* name, const char* found_by, Real EA = {.lo = 1, .hi = 1e6}) {
  auto& table = plugin.element<E>(name, found_by);
  table.real("EA", &Parameters::EA, "N", "axial stiffness", EA);
  table.data("rest_length", &Data::rest_length, "m", "unstretched length");
  return table;
}

template <class Term, std::uint32_t Traits = kPotential>
void add(Plugin& plugin, const char* name, const char* found_by) {
  bar<On<Term>>(plugin, name, found_by).template term<Term, Traits>("elastic", "what is wrong");
}

template <class Flow>
void add_flow(Plugin& plugin, const char* name, const char* found_by) {
  auto& flow = bar<FlowOn<Flow>>(plugin, name, found_by);
  flow.global("slowed", "1", "fraction of the speed that the water loses", nullptr, FlowOn<Flow>::start);
  flow.template term<typename FlowOn<Flow>::Thrust, from_outside | needs_flow | reads_current>(
      "thrust", "what is wrong");
}

struct NeverMade {
  static Status evaluate(const Parameters& p, const Data& d, const State<2>& s, Local<2>& out) {
    return evaluate_spring(p, d, s, out);
  }
};
struct BadDefault : NeverMade {};

/// A spring that is as stiff in compression as in tension, but reports a member without stiffness in
/// compression.
struct ForgetsCompression : NeverMade {
  static constexpr auto stencil = NETLOFT_BAR;
  using Parameters = wrong::Parameters;
  using Data = wrong::Data;
  static std::array<Member, 1> members(const Parameters& p, const Data& d, double) {
    return {{{{-1, 1, 0}, d.rest_length, p.EA, 0, 1}}};
  }
};

}  // namespace

NETLOFT_PLUGIN("wrong", "1", "Elements that are wrong in one place each") {
  add<WithMetric<One>, kPotential | has_convex | has_metric>(plugin, "right", "nothing");
  add<ForceSign>(plugin, "force_sign", "force-is-gradient");
  add<ComponentDoubled>(plugin, "component_doubled", "force-is-gradient");
  add<EnergyDoubled>(plugin, "energy_doubled", "force-is-gradient");
  add<EnergyJumps>(plugin, "energy_jumps", "no-work-round-a-closed-path");
  add<NoGeometricPart>(plugin, "no_geometric_part", "tangent-is-derivative");
  add<IgnoresFactor>(plugin, "ignores_factor", "tangent-is-derivative");
  add<Asymmetric, symmetric>(plugin, "asymmetric", "symmetric-where-claimed");
  add<NotConstant, kPotential | constant>(plugin, "not_constant", "constant-where-claimed");
  add<ConvexNotPositive, kPotential | has_convex>(plugin, "convex_not_positive", "convex-is-positive");
  add<WithMetric<Half>, kPotential | has_convex | has_metric>(plugin, "metric_too_small",
                                                              "metric-bounds-convex");
  add<WithMetric<Growing>, kPotential | has_convex | has_metric>(plugin, "metric_moves",
                                                                 "metric-is-constant");
  add<CountsCalls>(plugin, "counts_calls", "no-hidden-state");
  add<GrowsWithTime>(plugin, "undeclared_time", "reads-the-inputs-it-declares");
  add<WritesPastCount>(plugin, "writes_past_count", "nothing-written-past-count");
  add<Overwrites>(plugin, "overwrites", "adds-not-overwrites");
  add<KnowsLane>(plugin, "knows_lane", "same-in-any-lane");
  add<ForceFromTangent>(plugin, "force_from_tangent", "same-force-without-tangent");
  add<SloppyEnergy>(plugin, "sloppy_energy", "same-energy-alone");
  add<SharedScratch>(plugin, "shared_scratch", "same-from-two-threads");
  add<StartsThread>(plugin, "starts_thread", "starts-no-threads");
  add<NeedsVelocity, reads_velocity>(plugin, "needs_velocity", "missing-inputs-are-zero");
  add<Anisotropic>(plugin, "anisotropic", "rotation-turns-the-force");
  add<StifferUpright>(plugin, "stiffer_upright", "moments-sum-to-zero");
  add<Lopsided, 0>(plugin, "lopsided", "forces-sum-to-zero");
  add<Anchored>(plugin, "anchored", "translation-changes-nothing");
  add<LowDigitsTwice>(plugin, "low_digits_twice", "low-digits-ignored-or-taken");
  add<Throws>(plugin, "throws", "evaluates-without-error");
  add<NotANumber>(plugin, "not_a_number", "outputs-finite");
  add<NotANumberAtRest>(plugin, "not_a_number_at_rest", "finite-at-rest");
  add<InfiniteWhenCollapsed>(plugin, "infinite_when_collapsed", "collapsed-finite");
  add<Drag<1, true>, kWater>(plugin, "right_in_water", "nothing");
  add<Drag<-1, true>, kWater>(plugin, "gains_energy", "never-gains-energy");
  add<UndampedAtRest, kWater>(plugin, "undamped_at_rest", "missing-inputs-are-zero");
  add<Drag<1, false>, kWater>(plugin, "ignores_motion", "no-force-without-flow");
  add_flow<RightFlow>(plugin, "right_flow", "nothing");
  add_flow<SlowsEverywhere>(plugin, "slows_everywhere", "water-is-undisturbed-out-of-reach");
  add_flow<SlowsInSteps>(plugin, "slows_in_steps", "water-has-its-derivatives");
  add_flow<SlowsTheNorth>(plugin, "slows_the_north", "water-turns-with-the-current");
  add_flow<TakesSides>(plugin, "takes_sides", "water-turns-with-the-current");
  add_flow<RisesInStillWater>(plugin, "rises_in_still_water", "still-water-stays-still");
  add_flow<LosesHalfTheMomentum>(plugin, "loses_half_the_momentum", "lost-momentum-is-the-drag");
  add_flow<FacesEast>(plugin, "faces_east", "mouth-is-the-same-in-any-frame");
  add_flow<CountsBars>(plugin, "counts_bars", "finer-rims-converge");
  add<DragAtRest, reads_current | needs_flow>(plugin, "undeclared_velocity", "reads-the-inputs-it-declares");
  auto& by_law = bar<DragByLaw>(plugin, "drag_by_law", "says-how-much-it-stands-for");
  by_law.law("drag", NETLOFT_TWINE_LAW, "hydro/morison", "force of the water");
  by_law.term<DragByLaw::Term, kWater>("drag", "right");
  bar<KeepsThread>(plugin, "keeps_thread", "starts-no-threads")
      .term<KeepsThread, kPotential>("elastic", "right");
  bar<RefusesAll>(plugin, "refuses_all", "makes-elements").term<NeverMade, kPotential>("elastic", "unused");
  bar<On<BadDefault>>(plugin, "bad_default", "defaults-are-allowed", {.lo = 1, .hi = 1e6, .fallback = 0})
      .term<BadDefault, kPotential>("elastic", "right");
  bar<ForgetsCompression>(plugin, "forgets_compression", "members-make-their-term")
      .term<NeverMade, kPotential | of_members>("elastic", "right");
}
