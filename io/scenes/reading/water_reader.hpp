// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/bottom.hpp"
#include "io/scenes/reading/gear_steps.hpp"
#include "io/scenes/reading/keys.hpp"
#include "io/scenes/reading/tauti.hpp"

namespace netloft::scenes {

/// Reads what a gear is towed through and over: `[water]`, `[tow]`, `[bed]`, and the speed of the `[ship]`.
class WaterReader {
 public:
  WaterReader(formats::TableReader& root, Draft& draft, const GearSteps& gear)
      : root_(root), diagnostics_(root.diagnostics()), draft_(draft), out_(draft.out), gear_(gear) {}

  void read();
  /// Waves act on what moves; a static result would be one of still water.
  void check_waves();
  /// Forces of an equilibrium are similar by Tauti's rule, masses are not.
  void take_model();
  /// Gives the ground of the bed to all parts that rest on it.
  void lay_bottom();
  /// The key of the bed that tells port from starboard; null: none does.
  const char* uneven_key() const;
  bool says_tow() const { return says_tow_; }

 private:
  void read_ship();
  void take_water(const WaterKeys& keys, formats::TableReader& water);

  formats::TableReader& root_;
  formats::Diagnostics& diagnostics_;
  const Draft& draft_;
  LoadedScene& out_;  // of the draft
  const GearSteps& gear_;
  bool says_tow_ = false;
  SeaBottom bottom_;
  std::optional<TautiModel> tauti_;
};

}  // namespace netloft::scenes
