// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/turn_outward.hpp"

#include <netloft/vec3.hpp>

#include "framework/registry/element_data.hpp"

#include <algorithm>

namespace netloft::scenes {

namespace {

// If the volume between a panel and the centre is a smaller fraction than this of the volume of a ball around
// the centre, it is not clear which side is inside.
constexpr double kLeastVolume = 1e-3;

class Triangles {
 public:
  Triangles(const std::vector<double>& positions, Part& rider) : x_(positions), rider_(rider) {
    for (const auto node : rider.nodes) middle_ = middle_ + at(node);
    middle_ = (1.0 / static_cast<double>(rider.nodes.size())) * middle_;
  }

  /// Whether the triangles from `begin` to `end` face the centre: their normals, weighted by area, point
  /// towards it on average.
  bool face_inward(std::size_t begin, std::size_t end) const {
    double volume = 0, most = 0;
    for (std::size_t i = begin; i < end; i += 3) {
      const Vec3<double> a = at(rider_.nodes[i]), b = at(rider_.nodes[i + 1]), c = at(rider_.nodes[i + 2]);
      const Vec3<double> normal = cross(b - a, c - a), from_middle = (1.0 / 3) * (a + b + c) - middle_;
      volume += dot(normal, from_middle);
      most += norm(normal) * norm(from_middle);
    }
    return volume < -kLeastVolume * most;
  }

  void reverse(std::size_t begin, std::size_t end) {
    const auto data = rider_.data.find(datum::kToAft.name);
    for (std::size_t i = begin; i < end; i += 3) {
      std::swap(rider_.nodes[i + 1], rider_.nodes[i + 2]);
      if (data != rider_.data.end()) std::swap(data->second[i + 1], data->second[i + 2]);
    }
  }

 private:
  Vec3<double> at(std::uint32_t node) const { return {x_[3 * node], x_[3 * node + 1], x_[3 * node + 2]}; }

  const std::vector<double>& x_;
  Part& rider_;
  Vec3<double> middle_{};
};

}  // namespace

void turn_outward(const std::vector<std::size_t>& begins, const std::vector<double>& positions, Part& rider) {
  if (rider.nodes.empty()) return;
  Triangles triangles(positions, rider);
  for (std::size_t p = 0; p < begins.size(); ++p) {
    const std::size_t end = p + 1 < begins.size() ? begins[p + 1] : rider.nodes.size();
    if (triangles.face_inward(begins[p], end)) triangles.reverse(begins[p], end);
  }
}

}  // namespace netloft::scenes
