// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/response.hpp"
#include "io/results/figures/triangle_tree.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

#include <string>
#include <vector>

namespace netloft::results {

/// The netting and the lines of a gear, at given positions of their nodes.
struct Layers {
  struct Line {
    std::array<std::uint32_t, 2> ends;
    std::uint32_t part;
  };
  std::vector<TriangleTree::Triangle> triangles;
  std::vector<std::uint32_t> part_of_triangle;
  std::vector<Line> bars;  // bars of ropes; sides of triangles are not among them
  // For each part, the length of a bar of its meshes or, if it is a rope, its diameter [m]; 0 if it has
  // neither.
  std::vector<double> gauge;
};

/// Places at which one part passes through the netting of another one.
struct Passage {
  std::uint32_t part = 0, through = 0;
  std::size_t places = 0;         // triangles that are pierced
  double depth = 0;               // of the deepest place [m]
  std::array<double, 3> at = {};  // the deepest place [m]
};

/// Finds where sides of triangles and bars pierce triangles of other parts that are not their neighbours.
/// Triangles of one part are left out, because slack netting lies in wrinkles. A place counts if both ends
/// are off the plane of the triangle by more than the mean gauge of both parts, because meshes of layers that
/// lie on each other reach into each other. Passages are sorted by their parts.
std::vector<Passage> find_passages(const Layers& layers, std::span<const double> positions);

/// Returns a sentence for every two parts that pass through each other. Elements have no contact with each
/// other, so nothing in the mechanics prevents it.
std::vector<std::string> passage_warnings(const scenes::LoadedScene& loaded, const Assembler& assembler,
                                          const Response& answer);

}  // namespace netloft::results
