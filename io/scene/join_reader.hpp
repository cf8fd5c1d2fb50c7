// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scene/joiner.hpp"
#include "io/scene/scene_reading.hpp"

namespace netloft::io {

/// Joins parts, by `[[join]]`, by their meshes and by the net plan, and numbers the nodes of the scene.
class JoinReader {
 public:
  explicit JoinReader(SceneReading& reading)
      : reading_(reading), diagnostics_(reading.diagnostics), draft_(reading.draft), gear_(reading.gear) {}

  void read();

 private:
  /// A [[join]] that was made, and where it stands.
  struct Join {
    std::vector<Joiner::Ends> sets;
    Mention at;
    bool together;  // all nodes in one
    void make(Joiner& joiner) const { together ? joiner.gather(sets) : joiner.join(sets); }
  };

  void join_by_others(Joiner& joiner) const;
  void read_join(TableReader& table, Joiner& joiner);
  bool can_be_joined(const std::vector<Joiner::Ends>& sets, const std::vector<std::string>& points,
                     TableReader& table, bool together);
  void check_joins(Joiner& joiner) const;
  void number(Joiner& joiner);

  SceneReading& reading_;
  Diagnostics& diagnostics_;
  Draft& draft_;
  std::optional<GearParts>& gear_;
  std::vector<Join> joins_;
};

}  // namespace netloft::io
