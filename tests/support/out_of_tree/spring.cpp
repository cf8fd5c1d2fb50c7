// SPDX-License-Identifier: BSD-3-Clause
#include <netloft/element.hpp>

/// A spring that gets stiffer as it stretches:  E = k/2 (l - l0)^2 + c/4 (l - l0)^4
struct Spring {
  static constexpr auto stencil = NETLOFT_BAR;
  struct Parameters {
    double k = 0, c = 0;
  };
  struct Data {
    double rest_length = 0;
  };
  struct Elastic {
    template <class T>
    static T energy(const Parameters& p, const Data& d, const netloft::Water&,
                    const netloft::Points<T, 2>& x) {
      const T e = norm(x[1] - x[0]) - d.rest_length;
      if (e <= T(-0.999999 * d.rest_length)) throw netloft::OutsideDomain("a spring of no length");
      return 0.5 * p.k * e * e + 0.25 * p.c * e * e * e * e;
    }
  };
};

NETLOFT_PLUGIN("spring", "1.0", "Springs from somewhere else") {
  auto& e = plugin.element<Spring>("spring", "Spring that stiffens");
  e.real("k", &Spring::Parameters::k, "N/m", "stiffness", {.lo = 0, .hi = 1e6});
  e.real("c", &Spring::Parameters::c, "N/m3", "stiffening", {.lo = 0, .hi = 1e6, .fallback = 0});
  e.data("rest_length", &Spring::Data::rest_length, "m", "unstretched length");
  e.term<Spring::Elastic>("elastic", "pull of the spring");
}
