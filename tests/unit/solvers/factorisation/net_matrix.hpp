// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "framework/balance/factorisation.hpp"

namespace netloft {

/// A sparse matrix in the form that factorisations read.
struct TestMatrix {
  SparsePattern pattern;
  std::vector<double> value;

  std::vector<double> times(std::span<const double> x) const;
  /// The transposed matrix; itself if it is given by its lower triangle.
  TestMatrix transposed() const;
  /// ‖A x − b‖∞ / (‖A‖∞ ‖x‖∞ + ‖b‖∞)
  double backward_error(std::span<const double> x, std::span<const double> b) const;
};

/// A net like a cod-end: rings of nodes on a tapered cylinder, bars along, around and (if `diagonals`)
/// across.
///   K = k t tᵀ + g (I − t tᵀ) per bar, + s I per node
struct NetOptions {
  int rings = 20;           // ≥ 1
  int nodes_per_ring = 20;  // ≥ 3
  bool diagonals = true;    // six neighbours instead of four
  bool symmetric = true;    // lower triangle only; otherwise the full pattern
  double axial = 1e4;       // k, axial stiffness of a bar [N/m]
  double geometric = 10;    // g, tension over length [N/m]
  double ground = 0.1;      // s [N/m]
  double skew = 0;          // ± s·skew between the unknowns of a node, as a drag force gives [N/m]
  std::function<bool(int node, int axis)> is_fixed = [](int, int) { return false; };
};

TestMatrix make_net_matrix(const NetOptions& options);

/// The pattern of a cubic lattice of side³ nodes with six neighbours each: its factor has many entries for
/// few unknowns.
SparsePattern make_lattice(std::int32_t side, std::int32_t unknowns_per_node, bool symmetric);

/// Makes a small matrix from its full rows. Every unknown is a node.
TestMatrix make_dense_matrix(const std::vector<std::vector<double>>& rows, bool symmetric);

}  // namespace netloft
