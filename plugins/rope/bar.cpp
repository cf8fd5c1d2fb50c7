// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/rope/bar.hpp"

#include "plugins/common/in_time.hpp"

namespace netloft::rope {

void Bar::check(const Parameters& p, const Data& d) {
  if (!in_time::is_positive(p.length_share))
    throw std::invalid_argument("the length of a rope must remain above zero: length_share must be positive");
  if (p.weight_in_water != 0 && !(p.diameter > 0))
    throw std::invalid_argument("rope.weight_in_water needs a rope.diameter above zero");
  if (!(d.rest_length > 0)) throw std::invalid_argument("a bar of rest length zero has no stiffness");
}

void Bar::pack(const Parameters& p, const Data& d, Lanes& lanes, std::size_t lane) {
  bars::pack(p, d.rest_length, 1, lanes, lane);
  lanes.constant_tension[lane] = p.constant_tension;
  lanes.weight_in_water[lane] = p.weight_in_water;
  lanes.is_weighed |= p.weight_in_water != 0;
  lanes.length_share[lane] = p.length_share;
  lanes.changes |= p.length_share.rows > 0;
  if (p.constant_tension > 0) lanes.EA[lane] = lanes.EA_compression[lane] = lanes.loss[lane] = 0;
}

double Bar::factor_at(const netloft_table& table, double time) { return in_time::factor_at(table, time); }

double Bar::growth_at(const netloft_table& table, double time) {
  for (std::uint32_t i = 1; i < table.rows; ++i) {
    const double t0 = table.values[2 * i - 2], t1 = table.values[2 * i];
    if (time > t0 && time <= t1)
      return (table.values[2 * i + 1] - table.values[2 * i - 1]) / (t1 - t0) / factor_at(table, time);
  }
  return 0;
}

Status Bar::Loss::tile(const Family<Bar>& family, netloft_tile& t) {
  const Lanes& p = family.lanes(t);
  Lanes room;
  double growth[kLanes] = {};
  for (std::size_t i = 0; i < t.count && p.changes; ++i) growth[i] = growth_at(p.length_share[i], t.time);
  return bars::add_loss(now(p, t, room), growth, t);
}

const Bar::Lanes& Bar::now(const Lanes& lanes, const netloft_tile& t, Lanes& room) {
  if (!lanes.changes) return lanes;
  room = lanes;
  for (std::size_t i = 0; i < t.count; ++i) {
    const double share = factor_at(lanes.length_share[i], t.time);  // (2)
    room.l0[i] *= share;
    room.twine[i] *= share;
    room.volume[i] *= share;
  }
  return room;
}

double Bar::density_by_weight(double weight_in_water, double density, double diameter, double water_density,
                              double gravity) {
  if (weight_in_water == 0 || !(gravity > 0)) return density;
  return water_density + weight_in_water / (gravity * std::numbers::pi / 4 * diameter * diameter);  // (3)
}

const Bar::Lanes& Bar::Weight::weighed(const Lanes& at_time, const netloft_tile& t, Lanes& room) {
  if (!at_time.is_weighed) return at_time;
  if (&at_time != &room) room = at_time;
  for (std::size_t i = 0; i < t.count; ++i)
    room.density[i] = density_by_weight(room.weight_in_water[i], room.density[i], room.diameter[i],
                                        t.water_density, t.gravity);
  return room;
}

axial::Bar Bar::stretch(const Parameters& p, const Data& d, const State<2>& s) {
  const Vec3<double> w = s.between(0, 1);
  const double rest_length = d.rest_length * factor_at(p.length_share, s.time);
  auto bar = axial::stretch(w.x, w.y, w.z, rest_length, p.EA, p.EA_compression);
  if (p.constant_tension > 0) bar.T = p.constant_tension;
  return bar;
}

std::array<Member, 1> Bar::members(const Parameters& p, const Data& d, double time) {
  Member member = bars::member(p, d.rest_length * factor_at(p.length_share, time), 1);  // (2)
  if (p.constant_tension > 0) member.EA = member.EA_compression = 0;
  return {member};
}

Status Bar::Tension::tile(const Family<Bar>& family, netloft_tile& t) {
  const Lanes& p = family.lanes(t);
  const bars::Chords chord(t, p.l0);
  double A[6][kLanes];
  for (std::size_t i = 0; i < t.count; ++i) {
    const double T = p.constant_tension[i];
    if (t.energy) t.energy[i] += T * chord.l[i];
    if (t.force)
      for (int axis = 0; axis < 3; ++axis) {
        t.force[bars::at(axis, i)] -= T * chord.t[axis][i];
        t.force[bars::at(axis + 3, i)] += T * chord.t[axis][i];
      }
    const double g = t.cu * T * chord.inverse[i];
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c <= r; ++c)
        A[axial::kPlace[r][c]][i] = g * ((r == c ? 1 : 0) - chord.t[r][i] * chord.t[c][i]);
  }
  if (t.tangent) bars::add_blocks(A, t.count, t.tangent);  // A is semi-definite: its own convex part
  return Status::ok;
}

}  // namespace netloft::rope
