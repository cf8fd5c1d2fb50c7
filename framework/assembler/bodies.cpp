// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/bodies.hpp"

#include <netloft/dual.hpp>
#include <netloft/vec3.hpp>

#include <algorithm>

namespace netloft {

namespace {

/// R(θ) r = r + a θ×r + b θ×(θ×r) with a = sin φ/φ, b = (1 − cos φ)/φ², φ = ‖θ‖; series near zero.
template <class T>
Vec3<T> rotated(const Vec3<T>& theta, const std::array<double, 3>& r) {
  const Vec3<T> v{T(r[0]), T(r[1]), T(r[2])};
  const T s = dot(theta, theta);
  T a, b;
  if (s < T(1e-4)) {
    a = 1.0 - s / 6.0 + s * s / 120.0 - s * s * s / 5040.0;
    b = 0.5 - s / 24.0 + s * s / 720.0 - s * s * s / 40320.0;
  } else {
    const T phi = sqrt(s);
    a = sin(phi) / phi;
    b = (1.0 - cos(phi)) / s;
  }
  const Vec3<T> once = cross(theta, v);
  return v + a * once + b * cross(theta, once);
}

std::array<std::size_t, 3> places_of(const Numbering& numbering, std::uint32_t node) {
  return {static_cast<std::size_t>(numbering.index(node, 0)),
          static_cast<std::size_t>(numbering.index(node, 1)),
          static_cast<std::size_t>(numbering.index(node, 2))};
}

}  // namespace

Bodies::Bodies(const Scene& scene, const Numbering& numbering, const NodeBlocks& blocks, bool symmetric) {
  if (scene.bodies.empty()) return;
  targets_.resize(scene.node_count());
  for (std::uint32_t n = 0; n < scene.node_count(); ++n) targets_[n] = {{n, -1}};
  for (const auto& body : scene.bodies)
    for (const auto& point : body.points) {
      targets_[point.node].clear();
      if (!scene.stands_still(body.position)) targets_[point.node].push_back({body.position, -1});
      const bool turns = !scene.stands_still(body.rotation);
      if (turns) targets_[point.node].push_back({body.rotation, static_cast<int>(points_.size())});
      points_.push_back({places_of(numbering, point.node),
                         places_of(numbering, body.position),
                         places_of(numbering, body.rotation),
                         point.r,
                         turns ? blocks.base(body.rotation, body.rotation) : kNoBlock,
                         {},
                         {}});
    }
  for (std::uint32_t column = 0; column + 1 < blocks.column_start.size(); ++column)
    for (std::size_t b = blocks.column_start[column]; b < blocks.column_start[column + 1]; ++b)
      if ((!scene.carried.empty()) && (scene.carried[blocks.row_node[b]] || scene.carried[column]))
        add_products(blocks, 9 * b, blocks.row_node[b], column, symmetric);
}

/// A lower block off the diagonal represents its transpose, too; a diagonal block is symmetric and complete.
void Bodies::add_products(const NodeBlocks& blocks, std::size_t from, std::uint32_t row, std::uint32_t column,
                          bool symmetric) {
  const bool on_diagonal = row == column;
  for (const Target& r : targets_[row])
    for (const Target& c : targets_[column]) {
      if (!symmetric) {
        products_.push_back({from, blocks.base(r.node, c.node), r.point, c.point, false, false, false});
      } else if (r.node == c.node) {
        products_.push_back(
            {from, blocks.base(r.node, c.node), r.point, c.point, on_diagonal, false, !on_diagonal});
      } else if (!on_diagonal || r.node > c.node) {
        const bool up = r.node < c.node;
        products_.push_back({from, blocks.base(std::max(r.node, c.node), std::min(r.node, c.node)), r.point,
                             c.point, on_diagonal, up, false});
      }
    }
}

void Bodies::place(std::span<double> x) const {
  for (const Point& p : points_) {
    const Vec3<double> theta{x[p.rotation[0]], x[p.rotation[1]], x[p.rotation[2]]};
    const Vec3<double> arm = rotated(theta, p.r);
    for (std::size_t i = 0; i < 3; ++i) x[p.at[i]] = x[p.position[i]] + arm[static_cast<int>(i)];
  }
}

void Bodies::differentiate(std::span<const double> x) {
  using T = Dual<3>;
  for (Point& p : points_) {
    Vec3<T> theta;
    for (int k = 0; k < 3; ++k) theta[k] = T::variable(x[p.rotation[static_cast<std::size_t>(k)]], k);
    const Vec3<T> arm = rotated(theta, p.r);
    for (std::size_t i = 0; i < 3; ++i) {
      const T& a = arm[static_cast<int>(i)];
      for (std::size_t k = 0; k < 3; ++k) p.G[3 * i + k] = a.gradient[k];
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t l = 0; l < 3; ++l)
          p.second[i][3 * k + l] = a.hessian[std::max(k, l) * (std::max(k, l) + 1) / 2 + std::min(k, l)];
    }
  }
}

void Bodies::hand_on(std::span<const double> x, double* residual, double* values, bool exact) {
  if (points_.empty() || (!residual && !values)) return;
  differentiate(x);
  const auto G_of = [&](int point) -> const Matrix3* {
    return point < 0 ? nullptr : &points_[static_cast<std::size_t>(point)].G;
  };
  if (values)
    for (const Product& product : products_) {
      Matrix3 K;
      std::copy_n(values + product.from, 9, K.begin());
      if (product.from_diagonal) K[1] = K[3], K[2] = K[6], K[5] = K[7];
      const Matrix3 *L = G_of(product.left), *R = G_of(product.right);
      Matrix3 left{}, all{};
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          for (std::size_t k = 0; k < 3; ++k)
            left[3 * i + j] += (L ? (*L)[3 * k + i] : (i == k ? 1.0 : 0.0)) * K[3 * k + j];
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          for (std::size_t k = 0; k < 3; ++k)
            all[3 * i + j] += left[3 * i + k] * (R ? (*R)[3 * k + j] : (j == k ? 1.0 : 0.0));
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          values[product.to + 3 * i + j] +=
              (product.transposed ? all[3 * j + i] : all[3 * i + j]) + (product.both ? all[3 * j + i] : 0.0);
    }
  for (const Point& p : points_)
    for (std::size_t i = 0; i < 3 && residual; ++i) {
      const double f = residual[p.at[i]];
      residual[p.position[i]] += f;
      for (std::size_t k = 0; k < 3; ++k) residual[p.rotation[k]] += p.G[3 * i + k] * f;
      for (std::size_t k = 0; k < 9 && values && exact && p.rotation_block != kNoBlock; ++k)
        values[p.rotation_block + k] += f * p.second[i][k];
      residual[p.at[i]] = 0;
    }
}

}  // namespace netloft
