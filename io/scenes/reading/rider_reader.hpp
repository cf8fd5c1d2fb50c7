// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/element_choice.hpp"
#include "io/scenes/reading/gear_steps.hpp"

#include <set>

namespace netloft::scenes {

/// Reads parts that stand on others, once the scene has its nodes: those with a table of their own, what of a
/// net plan touches the bed, and the elements that ride on those of a part.
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
  /// Parts of the plan that touch the bed.
  void read_contacts();
  void add_companions();
  /// The types of the parts that were added last.
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
