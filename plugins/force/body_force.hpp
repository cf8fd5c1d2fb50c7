// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/element.hpp>

#include <array>

namespace netloft::forces {

/// A force that acts on a rigid body and rotates with it, such as the force of a fin or a thruster, or one
/// that was measured in the axes of a board.
///   f = R F,   m = r × f                                                (1)
/// F [N] is the force in the axes of the body, with y outward on either side of a gear; R is the rotation of
/// the body, r the lever from its origin to the point of action, m the moment. The force has no potential,
/// because its work depends on the path.
struct OnBody {
  static constexpr auto stencil = NETLOFT_BODY;

  struct Parameters {
    double x = 0, y = 0, z = 0;  // force F [N]
  };
  struct Data {
    double side = 1;              // 1 to starboard, -1 to port
    std::array<double, 3> arm{};  // point of action, in the axes of a body to starboard [m]
  };

  struct Push {
    template <class T>
    static Wrench<T> force(const Parameters& p, const Data& d, const Body<T>& b) {
      Wrench<T> push;
      push.push(b.to_world(Vec3<double>{p.x, d.side * p.y, p.z}),
                b.to_world(Vec3<double>{d.arm[0], d.side * d.arm[1], d.arm[2]}));  // (1)
      return push;
    }
  };
};

}  // namespace netloft::forces
