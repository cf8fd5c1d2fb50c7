// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/draft.hpp"

namespace netloft::scenes {

/// Reads `[results]`, the numbers that a scene requests, and checks that they exist.
class ResultReader {
 public:
  ResultReader(formats::TableReader& root, Draft& draft)
      : root_(root), diagnostics_(root.diagnostics()), draft_(draft), out_(draft.out) {}

  void read();

 private:
  void read_result(const std::string& name, formats::TableReader& entry, bool holds_are_known);
  void check_reaction(const ResultRequest& request, formats::TableReader& entry);

  formats::TableReader& root_;
  formats::Diagnostics& diagnostics_;
  Draft& draft_;
  LoadedScene& out_;  // the scene of the draft
};

}  // namespace netloft::scenes
