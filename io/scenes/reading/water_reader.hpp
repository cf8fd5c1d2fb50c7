// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/bottom.hpp"
#include "io/scenes/reading/gear_steps.hpp"
#include "io/scenes/reading/keys.hpp"
#include "io/scenes/reading/tauti.hpp"

namespace netloft::scenes {

/// Reads the surroundings of a gear: `[water]`, `[tow]`, `[bed]`, and the speed of the `[ship]`.
class WaterReader {
 public:
  WaterReader(formats::TableReader& root, Draft& draft, const GearSteps& gear)
      : root_(root), diagnostics_(root.diagnostics()), draft_(draft), out_(draft.out), gear_(gear) {}

  void read();
  /// Reports an error for waves in a static analysis, where they have no effect.
  void check_waves();
  /// If the scene requests it, scales ropes and floats by Tauti's rule (tauti.hpp). A motion is then an
  /// error, because the rule makes forces similar, but not masses.
  void take_model();
  /// Gives the factors of `[bed] bottom` to all parts that rest on the bed.
  void lay_bottom();
  /// A key of `[bed]` that makes the bed differ between port and starboard; nullptr if there is none.
  const char* uneven_key() const;
  bool says_tow() const { return says_tow_; }

 private:
  void read_ship();
  void take_water(const WaterKeys& keys, formats::TableReader& water);

  formats::TableReader& root_;
  formats::Diagnostics& diagnostics_;
  const Draft& draft_;
  LoadedScene& out_;  // the scene of the draft
  const GearSteps& gear_;
  bool says_tow_ = false;
  SeaBottom bottom_;
  std::optional<TautiModel> tauti_;
};

}  // namespace netloft::scenes
