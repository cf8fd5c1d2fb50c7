// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/standard_gravity.hpp"
#include "io/formats/mesh/mesh.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace netloft::scenes {

/// A node in a table of nodes and bars.
struct TableNode {
  std::string name;
  formats::Place place;
  std::array<double, 3> at{}, force{};  // position [m], force [N]
  std::string hold;                     // held axes: "", "z", "xyz"
  double mass = 0, buoyancy = 0;        // mass [kg], or instead buoyancy minus weight in water [N]
  double volume = 0, drag_area = 0;     // displaced water [m³]; drag coefficient times area [m²]
};

/// A rope: all bars with the same rope name, in the order of their rows.
struct TableRope {
  struct Bar {
    std::array<std::uint32_t, 2> nodes{};
    double length = 0;  // unstretched length [m]
  };
  std::string name;
  formats::Place place;
  double diameter = 0, EA = 0, density = 0, EI = 0;  // [m], [N], [kg/m³], [N m²] in this order
  std::optional<double> EA_compression;              // [N]
  std::optional<double> normal, tangential;          // coefficients of drag
  double bed = 0;  // stiffness of the seabed under the rope [N/m²]; 0: no seabed
  std::vector<Bar> bars;
};

/// A number that a run of the scene reports: the quantity `take` of the nodes or part `of`.
struct TableResult {
  std::string name, of, take;
};

/// A table of nodes and bars.
struct BarTable {
  std::vector<TableNode> nodes;
  std::vector<TableRope> ropes;
  std::vector<TableResult> results = {};
  // Density [kg/m³] and depth [m] of the water, and gravity [m/s²].
  double density = 1025, gravity = kStandardGravity, depth = 0;
};

/// Reads a table (TABLE.md). Errors are reported at their line and column; `file` is the index of `text`
/// among the sources of `diagnostics`. After an error the result contains whatever could be read.
BarTable read_bar_table(const std::string& text, int file, formats::Diagnostics& diagnostics);

/// A scene that is made from a table, and the mesh of its parts. `head` contains the lines of the comment at
/// the beginning of the scene.
struct BarTableScene {
  std::string scene;
  formats::InputMesh mesh;
};
BarTableScene scene_of(const BarTable& table, const std::vector<std::string>& head,
                       const std::string& mesh_name);

}  // namespace netloft::scenes
