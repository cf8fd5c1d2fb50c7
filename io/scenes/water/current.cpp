// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/water/current.hpp"

#include <algorithm>

namespace netloft::scenes {

namespace {

const formats::Range kSpeeds = formats::between(-50, 50);

std::vector<double> read_column(formats::TableReader& profile, const char* key, std::size_t count) {
  if (!profile.has(key)) return std::vector<double>(count, 0.0);
  auto column = profile.reals(key, {.unit = "m/s",
                                    .doc = "velocity of the water at each z",
                                    .range = kSpeeds,
                                    .count = formats::exactly(count)});
  column.resize(count);
  return column;
}

/// Reports a table that has heights or times but no velocity, with which the water would be still.
void require_velocity(const formats::TableReader& table) {
  const auto keys = table.keys();
  const auto is_argument = [](const auto& key) { return key == "z" || key == "t" || key == "factor"; };
  if (!keys.empty() && std::ranges::all_of(keys, is_argument))
    table.diagnostics().error(
        table.place(), table.path() + ": has no x, y or up, so that the water would be still",
        "x = [1.2, 0.6] is the velocity aft, in m/s, for each number in the other column");
}

const formats::RealsSpec kTimes{
    .unit = "s", .doc = "times, ascending", .range = formats::between(-1e9, 1e9), .count = {.least = 1}};

bool ascend(const std::vector<double>& t, formats::TableReader& table) {
  for (std::size_t i = 1; i < t.size(); ++i)
    if (!(t[i] > t[i - 1])) {
      table.error("t", "does not ascend: each time must be later than the one before");
      return false;
    }
  return true;
}

/// Reads a current that is the same at all heights, from columns of velocities over time.
Current read_drift(formats::TableReader table) {
  Current current;
  require_velocity(table);
  const auto t = table.reals("t", kTimes);
  const auto x = read_column(table, "x", t.size()), y = read_column(table, "y", t.size()),
             up = read_column(table, "up", t.size());
  if (!ascend(t, table)) return current;
  for (std::size_t i = 0; i < t.size(); ++i) current.drifts.push_back({t[i], {x[i], y[i], up[i]}});
  return current;
}

/// Reads the factors by which the profile is multiplied at the times `t`.
void read_factors(formats::TableReader& profile, Current& current) {
  if (!profile.has("t") && !profile.has("factor")) return;
  const auto t = profile.reals("t", kTimes);
  const auto factor = profile.reals("factor", {.doc = "factor on the profile at each t",
                                               .range = formats::between(-1e3, 1e3),
                                               .count = formats::exactly(t.size())});
  if (!ascend(t, profile)) return;
  for (std::size_t i = 0; i < std::min(t.size(), factor.size()); ++i)
    current.factors.push_back({t[i], factor[i]});
}

Current read_profile(formats::TableReader profile) {
  if (!profile.has("z") && profile.has("t")) return read_drift(profile);
  Current current;
  require_velocity(profile);
  read_factors(profile, current);
  const auto z = profile.reals("z", {.unit = "m",
                                     .doc = "heights of the samples, 0 at the surface",
                                     .range = formats::between(-2e4, 1e3),
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

Current read_current(formats::TableReader& water) {
  if (!water.has("current")) return {};
  const formats::Table* table = water.raw("current")->as<formats::Table>();
  if (table && !table->find("values")) return read_profile(water.table("current"));
  const auto v = water.reals(
      "current",
      {.unit = "m/s", .doc = "velocity of the water", .range = kSpeeds, .count = formats::exactly(3)});
  if (v.size() != 3) return {};
  return {{{0, {v[0], v[1], v[2]}}}};
}

std::vector<VelocitiesOverHeight> velocities_at_kinks(const Current& current) {
  std::vector<double> times, heights;
  for (const auto& factor : current.factors) times.push_back(factor.t);
  for (const auto& drift : current.drifts) times.push_back(drift.t);
  for (const auto& sample : current.samples) heights.push_back(sample.z);
  if (times.empty()) times.push_back(0);
  if (heights.empty()) heights.push_back(0);
  std::vector<VelocitiesOverHeight> all;
  for (const double t : times) {
    VelocitiesOverHeight& velocities = all.emplace_back();
    for (const double z : heights) {
      std::array<double, 3> velocity, dz;
      current.at(z, velocity, dz, t);
      velocities.push_back(velocity);
    }
  }
  return all;
}

}  // namespace netloft::scenes
