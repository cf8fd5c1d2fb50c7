// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/motion/warp_figures.hpp"

#include "io/scenes/reading/known_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace netloft::results {

namespace {

void set(std::vector<NamedScalar>& gear, const std::string& name, const char* unit, const char* doc,
         double value) {
  for (NamedScalar& figure : gear)
    if (figure.name == name) return void(figure.value = value);
  NamedScalar figure;
  figure.name = name;
  figure.unit = unit;
  figure.doc = doc;
  figure.value = value;
  gear.push_back(std::move(figure));
}

/// The length of a rope at time t, divided by its unstretched length in the scene. It is linear between the
/// rows (t, factor) of the part, and constant after the last row; 1 without rows.
double factor_at(const Part& part, double t) {
  const auto given = part.parameters.find(scenes::parameter::kLengthShare.name);
  const auto* rows = given == part.parameters.end() ? nullptr : std::get_if<Samples>(&given->second);
  if (!rows || rows->empty()) return 1;
  const auto next = std::ranges::upper_bound(*rows, t, {}, [](const auto& row) { return row[0]; });
  if (next == rows->begin()) return rows->front()[1];
  if (next == rows->end()) return rows->back()[1];
  const auto &a = next[-1], &b = *next;
  return a[1] + (b[1] - a[1]) * (t - a[0]) / (b[0] - a[0]);
}

double length_at(const Part& part, double t) {
  const auto* lengths = find_data(part.data, datum::kRestLength);
  if (!lengths) return NamedScalar::kUnknown;
  return factor_at(part, t) * std::accumulate(lengths->begin(), lengths->end(), 0.0);
}

}  // namespace

void add_warp_figures(const scenes::LoadedScene& loaded, const Assembler& assembler, const Snapshot& at,
                      std::vector<NamedScalar>& gear) {
  if (!loaded.gear) return;
  const auto warps = loaded.gear->roles.find("warp");
  if (warps == loaded.gear->roles.end()) return;
  for (const std::uint32_t rope : warps->second) {
    const Part& part = loaded.scene.parts[rope];
    const std::string own = "warps/" + part.name + "/";
    const auto force = assembler.reaction(loaded.parts[rope].nodes.front(), at.forces.residual);
    const auto winch = std::ranges::find(at.winches, part.name, &WinchMoment::rope);
    const bool holds = winch != at.winches.end();
    set(gear, own + "length", "m", "unstretched length of the warp",
        holds ? winch->length : length_at(part, at.t));
    set(gear, own + "tension", "N",
        "force of the warp on the block; its mean over the last step, if the time scheme computes mean "
        "forces",
        std::hypot(force[0], force[1], force[2]));
    if (holds) set(gear, own + "paying_out", "m/s", "speed of the winch; negative: hauling", winch->speed);
  }
}

}  // namespace netloft::results
