// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/geometry.hpp"
#include "io/scenes/reading/joiner.hpp"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace netloft::scenes {

/// Keeps the first of each.
void drop_repeats(std::vector<std::uint32_t>& nodes);

/// A name and its place, for errors.
struct Mention {
  std::string name;
  formats::Place place;
  std::string path;  // "hold[0].on"
};

/// A name that stands under `key`.
Mention mention(const std::string& name, const formats::TableReader& table, std::string_view key);
/// One of several; of a name that stands there alone, the key itself.
Mention mention_of_item(const std::string& name, formats::TableReader& table, std::string_view key,
                        std::size_t i);

/// A scene while it is read: its parts with what is known of each, and the names of their edges and points.
class Draft {
 public:
  explicit Draft(formats::Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  /// A part on nodes of its own. `type` is null if nobody knows it; not sound: there is an error in its
  /// table, so that its number of nodes need not be true and nothing that depends on it is judged.
  void add_part(Part part, Geometry geometry, const ElementType* type, bool is_sound);
  /// A part that stands on others, once nodes are numbered; announced before, so that its name is known.
  void announce_rider(const std::string& name) { riders_.insert(name); }
  void add_rider(Part part, formats::Place place, const ElementType* type, bool is_sound);

  /// "net", "net.fore", "net.node-17": own nodes of one part. If there are none, it is said where they were
  /// mentioned.
  std::optional<Joiner::Ends> find_set(const Mention& m);
  /// The same where nodes are wanted. A part that stands on others has none of its own.
  std::optional<Joiner::Ends> find_nodes(const Mention& m);
  /// Nodes of the scene, once they are numbered.
  std::vector<std::uint32_t> scene_nodes(const Joiner::Ends& ends) const;
  void refuse_rider(const Mention& m, const std::string& name);
  std::optional<std::size_t> part_number(const std::string& name) const;
  /// "*.middle" as the names of this edge or point of all parts that have it; other names as they are. If
  /// nothing has it, it is said where it was mentioned.
  std::vector<Mention> expand(const Mention& m);
  /// The names of a pair of the plan in the whole gear: "starboard-door.toe" and "port-door.toe" for
  /// "door.toe". Other names stay as they are. So a part rests on a pair in the half and in the whole.
  std::vector<Mention> both_sides(const Mention& m) const;

  LoadedScene out;
  std::vector<Geometry> geometries;            // as out.scene.parts
  std::vector<const ElementType*> types;       // the same
  std::vector<bool> is_sound;                  // the same
  std::map<std::string, Joiner::Ends> points;  // names of their own, without a part before a dot

 private:
  std::optional<std::size_t> find_part(const Mention& m, const std::string& name);
  bool has(const std::string& name) const;
  PartGeometry& names_of(std::size_t part);

  formats::Diagnostics& diagnostics_;
  std::set<std::string> riders_;
};

}  // namespace netloft::scenes
