// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/joiner.hpp"
#include "io/scenes/reading/scene_reading.hpp"

namespace netloft::scenes {

/// Joins parts, by `[[join]]`, by their meshes and by the net plan, and numbers the nodes of the scene.
class JoinReader : ReadingStep {
 public:
  explicit JoinReader(SceneReading& reading) : ReadingStep(reading), reading_(reading) {}

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
  void read_join(formats::TableReader& table, Joiner& joiner);
  bool can_be_joined(const std::vector<Joiner::Ends>& sets, const std::vector<std::string>& points,
                     formats::TableReader& table, bool together);
  void check_joins(Joiner& joiner) const;
  void number(Joiner& joiner);

  SceneReading& reading_;
  std::vector<Join> joins_;
};

}  // namespace netloft::scenes
