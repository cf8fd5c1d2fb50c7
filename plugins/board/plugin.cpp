// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/board/otter.hpp"

using namespace netloft;
using boards::Otter;

namespace {

using P = Otter::Parameters;

using D = Otter::Data;
using W = Otter::Whole;
using B = Body<double>;

Wrench<double> push_of(const P& p, const D& d, const W& whole, const B& b) {
  return Otter::Force::force(p, d, whole, b);
}

/// The unit vector of the flow past the origin, in the axes of the world; zero in still water.
Vec3<double> way_of(const B& b) {
  const Vec3<double> flow = b.current - b.v;
  return norm(flow) > 0 ? (1 / norm(flow)) * flow : flow;
}

void add_outputs(ElementTable<Otter>& e) {
  e.output("attack", "rad", "angle of attack: from the chord to the flow across the span, positive outward",
           [](const P&, const D& d, const B& b) { return Otter::flow_past(d, b).attack; });
  e.output("sideslip", "rad", "angle by which the flow points up the span",
           [](const P&, const D& d, const B& b) { return Otter::flow_past(d, b).sideslip; });
  e.output_of_whole("lift", "N", "force of the water across the flow",
                    [](const P& p, const D& d, const W& w, const B& b) {
                      const Vec3<double> f = push_of(p, d, w, b).force, way = way_of(b);
                      return norm(f - dot(f, way) * way);
                    });
  e.output_of_whole("drag", "N", "force of the water along the flow",
                    [](const P& p, const D& d, const W& w, const B& b) {
                      return dot(push_of(p, d, w, b).force, way_of(b));
                    });
  e.output_of_whole(
      "outward", "N", "force of the water outward, along y of the scene",
      [](const P& p, const D& d, const W& w, const B& b) { return d.side * push_of(p, d, w, b).force.y; });
  e.output_of_whole(
      "outside", "1", "the tables of the board do not cover the direction of the flow",
      [](const P&, const D& d, const W& w, const B& b) {
        return Otter::is_outside(w, Otter::flow_past(d, b)) ? 1.0 : 0.0;
      },
      OutputRole::doubt);
}

void add_board(Plugin& plugin, const char* name, const char* doc) {
  auto& e = plugin.element<Otter>(name, doc);
  solids::declare_solid(e, "board.", {.lo = 0, .hi = 1e6});
  e.real("board.area", &P::area, "m2", "projected area", {.lo = 1e-4, .hi = 1e3});
  e.real("board.chord", &P::chord, "m", "length along the flow", {.lo = 1e-2, .hi = 100});
  e.real("board.span", &P::span, "m", "height of a board, width of a kite", {.lo = 1e-2, .hi = 100});
  e.real("board.lift", &P::lift, "1", "factor on the force across the flow, for calibration",
         {.lo = 0, .hi = 5, .fallback = 1});
  e.real("board.drag", &P::drag, "1", "factor on the force along the flow, for calibration",
         {.lo = 0, .hi = 5, .fallback = 1});
  e.real("board.parasite", &P::parasite, "1",
         "drag coefficient of brackets and edges, added to that of a flat plate; not used with a polar",
         {.lo = 0, .hi = 5, .fallback = 0.05});
  e.real("board.ploughing", &P::ploughing, "N/m",
         "force across the motion, on a metre of the lower edge at a depth of 0.1 m in the ground",
         {.lo = 0, .hi = 1e6, .fallback = 0});
  e.real("board.power", &P::power, "1",
         "exponent of the depth in the force of ploughing: 1 in clay, 2 in sand",
         {.lo = 1, .hi = 3, .fallback = 1});
  e.table("board.polar", &P::polar, "coefficients of lift and drag over the angle of attack",
          {{"attack", "rad"}, {"lift", "1"}, {"drag", "1"}});
  e.grid("board.polar_slip", &P::polar_slip,
         "instead of board.polar: coefficients over attack and sideslip, with that of the force up the span",
         {{"attack", "rad"}, {"sideslip", "rad"}, {"lift", "1"}, {"drag", "1"}, {"side", "1"}});
  e.table("board.pressure", &P::pressure,
          "centre of pressure: its distance from the nose over the chord, its height above the middle over "
          "the span",
          {{"attack", "rad"}, {"chord", "1"}, {"span", "1"}});
  e.grid("board.bottom", &P::bottom, "local factor on the resistance to ploughing; [bed] bottom gives it",
         {{"x", "m"}, {"y", "m"}, {"ploughing", "1"}});
  e.term<Otter::Force, reads_velocity | reads_current | reads_bed | needs_flow | is_drag>(
      "water", "force of the flowing water");
  e.term<Otter::Ploughing, reads_velocity | reads_ground | reads_bed | from_outside>(
      "ploughing", "force of the ground that the lower edge ploughs up", "board.ploughing");
  add_outputs(e);
}

}  // namespace

NETLOFT_PLUGIN("board", "0.1.0", "Otter boards, kites and depressors") {
  add_board(plugin, "otter", "Otter board: a rigid body that the water lifts outward");
}
