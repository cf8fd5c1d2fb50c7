// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/gear_steps.hpp"
#include "io/scenes/reading/holder.hpp"
#include "io/scenes/reading/one_sided_holds.hpp"

namespace netloft::scenes {

/// Reads `[[hold]]`: the held nodes, their positions, and, for a moving hold, its motion (`Course`).
class HoldReader {
 public:
  HoldReader(formats::TableReader& root, Draft& draft, const GearSteps& gear)
      : root_(root), diagnostics_(root.diagnostics()), draft_(draft), out_(draft.out), gear_(gear) {}

  void read();
  /// Reports an error for moving holds in a static analysis, unless `--set` has made the analysis static.
  void check_guides();
  void report_one_sided() const { one_sided_.report(draft_, diagnostics_); }

 private:
  std::vector<std::uint32_t> find_held(const HoldEntry& entry, formats::TableReader& table);
  void refuse_carried(const Mention& m, std::uint32_t node);
  void guide(const HoldEntry& entry, const Hold& hold, formats::TableReader& table);
  void check_hold_name(const HoldEntry& entry, formats::TableReader& table);

  formats::TableReader& root_;
  formats::Diagnostics& diagnostics_;
  Draft& draft_;
  LoadedScene& out_;  // the scene of the draft
  const GearSteps& gear_;
  std::vector<formats::TableReader> guides_;  // tables of moving holds
  OneSidedHolds one_sided_;
  std::map<std::string, formats::Place> hold_names_;
};

}  // namespace netloft::scenes
