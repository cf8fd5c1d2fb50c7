// SPDX-License-Identifier: BSD-3-Clause
#include "io/scene/current.hpp"

#include <algorithm>

namespace netloft::io {

namespace {

const Range kSpeeds = between(-50, 50);

std::vector<double> read_column(TableReader& profile, const char* key, std::size_t count) {
  if (!profile.has(key)) return std::vector<double>(count, 0.0);
  auto column = profile.reals(
      key,
      {.unit = "m/s", .doc = "velocity of the water at each z", .range = kSpeeds, .count = exactly(count)});
  column.resize(count);
  return column;
}

Current read_profile(TableReader profile) {
  Current current;
  const auto z = profile.reals("z", {.unit = "m",
                                     .doc = "heights of the samples, 0 at the surface",
                                     .range = between(-2e4, 1e3),
                                     .count = {.least = 1}});
  const auto x = read_column(profile, "x", z.size()), y = read_column(profile, "y", z.size()),
             up = read_column(profile, "up", z.size());
  for (std::size_t i = 0; i < z.size(); ++i) current.samples.push_back({z[i], {x[i], y[i], up[i]}});
  std::sort(current.samples.begin(), current.samples.end(),
            [](const auto& a, const auto& b) { return a.z < b.z; });
  for (std::size_t i = 1; i < current.samples.size(); ++i)
    if (!(current.samples[i].z > current.samples[i - 1].z)) {
      profile.error("z",
                    "has the same height twice; a jump in the current needs two heights close to each other");
      break;
    }
  return current;
}

}  // namespace

Current read_current(TableReader& water) {
  if (!water.has("current")) return {};
  if (water.kind("current") == Kind::table) return read_profile(water.table("current"));
  const auto v = water.reals(
      "current", {.unit = "m/s", .doc = "velocity of the water", .range = kSpeeds, .count = exactly(3)});
  if (v.size() != 3) return {};
  return {{{0, {v[0], v[1], v[2]}}}};
}

}  // namespace netloft::io
