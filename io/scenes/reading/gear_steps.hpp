// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/plan/net_plan.hpp"
#include "io/scenes/reading/draft.hpp"

#include <set>
#include <utility>

namespace netloft::scenes {

class PartReader;

/// The steps of a net plan while a scene is read, in the order in which they happen. This class is for a
/// scene without a net plan: its steps do nothing. GearParts has those of a plan.
class GearSteps {
 public:
  virtual ~GearSteps() = default;

  /// False after an error in the plan or its model; nothing else in the scene is read then.
  virtual bool is_divided() const { return true; }
  /// The ship of the plan; null if there is none.
  virtual const gears::Ship* ship() const { return nullptr; }
  /// Whether the plan makes something of this name.
  virtual bool has_name(const std::string&) const { return false; }
  /// Reads `[parts]` and `[bodies]`, and adds the panels and ropes of the plan.
  virtual void read_parts(PartReader& parts);
  /// Whether a `[[join]]` is a seam of the plan rather than a join of parts.
  virtual bool is_seam(formats::TableReader&) const { return false; }
  /// Joins the nodes that panels and ropes share.
  virtual void join(Joiner&) const {}
  /// Adds floats and weights once the nodes of the scene are numbered.
  virtual void add_pieces() {}
  /// With `[elements.contact]`, the parts that carry the gear on the bed, as tables of `[parts]`: one for
  /// each rope and body of the plan that touches the bed, unless a part of the scene carries it. `carried`
  /// are the nodes of such parts.
  virtual std::vector<std::pair<std::string, formats::Value>> contacts(const std::set<std::uint32_t>&) const {
    return {};
  }
  /// Whether the footrope of a towed gear has no part that carries it on the bed.
  virtual bool sinks_into_bed(const std::set<std::uint32_t>&) const { return false; }
  /// Holds the plane of symmetry of half a gear, and the blocks of the ship.
  virtual void add_holds() {}
  /// Updates the initial shape for the nodes that are held.
  virtual void follow_holds() {}
  /// Reports what moves in a static analysis.
  virtual void refuse_motions() const {}
  /// Completes the winches of the plan once the analysis is known.
  virtual void complete_winches(Registry&) const {}
};

}  // namespace netloft::scenes
