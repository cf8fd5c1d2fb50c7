// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/element_choice.hpp"
#include "io/scenes/reading/gear_steps.hpp"

#include <set>

namespace netloft::scenes {

/// Makes the riders of a scene: parts without nodes of their own, whose elements are on the nodes or elements
/// of other parts. There are three kinds of riders: parts with a table of their own, the contact parts of a
/// net plan, and companions, which an element type adds to its parts. Nodes must be numbered.
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
  /// Reads and checks those keys of a rider's table that need no mesh.
  void read_undivided(const std::string& name, formats::TableReader& table);
  /// Makes the contact parts that keep a gear of a net plan on the bed.
  void read_contacts();
  /// Reads and checks those keys of `[elements.contact]` that need no mesh.
  void read_contacts_undivided();
  void add_companions();
  /// The element types of the companions. Companions are the last parts of the scene, in this order.
  const std::vector<const ElementType*>& companions() const { return companions_; }

 private:
  std::set<std::uint32_t> carried_by_beds() const;

  formats::TableReader& root_;
  formats::Diagnostics& diagnostics_;
  const ElementChoice& elements_;
  Draft& draft_;
  LoadedScene& out_;  // the scene of the draft
  const GearSteps& gear_;
  std::vector<const ElementType*> companions_;
};

}  // namespace netloft::scenes
