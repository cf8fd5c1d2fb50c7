// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/scene_reading.hpp"

namespace netloft::scenes {

/// Reads `[results]`: what is asked of the answer, and whether there is such a thing.
class ResultReader : ReadingStep {
 public:
  explicit ResultReader(SceneReading& reading) : ReadingStep(reading) {}

  void read();

 private:
  void read_result(const std::string& name, formats::TableReader& entry, bool holds_are_known);
  void check_reaction(const ResultRequest& request, formats::TableReader& entry);
};

}  // namespace netloft::scenes
