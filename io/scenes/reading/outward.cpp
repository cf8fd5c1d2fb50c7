// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/outward.hpp"

#include <netloft/vec3.hpp>

#include <algorithm>

namespace netloft::scenes {

namespace {

// Least volume between a panel and the centre, as a fraction of the volume of a ball around the centre. If
// the volume is smaller, the inside of the panel is not known.
constexpr double kLeastVolume = 1e-3;

class Triangles {
 public:
  Triangles(const std::vector<double>& positions, const Part& rider) : x_(positions), rider_(rider) {
    for (const auto node : rider.nodes) middle_ = middle_ + at(node);
    middle_ = (1.0 / static_cast<double>(rider.nodes.size())) * middle_;
  }

  /// The sign of the volume between the centre and the triangles whose corners have the indices from `begin`
  /// to `end`: 1 if their normals, weighted by area, point away from the centre, -1 if they point towards it,
  /// 0 if this is not clear.
  double sign_of_volume(std::size_t begin, std::size_t end) const {
    double volume = 0, most = 0;
    for (std::size_t i = begin; i < end; i += 3) {
      const Vec3<double> a = at(rider_.nodes[i]), b = at(rider_.nodes[i + 1]), c = at(rider_.nodes[i + 2]);
      const Vec3<double> normal = cross(b - a, c - a), from_middle = (1.0 / 3) * (a + b + c) - middle_;
      volume += dot(normal, from_middle);
      most += norm(normal) * norm(from_middle);
    }
    return volume > kLeastVolume * most ? 1 : volume < -kLeastVolume * most ? -1 : 0;
  }

 private:
  Vec3<double> at(std::uint32_t node) const { return {x_[3 * node], x_[3 * node + 1], x_[3 * node + 2]}; }

  const std::vector<double>& x_;
  const Part& rider_;
  Vec3<double> middle_{};
};

}  // namespace

Outward find_outward(const std::vector<PanelBelow>& panels, const std::vector<double>& positions,
                     const Part& rider) {
  Outward found{std::vector<double>(rider.nodes.size() / 3, 1.0)};
  if (rider.nodes.empty()) return found;
  const Triangles triangles(positions, rider);
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const std::size_t begin = panels[p].begin,
                      end = p + 1 < panels.size() ? panels[p + 1].begin : rider.nodes.size();
    const double sign = panels[p].is_outward ? 1 : triangles.sign_of_volume(begin, end);
    if (sign == 0) ++found.unknown;
    if (sign < 0)
      std::fill(found.of_triangles.begin() + std::ptrdiff_t(begin / 3),
                found.of_triangles.begin() + std::ptrdiff_t(end / 3), -1.0);
  }
  return found;
}

}  // namespace netloft::scenes
