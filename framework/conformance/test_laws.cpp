// SPDX-License-Identifier: BSD-3-Clause
#include "framework/conformance/test_laws.hpp"

#include "framework/conformance/specimen.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::conformance {

namespace {

void write_lane(const netloft_law_tile& f, std::size_t i, double half) {
  const auto at = [i](std::size_t row) { return row * kLanes + i; };
  const double W[3] = {f.flow[at(0)], f.flow[at(1)], f.flow[at(2)]};
  const double t[3] = {f.direction[at(0)], f.direction[at(1)], f.direction[at(2)]};
  const double k = half * (1 + f.solidity[i]), along = 0.5 * (W[0] * t[0] + W[1] * t[1] + W[2] * t[2]);
  const double speed = std::sqrt(W[0] * W[0] + W[1] * W[1] + W[2] * W[2]);
  const double inverse = 1 / std::max(speed, 1e-150);
  for (std::size_t r = 0; r < 3; ++r) {
    const double shape = W[r] + along * t[r];
    f.force[at(r)] = k * speed * shape;
    if (!f.d_flow) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const double one = r == c ? 1 : 0;
      f.d_flow[at(3 * r + c)] = k * (shape * W[c] * inverse + speed * (one + 0.5 * t[r] * t[c]));
      f.d_direction[at(3 * r + c)] = k * speed * (0.5 * t[r] * W[c] + along * one);
    }
    f.d_solidity[at(r)] = half * speed * shape;
  }
}

void count(const void* law, const netloft_law_tile& f) {
  if (!law || !f.extent) return;
  LaneCounts& lanes = *static_cast<LaneCounts*>(const_cast<void*>(law));
  lanes.all += f.count;
  for (std::size_t i = 0; i < f.count; ++i) lanes.wrong += !(f.extent[i] > 0 && std::isfinite(f.extent[i]));
}

int twine(const void* law, const netloft_law_tile* f) {
  count(law, *f);
  for (std::size_t i = 0; i < f->count; ++i) write_lane(*f, i, 0.5 * f->water_density * f->diameter[i]);
  return NETLOFT_OK;
}

int screen(const void* law, const netloft_law_tile* f) {
  count(law, *f);
  for (std::size_t i = 0; i < f->count; ++i) write_lane(*f, i, 0.5 * f->water_density);
  return NETLOFT_OK;
}

}  // namespace

netloft_bound_law test_law(std::uint32_t kind, LaneCounts* lanes) {
  return {kind, 0, lanes, kind == NETLOFT_SCREEN_LAW ? screen : twine};
}

}  // namespace netloft::conformance
