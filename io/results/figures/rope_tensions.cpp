// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/figures/rope_tensions.hpp"

#include "io/results/figures/gear_view.hpp"

namespace netloft::results {

double RopeTensions::at(double distance) const {
  double before = 0.5 * rest_length.front();  // distance from the start to the middle of the bar
  for (std::size_t bar = 0; bar + 1 < tension.size(); ++bar) {
    const double step = 0.5 * (rest_length[bar] + rest_length[bar + 1]);
    const double way = (distance - before) / step;
    if (way <= 1) return tension[bar] + std::max(way, 0.0) * (tension[bar + 1] - tension[bar]);
    before += step;
  }
  return tension.back();
}

RopeTensions RopeTensions::turned_round() const {
  return {rope, {tension.rbegin(), tension.rend()}, {rest_length.rbegin(), rest_length.rend()}};
}

std::vector<RopeTensions> find_rope_tensions(const scenes::LoadedScene& loaded, const Assembler& assembler,
                                             const Response& answer) {
  std::vector<RopeTensions> all;
  if (!loaded.gear) return all;
  const GearView gear(loaded, assembler, answer);
  for (const auto rope : gear.gear().ropes)
    if (auto tension = gear.tensions(rope); !tension.empty())
      all.push_back({gear.name(rope), std::move(tension), gear.rest_lengths(rope)});
  return all;
}

}  // namespace netloft::results
