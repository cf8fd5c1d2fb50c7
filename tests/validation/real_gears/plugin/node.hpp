// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/element.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace netloft::femnet {

/// FEMNET's forces on a node; s is their multiple (one half on a plane of symmetry):
///   E = −s (F·x − m g z)                                              force and weight        (1)
///   E = s ρ_w g A Z,  −dZ/dz = clamp(top − z, 0, H)                   buoyant box             (2)
///   E = s ½ k Σ p²,  p = limit − coordinate where that is violated    penalty on coordinates  (3)
///   r = −s μ k p_z Ĉ                                                  friction of a bed       (4)
/// F [N], m [kg]; A = |b_x b_y| [m²] and H = |b_z| [m] of the box, whose middle is at the node, or its upper
/// face if b_z < 0; k [N/m], μ [1]; Ĉ the direction of the current: friction has a fixed direction and does
/// not wait for a node to slip. Source: FEMNET (D. Priour), nodes of its .mdg files.
struct Node {
  static constexpr auto stencil = NETLOFT_NODE;

  struct Parameters {
    double stiffness = 0, friction = 0;  // k, μ
  };
  struct Data {
    std::array<double, 3> force{}, box{}, limit{},
        sense{};  // sense +1: at least the limit, -1: at most, 0: none
    double mass = 0, share = 1;
  };

  /// p of (3) along an axis.
  static double violation(const Data& d, int axis, double x) {
    const auto a = static_cast<std::size_t>(axis);
    return d.sense[a] == 0 ? 0 : d.sense[a] * std::max(0.0, d.sense[a] * (d.limit[a] - x));
  }

  struct Load {
    static Status tile(const Family<Node>& family, netloft_tile& t);
  };
  struct Buoyancy {
    static Status tile(const Family<Node>& family, netloft_tile& t);
  };
  struct Limit {
    static Status tile(const Family<Node>& family, netloft_tile& t);
  };
  struct Friction {
    static Status tile(const Family<Node>& family, netloft_tile& t);
  };
};

}  // namespace netloft::femnet
