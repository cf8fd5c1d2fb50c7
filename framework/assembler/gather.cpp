// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/gather.hpp"

#include <algorithm>
#include <cassert>

namespace netloft {

namespace {

/// Copies entries of a vector over all dofs into the layout of a tile.
void gather_vector(const Tiling& tiling, std::size_t tile, const double* from, double* to) {
  const auto dofs = static_cast<std::size_t>(tiling.family->type().dofs());
  const std::size_t count = tiling.lanes(tile);
  const std::int32_t* map = &tiling.vector_map[tile * dofs * kTileLanes];
  for (std::size_t d = 0; d < dofs; ++d, map += kTileLanes, to += kTileLanes)
#pragma GCC unroll 8
    for (std::size_t lane = 0; lane < count; ++lane) to[lane] = from[map[lane]];
}

/// Converts rotations of bodies, whose unknowns are lengths, to radians for the elements.
void divide_rotations(const Tiling& tiling, std::size_t tile, double* rows) {
  for (std::size_t lane = 0; lane < tiling.lanes(tile); ++lane)
    for (std::size_t d = 3; d < 6; ++d)
      rows[d * kTileLanes + lane] /= tiling.family->arm(tile * kTileLanes + lane);
}

}  // namespace

void gather_positions(const Tiling& tiling, std::size_t tile, const double* x, double* to) {
  gather_vector(tiling, tile, x, to);
  if (tiling.family->type().is_on_body()) divide_rotations(tiling, tile, to);
}

Gatherer::Gatherer(const Scene& scene, const ScenePlan& plan)
    : water_(scene.water),
      current_(scene.current),
      waves_(plan.kind == AnalysisKind::dynamics ? scene.waves : nullptr),
      ground_(scene.ground),
      bed_(scene.bed),
      ground_passes_(scene.ground != std::array<double, 3>{}),
      has_rates_(plan.kind == AnalysisKind::dynamics) {}

TileInputs Gatherer::make_inputs(std::size_t dofs) const {
  const std::size_t numbers = dofs * kTileLanes, flow = current_.flows() || waves_ ? numbers : 0;
  TileInputs in;
  in.x.resize(numbers);
  in.x_low.resize(numbers);
  in.v.resize(has_rates_ ? numbers : 0);
  in.a.resize(in.v.size());
  in.current.resize(flow);
  in.current_dz.resize(flow);
  in.water_acceleration.resize(waves_ ? numbers : 0);
  in.surface.resize(in.water_acceleration.size() / 3);
  in.bed.resize(2 * numbers);
  return in;
}

void Gatherer::gather(const FamilyGroup& group, std::size_t tile, std::span<const double> x,
                      const Kinematics& motion, TileInputs& w) const {
  assert(tile < group.tiling.tiles);
  const Tiling& tiling = group.tiling;
  const auto some_read = [&](std::uint32_t trait) { return (group.traits & trait) != 0; };
  gather_vector(tiling, tile, x.data(), w.x.data());
  if (motion.x_low) gather_vector(tiling, tile, motion.x_low, w.x_low.data());
  assert((!motion.v || !some_read(NETLOFT_READS_VELOCITY) || !w.v.empty()) && "a static plan has no rates");
  if (motion.v && some_read(NETLOFT_READS_VELOCITY)) gather_vector(tiling, tile, motion.v, w.v.data());
  if (motion.a && some_read(NETLOFT_READS_ACCELERATION)) gather_vector(tiling, tile, motion.a, w.a.data());
  if (tiling.family->type().is_on_body())
    for (auto* rows : {&w.x, &w.v, &w.a})
      if (!rows->empty()) divide_rotations(tiling, tile, rows->data());
  const bool in_waves = waves_ && (some_read(NETLOFT_READS_CURRENT) || some_read(NETLOFT_READS_WAVES));
  if (in_waves || (!w.current.empty() && some_read(NETLOFT_READS_CURRENT)))
    gather_current(tiling, tile, motion.time, w);
  if (in_waves) gather_waves(tiling, tile, motion.time, w);
  if (bed_.is_there && some_read(NETLOFT_READS_BED)) gather_bed(tiling, tile, w);
}

netloft_tile Gatherer::make_tile(const ElementFamily& f, std::size_t tile, const Kinematics& motion,
                                 TileInputs& w) const {
  netloft_tile t{};
  t.size = sizeof t;
  t.first = static_cast<std::uint32_t>(tile * kTileLanes);
  t.count = static_cast<std::uint32_t>(std::min(kTileLanes, f.size() - tile * kTileLanes));
  t.time = motion.time;
  t.cu = motion.cu;
  t.cv = motion.cv;
  t.ca = motion.ca;
  t.water_density = water_.density;
  t.gravity = water_.gravity;
  t.water_viscosity = water_.viscosity * f.viscosity_ratio();
  t.x = w.x.data();
  if (motion.x_low) t.x_low = w.x_low.data();
  if (motion.v && f.reads(NETLOFT_READS_VELOCITY)) t.v = w.v.data();
  if (motion.a && f.reads(NETLOFT_READS_ACCELERATION)) t.a = w.a.data();
  if (!w.current.empty() && f.reads(NETLOFT_READS_CURRENT)) {
    t.current = w.current.data();
    t.current_dz = w.current_dz.data();
  }
  const bool meets_waves = waves_ && f.reads(NETLOFT_READS_WAVES);
  w.extensions.ground.velocity = ground_passes_ && f.reads(NETLOFT_READS_GROUND) ? ground_.data() : nullptr;
  w.extensions.ground.bed = bed_.is_there && f.reads(NETLOFT_READS_BED) ? w.bed.data() : nullptr;
  w.extensions.waves.acceleration = meets_waves ? w.water_acceleration.data() : nullptr;
  w.extensions.waves.surface = meets_waves ? w.surface.data() : nullptr;
  return t;
}

/// Computes the velocity of the water at the nodes of a tile (64 elements), whose positions have been
/// gathered. A uniform current without waves is computed once for all tiles.
void Gatherer::gather_current(const Tiling& tiling, std::size_t tile, double time, TileInputs& w) const {
  if (current_.is_uniform() && !waves_) return fill_current(time, w);
  std::array<double, 3> velocity, dz;
  for (std::size_t node = 0; node < static_cast<std::size_t>(tiling.family->nodes_per_element()); ++node)
    for (std::size_t lane = 0; lane < tiling.lanes(tile); ++lane) {
      current_.at(w.x[(3 * node + 2) * kTileLanes + lane], velocity, dz, time);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        w.current[(3 * node + axis) * kTileLanes + lane] = velocity[axis];
        w.current_dz[(3 * node + axis) * kTileLanes + lane] = dz[axis];
      }
    }
}

