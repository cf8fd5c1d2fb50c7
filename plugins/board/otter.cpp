// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/board/otter.hpp"

#include <stdexcept>

namespace netloft::boards {

void Otter::check(const Parameters& p, const Data&) {
  if (!(p.area > 0) || !(p.chord > 0) || !(p.span > 0))
    throw std::invalid_argument("a board needs board.area, board.chord and board.span above zero");
  if (p.polar.rows && p.polar_slip.rows)
    throw std::invalid_argument("board.polar and board.polar_slip describe the same forces; give only one");
}

void Otter::gather(const Parameters& p, const Data&, Whole& whole) {
  if (!whole.lift.empty() || !whole.chord.empty() || !whole.ploughing.empty())
    return;  // already read for a previous element
  if (p.polar.rows) {
    const auto attack = Curve::read(p.polar, 0);
    whole.lift = Surface(attack, {0}, Curve::read(p.polar, 1));
    whole.drag = Surface(attack, {0}, Curve::read(p.polar, 2));
    whole.is_of_attack_alone = true;
  } else if (p.polar_slip.rows) {
    whole.lift = Surface(p.polar_slip, 2);
    whole.drag = Surface(p.polar_slip, 3);
    whole.side = Surface(p.polar_slip, 4);
  }
  if (p.bottom.rows) whole.ploughing = Surface(p.bottom, 2);
  if (p.pressure.rows) {
    whole.chord = Curve(p.pressure, 1);
    whole.span = Curve(p.pressure, 2);
  }
}

Otter::Flow Otter::flow_past(const Data& d, const Body<double>& b) {
  const Vec3<double> W = b.to_body(b.current - b.v);
  Flow flow;
  flow.speed = norm(W);
  if (flow.speed > 0) flow.w = (1 / flow.speed) * Vec3<double>{W.x, d.side * W.y, W.z};
  flow.attack = std::atan2(flow.w.y, flow.w.x);
  flow.sideslip = std::asin(std::clamp(flow.w.z, -1.0, 1.0));
  return flow;
}

bool Otter::is_outside(const Whole& t, const Flow& flow) {
  if (flow.speed == 0) return false;
  const bool by_lift =
      !t.lift.empty() && !t.lift.covers(flow.attack, t.is_of_attack_alone ? 0 : flow.sideslip);
  return by_lift || (!t.chord.empty() && !t.chord.covers(flow.attack));
}

}  // namespace netloft::boards
