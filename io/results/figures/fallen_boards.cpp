// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/figures/fallen_boards.hpp"

#include "io/formats/units/degrees.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace netloft::results {

namespace {

/// Figures of a gear by name; 0 for a figure that the gear does not have.
class Values {
 public:
  explicit Values(const std::vector<NamedScalar>& figures) : figures_(figures) {}
  double operator()(const std::string& name) const {
    const NamedScalar* figure = find_scalar(figures_, name);
    return figure ? figure->value : 0;
  }

 private:
  const std::vector<NamedScalar>& figures_;
};

double side_of(const scenes::LoadedScene& loaded, std::uint32_t part) {
  for (const scenes::BodyInScene& body : loaded.bodies)
    if (body.part == part) return body.side;
  return 1;
}

/// Outward force of water and ground on a board [N]: its component along the horizontal line from the other
/// board of the pair to this one. In a half gear the other board is the mirror image of this one.
double outward_force(const scenes::LoadedScene& loaded, const std::vector<std::uint32_t>& pair,
                     std::size_t which, const Values& value) {
  const auto name = [&](std::size_t k) { return loaded.scene.parts[pair[k]].name; };
  const std::string here = "bodies/" + name(which) + "/";
  double x = 0, y = 2 * value(here + "y");
  if (pair.size() == 2) {
    const std::string there = "bodies/" + name(1 - which) + "/";
    x = value(here + "x") - value(there + "x");
    y = value(here + "y") - value(there + "y");
  }
  const double side = side_of(loaded, pair[which]), apart = std::hypot(x, y);
  double work = 0;
  for (const char* source : {"/water/", "/ground/"}) {
    const std::string force = "body_forces/" + name(which) + source;
    work += value(force + "x") * x + side * value(force + "out") * y;
  }
  return apart > 0 ? work / apart : 0;
}

/// Returns a sentence that says what is wrong with a board; empty for a board that is upright and spreads.
std::string trouble_of(const std::string& board, double heel, double outward) {
  if (std::abs(heel) > std::numbers::pi / 2)
    return fmt::format("{} has fallen over: its top is turned {} by {:.0f}°", board,
                       heel > 0 ? "outward" : "inward", formats::kDegreesPerRadian * std::abs(heel));
  if (outward >= 0) return "";
  return fmt::format("{} does not spread the gear: water and ground push it inward with {:.4g} N", board,
                     -outward);
}

}  // namespace

std::vector<FallenBoard> find_fallen_boards(const scenes::LoadedScene& loaded,
                                            const std::vector<NamedScalar>& figures) {
  std::vector<FallenBoard> fallen;
  if (!loaded.gear) return fallen;
  const Values value(figures);
  for (const auto& [name, parts] : loaded.gear->pairs)
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const std::string& board = loaded.scene.parts[parts[k]].name;
      // Bodies that are weights or floats do not have this figure.
      if (!find_scalar(figures, "bodies/" + board + "/outward")) continue;
      std::string sentence =
          trouble_of(board, value("bodies/" + board + "/heel"), outward_force(loaded, parts, k, value));
      if (!sentence.empty()) fallen.push_back({board, std::move(sentence)});
    }
  return fallen;
}

}  // namespace netloft::results
