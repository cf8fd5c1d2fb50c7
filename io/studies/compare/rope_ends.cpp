// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/compare/rope_ends.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace netloft::studies {

namespace {

constexpr std::string_view kRopes = "ropes/", kTension = "/tension_";

/// The rope whose tension at one end is `figure` ("ropes/headrope/tension_end"), with its bars in the order
/// from this end; nullopt for other figures, or if the mesh has no such rope.
std::optional<results::RopeTensions> seen_from_end(const std::string& figure, const NumbersOnMesh& mesh) {
  const auto slash = figure.rfind(kTension);
  if (!figure.starts_with(kRopes) || slash == std::string::npos) return {};
  const std::string end = figure.substr(slash + kTension.size());
  if (end == "largest") return {};
  const std::string rope = figure.substr(kRopes.size(), slash - kRopes.size());
  for (const results::RopeTensions& r : mesh.ropes)
    if (r.rope == rope) return end == "end" || end == "starboard" ? r.turned_round() : r;
  return {};
}

/// The tensions at `distance` from the end of a rope, one for each mesh that has the rope.
std::vector<double> tensions_inside(const std::string& figure, const std::vector<NumbersOnMesh>& meshes,
                                    double distance) {
  std::vector<double> tensions;
  for (const auto& mesh : meshes)
    if (const auto rope = seen_from_end(figure, mesh)) tensions.push_back(rope->at(distance));
  return tensions;
}

}  // namespace

bool is_of_rope_end(const std::string& figure) { return figure.find(kTension) != std::string::npos; }

std::string divergence_text(const std::string& figure, const std::vector<NumbersOnMesh>& meshes,
                            std::size_t asked) {
  const std::string text = figure + " does not converge with the mesh";
  const auto coarsest = seen_from_end(figure, meshes.front());
  if (!coarsest) return text;
  const double distance = 2 * coarsest->rest_length.front();
  const auto tensions = tensions_inside(figure, meshes, distance);
  if (tensions.size() != meshes.size()) return text;
  std::vector<double> widths;
  for (const auto& mesh : meshes) widths.push_back(mesh.mesh.width);
  return text +
         fmt::format("; {:.3g} m from that end, two bars of the coarsest mesh, it is {:.4g} N ± {:.2g} N",
                     distance, tensions[asked], find_trend(tensions, widths, asked).error);
}

}  // namespace netloft::studies
