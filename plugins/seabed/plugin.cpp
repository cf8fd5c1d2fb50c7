// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/seabed/bed.hpp"

using netloft::seabed::OnBed;
using netloft::seabed::Plane;

namespace {

using netloft::Real;

void add_bed_outputs(netloft::ElementTable<OnBed>& e) {
  e.output_of_whole("normal_force", "N", "force of the bed on the node, along its normal",
                    [](auto& p, auto& d, auto& w, auto& s) { return OnBed::normal_force(p, d, w, s); });
  e.output("gap", "m", "height of the lower side of the node over the bed, negative where they touch",
           [](auto& p, auto&, auto& s) { return OnBed::gap(p, s); });
}

void add_bed(netloft::Plugin& plugin) {
  using P = OnBed::Parameters;
  auto& e = plugin.element<OnBed>("bed", "The bed of the scene under nodes, of any shape");
  e.real("seabed.stiffness", &P::stiffness, "N/m2", "force per metre of rope and metre of depth",
         {.lo = 0, .hi = 1e12, .fallback = 1e5});
  e.real("seabed.softness", &P::softness, "m",
         "depth below the surface of the bed at which the bed reaches seabed.stiffness",
         {.lo = 1e-6, .hi = 10, .fallback = 0.02});
  e.real("seabed.friction", &P::friction, "1", "friction force over normal force",
         {.lo = 0, .hi = 10, .fallback = 0});
  e.real("seabed.shear_stiffness", &P::shear_stiffness, "N/m2",
         "force per metre of rope and metre along a bed at rest, until it slides",
         {.lo = 1e-3, .hi = 1e12, .fallback = 1, .fallback_of = "seabed.stiffness"});
  e.real("seabed.radius", &P::radius, "m",
         "height above the bed at which bobbins, discs or its own radius keep the middle of the rope",
         {.lo = 0, .hi = 10, .fallback = 0});
  e.real("seabed.loss_factor", &P::loss_factor, "1",
         "loss factor: energy that the bed loses per radian of an oscillation, over its elastic energy",
         {.lo = 0, .hi = 1, .fallback = 0.2});
  e.real("seabed.loss_frequency", &P::loss_frequency, "Hz",
         "frequency of the oscillations for which the loss factor is given",
         {.lo = 1e-3, .hi = 1e4, .fallback = 1});
  e.grid("seabed.bottom", &P::bottom, "local factors on stiffness and friction; [bed] bottom gives them",
         {{"x", "m"}, {"y", "m"}, {"stiffness", "1"}, {"friction", "1"}});
  e.data("length", &OnBed::Data::length, "m", "rope or twine that the node carries");
  e.data("pieces", &OnBed::Data::pieces, "1",
         "number of pieces at the node, each counted as a metre if the node carries no length");
  e.term<OnBed::Contact, netloft::conservative | netloft::symmetric | netloft::reads_bed |
                             netloft::from_outside>("contact", "normal force of the bed on the node");
  e.remembers(Plane::kRemembers);
  e.term<OnBed::Friction, netloft::reads_bed | netloft::reads_state | netloft::reads_ground |
                              netloft::reads_velocity | netloft::from_outside>(
      "friction", "friction of the bed on the node: elastic up to sliding, or of a moving bed",
      "seabed.friction");
  e.term<OnBed::Loss,
         netloft::reads_bed | netloft::reads_velocity | netloft::needs_motion | netloft::from_outside>(
      "loss", "energy loss of the bed in compression", "seabed.loss_factor");
  add_bed_outputs(e);
}

}  // namespace

NETLOFT_PLUGIN("seabed", "0.1.0", "The ground under a gear, with contact and friction") {
  auto& e = plugin.element<Plane>("plane", "A plane seabed under nodes, with friction that sticks");
  e.real("seabed.depth", &Plane::Parameters::depth, "m", "depth of the seabed below z = 0, at x = y = 0",
         {.lo = -1e6, .hi = 1e6});
  e.real("seabed.slope_x", &Plane::Parameters::slope_x, "1", "rise of the seabed along x",
         {.lo = -10, .hi = 10, .fallback = 0});
  e.real("seabed.slope_y", &Plane::Parameters::slope_y, "1", "rise of the seabed along y",
         {.lo = -10, .hi = 10, .fallback = 0});
  e.real("seabed.stiffness", &Plane::Parameters::stiffness, "N/m2",
         "force per metre of rope and metre of depth", {.lo = 0, .hi = 1e12, .fallback = 1e5});
  e.real("seabed.softness", &Plane::Parameters::softness, "m",
         "depth below its surface at which the seabed reaches seabed.stiffness",
         {.lo = 0, .hi = 10, .fallback = 1e-3});
  e.real("seabed.friction", &Plane::Parameters::friction, "1", "friction force over normal force",
         {.lo = 0, .hi = 10, .fallback = 0});
  e.real("seabed.shear_stiffness", &Plane::Parameters::shear_stiffness, "N/m2",
         "force per metre of rope and metre along the seabed, until it slides",
         {.lo = 1e-3, .hi = 1e12, .fallback = 1, .fallback_of = "seabed.stiffness"});
  e.data("length", &Plane::Data::length, "m", "rope or twine that the node carries");
  e.data("pieces", &Plane::Data::pieces, "1",
         "number of pieces at the node, each counted as a metre if the node carries no length");
  e.remembers(Plane::kRemembers);
  e.term<Plane::Contact, netloft::conservative | netloft::symmetric | netloft::has_convex |
                             netloft::has_metric | netloft::from_outside>(
      "contact", "normal force of the seabed on the node");
  e.term<Plane::Friction,
         netloft::reads_state | netloft::reads_ground | netloft::reads_velocity | netloft::from_outside>(
      "friction", "friction of the seabed on the node: elastic up to sliding, or of a moving bed",
      "seabed.friction");
  e.output("normal_force", "N", "force of the seabed on the node, along its normal",
           [](auto& p, auto& d, auto& s) { return Plane::normal_force(p, d, s); });
  e.output("gap", "m", "height of the node over the seabed, negative where they touch",
           [](auto& p, auto&, auto& s) { return Plane::gap(p, s); });
  add_bed(plugin);
}
