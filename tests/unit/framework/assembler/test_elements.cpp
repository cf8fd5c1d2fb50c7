// SPDX-License-Identifier: BSD-3-Clause
//
// These elements have a file of their own, because the headers for authors and those of the host have
// different types with the same names (Water, Family).
#include <netloft/element.hpp>

#include <cmath>
#include <stdexcept>

namespace netloft::test {

const netloft_plugin* test_plugin();

namespace {

struct BarData {
  double rest_length = 0;
};

/// A force without a potential on the second node, with the residual f = k (w × e): w is the vector from the
/// first node to the second, e = (1, 2, 3).
struct Follower {
  static constexpr auto stencil = NETLOFT_BAR;
  struct Parameters {
    double k = 0;  // [N/m]
  };
  using Data = BarData;
  struct Push {
    static Status evaluate(const Parameters& p, const Data&, const State<2>& s, Local<2>& out) {
      const Vec3<double> w = s.x[1] - s.x[0], e{1, 2, 3};
      out.force[1] += p.k * cross(w, e);
      const double turn[3][3] = {{0, e.z, -e.y}, {-e.z, 0, e.x}, {e.y, -e.x, 0}};  // w × e = turn w
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) {
          out.tangent[3 + r][c] -= s.cu * p.k * turn[r][c];
          out.tangent[3 + r][3 + c] += s.cu * p.k * turn[r][c];
        }
      return Status::ok;
    }
  };
};

/// A spring with the energy E = k (‖w‖² − l₀²)² / (8 l₀²). It softens in compression, so that its tangent
/// becomes indefinite.
struct Spring {
  static constexpr auto stencil = NETLOFT_BAR;
  struct Parameters {
    double k = 0;  // [N/m]
  };
  using Data = BarData;
  struct Elastic {
    template <class T>
    static T energy(const Parameters& p, const Data& d, const Water&, const Points<T, 2>& x) {
      const Vec3<T> w = x[1] - x[0];
      const T strain = dot(w, w) - d.rest_length * d.rest_length;
      return (p.k / (8 * d.rest_length * d.rest_length)) * strain * strain;
    }
  };
};

/// A spring with the energy E = ½ k ‖w‖², not defined for bars longer than `limit`.
struct Picky {
  static constexpr auto stencil = NETLOFT_BAR;
  struct Parameters {
    double limit = 0;  // [m]
    bool broken = false;
  };
  using Data = BarData;
  struct Pull {
    template <class T>
    static T energy(const Parameters& p, const Data&, const Water&, const Points<T, 2>& x) {
      const Vec3<T> w = x[1] - x[0];
      if (p.broken) throw std::runtime_error("this one never works");
      if (dot(w, w) > T(p.limit * p.limit)) throw OutsideDomain("longer than its limit");
      return 0.5 * dot(w, w);
    }
  };
};

/// A spring with the energy E = ½ k (‖w‖² − q)². q is shared by all bars of a part: an unknown if `free` is
/// set, otherwise 4 m².
struct Alike {
  static constexpr auto stencil = NETLOFT_BAR;
  static constexpr int globals = 1;
  struct Parameters {
    double k = 0, free = 0;
  };
  using Data = BarData;
  struct Whole {
    double bars = 0;
  };
  static void gather(const Parameters&, const Data&, Whole& whole) { ++whole.bars; }
  struct Pull {
    template <class T>
    static T energy(const Parameters& p, const Data&, const Water&, const Points<T, 3>& x) {
      const Vec3<T> w = x[1] - x[0];
      const T lack = dot(w, w) - x[2].x;
      return (0.5 * p.k) * lack * lack;
    }
  };
};

/// A constant force F, with the energy E = −F·x.
struct Load {
  static constexpr auto stencil = NETLOFT_NODE;
  struct Parameters {
    double x = 0, y = 0, z = 0;  // F [N]
  };
  struct Data {};
  struct Force {
    template <class T>
    static T energy(const Parameters& p, const Data&, const Water&, const Points<T, 1>& x) {
      return -(p.x * x[0].x + p.y * x[0].y + p.z * x[0].z);
    }
  };
};

/// A residual f = k (x - a) along x, where a is the position at the last remembered step. It is not defined
/// beyond x = 1000. Ground that moves past the node drags it along with a force of k times the velocity of
/// the ground.
struct Leash {
  static constexpr auto stencil = NETLOFT_NODE;
  struct Parameters {
    double k = 0;  // [N/m]
  };
  struct Data {};
  struct Pull {
    static Status tile(const Family<Leash>& family, netloft_tile& t) {
      for (std::size_t i = 0; i < t.count; ++i) {
        t.lane_at_fault = static_cast<std::uint32_t>(i);
        if (t.x[i] > 1000) return Status::outside_domain;
        const double k = family.parameters(t.first + i).k;
        const double* ground = ground_of(t);
        double* state_new = new_state_of(t);
        if (t.force) t.force[i] += ground ? -k * ground[0] : k * (t.x[i] - state_of(t)[i]);
        if (state_new) state_new[i] = t.x[i], state_new[kLanes + i] += 1;
      }
      return Status::ok;
    }
  };
};

/// A body with a mass at one point and a plate at another. The force on the plate grows with the square of
/// the water's velocity relative to it.
struct Vane {
  static constexpr auto stencil = NETLOFT_BODY;
  struct Parameters {
    double mass = 0, inertia = 0, drag = 0;  // [kg], [kg m2], [N s2/m2]
  };
  struct Data {};
  static Vec3<double> centre() { return {0.2, -0.1, -0.3}; }
  static Vec3<double> plate() { return {0.5, 0.1, 0.2}; }

