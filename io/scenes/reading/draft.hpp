// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/geometry.hpp"
#include "io/scenes/reading/joiner.hpp"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace netloft::scenes {

/// Removes all but the first of equal nodes; the order stays.
void drop_repeats(std::vector<std::uint32_t>& nodes);

/// A name in a scene and its place in the file, for error messages.
struct Mention {
  std::string name;
  formats::Place place;
  std::string path;  // "hold[0].on"
};

/// The mention of `name`, which is the value of `key`.
Mention mention(const std::string& name, const formats::TableReader& table, std::string_view key);
/// The mention of item i of an array under `key`. If the value is a single name, its place is that of the
/// key.
Mention mention_of_item(const std::string& name, formats::TableReader& table, std::string_view key,
                        std::size_t i);

/// A scene while it is read: its parts, the geometry and element type of each part, and the names of edges
/// and points.
class Draft {
 public:
  explicit Draft(formats::Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  /// Adds a part with nodes of its own. `type` is null if the element type is unknown. `is_sound` is false if
  /// the table of the part has an error; its number of nodes may then be wrong, so nothing that depends on it
  /// is checked.
  void add_part(Part part, Geometry geometry, const ElementType* type, bool is_sound);
  /// Makes the name of a rider known before nodes are numbered. A rider is a part that stands on other parts;
  /// add_rider() adds it after the numbering.
  void announce_rider(const std::string& name) { riders_.insert(name); }
  void add_rider(Part part, formats::Place place, const ElementType* type, bool is_sound);

  /// The own nodes of one part that a name means: "net", "net.fore", "net.node-17". Empty if there are none,
  /// which is reported at the mention.
  std::optional<Joiner::Ends> find_set(const Mention& m);
  /// The same, but a rider, which has no nodes of its own, is an error.
  std::optional<Joiner::Ends> find_nodes(const Mention& m);
  /// The scene nodes of `ends`; nodes must be numbered.
  std::vector<std::uint32_t> scene_nodes(const Joiner::Ends& ends) const;
  void refuse_rider(const Mention& m, const std::string& name);
  std::optional<std::size_t> part_number(const std::string& name) const;
  /// Expands "*.middle" to the names of this edge or point in all parts that have it; returns other names
  /// unchanged. If no part has it, this is reported at the mention.
  std::vector<Mention> expand(const Mention& m);
  /// Expands the name of a pair of the plan in a whole gear: "door.toe" becomes "starboard-door.toe" and
  /// "port-door.toe". Returns other names unchanged. The same scene can therefore stand a part on a pair
  /// whether a half or the whole is modelled.
  std::vector<Mention> both_sides(const Mention& m) const;

  LoadedScene out;
  std::vector<Geometry> geometries;            // in the order of out.scene.parts
  std::vector<const ElementType*> types;       // the same
  std::vector<bool> is_sound;                  // the same
  std::map<std::string, Joiner::Ends> points;  // points named without a part and a dot

 private:
  std::optional<std::size_t> find_part(const Mention& m, const std::string& name);
  bool has(const std::string& name) const;
  PartGeometry& names_of(std::size_t part);

  formats::Diagnostics& diagnostics_;
  std::set<std::string> riders_;
};

}  // namespace netloft::scenes
