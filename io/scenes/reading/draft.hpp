// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/name_index.hpp"
#include "io/scenes/reading/geometry.hpp"
#include "io/scenes/reading/joiner.hpp"
#include "io/scenes/reading/node_elements.hpp"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace netloft::scenes {

/// Removes repeated nodes and keeps the order of the others.
void drop_repeats(std::vector<std::uint32_t>& nodes);

/// A name that a scene uses, and its place in the file, for error messages.
struct Mention {
  std::string name;
  formats::Place place;
  std::string path;  // path of its key: "hold[0].on"
};

/// The mention of a name that is the value of `key` in `table`.
Mention mention(const std::string& name, const formats::TableReader& table, std::string_view key);
/// The mention of a name that is item i of the array `key`. If the value is a single name instead of an
/// array, the mention has the place of the key.
Mention mention_of_item(const std::string& name, formats::TableReader& table, std::string_view key,
                        std::size_t i);

/// A scene while it is read: its parts, the geometry and element type of each part, and the names of edges
/// and points.
class Draft {
 public:
  explicit Draft(formats::Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  /// Adds a part with nodes of its own. `type` is nullptr if the element type is unknown. `is_sound` is false
  /// if the table of the part has an error. The number of its nodes may then be wrong, so that checks that
  /// depend on this number are skipped.
  void add_part(Part part, Geometry geometry, const ElementType* type, bool is_sound);
  /// Makes the name of a rider known before nodes are numbered. A rider is a part without nodes of its own,
  /// whose elements are on the nodes or elements of other parts; add_rider() adds it after the numbering.
  void announce_rider(const std::string& name) { riders_.insert(name); }
  void add_rider(Part part, formats::Place place, const ElementType* type, bool is_sound);

  /// Finds the nodes that a name ("net", "net.fore", "net.node-17") means, as numbers within one part. If
  /// there are none, reports an error at the mention and returns nullopt.
  std::optional<Joiner::Ends> find_set(const Mention& m);
  /// Like find_set(), but the name of a rider is an error, because a rider has no nodes.
  std::optional<Joiner::Ends> find_nodes(const Mention& m);
  /// Converts node numbers within a part to node numbers of the scene. Nodes must be numbered.
  std::vector<std::uint32_t> scene_nodes(const Joiner::Ends& ends) const;
  /// The elements at the nodes of the scene, without those of riders; nodes must be numbered.
  const NodeElements& node_elements() const;
  void refuse_rider(const Mention& m, const std::string& name);
  std::optional<std::size_t> part_number(const std::string& name) const;
  /// Expands "*.middle" to the names "PART.middle" for all parts that have an edge or point `middle`, and
  /// reports an error if none has it. Returns other names unchanged.
  std::vector<Mention> expand(const Mention& m);
  /// Expands the name of a body of a pair if the whole gear is modelled: "door.toe" becomes
  /// "starboard-door.toe" and "port-door.toe". Returns other names unchanged. A scene can therefore use the
  /// name "door.toe" both for half the gear and for the whole gear.
  std::vector<Mention> both_sides(const Mention& m) const;

  LoadedScene out;
  std::vector<Geometry> geometries;            // geometries in the order of out.scene.parts
  std::vector<const ElementType*> types;       // element types in the order of out.scene.parts
  std::vector<bool> is_sound;                  // whether each part is sound, in the order of out.scene.parts
  std::map<std::string, Joiner::Ends> points;  // points whose names have no dot, by name

 private:
  std::optional<std::size_t> find_part(const Mention& m, const std::string& name);
  std::string part_hint(const std::string& name) const;
  bool has(const std::string& name) const;
  PartGeometry& names_of(std::size_t part);

  formats::Diagnostics& diagnostics_;
  std::set<std::string> riders_;
  mutable formats::NameIndex numbers_;  // the names in `geometries`
  mutable std::optional<NodeElements> node_elements_;
};

}  // namespace netloft::scenes
