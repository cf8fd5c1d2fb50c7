// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/beds.hpp"

#include "framework/parameters/find_number.hpp"
#include "io/formats/units/in_metres.hpp"
#include "io/scenes/reading/known_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

/// The height of the highest node of the gear above a bed [m]. The search begins at node `first` and stops at
/// the first node that is higher than `enough` [m]. The index of this node is stored in `first`, because the
/// node is probably above the next bed, too.
double height_above(const Bed& bed, const std::vector<double>& positions, double enough, std::size_t& first) {
  double highest = -std::numeric_limits<double>::infinity();
  const std::size_t nodes = positions.size() / 3;
  for (std::size_t k = 0; k < nodes && highest < enough; ++k) {
    const std::size_t node = first + k < nodes ? first + k : first + k - nodes;
    highest = std::max(highest, bed.above(&positions[3 * node]));
    if (highest >= enough) first = node;
  }
  return highest;
}

/// Checks that the gear is not below the bed. The search begins at `above_others`, a node above the beds
/// checked so far.
void check_height(const Bed& bed, const Scene& scene, std::size_t& above_others,
                  formats::Diagnostics& diagnostics) {
  const double sinking = std::max(bed.softness, 1e-3);
  const double highest = height_above(bed, scene.positions, -sinking, above_others);
  double held = 0;
  std::string lowest_held;
  for (const auto node : bed.part->nodes) {
    const double above = bed.above(&scene.positions[3 * std::size_t{node}]);
    if (above < held && scene.held[node] == kAllAxes) {
      held = above;
      lowest_held = scene.node_name(node);
    }
  }
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

/// Compares each bed with the beds before it.
class BedComparison {
 public:
  BedComparison(const std::vector<Bed>& beds, const Scene& scene)
      : beds_(beds), carrier_(scene.node_count(), kNobody) {}

  /// Reports an error if two beds push at the same node. If `warns`, also warns of a bed whose plane differs
  /// from the plane of the first bed, because reports give heights above the first bed.
  void compare(std::size_t bed, bool warns, formats::Diagnostics& diagnostics) {
    const Bed &own = beds_[bed], &first = beds_.front();
    if (const std::size_t other = claim_nodes(bed); other != kNobody)
      diagnostics.error(
          own.place,
          pair_of(own, beds_[other], diagnostics) + " carry the same nodes, so that both push at them",
          "make one bed with everything in `on`");
    else if (warns && first.plane != own.plane)
      diagnostics.warning(
          own.place, pair_of(own, first, diagnostics) + " are different planes",
          "give both the same depth and slopes, unless you want two beds; the report gives heights above " +
              first.part->name);
  }

 private:
  static constexpr std::size_t kNobody = std::numeric_limits<std::size_t>::max();

  /// Makes `bed` the carrier of its nodes, except of nodes that an earlier bed carries. Returns the first
  /// earlier bed that carries one of its nodes; kNobody if there is none.
  std::size_t claim_nodes(std::size_t bed) {
    std::size_t other = kNobody;
    for (const auto node : beds_[bed].part->nodes) {
      if (carrier_[node] == kNobody) carrier_[node] = bed;
      if (carrier_[node] != bed) other = std::min(other, carrier_[node]);
    }
    return other;
  }

  static std::string pair_of(const Bed& own, const Bed& other, const formats::Diagnostics& diagnostics) {
    return own.part->name + " and " + other.part->name + " at " + diagnostics.where(other.place);
  }

  const std::vector<Bed>& beds_;
  std::vector<std::size_t> carrier_;  // for each node: the first bed that carries it
};

}  // namespace

std::optional<BedPlane> bed_plane_of(const Part& part) {
  const double* depth = find_number(part.parameters, parameter::kBedDepth.name);
  if (!depth) return {};
  return BedPlane{*depth, number_or(0, part.parameters, parameter::kBedSlopeX.name),
                  number_or(0, part.parameters, parameter::kBedSlopeY.name)};
}

void check_beds(const LoadedScene& loaded, formats::Diagnostics& diagnostics) {
  const auto beds = beds_of(loaded);
  BedComparison comparison(beds, loaded.scene);
  std::size_t above_others = 0;
  for (std::size_t i = 0; i < beds.size(); ++i) {
    check_height(beds[i], loaded.scene, above_others, diagnostics);
    comparison.compare(i, !loaded.scene.bed.is_there, diagnostics);
  }
}

}  // namespace netloft::scenes
