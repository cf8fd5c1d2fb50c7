// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"
#include "io/formats/toml/table_reader.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace netloft::hard_cases {

/// One way to disturb the initial shape, for each node at x: noise x ← x + random, scale c + F (x − c), turn
/// c + R (x − c), shift x + d, or shuffle, which moves a node to the position of another free node. Held
/// nodes keep the coordinates that are held; rigid bodies do not move.
struct StartStep {
  enum class Kind { noise, scale, turn, shift, shuffle };
  Kind kind = Kind::noise;
  double amplitude = 0;  // for noise: coordinates are moved by random numbers, uniform up to ± this [m]
  double angle = 0;      // of a turn [rad]
  int axis = 0;          // of a turn: 0 x, 1 y, 2 z
  std::array<double, 3> factor{1, 1, 1};  // F of a scaling, by axis
  std::array<double, 3> about{};          // c, the fixed point of scaling and turning [m]
  std::array<double, 3> shift{};          // [m]
  std::uint64_t seed = 1;
};

/// Reads `start = [{ noise = "2 m", seed = 1 }, { scale = [1, 1, 3] }, { turn = "90 deg", axis = "x" }, …]`.
/// A step without a seed gets one that follows from `seed`.
std::vector<StartStep> read_start(formats::TableReader& table, std::uint64_t seed);

/// Moves the nodes of the scene, step by step.
void spoil(Scene& scene, const std::vector<StartStep>& steps);

}  // namespace netloft::hard_cases
