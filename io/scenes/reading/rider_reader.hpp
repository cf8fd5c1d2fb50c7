// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/scene_reading.hpp"

#include <set>

namespace netloft::scenes {

/// Reads parts that stand on others, once the scene has its nodes: those with a table of their own, what of a
/// net plan touches the bed, and the elements that ride on those of a part.
class RiderReader : ReadingStep {
 public:
  explicit RiderReader(SceneReading& reading) : ReadingStep(reading), companions_(reading.companions) {}

  void read(const std::string& name, formats::TableReader& table);
  /// Parts of the plan that touch the bed.
  void read_contacts();
  void add_companions();

 private:
  std::set<std::uint32_t> carried_by_beds() const;

  std::vector<const ElementType*>& companions_;
};

}  // namespace netloft::scenes
