// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scene/scene_reading.hpp"

namespace netloft::io {

/// Reads `[results]`: what is asked of the answer, and whether there is such a thing.
class ResultReader {
 public:
  explicit ResultReader(SceneReading& reading)
      : root_(reading.root), diagnostics_(reading.diagnostics), draft_(reading.draft), out_(reading.out()) {}

  void read();

 private:
  void read_result(const std::string& name, TableReader& entry, bool holds_are_known);
  void check_reaction(const ResultRequest& request, TableReader& entry);

  TableReader& root_;
  Diagnostics& diagnostics_;
  Draft& draft_;
  LoadedScene& out_;  // of the draft
};

}  // namespace netloft::io
