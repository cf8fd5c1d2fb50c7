// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/element_choice.hpp"
#include "io/scenes/reading/gear_steps.hpp"

#include <set>

namespace netloft::scenes {

/// Reads riders, the parts that stand on others, once the nodes of the scene are numbered: parts with a table
/// of their own, contacts of a net plan with the bed, and companion elements of parts.
class RiderReader {
 public:
  RiderReader(formats::TableReader& root, const ElementChoice& elements, Draft& draft, const GearSteps& gear)
      : root_(root),
        diagnostics_(root.diagnostics()),
        elements_(elements),
        draft_(draft),
        out_(draft.out),
        gear_(gear) {}

  void read(const std::string& name, formats::TableReader& table);
  /// Reads the contacts of the plan with the bed.
  void read_contacts();
  void add_companions();
  /// The element types of the companions, which are the last parts of the scene.
  const std::vector<const ElementType*>& companions() const { return companions_; }

 private:
  std::set<std::uint32_t> carried_by_beds() const;

  formats::TableReader& root_;
  formats::Diagnostics& diagnostics_;
  const ElementChoice& elements_;
  Draft& draft_;
  LoadedScene& out_;  // of the draft
  const GearSteps& gear_;
  std::vector<const ElementType*> companions_;
};

}  // namespace netloft::scenes
