// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/priour/drag.hpp"
#include "plugins/priour/knot_contact.hpp"
#include "plugins/priour/netting_bending.hpp"
#include "plugins/priour/netting_motion.hpp"
#include "plugins/priour/opening.hpp"
#include "plugins/priour/slowed.hpp"

using namespace netloft::priour;

NETLOFT_PLUGIN("priour", "0.1.0", "Netting as Priour's triangles") {
  auto& t = plugin.element<Triangle>("triangle", "Triangle of netting with straight, parallel twines inside");
  t.real("twine.EA", &Triangle::Parameters::EA, "N", "axial stiffness of one twine",
         {.lo = 0, .hi = 1e12, .role = netloft::Role::stiffness});
  t.real("twine.EA_compression", &Triangle::Parameters::EA_compression, "N",
         "axial stiffness of a slack twine",
         {.lo = 0, .hi = 1e12, .fallback = 0, .role = netloft::Role::compression});
  t.real("twine.diameter", &Triangle::Parameters::diameter, "m", "diameter of one twine", {.lo = 0, .hi = 1});
  t.real("twine.density", &Triangle::Parameters::density, "kg/m3", "density of the twine's material",
         {.lo = 0, .hi = 1e6});
  t.real("twine.EI", &Triangle::Parameters::EI, "N m2", "bending stiffness of one twine",
         {.lo = 0, .hi = 1e6, .fallback = 0, .role = netloft::Role::stiffness});
  t.real(
      "twine.opening_stiffness", &Triangle::Parameters::opening_stiffness, "N m/rad",
      "couple per radian with which a knot resists opening of its meshes, on each twine; instead of twine.EI",
      {.lo = 0, .hi = 1e6, .fallback = 0, .role = netloft::Role::stiffness});
  t.real("twine.opening_angle", &Triangle::Parameters::opening_angle, "rad",
         "half angle between the twines of an unloaded mesh", {.lo = 0, .hi = 1.5707, .fallback = 0});
  t.real("twine.knot_size", &Triangle::Parameters::knot_size, "m",
         "knots of this size touch when a mesh closes; 0: meshes close completely",
         {.lo = 0, .hi = 10, .fallback = 0});
  t.real("twine.damping", &Triangle::Parameters::damping, "N s",
         "damping of stretch: tension per strain rate, EA times a relaxation time",
         {.lo = 0, .hi = 1e9, .fallback = 0, .role = netloft::Role::damping});
  t.real("twine.loss_factor", &Triangle::Parameters::loss_factor, "1",
         "loss factor: energy that an oscillating taut twine loses per radian, over its elastic energy",
         {.lo = 0, .hi = 1, .fallback = 0});
  t.real("twine.loss_frequency", &Triangle::Parameters::loss_frequency, "Hz",
         "frequency of the oscillations for which the loss factor is given",
         {.lo = 1e-3, .hi = 1e4, .fallback = 10});
  t.real("twine.added_mass", &Triangle::Parameters::added_mass, "1",
         "added mass across a twine over the mass of the water it displaces",
         {.lo = 0, .hi = 10, .fallback = 1});
  t.integer("twine.number", &Triangle::Parameters::number,
            "twines side by side in every bar: 2 in double netting", 1, 9, 1);
  t.real("twine.surface", &Triangle::Parameters::surface, "1",
         "fraction of drag that is lost above z = 0; 0 in water without a surface",
         {.lo = 0, .hi = 1, .fallback = 0});
  t.real("slowed.by", &Triangle::Parameters::slowed_by, "1",
         "fraction of the velocity of the water that is lost at the front of a catch",
         {.lo = 0, .hi = 1, .fallback = 0});
  t.real("slowed.front", &Triangle::Parameters::slowed_front, "m",
         "position of the front of the catch along the flow; the effect decreases ahead of it",
         {.lo = -1e6, .hi = 1e6, .fallback = 0});
  t.real("slowed.radius", &Triangle::Parameters::slowed_radius, "m", "radius of the catch at its front",
         {.lo = 1e-3, .hi = 1e3, .fallback = 1});
  t.real("slowed.direction", &Triangle::Parameters::slowed_direction, "rad",
         "direction to which the water flows, from x towards y", {.lo = -6.3, .hi = 6.3, .fallback = 0});
  t.law("drag", NETLOFT_TWINE_LAW | NETLOFT_SCREEN_LAW, "hydro/morison",
        "force of the water on the netting, twine by twine or as a screen");
  t.data("u", &Triangle::Data::u, "1", "twine coordinate of the corners along u, in bars");
  t.data("v", &Triangle::Data::v, "1", "twine coordinate of the corners along v, in bars");
  t.data("bar_length", &Triangle::Data::bar_length, "m", "unstretched length of a bar, from knot to knot");
  t.term<Triangle::Elastic, netloft::conservative | netloft::symmetric | netloft::has_convex |
                                netloft::has_metric | netloft::of_members>(
      "elastic", "tension of the twines, and their small resistance when slack",
      "twine.EA twine.EA_compression");
  t.term<Triangle::Weight, netloft::conservative | netloft::symmetric | netloft::constant |
                               netloft::needs_gravity | netloft::is_weight>(
      "weight", "weight in water of the unstretched twines");
  constexpr auto of_angle = netloft::conservative | netloft::symmetric | netloft::has_convex;
  t.term<OpeningGiven, of_angle>("opening", "resistance of the meshes to opening", "twine.opening_stiffness");
  t.term<OpeningOfTwines, of_angle>(
      "opening-by-EI", "resistance of the meshes to opening, by bending of the twines", "twine.EI");
  t.term<KnotContact, of_angle>("knot-contact", "knots that touch before a mesh is closed",
                                "twine.knot_size");
  t.term<Drag, netloft::reads_current | netloft::reads_velocity | netloft::needs_flow | netloft::is_drag>(
      "drag", "force of the water on the netting, by its law, a third per corner", "twine.diameter");
  t.term<SlowedDrag, netloft::reads_current | netloft::reads_velocity | netloft::needs_flow |
                         netloft::from_outside | netloft::is_drag>(
      "slowed-drag", "drag that is lost in water that a catch slows ahead of it", "slowed.by");
  t.term<DryDrag, netloft::reads_current | netloft::reads_waves | netloft::reads_velocity |
                      netloft::needs_flow | netloft::from_outside | netloft::is_drag>(
      "dry-drag", "drag that is lost above the surface", "twine.surface");
  t.term<Damping, netloft::reads_velocity | netloft::needs_motion>(
      "damping", "resistance to the rate of stretch, also when slack", "twine.damping");
  t.term<Loss, netloft::reads_velocity | netloft::needs_motion>(
      "loss", "damping of a taut twine by its material", "twine.loss_factor");
  t.term<Inertia, netloft::reads_acceleration | netloft::needs_motion>(
      "inertia", "mass of the twines, and added mass across them, a third per corner");
  t.term<Waves, netloft::reads_waves | netloft::needs_waves | netloft::needs_motion>(
      "waves",
      "pressure of the waves on the displaced volume, and added mass of water accelerated across the twines");
  t.output(
      "tension", "N", "tension of one twine, the larger of both directions",
      [](auto& p, auto& d, auto& s) {
        return std::max(Triangle::stretch(0, p, d, s).T, Triangle::stretch(1, p, d, s).T);
      },
      netloft::OutputRole::tension);
  t.output(
      "strain", "1", "elongation over unstretched length, the larger of both directions",
      [](auto& p, auto& d, auto& s) {
        return std::max(Triangle::stretch(0, p, d, s).l, Triangle::stretch(1, p, d, s).l) / d.bar_length - 1;
      });
  t.output(
      "tension_u", "N", "tension of one twine along u",
      [](auto& p, auto& d, auto& s) { return Triangle::stretch(0, p, d, s).T; },
      netloft::OutputRole::tension);
  t.output(
      "tension_v", "N", "tension of one twine along v",
      [](auto& p, auto& d, auto& s) { return Triangle::stretch(1, p, d, s).T; },
      netloft::OutputRole::tension);
  t.output("half_angle", "rad", "half the angle between the twines of a mesh",
           [](auto&, auto& d, auto& s) { return Triangle::half_angle(d, s); });
  t.output("contact", "1", "compression of touching knots: 0 at contact, 1 for a closed mesh",
           [](auto& p, auto& d, auto& s) { return KnotContact::depth(p, d, s); });
  t.output_lanes("drag", "N", "magnitude of the force of the water on the triangle", Drag::output);
  t.output("knots", "1", "knots in the triangle, two bars of twine each",
           [](auto&, auto& d, auto&) { return Triangle::shape(d).bars; });
  t.output("twine_area", "m2", "length times diameter of the twines, knots left out",
           [](auto& p, auto& d, auto&) { return Triangle::twine_area(p, d); });
  t.output("mass", "kg", "mass of the twines, in air",
           [](auto& p, auto& d, auto&) { return p.density * Triangle::twine_volume(p, d); });

  auto& bending =
      plugin.element<Bending>("bending", "Resistance of netting to bending between two triangles");
  bending.rides_on("triangle");
  bending.real("twine.EI", &Bending::Parameters::EI, "N m2", "bending stiffness of one twine",
               {.lo = 0, .hi = 1e6, .fallback = 0, .role = netloft::Role::stiffness});
  bending.real("twine.bending_half_angle", &Bending::Parameters::half_angle, "rad",
               "half angle of the meshes in which altitudes and edges are measured for bending; 45 degrees",
               {.lo = 0.01, .hi = 1.56, .fallback = 0.78539816339744831});
  bending.data("u", &Bending::Data::u, "1", "twine coordinate of the corners along u, in bars");
  bending.data("v", &Bending::Data::v, "1", "twine coordinate of the corners along v, in bars");
  bending.data("bar_length", &Bending::Data::bar_length, "m",
               "unstretched length of a bar in both triangles");
  bending.term<Bending::Elastic, netloft::conservative | netloft::symmetric>(
      "bending", "moment against the curvature of the netting", "twine.EI");
  bending.output("turning_angle", "rad", "angle by which the second triangle turns away from the first",
                 [](auto&, auto&, auto& s) { return Bending::turning_angle(s); });
}
