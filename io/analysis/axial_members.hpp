// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "framework/scene/scene.hpp"

#include <span>
#include <vector>

namespace netloft::io {

/// What has one tension and keeps its line: a bar of a rope, or all bars of one direction of a triangle of
/// netting.
///   w = Σ c_i x_i,  l = ‖w‖,  t = w/l,  ε = l/l₀ − 1                                    (1)
///   T = EA ε where taut, EA_c ε where pressed;  forces n c_i T t on its nodes           (2)
/// x positions of the nodes [m]; l₀ unstretched length [m]; EA, EA_c stiffness in tension and compression
/// [N]; n bars that are alike [1].
struct AxialMember {
  std::uint32_t part = 0;  // of the scene
  std::uint32_t nodes = 2;
  std::array<std::uint32_t, 3> node{};
  std::array<double, 3> c{};
  double l0 = 0, EA = 0, EA_compression = 0, count = 1;
};

/// The members of all parts that have them: elements on bars or triangles, shipped or not, with one stiffness
/// in newtons and one of what is slack, by the roles of their parameters. What else a law may do with these
/// is not known here: where it ends is a start, not an answer.
std::vector<AxialMember> axial_members(const Scene& scene, Registry& registry);

/// The same scene in which its members are as little stiff as their elements allow, as a rule not at all: all
/// other forces are left.
Scene without_axial_stiffness(const Scene& scene, Registry& registry, std::span<const AxialMember> members);

}  // namespace netloft::io
