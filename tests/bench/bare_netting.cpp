// SPDX-License-Identifier: BSD-3-Clause
//
// priour/triangle with tension and weight only. idle_terms.cpp compares the cost of this triangle and of the
// full one in a scene that needs no other terms.
#include "plugins/priour/triangle.hpp"

using netloft::priour::Triangle;

NETLOFT_PLUGIN("bare", "0.1.0", "Netting without the terms that such a scene does not need") {
  auto& t = plugin.element<Triangle>("triangle", "Triangle of netting, tension and weight alone");
  t.real("twine.EA", &Triangle::Parameters::EA, "N", "axial stiffness of one twine", {.lo = 0, .hi = 1e9});
  t.real("twine.EA_compression", &Triangle::Parameters::EA_compression, "N",
         "axial stiffness of a slack twine", {.lo = 0, .hi = 1e9});
  t.real("twine.diameter", &Triangle::Parameters::diameter, "m", "diameter of one twine", {.lo = 0, .hi = 1});
  t.real("twine.density", &Triangle::Parameters::density, "kg/m3", "density of the twine",
         {.lo = 0, .hi = 3e4});
  t.data("u", &Triangle::Data::u, "1", "twine coordinate of the corners along u, in bars");
  t.data("v", &Triangle::Data::v, "1", "twine coordinate of the corners along v, in bars");
  t.data("bar_length", &Triangle::Data::bar_length, "m", "unstretched length of a bar, from knot to knot");
  t.term<Triangle::Elastic, netloft::conservative | netloft::symmetric | netloft::has_convex |
                                netloft::has_metric>("elastic", "tension");
  t.term<Triangle::Weight, netloft::conservative | netloft::symmetric | netloft::constant |
                               netloft::needs_gravity>("weight", "weight");
}
