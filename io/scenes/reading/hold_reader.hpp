// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/holder.hpp"
#include "io/scenes/reading/one_sided_holds.hpp"
#include "io/scenes/reading/scene_reading.hpp"

namespace netloft::scenes {

/// Reads `[[hold]]`: what is held, where, and along which course it goes.
class HoldReader : ReadingStep {
 public:
  explicit HoldReader(SceneReading& reading) : ReadingStep(reading) {}

  void read();
  /// Nothing moves in a static analysis, unless somebody looks at a motion that way for once.
  void check_guides();
  void report_one_sided() const { one_sided_.report(draft_, diagnostics_); }

 private:
  std::vector<std::uint32_t> find_held(const HoldEntry& entry, formats::TableReader& table);
  void refuse_carried(const Mention& m, std::uint32_t node);
  void guide(Course course, const HoldEntry& entry, const Hold& hold, formats::TableReader& table);
  void check_hold_name(const HoldEntry& entry, formats::TableReader& table);

  std::vector<formats::TableReader> guides_;  // holds that move
  OneSidedHolds one_sided_;
  std::map<std::string, formats::Place> hold_names_;
};

}  // namespace netloft::scenes
