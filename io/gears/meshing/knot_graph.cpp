// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/meshing/knot_graph.hpp"

#include <Eigen/SparseCholesky>

namespace netloft::gears {

namespace {

constexpr double kTie = 1e-9;  // weight towards zero, for values that nothing else determines
constexpr double kHold = 1e9;  // weight of a given value; all others have weight one

}  // namespace

std::vector<MeshSide> sides_of(const GearMesh& mesh) {
  std::vector<MeshSide> sides;
  for (const auto& panel : mesh.panels)
    for (std::size_t t = 0; t + 2 < panel.triangles.size(); t += 3)
      for (std::size_t k = 0; k < 3; ++k)
        sides.push_back({panel.nodes[panel.triangles[t + k]], panel.nodes[panel.triangles[t + (k + 1) % 3]]});
  for (const auto& rope : mesh.ropes)
    for (std::size_t i = 1; i < rope.nodes.size(); ++i) sides.push_back({rope.nodes[i - 1], rope.nodes[i]});
  return sides;
}

Neighbours rope_neighbours(const GearMesh& mesh) {
  Neighbours neighbours(mesh.nodes);
  for (const auto& rope : mesh.ropes)
    for (std::size_t i = 1; i < rope.nodes.size(); ++i) {
      neighbours[rope.nodes[i - 1]].push_back({rope.nodes[i], rope.rest_lengths[i - 1]});
      neighbours[rope.nodes[i]].push_back({rope.nodes[i - 1], rope.rest_lengths[i - 1]});
    }
  return neighbours;
}

std::vector<double> by_gains(std::size_t nodes, const std::vector<Gain>& gains,
                             const std::vector<std::pair<std::uint32_t, double>>& fixed) {
  using Index = Eigen::Index;
  const auto n = static_cast<Index>(nodes);
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd load = Eigen::VectorXd::Zero(n);
  for (Index i = 0; i < n; ++i) entries.push_back({static_cast<int>(i), static_cast<int>(i), kTie});
  for (const auto& [from, to, gain, weight] : gains) {
    const int i = static_cast<int>(from), j = static_cast<int>(to);
    entries.insert(entries.end(), {{i, i, weight}, {j, j, weight}, {i, j, -weight}, {j, i, -weight}});
    load[i] -= weight * gain;
    load[j] += weight * gain;
  }
  for (const auto& [node, value] : fixed) {
    entries.push_back({static_cast<int>(node), static_cast<int>(node), kHold});
    load[static_cast<Index>(node)] += kHold * value;
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
  const Eigen::VectorXd field = factors.solve(load);
  return {field.begin(), field.end()};
}

std::vector<double> harmonic(std::size_t nodes, const std::vector<MeshSide>& sides,
                             const std::vector<std::pair<std::uint32_t, double>>& fixed) {
  std::vector<Gain> gains;
  for (const auto& side : sides) gains.push_back({side.from, side.to, 0, 1});
  return by_gains(nodes, gains, fixed);
}

}  // namespace netloft::gears
