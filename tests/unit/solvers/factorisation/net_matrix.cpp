// SPDX-License-Identifier: BSD-3-Clause
#include "tests/unit/solvers/factorisation/net_matrix.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

namespace netloft {
namespace {

struct Entry {
  std::int32_t column, row;
  double value;
};

/// Makes a compressed matrix: sorts the entries, and adds up those with the same row and column.
TestMatrix compress(std::vector<Entry> entries, std::vector<std::int32_t> node, bool symmetric) {
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.column, a.row) < std::tie(b.column, b.row);
  });
  TestMatrix matrix;
  SparsePattern& pattern = matrix.pattern;
  pattern.size = static_cast<std::int32_t>(node.size());
  pattern.node = std::move(node);
  pattern.symmetric = symmetric;
  pattern.column_start.assign(1, 0);
  const Entry* last = nullptr;
  for (const Entry& entry : entries) {
    if (symmetric && entry.row < entry.column) continue;
    const bool same_place = last != nullptr && last->column == entry.column && last->row == entry.row;
    last = &entry;
    if (same_place) {
      matrix.value.back() += entry.value;
      continue;
    }
    while (static_cast<std::int32_t>(pattern.column_start.size()) <= entry.column) {
      pattern.column_start.push_back(static_cast<std::int32_t>(pattern.row.size()));
    }
    pattern.row.push_back(entry.row);
    matrix.value.push_back(entry.value);
  }
  pattern.column_start.resize(pattern.size + 1, static_cast<std::int32_t>(pattern.row.size()));
  return matrix;
}

class NetBuilder {
 public:
  explicit NetBuilder(const NetOptions& options) : options_(options) {
    for (int node = 0; node < options.rings * options.nodes_per_ring; ++node) {
      for (int axis = 0; axis < 3; ++axis) {
        const bool fixed = options.is_fixed(node, axis);
        unknown_.push_back(fixed ? -1 : static_cast<std::int32_t>(node_.size()));
        if (!fixed) node_.push_back(node);
      }
    }
  }

  TestMatrix build() {
    for (int ring = 0; ring < options_.rings; ++ring) {
      for (int i = 0; i < options_.nodes_per_ring; ++i) {
        add_node(node_at(ring, i));
        add_bar({ring, i}, {ring, i + 1});
        if (ring + 1 == options_.rings) continue;
        add_bar({ring, i}, {ring + 1, i});
        if (options_.diagonals) add_bar({ring, i}, {ring + 1, i + 1});
      }
    }
    return compress(std::move(entries_), std::move(node_), options_.symmetric);
  }

 private:
  struct Place {
    int ring, i;
  };
  int node_at(int ring, int i) const { return ring * options_.nodes_per_ring + i % options_.nodes_per_ring; }

  std::array<double, 3> position(Place p) const {
    const double angle = 2 * std::numbers::pi * (p.i + 0.3 * std::sin(p.ring)) / options_.nodes_per_ring;
    const double radius = 1 - 0.5 * p.ring / options_.rings;
    return {4.0 * p.ring / options_.rings, radius * std::cos(angle), radius * std::sin(angle)};
  }

  void add(int row_node, int row_axis, int column_node, int column_axis, double value) {
    const std::int32_t row = unknown_[3 * row_node + row_axis];
    const std::int32_t column = unknown_[3 * column_node + column_axis];
    if (row >= 0 && column >= 0) entries_.push_back({column, row, value});
  }

  void add_node(int node) {
    const double s = options_.ground;
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        const double skew = a == b ? 0 : (a < b ? options_.skew : -options_.skew);
        add(node, a, node, b, (a == b ? s : 0) + s * skew);
      }
    }
  }

  void add_bar(Place from, Place to) {
    const std::array<double, 3> x0 = position(from), x1 = position(to);
    const double l = std::hypot(x1[0] - x0[0], x1[1] - x0[1], x1[2] - x0[2]);
    const int n0 = node_at(from.ring, from.i), n1 = node_at(to.ring, to.i);
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        const double tt = (x1[a] - x0[a]) * (x1[b] - x0[b]) / (l * l);
        const double k = options_.axial * tt + options_.geometric * ((a == b ? 1 : 0) - tt);
        add(n0, a, n0, b, k);
        add(n1, a, n1, b, k);
        add(n0, a, n1, b, -k);
        add(n1, a, n0, b, -k);
      }
    }
  }

  const NetOptions& options_;
  std::vector<std::int32_t> unknown_, node_;
  std::vector<Entry> entries_;
};

