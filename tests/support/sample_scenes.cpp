// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/sample_scenes.hpp"

#include <array>

namespace netloft::sample {

namespace {

void add_node(Scene& scene, double x, double y, double z, bool held) {
  scene.labels.push_back({0, static_cast<std::uint32_t>(scene.node_count())});
  scene.positions.insert(scene.positions.end(), {x, y, z});
  scene.held.push_back(held ? kAllAxes : 0);
}

}  // namespace

Scene hanging_panel(int n, double height) {
  constexpr double kMeshes = 40, kBar = 0.6, kWidth = 32;
  Scene scene;
  scene.name = "hanging-panel";
  scene.water = {1025, 9.81};
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) add_node(scene, kWidth * (double(i) / n - 0.5), 0, -height * j / n, j == 0);

  Part net;
  net.name = "net", net.type = "priour/triangle";
  net.parameters = {
      {"twine.EA", 1e4}, {"twine.EA_compression", 1.0}, {"twine.diameter", 0.01}, {"twine.density", 2000.0}};
  using Corner = std::array<int, 2>;
  const auto add = [&](Corner a, Corner b, Corner c) {
    for (const auto [i, j] : {a, b, c}) {
      const double across = kMeshes * i / n, along = kMeshes * j / n;
      net.nodes.push_back(static_cast<std::uint32_t>(j * (n + 1) + i));
      net.data["u"].push_back(across + along);
      net.data["v"].push_back(along - across);
    }
    net.data["bar_length"].push_back(kBar);
  };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const Corner a{i, j}, b{i + 1, j}, c{i + 1, j + 1}, d{i, j + 1};
      if ((i + j) % 2 == 0)
        add(a, b, c), add(a, c, d);
      else
        add(a, b, d), add(b, c, d);
    }
  scene.parts.push_back(std::move(net));
  return scene;
}

Scene hanging_rope(int n) {
  Scene scene;
  scene.name = "hanging-rope";
  scene.water = {1025, 9.81};
  for (int i = 0; i <= n; ++i) add_node(scene, 80.0 * i / n, 0, -20.0 * i / n, i == 0 || i == n);
  Part rope;
  rope.name = "rope", rope.type = "rope/bar";
  rope.parameters = {{"rope.EA", 2e6}, {"rope.diameter", 0.02}, {"rope.density", 7850.0}};
  for (int i = 0; i < n; ++i) {
    rope.nodes.insert(rope.nodes.end(), {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i + 1)});
    rope.data["rest_length"].push_back(100.0 / n);
  }
  scene.parts.push_back(std::move(rope));
  return scene;
}

}  // namespace netloft::sample
