// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"
#include "io/formats/toml/table_reader.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace netloft::hard_cases {

/// One way to spoil a start: x ← x + noise, c + F (x − c), c + R (x − c), x + d, or x of another free node.
/// Held nodes keep their coordinates along the axes of their hold; rigid bodies do not move.
struct StartStep {
  enum class Kind { noise, scale, turn, shift, shuffle };
  Kind kind = Kind::noise;
  double amplitude = 0;                   // of noise: uniform in a cube of half this edge [m]
  double angle = 0;                       // of a turn [rad]
  int axis = 0;                           // it turns about: 0 x, 1 y, 2 z
  std::array<double, 3> factor{1, 1, 1};  // of a scaling, by axis
  std::array<double, 3> about{};          // what stays in place when it is scaled or turned [m]
  std::array<double, 3> shift{};          // [m]
  std::uint64_t seed = 1;
};

/// `start = [{ noise = "2 m", seed = 1 }, { scale = [1, 1, 3] }, { turn = "90 deg", axis = "x" }, …]`;
/// seeds that are not given follow from `seed`.
std::vector<StartStep> read_start(formats::TableReader& table, std::uint64_t seed);

/// Moves the nodes of the scene, step by step.
void spoil(Scene& scene, const std::vector<StartStep>& steps);

}  // namespace netloft::hard_cases
