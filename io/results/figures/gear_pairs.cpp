// SPDX-License-Identifier: BSD-3-Clause
//
// Figures of pairs of bodies to port and to starboard, under the name of the pair in the plan. They are the
// same for half a gear and for the whole gear.
#include <algorithm>
#include <cmath>

#include "io/results/figures/gear_view.hpp"

namespace netloft::results {

namespace {

const Figure* find(const std::vector<Figure>& figures, const std::string& name) {
  const auto at = std::ranges::find(figures, name, &Figure::name);
  return at == figures.end() ? nullptr : &*at;
}

/// Names of the bodies of a pair; half a gear has only the starboard body.
std::vector<std::string> bodies_of(const GearView& gear, const std::vector<std::uint32_t>& parts) {
  std::vector<std::string> names;
  for (const auto part : parts) names.push_back(gear.name(part));
  return names;
}

/// The mean over the bodies of a pair of the figure with the name `before` + body + `after`. A body without
/// this figure counts as 0.
double mean_of(const std::vector<Figure>& figures, const std::vector<std::string>& bodies,
               const std::string& before, const std::string& after) {
  double sum = 0;
  for (const auto& body : bodies)
    if (const Figure* figure = find(figures, before + body + after)) sum += figure->value;
  return sum / static_cast<double>(bodies.size());
}

void add_spread(const std::vector<std::string>& bodies, const std::string& own,
                std::vector<Figure>& figures) {
  std::vector<Vector> at;
  for (const auto& body : bodies) {
    const auto coordinate = [&](const char* axis) {
      return mean_of(figures, {body}, "bodies/", std::string("/") + axis);
    };
    at.push_back({coordinate("x"), coordinate("y"), coordinate("z")});
  }
  figures.push_back({own + "spread", "m", "distance between the body to port and the body to starboard",
                     at.size() == 2 ? norm(at[1] - at[0]) : 2 * std::abs(at[0].y)});
}

/// Adds the means of position, attitude and outputs over the pair. There is no mean of y, because
/// add_spread() gives the distance instead.
void add_means(const std::vector<std::string>& bodies, const std::string& own, std::vector<Figure>& figures) {
  const std::string first = "bodies/" + bodies.front() + "/";
  std::vector<Figure> means;
  for (const auto& figure : figures) {
    if (!figure.name.starts_with(first) || figure.name == first + "y") continue;
    const std::string last = figure.name.substr(first.size());
    means.push_back({own + last, figure.unit, figure.doc + ", mean of the two",
                     mean_of(figures, bodies, "bodies/", "/" + last)});
  }
  std::ranges::move(means, std::back_inserter(figures));
}

/// Adds the outward force of water and ground, which spreads the pair, as the mean over its bodies.
void add_spreading(const std::vector<std::string>& bodies, const std::string& own,
                   std::vector<Figure>& figures) {
  const auto acts = [&](const char* source) {
    return std::ranges::any_of(bodies, [&](const auto& body) {
      return find(figures, "body_forces/" + body + "/" + source + "/out");
    });
  };
  if (!acts("water") && !acts("ground")) return;
  const auto outward = [&](const char* source) {
    return mean_of(figures, bodies, "body_forces/", std::string("/") + source + "/out");
  };
  const double water = outward("water"), ground = outward("ground");
  figures.push_back(
      {own + "spread_force", "N", "outward force of water and ground, mean of both bodies", water + ground});
  figures.push_back({own + "ground_share", "1", "fraction of the spreading force that comes from the ground",
                     ground == 0 ? 0 : ground / (water + ground)});
}

}  // namespace

void add_pair_figures(const GearView& gear, std::vector<Figure>& figures) {
  for (const auto& [name, parts] : gear.gear().pairs) {
    const auto bodies = bodies_of(gear, parts);
    if (bodies.empty()) continue;
    const std::string own = "pairs/" + name + "/";
    add_spread(bodies, own, figures);
    add_means(bodies, own, figures);
    add_spreading(bodies, own, figures);
  }
}

}  // namespace netloft::results
