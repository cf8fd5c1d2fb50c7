// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/element_choice.hpp"
#include "io/scenes/reading/gear_steps.hpp"

#include <set>

namespace netloft::scenes {

/// Makes the riders of a scene, parts without nodes whose elements are on the nodes or elements of other
/// parts. There are three kinds of riders: parts with a table of their own, the contact parts of a net plan,
/// and companions, which an element type adds to its parts. Nodes must be numbered.
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
  /// Reads the table of a rider, except for the nodes and elements on which it is.
  void read_undivided(const std::string& name, formats::TableReader& table);
  /// Makes the contact parts that keep a gear of a net plan on the bed.
  void read_contacts();
  /// Reads `[elements.contact]` without the nodes of the contact parts.
  void read_contacts_undivided();
  void add_companions();
  /// The element types of the companions, in the order of the companions, which are the last parts of the
  /// scene.
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
