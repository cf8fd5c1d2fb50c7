// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/element.hpp>

#include <array>

namespace netloft::forces {

/// A constant force at a node, independent of the shape of the gear, such as that of an otter board or a
/// winch that is not modelled.
///   E = −s F·x,  r = −s F                                                 (1)
/// F [N] is the force in the axes of the world. s is the number of such forces at the node: ½ if the node
/// lies in the plane of symmetry of a gear of which one half is modelled.
struct Constant {
  static constexpr auto stencil = NETLOFT_NODE;

  struct Parameters {
    double x = 0, y = 0, z = 0;  // force F [N]
  };
  struct Data {
    double pieces = 0;  // number s of forces
  };

  static void check(const Parameters&, const Data& d);

  struct Pull {
    static Status evaluate(const Parameters& p, const Data& d, const State<1>& s, Local<1>& out);
  };
};

}  // namespace netloft::forces
