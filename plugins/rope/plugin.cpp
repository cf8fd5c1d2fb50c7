// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/rope/bar.hpp"
#include "plugins/rope/clamp.hpp"
#include "plugins/rope/mirror.hpp"
#include "plugins/rope/rope_bending.hpp"
#include "plugins/rope/sag.hpp"

using netloft::rope::Bar;
using netloft::rope::Bending;
using netloft::rope::Clamp;
using netloft::rope::Mirror;

namespace {

constexpr const char* kCurvature =
    "circle that defines the curvature: one tangent to both bars at their middles, or one through three "
    "nodes";

void add_clamp(netloft::Plugin& plugin) {
  auto& clamp = plugin.element<Clamp>("clamp", "Clamp that keeps the angle between two ropes that meet");
  clamp.real("clamp.EI", &Clamp::Parameters::EI, "N m2", "bending stiffness of the clamp",
             {.lo = 0, .hi = 1e12, .role = netloft::Role::stiffness});
  clamp.real("clamp.angle", &Clamp::Parameters::angle, "rad",
             "angle at rest between the directions of the first and second rope; 0: in line",
             {.lo = 0, .hi = 3.14159265358979, .fallback = 0});
  clamp.choice("clamp.curvature", &Clamp::Parameters::curvature, kCurvature, {"bars", "nodes"});
  clamp.data("rest_length", &Clamp::Data::rest_length, "m", "unstretched length of both bars");
  clamp.term<Clamp::Elastic, netloft::conservative | netloft::symmetric>(
      "clamp", "moment against a change of the angle", "clamp.EI");
  clamp.output("turning_angle", "rad", "angle by which the second bar turns away from the first",
               [](auto&, auto&, auto& s) { return Bending::turning_angle(s); });
}

void add_mirror(netloft::Plugin& plugin) {
  auto& mirror =
      plugin.element<Mirror>("mirror", "Bending of a rope against its image in a plane of symmetry");
  mirror.real("mirror.EI", &Mirror::Parameters::EI, "N m2", "bending stiffness of the rope",
              {.lo = 0, .hi = 1e12, .role = netloft::Role::stiffness});
  mirror.choice("mirror.axis", &Mirror::Parameters::axis, "axis normal to the plane", {"x", "y", "z"});
  mirror.choice("mirror.side", &Mirror::Parameters::side, "side of the plane on which the rope is",
                {"positive", "negative"});
  mirror.choice("mirror.curvature", &Mirror::Parameters::curvature, kCurvature, {"bars", "nodes"});
  mirror.data("rest_length", &Mirror::Data::rest_length, "m", "unstretched length of the bar");
  mirror.term<Mirror::Elastic, netloft::conservative | netloft::symmetric | netloft::from_outside>(
      "mirror", "moment against the curvature of the rope at the plane of symmetry", "mirror.EI");
}

}  // namespace

