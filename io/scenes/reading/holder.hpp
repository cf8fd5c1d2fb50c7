// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/table_reader.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

#include <optional>
#include <unordered_map>

namespace netloft::scenes {

/// The content of one `[[hold]]`.
struct HoldEntry {
  std::vector<std::string> on;
  std::string name;
  std::uint8_t axes = kAllAxes;
  // Axes of the hold if the keys `along` or `plane` are used; else those of the world.
  std::optional<std::array<double, 9>> frame;
  std::vector<std::array<double, 3>> at;  // points of a line; empty: at the initial positions
};

/// Reads one hold; errors go to the diagnostics of `table`.
HoldEntry read_hold(formats::TableReader& table);

/// Holds nodes of a scene at the positions of `[[hold]]` entries, and finds entries that contradict each
/// other.
class Holder {
 public:
  explicit Holder(Scene& scene) : scene_(scene), sketch_(scene.positions) {}

  /// Holds `nodes` of the scene, in the order of their set (an edge, for example). If an earlier entry
  /// already holds a node along an axis, that entry keeps the reaction, so that the reactions of all entries
  /// add up to the total on the gear.
  Hold hold(const HoldEntry& entry, const std::vector<std::uint32_t>& nodes, formats::TableReader& table);

 private:
  using Point = std::array<double, 3>;
  /// The position and the axes along which an entry holds a node, and the place of the entry in the file.
  struct Put {
    Point point;
    std::uint8_t axes;
    formats::Place said_at;
  };

  std::vector<Point> places(const HoldEntry& entry, const std::vector<std::uint32_t>& nodes) const;
  bool put(std::uint32_t node, const Put& put, formats::TableReader& table);
  bool holds_along_world_axes(std::uint32_t node, std::uint8_t axes) const;
  bool turn(std::uint32_t node, const std::array<double, 9>& frame);

  Scene& scene_;
  std::vector<double> sketch_;
  std::unordered_map<std::uint32_t, std::vector<Put>> put_;
};

}  // namespace netloft::scenes
