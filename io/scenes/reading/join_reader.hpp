// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/gear_steps.hpp"
#include "io/scenes/reading/joiner.hpp"
#include "io/scenes/reading/mesh_parts.hpp"

namespace netloft::scenes {

/// Joins parts as `[[join]]`, mesh files and the net plan demand, and numbers the nodes of the scene.
class JoinReader {
 public:
  JoinReader(formats::TableReader& root, Draft& draft, const MeshParts& meshes, const GearSteps& gear)
      : root_(root), diagnostics_(root.diagnostics()), draft_(draft), meshes_(meshes), gear_(gear) {}

  void read();

 private:
  /// A valid [[join]], and its place in the file.
  struct Join {
    std::vector<Joiner::Ends> sets;
    Mention at;
    bool together;  // true: all nodes of all sets become one; false: for each i, the nodes i of all sets do
    void make(Joiner& joiner) const { together ? joiner.gather(sets) : joiner.join(sets); }
  };

  void join_by_others(Joiner& joiner) const;
  void read_join(formats::TableReader& table, Joiner& joiner);
  bool can_be_joined(const std::vector<Joiner::Ends>& sets, const std::vector<std::string>& points,
                     formats::TableReader& table, bool together);
  void check_joins(Joiner& joiner) const;
  std::optional<Joiner::Collapse> find_collapse(std::size_t number) const;
  void number(Joiner& joiner);

  formats::TableReader& root_;
  formats::Diagnostics& diagnostics_;
  Draft& draft_;
  const MeshParts& meshes_;
  const GearSteps& gear_;
  std::vector<Join> joins_;
};

}  // namespace netloft::scenes
