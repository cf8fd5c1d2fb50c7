// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/plan/net_plan.hpp"
#include "io/scenes/reading/draft.hpp"

#include <memory>
#include <optional>
#include <set>
#include <utility>

namespace netloft::scenes {

class PartReader;

/// The bag of a net: the rim of its mouth, and the parts of the net whose drag slows the water.
struct Bag {
  /// Nodes of the scene along the rim: the footrope from port (in half a gear from the middle) to starboard,
  /// then back along the headline. The rim is closed: the first node follows the last.
  std::vector<std::uint32_t> rim;
  // Indices of parts. `behind`: the netting behind the mouth; `ahead`: wings, ropes on which netting hangs,
  // and parts that these carry.
  std::vector<std::uint32_t> behind, ahead;
  std::set<std::string> open;  // edges behind the mouth through which water leaves the bag
};

/// The steps of reading a scene that concern a net plan, in their order. In this class, which serves scenes
/// without a net plan, they do nothing; GearParts implements them for a plan.
class GearSteps {
 public:
  virtual ~GearSteps() = default;

  /// Divides the gear into triangles and bars. Returns false after an error in the plan or in `[gear]`; the
  /// rest of the scene is then not read. For `like` see SceneSource::instance().
  virtual bool divide(const std::shared_ptr<gears::Division>&) { return true; }
  /// Called instead of all following steps. Reads the tables of the plan that need no mesh: its bodies and
  /// the elements of its panels, ropes and floats.
  virtual void read_undivided(PartReader&) {}
  /// The ship of the plan; nullptr if there is none.
  virtual const gears::Ship* ship() const { return nullptr; }
  /// Whether a part, a point or a body of the plan has this name.
  virtual bool has_name(const std::string&) const { return false; }
  /// Reads `[parts]` and `[bodies]`, and adds the panels and ropes of the plan.
  virtual void read_parts(PartReader& parts);
  /// Whether a `[[join]]` is a seam between panels of the plan. Other joins connect parts of the scene.
  virtual bool is_seam(formats::TableReader&) const { return false; }
  /// Joins the nodes that panels and ropes share.
  virtual void join(Joiner&) const {}
  /// Adds floats and weights once the nodes of the scene are numbered.
  virtual void add_pieces() {}
  /// The contact parts that keep the gear on the bed, as tables like those of `[parts]`: one for each rope
  /// and body of the plan that touches the bed; none without `[elements.contact]`. `carried` are the nodes of
  /// contact parts that are already in the scene file. A rope or body all of whose nodes are in `carried`
  /// gets no contact part.
  virtual std::vector<std::pair<std::string, formats::Value>> contacts(const std::set<std::uint32_t>&) const {
    return {};
  }
  /// Whether a towed gear would sink into the bed, because a part of its footrope has no contact. `carried`
  /// are the nodes with contact.
  virtual bool sinks_into_bed(const std::set<std::uint32_t>&) const { return false; }
  /// The bag of the net, for flows that slow the water in it; nullopt if the plan has no mouth, with the
  /// reason in `why_not`. Nodes must be numbered.
  virtual std::optional<Bag> bag(std::string& /*why_not*/) const { return {}; }
  /// Holds the plane of symmetry of half a gear, and the blocks of the ship.
  virtual void add_holds() {}
  /// Fits the initial shape to the positions of held nodes.
  virtual void follow_holds() {}
  /// Reports an error if the plan has motions of the ship or of winches. Called for a static analysis only,
  /// where such motions have no effect.
  virtual void refuse_motions() const {}
  /// Completes the winches of the plan once the analysis is known.
  virtual void complete_winches(Registry&) const {}
};

}  // namespace netloft::scenes
