// SPDX-License-Identifier: BSD-3-Clause
//
// Elements on rigid bodies that are wrong in one place each, as in wrong.cpp: the description of an element
// is the name of the check that must fail.
#include <netloft/element.hpp>

using namespace netloft;

namespace {

/// A plate and a mass, each at an arm from the origin. On the other side of a gear, both arms have the
/// opposite y.
struct Board {
  static constexpr auto stencil = NETLOFT_BODY;
  struct Parameters {
    double drag = 0, mass = 0;
  };
  struct Data {
    double side = 1;
  };
};
using P = Board::Parameters;
using D = Board::Data;

Vec3<double> mass_at(const D& d) { return {0.2, 0.3 * d.side, -0.4}; }
Vec3<double> plate_at(const D& d) { return {-0.5, 0.2 * d.side, 0.3}; }

/// The element of one term: every term gets an element, and thereby a table, of its own.
template <class Term>
struct On : Board {};

struct Weight {
  template <class T>
  static T energy(const P& p, const D& d, const Water& w, const Pose<T>& pose) {
    return (p.mass * w.gravity) * pose.point(mass_at(d)).z;
  }
};

template <class T>
Wrench<T> push_of_water(const P& p, const D& d, const Body<T>& b) {
  const Vec3<T> W = b.current_at(plate_at(d)) - b.velocity(plate_at(d));
  Wrench<T> push;
  push.push(p.drag * (norm(W) * W + dot(W, b.axes[1]) * b.axes[1]), b.to_world(plate_at(d)));
  return push;
}
struct Push {
  template <class T>
  static Wrench<T> force(const P& p, const D& d, const Body<T>& b) {
    return push_of_water(p, d, b);
  }
};

template <class T>
Wrench<T> inertia_of_mass(const P& p, const D& d, const Body<T>& b, bool turns) {
  const Vec3<T> r = b.to_world(mass_at(d));
  Vec3<T> a = b.a + cross(b.alpha, r);
  if (turns) a += cross(b.omega, cross(b.omega, r));
  Wrench<T> push;
  push.push(T(-p.mass) * a, r);
  push.moment += T(-p.mass) * b.alpha;
  return push;
}
struct Inertia {
  template <class T>
  static Wrench<T> force(const P& p, const D& d, const Body<T>& b) {
    return inertia_of_mass(p, d, b, true);
  }
};
struct InertiaOfWhatDoesNotTurn {
  template <class T>
  static Wrench<T> force(const P& p, const D& d, const Body<T>& b) {
    return inertia_of_mass(p, d, b, false);
  }
};

/// The weight, but with twice its moment in the residual.
struct DoubledMoment {
  static Status evaluate(const P& p, const D& d, const State<2>& s, Local<2>& out) {
    using T = Dual<6>;
    Points<T, 2> x;
    for (int i = 0; i < 6; ++i)
      x[static_cast<std::size_t>(i / 3)][i % 3] = T::variable(s.x[static_cast<std::size_t>(i / 3)][i % 3], i);
    const T e = Weight::energy(p, d, s.water, detail::pose_of(x[0], x[1]));
    out.energy = e.value;
    std::size_t k = 0;
    for (int r = 0; r < 6; ++r) {
      const double factor = r < 3 ? 1 : 2;
      out.force[static_cast<std::size_t>(r / 3)][r % 3] = factor * e.gradient[static_cast<std::size_t>(r)];
      for (int c = 0; c <= r; ++c, ++k) out.tangent[r][c] = out.tangent[c][r] = factor * s.cu * e.hessian[k];
    }
    return Status::ok;
  }
};

/// The push, but its tangent lacks the derivatives with respect to the rate of rotation.
struct ForgetsSpin {
  static Status tile(const Family<On<ForgetsSpin>>& f, netloft_tile& t) {
    for (std::size_t lane = 0; lane < t.count; ++lane) {
      Local<2> local;
      detail::differentiate_force<On<Push>, Push>(reinterpret_cast<const Family<On<Push>>&>(f),
                                                  t.first + lane, t, lane, local);
      netloft_tile still = t;
      still.cv = 0;
      Local<2> without;
      detail::differentiate_force<On<Push>, Push>(reinterpret_cast<const Family<On<Push>>&>(f),
                                                  t.first + lane, still, lane, without);
      for (int r = 0; r < 6; ++r)
        for (int c = 3; c < 6; ++c) local.tangent[r][c] = without.tangent[r][c];
      detail::scatter(local, false, lane, t);
    }
    return Status::ok;
  }
};

/// A force along the body's own axis that increases with the length of the rotation vector.
struct CountsTurns {
  static Status evaluate(const P& p, const D&, const State<2>& s, Local<2>& out) {
    using T = Dual<6, 1>;
    Vec3<T> psi;
    for (int k = 0; k < 3; ++k) psi[k] = T::variable(s.x[1][k], 3 + k);
    const Vec3<T> force = T(p.drag) * dot(psi, psi) * turned_axes(psi)[0];
    for (int r = 0; r < 3; ++r) {
      out.force[0][r] = force[r].value;
      for (int c = 0; c < 6; ++c) out.tangent[r][c] = s.cu * force[r].gradient[static_cast<std::size_t>(c)];
    }
    return Status::ok;
  }
};

struct KnowsTheCompass {
  template <class T>
  static Wrench<T> force(const P& p, const D&, const Body<T>& b) {
    return {T(p.drag) * b.axes[0].x * b.axes[0], {}};
  }
};

struct OneSided {
  template <class T>
  static Wrench<T> force(const P& p, const D&, const Body<T>& b) {
    return push_of_water(p, {1}, b);
  }
};

/// `found_by` is the check that must fail.
template <class Term, std::uint32_t Traits>
void add(Plugin& plugin, const char* name, const char* found_by) {
  auto& table = plugin.element<On<Term>>(name, found_by);
  table.real("drag", &P::drag, "N s2/m2", "of the plate", {.lo = 1, .hi = 1e4});
  table.real("mass", &P::mass, "kg", "mass", {.lo = 1, .hi = 1e3});
  table.data("side", &D::side, "1", "1, or -1 on the other side");
  table.template term<Term, Traits>("force", "what is wrong");
}

constexpr auto kWater = reads_current | reads_velocity | needs_flow;
constexpr auto kInertia = reads_velocity | reads_acceleration | needs_motion;

}  // namespace

NETLOFT_PLUGIN("wrong_bodies", "1", "Elements on bodies that are wrong in one place each") {
  add<Weight, needs_gravity>(plugin, "weight", "nothing");
  add<Push, kWater>(plugin, "push", "nothing");
  add<Inertia, kInertia>(plugin, "inertia", "nothing");
  add<DoubledMoment, conservative | symmetric | needs_gravity>(plugin, "doubled_moment", "force-is-gradient");
  add<ForgetsSpin, kWater>(plugin, "forgets_spin", "tangent-is-derivative");
  add<CountsTurns, 0>(plugin, "counts_turns", "full-turns-change-nothing");
  add<KnowsTheCompass, 0>(plugin, "knows_the_compass", "body-turns-with-the-world");
  add<OneSided, kWater>(plugin, "one_sided", "sides-mirror-each-other");
  add<InertiaOfWhatDoesNotTurn, kInertia>(plugin, "does_not_turn", "inertia-makes-kinetic-energy");
}