double max_norm(std::span<const double> x) {
  double norm = 0;
  for (const double value : x) norm = std::max(norm, std::abs(value));
  return norm;
}

}  // namespace

std::vector<double> TestMatrix::times(std::span<const double> x) const {
  std::vector<double> y(x.size(), 0);
  for (std::int32_t column = 0; column < pattern.size; ++column) {
    for (std::int32_t e = pattern.column_start[column]; e < pattern.column_start[column + 1]; ++e) {
      const std::int32_t row = pattern.row[e];
      y[row] += value[e] * x[column];
      if (pattern.symmetric && row != column) y[column] += value[e] * x[row];
    }
  }
  return y;
}

TestMatrix TestMatrix::transposed() const {
  if (pattern.symmetric) return *this;
  std::vector<Entry> entries;
  for (std::int32_t column = 0; column < pattern.size; ++column)
    for (std::int32_t e = pattern.column_start[column]; e < pattern.column_start[column + 1]; ++e)
      entries.push_back({pattern.row[e], column, value[e]});
  return compress(std::move(entries), pattern.node, false);
}

double TestMatrix::backward_error(std::span<const double> x, std::span<const double> b) const {
  TestMatrix magnitude = *this;
  for (double& v : magnitude.value) v = std::abs(v);
  const std::vector<double> ones(b.size(), 1.0);
  const double norm = max_norm(magnitude.times(ones));
  std::vector<double> residual = times(x);
  for (std::size_t i = 0; i < b.size(); ++i) residual[i] -= b[i];
  return max_norm(residual) / (norm * max_norm(x) + max_norm(b));
}

TestMatrix make_net_matrix(const NetOptions& options) { return NetBuilder(options).build(); }

SparsePattern make_lattice(std::int32_t side, std::int32_t unknowns_per_node, bool symmetric) {
  const std::int32_t area = side * side, nodes = area * side, m = unknowns_per_node;
  const auto has = [&](std::int32_t node, std::int32_t step) {
    const std::int32_t lines = (step < 0 ? -step : step) * side;  // number of nodes in a line or layer
    return step == 0 || (node + step >= 0 && node + step < nodes && (node + step) / lines == node / lines);
  };
  SparsePattern pattern;
  pattern.size = m * nodes, pattern.symmetric = symmetric, pattern.column_start = {0};
  for (std::int32_t column = 0; column < pattern.size; ++column) {
    const std::int32_t node = column / m;
    for (const std::int32_t step : {-area, -side, -1, 0, 1, side, area})
      for (std::int32_t i = 0; has(node, step) && i < m; ++i)
        if (const std::int32_t row = m * (node + step) + i; !symmetric || row >= column)
          pattern.row.push_back(row);
    pattern.column_start.push_back(static_cast<std::int32_t>(pattern.row.size()));
    pattern.node.push_back(node);
  }
  return pattern;
}

TestMatrix make_dense_matrix(const std::vector<std::vector<double>>& rows, bool symmetric) {
  std::vector<Entry> entries;
  std::vector<std::int32_t> node;
  for (std::int32_t row = 0; row < static_cast<std::int32_t>(rows.size()); ++row) {
    node.push_back(row);
    for (std::int32_t column = 0; column < static_cast<std::int32_t>(rows.size()); ++column) {
      entries.push_back({column, row, rows[row][column]});
    }
  }
  return compress(std::move(entries), std::move(node), symmetric);
}

}  // namespace netloft
