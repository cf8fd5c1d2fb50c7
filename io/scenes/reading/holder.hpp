// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/table_reader.hpp"
#include "io/scenes/reading/geometry_keys.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

#include <memory>
#include <optional>
#include <unordered_map>

namespace netloft::scenes {

/// The content of one `[[hold]]`.
struct HoldEntry {
  std::vector<std::string> on;
  std::string name;
  std::uint8_t axes = kAllAxes;
  // Axes of the hold if the key `along` or `plane` is used; nullopt for the axes of the world.
  std::optional<std::array<double, 9>> frame;
  // Points of a line on which the nodes are held; empty: nodes are held at their initial positions.
  std::vector<std::array<double, 3>> at;
  Course course;          // the motion of the nodes; empty: none
  bool is_loose = false;  // see Hold::is_loose
};

/// Reads one hold; errors go to the diagnostics of `table`.
HoldEntry read_hold(formats::TableReader& table);

/// Holds nodes of a scene at the positions of `[[hold]]` entries, and finds entries that contradict each
/// other: entries that hold a node along the same direction must give it the same place and motion along this
/// direction.
class Holder {
 public:
  explicit Holder(Scene& scene);

  /// Holds `nodes` of the scene, which are in the order of their set (an edge, for example). If an earlier
  /// entry already holds a node along an axis, the reaction along this axis belongs to the earlier entry
  /// only, so that the reactions of all entries add up to the total on the gear.
  Hold hold(const HoldEntry& entry, const std::vector<std::uint32_t>& nodes, formats::TableReader& table);

 private:
  /// Records that an entry or the net plan holds a node along an axis.
  struct Grip {
    std::optional<formats::Place> said_at;  // nullopt: the net plan holds the node
    Course course;
  };
  /// For each axis of a node, the grip that holds the node along this axis; nullptr if the node is free along
  /// the axis, or if the net plan holds it at rest.
  using Grips = std::array<std::shared_ptr<const Grip>, 3>;

  Point place(const HoldEntry& entry, std::size_t i, const std::vector<std::uint32_t>& nodes) const;
  bool can_hold(std::uint32_t node, const HoldEntry& entry) const;
  bool agrees(std::uint32_t node, const HoldEntry& entry, const Point& at, formats::TableReader& table) const;
  void put(std::uint32_t node, const HoldEntry& entry, const Point& at,
           const std::shared_ptr<const Grip>& grip);

  const std::array<double, 9>* frame_of(std::uint32_t node) const;
  Point position(std::uint32_t node) const;
  std::vector<Point> shared_directions(std::uint32_t node, const HoldEntry& entry) const;
  bool moves_alike(std::uint32_t node, const Course& course, const Point& direction) const;
  std::string holder_of(std::uint32_t node, const Point& direction, formats::Diagnostics& diagnostics) const;

  Scene& scene_;
  std::vector<double> sketch_;
  std::unordered_map<std::uint32_t, Grips> grips_;
};

}  // namespace netloft::scenes
