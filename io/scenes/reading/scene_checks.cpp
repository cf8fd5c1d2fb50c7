// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/scene_checks.hpp"

#include "io/scenes/reading/beds.hpp"
#include "io/scenes/reading/element_choice.hpp"
#include "io/scenes/reading/halves.hpp"
#include "io/scenes/reading/plausible.hpp"
#include "io/scenes/reading/tow.hpp"
#include "io/scenes/reading/water_checks.hpp"

#include <algorithm>

namespace netloft::scenes {

namespace {

/// Reports parameters with a direction along y, whose names end in "_y", as errors if they are not zero.
void check_symmetric_parameters(const Draft& draft, const std::string& cure,
                                formats::Diagnostics& diagnostics) {
  const LoadedScene& out = draft.out;
  for (std::size_t p = 0; p < draft.types.size(); ++p) {
    const ElementType* type = draft.types[p];   // nullptr if the type is unknown, which has been reported
    if (!type || type->is_on_body()) continue;  // the y axis of a body points outward on either side
    const Part& part = out.scene.parts[p];
    for (const auto& [name, value] : part.parameters)
      if (const auto* number = std::get_if<double>(&value); number && *number != 0 && name.ends_with("_y"))
        diagnostics.error(
            out.place_of(part.name),
            part.name + ": " + name +
                " is not zero, so that port and starboard differ, but the gear is modelled as half",
            cure);
  }
}

/// Reports half a gear that is initially beyond its plane of symmetry, and boards that have crossed. This is
/// an error if a node beyond the plane is held; otherwise it is a warning, because free nodes can return.
void check_crossings(const LoadedScene& out, formats::Diagnostics& diagnostics) {
  for (const auto& crossing : find_crossings(out, out.scene.positions)) {
    const formats::Place place = out.parts[crossing.part].place;
    const std::string fault = "at the start " + crossing.sentence;
    if (crossing.is_held)
      diagnostics.error(place, fault, "hold the starboard half at a positive y");
    else
      diagnostics.warning(place, fault, "let it start at a positive y");
  }
}

/// Reports parts that nothing holds. `types`: element types of all parts of the scene.
void check_held(const LoadedScene& out, const std::vector<const ElementType*>& types,
                formats::Diagnostics& diagnostics) {
  for (const auto& fault : find_loose_parts(out.scene, nodes_per_element(types)))
    diagnostics.error(out.place_of(fault.part), fault.message);
}

/// Warns of friction that does not suit the ground: friction that acts only on moving ground, if the ground
/// is at rest; and friction that sticks to ground at rest, if water flows past and the scene says nothing
/// about a tow, because the gear is then probably towed.
void check_ground(const Draft& draft, bool says_tow, formats::Diagnostics& diagnostics) {
  const LoadedScene& out = draft.out;
  for (std::size_t p = 0; p < draft.types.size(); ++p) {
    const auto friction = friction_on_standing_ground(out.scene, out.scene.parts[p], *draft.types[p]);
    if (friction == StandingFriction::none)
      diagnostics.warning(out.parts[p].place,
                          out.scene.parts[p].name +
                              ": this type has friction only on a ground that moves past the gear, but the "
                              "ground does not move, so that there is no friction",
                          "[tow] speed = \"3 kn\" moves the ground; on a ground at rest use seabed/bed or "
                          "seabed/plane, whose friction sticks");
    else if (friction == StandingFriction::sticks && out.scene.current.flows() && !says_tow)
      diagnostics.warning(
          out.parts[p].place,
          out.scene.parts[p].name +
              ": water flows past the gear, but the ground is at rest; past a towed gear both move",
          "[tow] speed = \"3 kn\" moves both, instead of water.current; [tow] speed = 0 confirms that the "
          "ground is at rest");
  }
}

/// Reports an error for elements that need the bed of the scene, if there is none.
void check_bed(const Draft& draft, formats::Diagnostics& diagnostics) {
  const LoadedScene& out = draft.out;
  for (std::size_t p = 0; p < draft.types.size(); ++p)
    for (const auto& term : draft.types[p]->terms)
      if (const auto both = NETLOFT_READS_BED | NETLOFT_FROM_OUTSIDE;
          (term.traits & both) == std::uint32_t{both} && names_needed_by(term).empty())
        diagnostics.error(out.parts[p].place,
                          out.scene.parts[p].name + ": " + draft.types[p]->type +
                              " needs the bed of the scene, but there is none",
                          "add [bed] depth = \"100 m\"");
}

}  // namespace

void check_symmetry(formats::TableReader& root, const Draft& draft, const WaterReader& water) {
  const LoadedScene& out = draft.out;
  const std::string cure = "set [gear] extent = \"whole\"";
  const auto across = [](const auto& all) {
    return std::any_of(all.begin(), all.end(), [](const auto& one) { return one.velocity[1] != 0; });
  };
  if (across(out.scene.current.samples) || across(out.scene.current.drifts)) {
    root.table("water", formats::Presence::optional)
        .error("current", "flows across the plane y = 0, at which half a gear is mirrored", cure);
  }
  if (out.scene.ground[1] != 0) {
    root.table("tow").error("leeway", "leads across the plane y = 0, at which half a gear is mirrored", cure);
  }
  if (const char* key = water.uneven_key()) {
    root.table("bed").error(
        key, "differs between the two sides of the plane y = 0, at which half a gear is mirrored", cure);
  }
  check_symmetric_parameters(draft, cure, root.diagnostics());
}

void check_undivided(formats::TableReader& root, const Draft& draft) {
  check_current(draft.out.scene, root);
  check_plausible(draft.out, root);
}

void check_scene(formats::TableReader& root, const Draft& draft,
                 const std::vector<const ElementType*>& companions, const WaterReader& water) {
  formats::Diagnostics& diagnostics = root.diagnostics();
  std::vector<const ElementType*> types = draft.types;
  types.insert(types.end(), companions.begin(), companions.end());
  check_held(draft.out, types, diagnostics);
  check_undivided(root, draft);
  check_ground(draft, water.says_tow(), diagnostics);
  if (!draft.out.scene.bed.is_there) check_bed(draft, diagnostics);
  check_beds(draft.out, diagnostics);
  check_crossings(draft.out, diagnostics);
}

}  // namespace netloft::scenes
