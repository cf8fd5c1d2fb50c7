// SPDX-License-Identifier: BSD-3-Clause
//
// Inputs and results of elements on a rigid body. Included by element.hpp.
#pragma once
#include <netloft/rotation.hpp>
#include <netloft/state.hpp>

namespace netloft {

/// Position and rotation of a body: its origin, and its axes as unit vectors of the world (the columns of the
/// rotation matrix). T is double or a dual number.
template <class T>
struct Pose {
  Vec3<T> x;                    // origin [m]
  std::array<Vec3<T>, 3> axes;  // unit vectors

  /// Converts a vector from the axes of the body to the axes of the world.
  template <class S>
  Vec3<T> to_world(const Vec3<S>& r) const {
    return r.x * axes[0] + r.y * axes[1] + r.z * axes[2];
  }
  /// Converts a vector from the axes of the world to the axes of the body.
  Vec3<T> to_body(const Vec3<T>& w) const { return {dot(axes[0], w), dot(axes[1], w), dot(axes[2], w)}; }
  /// Position of a point r of the body [m].
  template <class S>
  Vec3<T> point(const Vec3<S>& r) const {
    return x + to_world(r);
  }
};

/// A body in motion, in the axes of the world. Inputs that the term does not request by a trait (`Trait` in
/// element.hpp) are zero.
template <class T>
struct Body : Pose<T> {
  Vec3<T> v, omega;  // velocity of the origin [m/s], spin [rad/s]
  Vec3<T> a, alpha;  // acceleration of the origin [m/s²], rate of the spin [rad/s²]
  Vec3<T> current;   // velocity of the water at the origin [m/s]
  Vec3<double> current_dz, ground{};
  Bed bed{};  // the bed below the origin
  Water water{};
  double time = 0;

  /// Velocity of a point r of the body [m/s].
  template <class S>
  Vec3<T> velocity(const Vec3<S>& r) const {
    return v + cross(omega, this->to_world(r));
  }
  /// Velocity of the water at a point r of the body [m/s], extrapolated from the origin linearly in depth.
  template <class S>
  Vec3<T> current_at(const Vec3<S>& r) const {
    const T height = this->to_world(r).z;
    return current + Vec3<T>{current_dz.x * height, current_dz.y * height, current_dz.z * height};
  }
};

/// The force [N] that acts on a body, and its moment [N m] about the body's origin, in the axes of the world.
template <class T>
struct Wrench {
  Vec3<T> force, moment;

  /// Adds a force that acts at origin + lever; both vectors are in the axes of the world.
  void push(const Vec3<T>& f, const Vec3<T>& lever) {
    force += f;
    moment += cross(lever, f);
  }
};

/// The nodes of an element in motion: the argument of a term's `force`, which is differentiated
/// automatically. Inputs that the term does not request by a trait (`Trait` in element.hpp) are zero.
template <class T, int Nodes>
struct MovingNodes {
  Points<T, Nodes> x, v, a, current;
  Vec3<double> ground{};
  std::array<Bed, Nodes> bed{};  // the bed below the nodes
  Water water{};
  double time = 0;
};

}  // namespace netloft
