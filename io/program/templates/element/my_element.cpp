// SPDX-License-Identifier: BSD-3-Clause
#include <netloft/element.hpp>

/// A spring whose stiffness increases with its elongation e:
///   E = k/2 e² + c/4 e⁴,  e = l − l₀                                     (1)
/// l, l₀ [m] length now and without load; k [N/m], c [N/m³]. Force and tangent are the derivatives of E.
struct MyElement {
  static constexpr auto stencil = NETLOFT_BAR;  // an element with two nodes

  struct Parameters {  // set by users, once for every part of a gear
    double k = 0, c = 0;
  };
  struct Data {  // data of one element
    double rest_length = 0;
  };
  struct Elastic {
    template <class T>
    static T energy(const Parameters& p, const Data& d, const netloft::Water&,
                    const netloft::Points<T, 2>& x) {
      const T e = norm(x[1] - x[0]) - d.rest_length;
      if (e <= T(-0.999999 * d.rest_length)) throw netloft::OutsideDomain("a spring of no length");
      return 0.5 * p.k * e * e + 0.25 * p.c * e * e * e * e;  // (1)
    }
  };
};

NETLOFT_PLUGIN("my_element", "0.1", "Springs that stiffen") {
  auto& e = plugin.element<MyElement>("my_element", "Spring that gets stiffer as it is stretched");
  e.real("k", &MyElement::Parameters::k, "N/m", "stiffness at rest", {.lo = 0, .hi = 1e6});
  e.real("c", &MyElement::Parameters::c, "N/m3", "stiffening", {.lo = 0, .hi = 1e6, .fallback = 0});
  e.data("rest_length", &MyElement::Data::rest_length, "m", "length without load");
  e.term<MyElement::Elastic>("elastic", "pull of the spring");
}
