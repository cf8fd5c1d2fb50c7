// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/meshing/knot_graph.hpp"

#include "io/formats/work/long_work.hpp"

#include <Eigen/SparseCholesky>

namespace netloft::gears {

namespace {

constexpr double kTie = 1e-9;  // weight of the value zero, for fields that nothing else determines
constexpr double kHold = 1e9;  // weight of a given value; all others have weight one

}  // namespace

Neighbours rope_neighbours(const GearMesh& mesh) {
  Neighbours neighbours(mesh.nodes);
  for (const auto& rope : mesh.ropes)
    for (std::size_t i = 1; i < rope.nodes.size(); ++i) {
      neighbours[rope.nodes[i - 1]].push_back({rope.nodes[i], rope.rest_lengths[i - 1]});
      neighbours[rope.nodes[i]].push_back({rope.nodes[i - 1], rope.rest_lengths[i - 1]});
    }
  return neighbours;
}

namespace {

using Index = Eigen::Index;

/// The matrix of the least-squares problem for a field with desired differences (gains) between nodes.
/// Additional terms pull the field towards given values at the nodes `fixed` and, weakly, towards zero.
Eigen::SparseMatrix<double> matrix_of(std::size_t nodes, const std::vector<Gain>& gains,
                                      const std::vector<std::uint32_t>& fixed) {
  const auto n = static_cast<Index>(nodes);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(nodes + 4 * gains.size() + fixed.size());
  for (Index i = 0; i < n; ++i) entries.push_back({static_cast<int>(i), static_cast<int>(i), kTie});
  for (const auto& [from, to, gain, weight] : gains) {
    const int i = static_cast<int>(from), j = static_cast<int>(to);
    entries.insert(entries.end(), {{i, i, weight}, {j, j, weight}, {i, j, -weight}, {j, i, -weight}});
  }
  for (const auto node : fixed) entries.push_back({static_cast<int>(node), static_cast<int>(node), kHold});
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

std::vector<std::uint32_t> nodes_of(const std::vector<std::pair<std::uint32_t, double>>& fixed) {
  std::vector<std::uint32_t> nodes;
  for (const auto& [node, value] : fixed) nodes.push_back(node);
  return nodes;
}

/// Gains of zero along every side of a triangle and every bar of a rope, which make a field smooth. A side of
/// two triangles counts twice.
std::vector<Gain> level_sides(const GearMesh& mesh) {
  std::vector<Gain> sides;
  for (const auto& panel : mesh.panels)
    for (std::size_t t = 0; t + 2 < panel.triangles.size(); t += 3)
      for (std::size_t k = 0; k < 3; ++k)
        sides.push_back(
            {panel.nodes[panel.triangles[t + k]], panel.nodes[panel.triangles[t + (k + 1) % 3]], 0, 1});
  for (const auto& rope : mesh.ropes)
    for (std::size_t i = 1; i < rope.nodes.size(); ++i)
      sides.push_back({rope.nodes[i - 1], rope.nodes[i], 0, 1});
  return sides;
}

}  // namespace

/// The factorised matrix for some gains and a set of nodes with given values.
class GainFactors {
 public:
  GainFactors(std::size_t nodes, const std::vector<Gain>& gains, const std::vector<std::uint32_t>& fixed)
      : factors_(matrix_of(nodes, gains, fixed)) {}

  /// The field for the right-hand side `load` (from the gains) and the given values `fixed`.
  std::vector<double> solve(Eigen::VectorXd load,
                            const std::vector<std::pair<std::uint32_t, double>>& fixed) const {
    for (const auto& [node, value] : fixed) load[static_cast<Index>(node)] += kHold * value;
    const Eigen::VectorXd field = factors_.solve(load);
    return {field.begin(), field.end()};
  }

 private:
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors_;
};

std::vector<double> by_gains(std::size_t nodes, const std::vector<Gain>& gains,
                             const std::vector<std::pair<std::uint32_t, double>>& fixed) {
  formats::report({"placing", "the gear", nodes, "nodes"});
  Eigen::VectorXd load = Eigen::VectorXd::Zero(static_cast<Index>(nodes));
  for (const auto& [from, to, gain, weight] : gains) {
    load[static_cast<Index>(from)] -= weight * gain;
    load[static_cast<Index>(to)] += weight * gain;
  }
  return GainFactors(nodes, gains, nodes_of(fixed)).solve(std::move(load), fixed);
}

HarmonicFields::HarmonicFields(const GearMesh& mesh) : nodes_(mesh.nodes), sides_(level_sides(mesh)) {}

std::vector<double> HarmonicFields::with(const std::vector<std::pair<std::uint32_t, double>>& fixed) {
  formats::report({"placing", "the gear", nodes_, "nodes"});
  const auto factors = factors_.of(nodes_of(fixed), [&](const auto& nodes) {
    return std::make_shared<GainFactors>(nodes_, sides_, nodes);
  });
  return factors->solve(Eigen::VectorXd::Zero(static_cast<Index>(nodes_)), fixed);
}

}  // namespace netloft::gears
