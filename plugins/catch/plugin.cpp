// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/catch/front.hpp"
#include "plugins/catch/pressure.hpp"

using netloft::catches::Front;
using netloft::catches::Pressure;

namespace {

constexpr const char* kOutward = "1 if the corners are counter-clockwise seen from outside, -1 if clockwise";

void add_front(netloft::Plugin& plugin) {
  auto& f = plugin.element<Front>("front", "Pressure on all netting behind a plane across the flow");
  f.real("catch.volume", &Front::Parameters::volume, "m3",
         "volume of the catch, from which the plane is computed; 0: catch.front gives the plane",
         {.lo = 0, .hi = 1e5, .fallback = 0});
  f.table("catch.growth", &Front::Parameters::growth,
          "fraction of the volume at a given time, as fish come in: linear between the times",
          {{"t", "s"}, {"share", "1"}});
  f.real("catch.front", &Front::Parameters::front, "m",
         "position of the plane along the flow; for a given volume, the initial guess",
         {.lo = -1e6, .hi = 1e6, .fallback = 0});
  f.real("catch.direction", &Front::Parameters::direction, "rad",
         "direction to which the water flows, from x towards y", {.lo = -6.3, .hi = 6.3, .fallback = 0});
  f.real("catch.pressure", &Front::Parameters::pressure, "Pa", "pressure on the netting from inside",
         {.lo = 0, .hi = 1e7, .fallback = 0});
  f.real("catch.speed", &Front::Parameters::speed, "m/s",
         "speed of the water through the gear, which adds the pressure of the flow it stops",
         {.lo = 0, .hi = 50, .fallback = 0});
  f.real("catch.drag_coefficient", &Front::Parameters::drag_coefficient, "1",
         "pressure divided by the dynamic pressure at catch.speed", {.lo = 0, .hi = 1e3, .fallback = 1.4});
  f.global("front", "m", "position of the plane along the flow", "catch.volume", Front::first_front);
  f.data("outward", &Front::Data::outward, "1", kOutward);
  f.term<Front::Push, netloft::from_outside | netloft::is_drag | netloft::reads_time>(
      "pressure", "outward force of the catch on the netting");
  f.output("pressure", "Pa", "pressure on the netting, reduced for triangles that the plane cuts",
           [](auto& p, auto& d, auto& s) { return Front::on(p, d, s); });
  f.output("volume", "m3", "contribution of the triangle to the volume of the catch",
           [](auto& p, auto& d, auto& s) { return Front::volume(p, d, s); });
  f.output("front", "m", "position of the plane along the flow",
           [](auto&, auto&, auto& s) { return s.x[3].x; });
}

}  // namespace

NETLOFT_PLUGIN("catch", "0.1.0", "The catch and its pressure on the cod-end") {
  auto& c =
      plugin.element<Pressure>("pressure", "Pressure on the netting of a cod-end behind the catch front");
  c.real("catch.meshes", &Pressure::Parameters::meshes, "1",
         "meshes along the netting that are filled, counted from its aft end through the panels in a row",
         {.lo = 0, .hi = 1e6, .fallback = 0});
  c.real("catch.volume", &Pressure::Parameters::volume, "m3",
         "volume of the catch, instead of meshes; its front is then computed",
         {.lo = 0, .hi = 1e5, .fallback = 0});
  c.table("catch.growth", &Pressure::Parameters::growth,
          "fraction of the volume at a given time, as fish come in: linear between the times",
          {{"t", "s"}, {"share", "1"}});
  c.choice("catch.across", &Pressure::Parameters::across,
           "axis across the cod-end, on which catch.middle is measured", {"y", "x", "z"});
  c.real("catch.middle", &Pressure::Parameters::middle, "m",
         "position of the middle of the cod-end on the axis catch.across",
         {.lo = -1e5, .hi = 1e5, .fallback = 0});
  c.real("catch.pressure", &Pressure::Parameters::pressure, "Pa", "pressure on the netting from inside",
         {.lo = 0, .hi = 1e7, .fallback = 0});
  c.real("catch.speed", &Pressure::Parameters::speed, "m/s",
         "speed of the water through the gear, which adds the pressure of the flow it stops",
         {.lo = 0, .hi = 50, .fallback = 0});
  c.real("catch.drag_coefficient", &Pressure::Parameters::drag_coefficient, "1",
         "pressure divided by the dynamic pressure at catch.speed", {.lo = 0, .hi = 10, .fallback = 1.4});
  c.global("front", "1", "meshes along the netting that the catch fills, from its aft end", "catch.volume",
           Pressure::first_front);
  c.data("to_aft", &Pressure::Data::to_aft, "1", "meshes from each corner to the aft end of the netting");
  c.data("outward", &Pressure::Data::outward, "1", kOutward);
  c.term<Pressure::Push, netloft::from_outside | netloft::is_drag | netloft::reads_time>(
      "pressure", "outward force of the catch on the netting");
  c.output("pressure", "Pa", "pressure on the netting, reduced for triangles that the catch front cuts",
           [](auto& p, auto& d, auto& s) { return Pressure::on(p, d, s); });
  c.output("volume", "m3", "contribution of the triangle to the volume of the catch",
           [](auto& p, auto& d, auto& s) { return Pressure::volume(p, d, s); });
  c.output("front", "1", "meshes along the netting that the catch fills, from its aft end",
           [](auto&, auto&, auto& s) { return s.x[3].x; });

  add_front(plugin);
}