NETLOFT_PLUGIN("rope", "0.1.0", "Ropes, wires and chains as elastic bars") {
  auto& bar = plugin.element<Bar>("bar", "Straight elastic bar of a rope between two nodes, weak when slack");
  bar.real("rope.EA", &Bar::Parameters::EA, "N", "axial stiffness of the rope",
           {.lo = 0, .hi = 1e15, .role = netloft::Role::stiffness});
  bar.real(
      "rope.EA_compression", &Bar::Parameters::EA_compression, "N", "axial stiffness when slack",
      {.lo = 0, .hi = 1e15, .fallback = 1e-4, .fallback_of = "rope.EA", .role = netloft::Role::compression});
  bar.real("rope.diameter", &Bar::Parameters::diameter, "m", "diameter of the rope", {.lo = 0, .hi = 10});
  bar.real("rope.density", &Bar::Parameters::density, "kg/m3", "density of the rope's material",
           {.lo = 0, .hi = 1e6});
  bar.real("rope.weight_in_water", &Bar::Parameters::weight_in_water, "N/m",
           "weight of a metre in the water of the scene, negative for floating ropes, independent of the "
           "density; 0: computed from rope.density",
           {.lo = -1e6, .hi = 1e6, .fallback = 0});
  bar.real(
      "rope.constant_tension", &Bar::Parameters::constant_tension, "N",
      "tension that a winch or a weight over a pulley holds at any length, instead of the spring; 0: none",
      {.lo = 0, .hi = 1e12, .fallback = 0});
  bar.real("rope.damping", &Bar::Parameters::damping, "N s",
           "damping of stretch: tension per strain rate, EA times a relaxation time",
           {.lo = 0, .hi = 1e15, .fallback = 0, .role = netloft::Role::damping});
  bar.real("rope.loss_factor", &Bar::Parameters::loss_factor, "1",
           "loss factor: energy that an oscillating taut rope loses per radian, over its elastic energy",
           {.lo = 0, .hi = 1, .fallback = 0});
  bar.real("rope.loss_frequency", &Bar::Parameters::loss_frequency, "Hz",
           "frequency of the oscillations for which the loss factor is given",
           {.lo = 1e-3, .hi = 1e4, .fallback = 10});
  bar.real("rope.added_mass", &Bar::Parameters::added_mass, "1",
           "added mass across the rope over the mass of the water it displaces",
           {.lo = 0, .hi = 10, .fallback = 1});
  bar.real("rope.sag", &Bar::Parameters::sag, "1",
           "fraction of the sag within a bar that counts; 0: straight bars; 1: all of it, which needs fewer "
           "bars for the same error",
           {.lo = 0, .hi = 1, .fallback = 0});
  bar.table("rope.length_share", &Bar::Parameters::length_share,
            "unstretched length divided by that at the start, as rope is paid out or hauled",
            {{"t", "s"}, {"share", "1"}});
  bar.real("rope.surface", &Bar::Parameters::surface, "1",
           "fraction of buoyancy and drag that is lost above z = 0; 0 in water without a surface",
           {.lo = 0, .hi = 1, .fallback = 0});
  bar.law("drag", NETLOFT_TWINE_LAW, "hydro/morison", "force of the water on the rope");
  bar.data("rest_length", &Bar::Data::rest_length, "m", "unstretched length of the bar");
  bar.term<Bar::Elastic, netloft::conservative | netloft::symmetric | netloft::has_convex |
                             netloft::has_metric | netloft::reads_time | netloft::of_members>(
      "elastic", "tension of the rope, and its small resistance when slack", "rope.EA rope.EA_compression");
  bar.term<Bar::Weight, netloft::conservative | netloft::symmetric | netloft::constant |
                            netloft::needs_gravity | netloft::reads_time | netloft::is_weight>(
      "weight", "weight in water of the unstretched rope");
  bar.term<Bar::Tension, netloft::conservative | netloft::symmetric | netloft::has_convex>(
      "tension", "constant tension instead of the spring", "rope.constant_tension");
  bar.term<netloft::rope::Sag, netloft::needs_gravity>(
      "sag", "sag and uneven stretch of the rope within a bar, under its weight", "rope.sag");
  bar.term<Bar::Drag, netloft::reads_current | netloft::reads_velocity | netloft::reads_time |
                          netloft::needs_flow | netloft::is_drag>(
      "drag", "force of the water on the unstretched rope, by its law, half per node");
  bar.term<Bar::DryDrag, netloft::reads_current | netloft::reads_waves | netloft::reads_velocity |
                             netloft::needs_flow | netloft::from_outside | netloft::is_drag>(
      "dry-drag", "drag that is lost above the surface", "rope.surface");
  bar.term<Bar::DryBuoyancy, netloft::conservative | netloft::reads_waves | netloft::symmetric |
                                 netloft::needs_gravity | netloft::from_outside | netloft::is_weight>(
      "dry-buoyancy", "buoyancy that is lost above the surface", "rope.surface");
  bar.term<Bar::Damping, netloft::reads_velocity | netloft::reads_time | netloft::needs_motion>(
      "damping", "resistance to the rate of stretch, also when slack", "rope.damping");
  bar.term<Bar::Loss, netloft::reads_velocity | netloft::needs_motion | netloft::reads_time>(
      "loss", "damping of a taut rope by its material", "rope.loss_factor");
  bar.term<Bar::Inertia, netloft::reads_acceleration | netloft::reads_time | netloft::needs_motion>(
      "inertia", "mass of the rope, and added mass across it, half per node");
  bar.term<Bar::Waves, netloft::reads_waves | netloft::needs_waves | netloft::needs_motion>(
      "waves",
      "pressure of the waves on the displaced volume, and added mass of water accelerated across the rope");
  bar.output(
      "tension", "N", "tension, positive when the rope pulls",
      [](auto& p, auto& d, auto& s) { return Bar::stretch(p, d, s).T; }, netloft::OutputRole::tension);
  bar.output("strain", "1", "elongation over unstretched length",
             [](auto& p, auto& d, auto& s) { return Bar::stretch(p, d, s).l / d.rest_length - 1; });
  bar.output_lanes("drag", "N", "magnitude of the force of the water on the bar", Bar::drag_of);
  bar.output_lanes("angle_to_flow", "rad", "angle between bar and flow; 0: the flow is along the bar",
                   Bar::angle_of);
  bar.output_lanes("mass", "kg", "mass of the unstretched rope, in air", Bar::mass_of);

  auto& bending = plugin.element<Bending>("bending", "Resistance to bending between two neighbouring bars");
  bending.rides_on("bar");
  bending.real("rope.EI", &Bending::Parameters::EI, "N m2", "bending stiffness of the rope",
               {.lo = 0, .hi = 1e12, .fallback = 0, .role = netloft::Role::stiffness});
  bending.choice("rope.curvature", &Bending::Parameters::curvature, kCurvature, {"bars", "nodes"});
  bending.data("rest_length", &Bending::Data::rest_length, "m", "unstretched length of both bars");
  bending.term<Bending::Elastic, netloft::conservative | netloft::symmetric>(
      "bending", "moment against the curvature of the rope", "rope.EI");
  bending.output("turning_angle", "rad", "angle by which the second bar turns away from the first",
                 [](auto&, auto&, auto& s) { return Bending::turning_angle(s); });

  add_clamp(plugin);
  add_mirror(plugin);
}
