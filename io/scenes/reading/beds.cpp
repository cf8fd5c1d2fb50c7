// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/beds.hpp"

#include "framework/parameters/find_number.hpp"
#include "io/formats/units/in_metres.hpp"
#include "io/scenes/reading/known_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace netloft::scenes {

namespace {

/// The bed of one part: a plane, whose surface yields by `softness` [m].
struct Bed {
  const Part* part = nullptr;
  formats::Place place;
  BedPlane plane;
  double softness = 0;

  double above(const double* x) const { return x[2] - plane.height(x[0], x[1]); }
};

std::vector<Bed> beds_of(const LoadedScene& loaded) {
  std::vector<Bed> beds;
  for (const auto& part : loaded.scene.parts)
    if (const auto plane = bed_plane_of(part); plane && !part.nodes.empty())
      beds.push_back({&part, loaded.place_of(part.name), *plane,
                      number_or(0, part.parameters, parameter::kBedSoftness.name)});
  return beds;
}

void check_height(const Bed& bed, const Scene& scene, formats::Diagnostics& diagnostics) {
  double highest = -std::numeric_limits<double>::infinity(), held = 0;
  for (std::size_t x = 0; x < scene.positions.size(); x += 3)
    highest = std::max(highest, bed.above(&scene.positions[x]));
  std::string lowest_held;
  for (const auto node : bed.part->nodes) {
    const double above = bed.above(&scene.positions[3 * std::size_t{node}]);
    if (above < held && scene.held[node] == kAllAxes) {
      held = above;
      lowest_held = scene.node_name(node);
    }
  }
  const double sinking = std::max(bed.softness, 1e-3);
  if (highest < -sinking)
    diagnostics.error(
        bed.place,
        bed.part->name + ": the whole gear is below this bed, by " + formats::in_metres(-highest) +
            " or more",
        "change the depth of the bed, which counts downwards from the surface, z = 0, or raise the gear");
  else if (held < -sinking)
    diagnostics.warning(bed.place,
                        bed.part->name + ": " + lowest_held + " is held " + formats::in_metres(-held) +
                            " below this bed, which pushes at a node that cannot move",
                        "hold it above the bed, or lower the bed");
}

/// Reports two beds on the same node as an error, because both would push at it. `is_first`: whether `a` is
/// the first bed of the scene, from which the report measures heights; if so, and if `b` is another plane,
/// warns.
void check_pair(const Bed& a, const Bed& b, bool is_first, formats::Diagnostics& diagnostics) {
  const std::set<std::uint32_t> carried(a.part->nodes.begin(), a.part->nodes.end());
  const bool shares = std::any_of(b.part->nodes.begin(), b.part->nodes.end(),
                                  [&](auto node) { return carried.contains(node); });
  const std::string other = a.part->name + " at " + diagnostics.where(a.place);
  if (shares)
    diagnostics.error(b.place,
                      b.part->name + " and " + other + " carry the same nodes, so that both push at them",
                      "make one bed with everything in `on`");
  else if (is_first && a.plane != b.plane)
    diagnostics.warning(
        b.place, b.part->name + " and " + other + " are different planes",
        "give both the same depth and slopes, unless you want two beds; the report gives heights above " +
            a.part->name);
}

}  // namespace

std::optional<BedPlane> bed_plane_of(const Part& part) {
  const double* depth = find_number(part.parameters, parameter::kBedDepth.name);
  if (!depth) return {};
  return BedPlane{*depth, number_or(0, part.parameters, parameter::kBedSlopeX.name),
                  number_or(0, part.parameters, parameter::kBedSlopeY.name)};
}

void check_beds(const LoadedScene& loaded, formats::Diagnostics& diagnostics) {
  const auto beds = beds_of(loaded);
  for (std::size_t i = 0; i < beds.size(); ++i) {
    check_height(beds[i], loaded.scene, diagnostics);
    for (std::size_t k = 0; k < i; ++k)
      check_pair(beds[k], beds[i], k == 0 && !loaded.scene.bed.is_there, diagnostics);
  }
}

}  // namespace netloft::scenes