/// Adds the waves to the gathered current at the nodes of a tile. Elements receive the derivative of the
/// velocity with z only (`current_dz`), so that the tangent contains no horizontal change of the waves. The
/// horizontal change that is left out is the slope of the drag times k a ω h, with wave number k, amplitude
/// a, angular frequency ω and step length h. It is small compared with inertia.
void Gatherer::gather_waves(const Tiling& tiling, std::size_t tile, double time, TileInputs& w) const {
  for (std::size_t node = 0; node < static_cast<std::size_t>(tiling.family->nodes_per_element()); ++node)
    for (std::size_t lane = 0; lane < tiling.lanes(tile); ++lane) {
      const auto at = [&](std::size_t axis) { return (3 * node + axis) * kTileLanes + lane; };
      const WaterMotion water = waves_->at({w.x[at(0)], w.x[at(1)], w.x[at(2)]}, time);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        w.current[at(axis)] += water.velocity[axis];
        w.current_dz[at(axis)] += water.velocity_dz[axis];
        w.water_acceleration[at(axis)] = water.acceleration[axis];
      }
      w.surface[node * kTileLanes + lane] = water.surface;
    }
}

/// Evaluates the bed below the nodes of a tile, whose positions have been gathered.
void Gatherer::gather_bed(const Tiling& tiling, std::size_t tile, TileInputs& w) const {
  for (std::size_t node = 0; node < static_cast<std::size_t>(tiling.family->nodes_per_element()); ++node)
    for (std::size_t lane = 0; lane < tiling.lanes(tile); ++lane) {
      const auto below = bed_.at(w.x[3 * node * kTileLanes + lane], w.x[(3 * node + 1) * kTileLanes + lane]);
      for (std::size_t k = 0; k < 6; ++k) w.bed[(6 * node + k) * kTileLanes + lane] = below[k];
    }
}

/// Writes a current that is the same at all heights to a tile. It is computed only when the time changes.
void Gatherer::fill_current(double time, TileInputs& w) const {
  if (w.current_time == time) return;
  w.current_time = time;
  std::array<double, 3> velocity, dz;
  current_.at(0, velocity, dz, time);
  for (std::size_t i = 0; i < w.current.size(); ++i) w.current[i] = velocity[i / kTileLanes % 3];
}

}  // namespace netloft