  struct Weight {
    template <class T>
    static T energy(const Parameters& p, const Data&, const Water& w, const Pose<T>& pose) {
      return (p.mass * w.gravity) * pose.point(centre()).z;
    }
  };
  struct Push {
    template <class T>
    static Wrench<T> force(const Parameters& p, const Data&, const Body<T>& b) {
      const Vec3<T> W = b.current_at(plate()) - b.velocity(plate());
      const T along = dot(W, b.axes[1]);
      Wrench<T> push;
      push.push(p.drag * norm(W) * (along * b.axes[1]), b.to_world(plate()));
      return push;
    }
  };
  /// A sphere about the centre of mass, with mass m and moment of inertia J.
  struct Inertia {
    template <class T>
    static Wrench<T> force(const Parameters& p, const Data&, const Body<T>& b) {
      const Vec3<T> r = b.to_world(centre());
      const Vec3<T> a = b.a + cross(b.alpha, r) + cross(b.omega, cross(b.omega, r));
      Wrench<T> push;
      push.push(T(-p.mass) * a, r);
      push.moment += T(-p.inertia) * b.alpha;
      return push;
    }
  };
};

void describe(Plugin& plugin) {
  auto& vane = plugin.element<Vane>("vane", "A body with a mass and a plate");
  vane.real("mass", &Vane::Parameters::mass, "kg", "mass, at a place of its own", {.fallback = 0});
  vane.real("inertia", &Vane::Parameters::inertia, "kg m2", "moment of inertia", {.fallback = 0});
  vane.real("drag", &Vane::Parameters::drag, "N s2/m2", "of the plate", {.fallback = 0});
  vane.term<Vane::Weight, needs_gravity>("weight", "weight of the mass");
  vane.term<Vane::Push, reads_velocity | reads_current | needs_flow>("push", "push of the water");
  vane.term<Vane::Inertia, reads_velocity | reads_acceleration | needs_motion>("inertia", "of the mass");
  vane.output("speed", "m/s", "of the water past the plate", [](auto&, auto&, const Body<double>& b) {
    return norm(b.current_at(Vane::plate()) - b.velocity(Vane::plate()));
  });

  auto& follower = plugin.element<Follower>("follower", "Pushes sideways and turns with the bar");
  follower.real("k", &Follower::Parameters::k, "N/m", "push per length", {});
  follower.data("rest_length", &BarData::rest_length, "m", "not used");
  follower.term<Follower::Push>("push", "sideways push");

  auto& spring = plugin.element<Spring>("spring", "Quartic spring");
  spring.real("k", &Spring::Parameters::k, "N/m", "stiffness at rest", {});
  spring.data("rest_length", &BarData::rest_length, "m", "length without force");
  spring.term<Spring::Elastic>("elastic", "pull of the spring");

  auto& picky = plugin.element<Picky>("picky", "Refuses to be long");
  picky.real("limit", &Picky::Parameters::limit, "m", "longest bar", {});
  picky.boolean("broken", &Picky::Parameters::broken, "fails whatever its length", false);
  picky.data("rest_length", &BarData::rest_length, "m", "not used");
  picky.term<Picky::Pull>("pull", "pull of the spring");

  auto& alike = plugin.element<Alike>("alike", "Bars that want to be of one length");
  alike.real("k", &Alike::Parameters::k, "N/m3", "stiffness", {});
  alike.real("free", &Alike::Parameters::free, "1", "whether the length is an unknown", {.fallback = 0});
  alike.data("rest_length", &BarData::rest_length, "m", "not used");
  alike.global("square", "m2", "square of the length", "free",
               [](const Alike::Parameters&, const Alike::Whole& whole) { return 2 * whole.bars; });
  alike.term<Alike::Pull>("pull", "pull of the bar");

  auto& leash = plugin.element<Leash>("leash", "Pulls back to where it was");
  leash.real("k", &Leash::Parameters::k, "N/m", "stiffness", {});
  leash.remembers(2);
  leash.term<Leash::Pull, reads_state | reads_ground | from_outside>("pull", "pull of the leash");

  auto& load = plugin.element<Load>("load", "A constant force");
  load.real("x", &Load::Parameters::x, "N", "force along x", {.fallback = 0});
  load.real("y", &Load::Parameters::y, "N", "force along y", {.fallback = 0});
  load.real("z", &Load::Parameters::z, "N", "force along z", {.fallback = 0});
  load.term<Load::Force, constant | from_outside>("force", "the force");
}

}  // namespace

const netloft_plugin* test_plugin() {
  return detail::describe_once<&describe>("test", "1", "Elements for tests");
}

}  // namespace netloft::test
