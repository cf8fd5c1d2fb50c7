// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/lumped/net.hpp"

using netloft::lumped::Net;

NETLOFT_PLUGIN("lumped", "0.1.0", "Netting as point masses, springs and dampers") {
  auto& net = plugin.element<Net>(
      "net", "Bar that represents several parallel twines of netting, with masses at its ends");
  net.real("twine.EA", &Net::Parameters::EA, "N", "axial stiffness of one twine",
           {.lo = 0, .hi = 1e12, .role = netloft::Role::stiffness});
  net.real("twine.EA_compression", &Net::Parameters::EA_compression, "N", "axial stiffness of a slack twine",
           {.lo = 0, .hi = 1e12, .fallback = 0, .role = netloft::Role::compression});
  net.real("twine.diameter", &Net::Parameters::diameter, "m", "diameter of one twine", {.lo = 0, .hi = 1});
  net.real("twine.density", &Net::Parameters::density, "kg/m3", "density of the twine's material",
           {.lo = 0, .hi = 1e6});
  net.real("twine.damping", &Net::Parameters::damping, "N s",
           "damping of stretch: tension per strain rate, EA times a relaxation time",
           {.lo = 0, .hi = 1e9, .fallback = 0, .role = netloft::Role::damping});
  net.real("twine.loss_factor", &Net::Parameters::loss_factor, "1",
           "loss factor: energy that an oscillating taut twine loses per radian, over its elastic energy",
           {.lo = 0, .hi = 1, .fallback = 0});
  net.real("twine.loss_frequency", &Net::Parameters::loss_frequency, "Hz",
           "frequency of the oscillations for which the loss factor is given",
           {.lo = 1e-3, .hi = 1e4, .fallback = 10});
  net.real("twine.added_mass", &Net::Parameters::added_mass, "1",
           "added mass across a twine over the mass of the water it displaces",
           {.lo = 0, .hi = 10, .fallback = 1});
  net.real("twine.surface", &Net::Parameters::surface, "1",
           "fraction of buoyancy and drag that is lost above z = 0; 0 in water without a surface",
           {.lo = 0, .hi = 1, .fallback = 0});
  net.law("drag", NETLOFT_TWINE_LAW, "hydro/morison", "force of the water on the twines");
  net.data("rest_length", &Net::Data::rest_length, "m", "unstretched length of the bar");
  net.data("parallel", &Net::Data::parallel, "1", "number of twines side by side that the bar represents");
  net.term<Net::Elastic, netloft::conservative | netloft::symmetric | netloft::has_convex |
                             netloft::has_metric | netloft::of_members>(
      "elastic", "tension of the twines, and their small resistance when slack",
      "twine.EA twine.EA_compression");
  net.term<Net::Weight, netloft::conservative | netloft::symmetric | netloft::constant |
                            netloft::needs_gravity | netloft::is_weight>(
      "weight", "weight in water of the unstretched twines");
  net.term<Net::Drag,
           netloft::reads_current | netloft::reads_velocity | netloft::needs_flow | netloft::is_drag>(
      "drag", "force of the water on the unstretched twines, by its law, half per node", "twine.diameter");
  net.term<Net::DryDrag, netloft::reads_current | netloft::reads_waves | netloft::reads_velocity |
                             netloft::needs_flow | netloft::from_outside | netloft::is_drag>(
      "dry-drag", "drag that is lost above the surface", "twine.surface");
  net.term<Net::DryBuoyancy, netloft::conservative | netloft::reads_waves | netloft::symmetric |
                                 netloft::needs_gravity | netloft::from_outside | netloft::is_weight>(
      "dry-buoyancy", "buoyancy that is lost above the surface", "twine.surface");
  net.term<Net::Damping, netloft::reads_velocity | netloft::needs_motion>(
      "damping", "resistance to the rate of stretch, also when slack", "twine.damping");
  net.term<Net::Loss, netloft::reads_velocity | netloft::needs_motion>(
      "loss", "damping of a taut twine by its material", "twine.loss_factor");
  net.term<Net::Inertia, netloft::reads_acceleration | netloft::needs_motion>(
      "inertia", "mass of the twines, and added mass across them, half per node");
  net.term<Net::Waves, netloft::reads_waves | netloft::needs_waves | netloft::needs_motion>(
      "waves",
      "pressure of the waves on the displaced volume, and added mass of water accelerated across the twines");
  net.output(
      "tension", "N", "tension of one twine",
      [](auto& p, auto& d, auto& s) { return Net::stretch(p, d, s).T; }, netloft::OutputRole::tension);
  net.output("strain", "1", "elongation over unstretched length",
             [](auto& p, auto& d, auto& s) { return Net::stretch(p, d, s).l / d.rest_length - 1; });
  net.output_lanes("drag", "N", "magnitude of the force of the water on all twines of the bar", Net::drag_of);
  net.output("twine_area", "m2", "length times diameter of the twines, knots left out",
             [](auto& p, auto& d, auto&) { return d.parallel * d.rest_length * p.diameter; });
  net.output_lanes("mass", "kg", "mass of the twines, in air", Net::mass_of);
}
