// SPDX-License-Identifier: BSD-3-Clause
//
// Figures of the mouth (height, spread, area) and tensions at the ends of ropes.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "io/results/figures/gear_view.hpp"
#include "io/scenes/reading/beds.hpp"

namespace netloft::results {

std::optional<double> bed_below(const Vector& place, const Scene& scene) {
  if (scene.bed.is_there) return scene.bed.at(place.x, place.y)[0];
  for (const Part& part : scene.parts)
    if (const auto plane = scenes::bed_plane_of(part)) return plane->height(place.x, place.y);
  return {};
}

namespace {

void add_height(const GearView& gear, std::uint32_t headline, const std::uint32_t* footrope,
                std::vector<Figure>& figures) {
  const Vector middle = gear.middle_of(headline);
  if (const auto bed = bed_below(middle, gear.loaded().scene))
    figures.push_back({"mouth/headline_height", "m", "height of the middle of the headline above the seabed",
                       middle.z - *bed});
  else if (footrope)
    figures.push_back({"mouth/headline_height", "m",
                       "height of the middle of the headline above that of the footrope",
                       middle.z - gear.middle_of(*footrope).z});
}

/// Distance between the ends of a rope [m]. In a half gear, it is the distance between the one end and its
/// mirror image.
double spread(const GearView& gear, std::uint32_t rope) {
  const Vector way = gear.at(gear.nodes_of(rope).back()) - gear.at(gear.nodes_of(rope).front());
  return gear.is_half() ? 2 * std::abs(way.y) : norm(way);
}

double mouth_area(const GearView& gear, std::uint32_t headline, std::uint32_t footrope) {
  std::vector<std::uint32_t> curve = gear.nodes_of(headline);
  const auto& below = gear.nodes_of(footrope);
  curve.insert(curve.end(), below.rbegin(), below.rend());
  const Vector from = gear.at(curve.front());  // a reference point nearby keeps rounding errors small
  Vector S, middle;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    S += 0.5 * cross(gear.at(curve[i]) - from, gear.at(curve[(i + 1) % curve.size()]) - from);  // (1)
    middle += (1.0 / static_cast<double>(curve.size())) * gear.at(curve[i]);
  }
  return gear.times() * std::abs(dot(gear.current_at(middle), S));
}

/// The tension at the end of a rope [N], from the tensions T and lengths l of its bars, beginning at this
/// end. It is extrapolated linearly from the middles of the two outer bars if the third bar fits the trend.
/// Otherwise, for instance if netting pulls at the end, it is the tension of the outer bar.
double tension_at_end(const std::vector<double>& T, const std::vector<double>& l) {
  if (T.size() < 3 || !(T[0] > 0 && T[1] > 0)) return T[0];
  const double change = T[0] - T[1], before = T[1] - T[2];
  if (change * before <= 0 || std::abs(change) > 2 * std::abs(before)) return T[0];
  return T[0] + change * l[0] / (l[0] + l[1]);
}

void add_tensions(const GearView& gear, std::uint32_t rope, std::vector<Figure>& figures) {
  const auto T = gear.tensions(rope);
  const auto l = gear.rest_lengths(rope);
  if (T.empty()) return;
  const double start = tension_at_end(T, l),
               end = tension_at_end({T.rbegin(), T.rend()}, {l.rbegin(), l.rend()});
  const std::string at = "ropes/" + gear.name(rope) + "/tension_";
  if (gear.gear().across.contains(rope)) {
    figures.push_back(gear.is_half()
                          ? Figure{at + "middle", "N", "tension in the middle of the rope", start}
                          : Figure{at + "port", "N", "tension at the port end of the rope", start});
    figures.push_back({at + "starboard", "N", "tension at the starboard end of the rope", end});
  } else {
    figures.push_back({at + "start", "N", "tension at the start of the rope", start});
    figures.push_back({at + "end", "N", "tension at the end of the rope", end});
  }
  figures.push_back({at + "largest", "N", "largest tension in the rope",
                     std::max({*std::max_element(T.begin(), T.end()), start, end})});
}

void add_mass(const GearView& gear, std::uint32_t rope, std::vector<Figure>& figures) {
  const auto masses = gear.output(rope, output::kMass);
  if (masses.empty()) return;
  figures.push_back({"ropes/" + gear.name(rope) + "/mass", "kg", "mass of the rope in air",
                     gear.times() * std::accumulate(masses.begin(), masses.end(), 0.0)});
}

void add_role_figures(const GearView& gear, std::vector<Figure>& figures) {
  for (const auto& [role, ropes] : gear.gear().roles) {
    double sum = 0;
    int counted = 0;
    for (const auto rope : ropes) {
      const auto T = gear.tensions(rope);
      if (T.empty() || gear.gear().across.contains(rope)) continue;
      sum += tension_at_end(T, gear.rest_lengths(rope));
      ++counted;
    }
    if (counted)
      figures.push_back({"rigging/" + role + "/tension_start", "N",
                         "sum of the tensions at the starts of all ropes of this role", gear.times() * sum});
  }
}

}  // namespace

void add_mouth_figures(const GearView& gear, std::vector<Figure>& figures) {
  const std::uint32_t* headline = gear.find_rope(gear.gear().headline);
  const std::uint32_t* footrope = gear.find_rope(gear.gear().footrope);
  if (headline) {
    add_height(gear, *headline, footrope, figures);
    figures.push_back({"mouth/upper_wing_spread", "m", "distance between the ends of the headline",
                       spread(gear, *headline)});
  }
  if (footrope)
    figures.push_back({"mouth/lower_wing_spread", "m", "distance between the ends of the footrope",
                       spread(gear, *footrope)});
  if (headline && footrope)
    figures.push_back({"mouth/area", "m2",
                       "area enclosed by headline and footrope on the plane across the current",
                       mouth_area(gear, *headline, *footrope)});
  add_water_figures(gear, figures);
}

void add_rope_figures(const GearView& gear, std::vector<Figure>& figures) {
  add_role_figures(gear, figures);
  for (const auto rope : gear.gear().ropes) {
    add_tensions(gear, rope, figures);
    add_mass(gear, rope, figures);
  }
}

}  // namespace netloft::results
