// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/bodies.hpp"

#include <netloft/rotation.hpp>

#include <algorithm>

namespace netloft {

namespace {

std::array<std::size_t, 3> places_of(const Numbering& numbering, std::uint32_t node) {
  return {numbering.dof(node, 0).at(), numbering.dof(node, 1).at(), numbering.dof(node, 2).at()};
}

/// Returns three entries of a vector over all dofs, divided by the length `over`.
Vec3<double> read(std::span<const double> x, const std::array<std::size_t, 3>& at, double over = 1) {
  return {x[at[0]] / over, x[at[1]] / over, x[at[2]] / over};
}

/// Returns three entries of a vector over all dofs, divided by the length `over`, as dual numbers, whose
/// derivatives are with respect to the variables `first` to `first` + 2.
template <class T>
Vec3<T> read_variables(std::span<const double> x, const std::array<std::size_t, 3>& at, double over,
                       int first) {
  Vec3<T> to;
  for (int k = 0; k < 3; ++k) to[k] = T::variable(x[at[static_cast<std::size_t>(k)]], first + k) / T(over);
  return to;
}

template <class T>
Vec3<T> constant(const std::array<double, 3>& r) {
  return {T(r[0]), T(r[1]), T(r[2])};
}

using Matrix3 = std::array<double, 9>;

/// Derivatives of f with respect to variables `first` to `first` + 2.
template <class T>
Matrix3 slope(const Vec3<T>& f, std::size_t first) {
  Matrix3 slope{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) slope[3 * i + k] = f[static_cast<int>(i)].gradient[first + k];
  return slope;
}

/// to += factor Aᵀ B
void add_transposed_product(const Matrix3& A, const Matrix3& B, double factor, Matrix3& to) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t j = 0; j < 3; ++j) to[3 * i + j] += factor * A[3 * k + i] * B[3 * k + j];
}

constexpr Matrix3 kIdentity{1, 0, 0, 0, 1, 0, 0, 0, 1};

Matrix3 transposed(const Matrix3& A) { return {A[0], A[3], A[6], A[1], A[4], A[7], A[2], A[5], A[8]}; }

Matrix3 product_of(const Matrix3& A, const Matrix3& B) {
  Matrix3 both{};
  add_transposed_product(transposed(A), B, 1, both);
  return both;
}

}  // namespace

Bodies::Bodies(const Scene& scene, const Numbering& numbering, const NodeBlocks& blocks, bool symmetric)
    : unknowns_(numbering.unknowns()) {
  if (scene.bodies.empty()) return;
  targets_.resize(scene.node_count());
  for (std::uint32_t n = 0; n < scene.node_count(); ++n) targets_[n] = {{n, -1}};
  for (const auto& body : scene.bodies) {
    const std::uint32_t turn = body.rotation_node;
    const bool turns = !scene.stands_still(turn);
    for (const auto& point : body.points) {
      targets_[point.node].clear();
      if (!scene.stands_still(body.origin)) targets_[point.node].push_back({body.origin, -1});
      if (turns) targets_[point.node].push_back({turn, static_cast<int>(points_.size())});
      points_.push_back({point.node, places_of(numbering, point.node), point.r, bodies_.size()});
    }
    bodies_.push_back({places_of(numbering, body.origin), places_of(numbering, turn), body.arm(),
                       turns ? blocks.base(turn, turn) : kNoBlock});
    pairs_.push_back({body.origin, turn});
  }
  slopes_.resize(points_.size());
  for (std::uint32_t column = 0; column + 1 < blocks.column_start.size(); ++column)
    for (std::size_t b = blocks.column_start[column]; b < blocks.column_start[column + 1]; ++b)
      if (scene.carried[blocks.row_node[b]] || scene.carried[column])
        add_products(blocks, 9 * b, blocks.row_node[b], column, symmetric);
}

/// A symmetric matrix stores its lower triangle only. A block below the diagonal therefore also stands for
/// its transpose, whereas a block on the diagonal stands only for itself.
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
    const Body& body = bodies_[p.body];
    const auto at = read(x, body.origin) + rotated(read(x, body.rotation, body.arm), constant<double>(p.r));
    for (std::size_t i = 0; i < 3; ++i) x[p.at[i]] = at[static_cast<int>(i)];
  }
}

void Bodies::move(std::span<const double> x, std::span<double> v, std::span<double> a) const {
  for (const Point& p : points_) {
    const Body& body = bodies_[p.body];
    const auto psi = read(x, body.rotation, body.arm), rate = read(v, body.rotation, body.arm);
    const auto arm = rotated(psi, constant<double>(p.r)), spin = spin_of(psi, rate),
               spin_rate = spin_rate_of(psi, rate, read(a, body.rotation, body.arm));
    const auto turning = cross(spin, arm);
    const auto velocity = read(v, body.origin) + turning;
    const auto acceleration = read(a, body.origin) + cross(spin_rate, arm) + cross(spin, turning);
    for (std::size_t i = 0; i < 3; ++i) {
      v[p.at[i]] = velocity[static_cast<int>(i)];
      a[p.at[i]] = acceleration[static_cast<int>(i)];
    }
  }
}

void Bodies::differentiate(std::span<const double> x, const BodyMotion& motion) {
  using T = Dual<3>;
  using R = Dual<6, 1>;  // derivatives with respect to q and its rate
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const Point& p = points_[k];
    const Body& body = bodies_[p.body];
    Slopes& s = slopes_[k];
    const auto arm = rotated(read_variables<T>(x, body.rotation, body.arm, 0), constant<T>(p.r));
    s.G = slope(arm, 0);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 3; ++c)
          s.second[i][3 * r + c] =
              arm[static_cast<int>(i)].hessian[std::max(r, c) * (std::max(r, c) + 1) / 2 + std::min(r, c)];
    if (!motion.v) continue;
    const std::span<const double> v(motion.v, x.size()), a(motion.a, x.size());
    const auto psi = read_variables<R>(x, body.rotation, body.arm, 0),
               rate = read_variables<R>(v, body.rotation, body.arm, 3);
    const auto second = read(a, body.rotation, body.arm);
    const auto lever = rotated(psi, constant<R>(p.r)), spin = spin_of(psi, rate),
               spin_rate = spin_rate_of(psi, rate, Vec3<R>{R(second.x), R(second.y), R(second.z)});
    const auto velocity = cross(spin, lever), acceleration = cross(spin_rate, lever) + cross(spin, velocity);
    s.velocity = slope(velocity, 0);
    s.acceleration = slope(acceleration, 0);
    s.acceleration_by_rate = slope(acceleration, 3);
  }
}

void Bodies::hand_on_matrix(const Product& product, const BodyMotion& motion,
                            const BodyMatrices& matrices) const {
  const auto block = [&](const double* from) {
    Matrix3 K;
    std::copy_n(from + product.from, 9, K.begin());
    if (product.from_diagonal) K[1] = K[3], K[2] = K[6], K[5] = K[7];
    return K;
  };
  const Slopes* left = product.left < 0 ? nullptr : &slopes_[static_cast<std::size_t>(product.left)];
  const Slopes* right = product.right < 0 ? nullptr : &slopes_[static_cast<std::size_t>(product.right)];
  Matrix3 K = block(matrices.values);
  if (right) K = product_of(K, right->G);
  if (right && matrices.damping) {  // (4)
    Matrix3 by_rate{};
    for (std::size_t i = 0; i < 9; ++i)
      by_rate[i] = motion.cv * right->acceleration_by_rate[i] + motion.cu * right->acceleration[i];
    const Matrix3 C = product_of(block(matrices.damping), right->velocity),
                  M = product_of(block(matrices.mass), by_rate);
    for (std::size_t i = 0; i < 9; ++i) K[i] += motion.cu * C[i] + M[i];
  }
  Matrix3 all{};
  add_transposed_product(left ? left->G : kIdentity, K, 1, all);
  double* to = matrices.values + product.to;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      to[3 * i + j] +=
          (product.transposed ? all[3 * j + i] : all[3 * i + j]) + (product.both ? all[3 * j + i] : 0.0);
}

void Bodies::hand_on(std::span<const double> x, const BodyMotion& motion, double* residual,
                     const BodyMatrices& matrices, bool exact) {
  if (points_.empty() || (!residual && !matrices.values)) return;
  differentiate(x, motion);
  if (matrices.values)
    for (const Product& product : products_) hand_on_matrix(product, motion, matrices);
  for (std::size_t k = 0; k < points_.size() && residual; ++k) {
    const Point& p = points_[k];
    const Body& body = bodies_[p.body];
    for (std::size_t i = 0; i < 3; ++i) {
      const double f = residual[p.at[i]];
      residual[body.origin[i]] += f;
      for (std::size_t c = 0; c < 3; ++c) residual[body.rotation[c]] += slopes_[k].G[3 * i + c] * f;
      for (std::size_t c = 0; c < 9 && matrices.values && exact && body.rotation_block != kNoBlock; ++c)
        matrices.values[body.rotation_block + c] += motion.cu * f * slopes_[k].second[i][c];
      residual[p.at[i]] = 0;
    }
  }
}

void Bodies::resist_turning(double* metric) const {
  for (const Body& body : bodies_) {
    if (body.rotation_block == kNoBlock) continue;
    double* A = metric + body.rotation_block;
    const double trace = A[0] + A[4] + A[8];
    for (std::size_t i = 0; i < 9; ++i) A[i] = trace * kIdentity[i];
  }
}

void Bodies::hand_on_masses(std::span<const double> x, std::span<double> blocks,
                            std::span<double> between) const {
  for (const Point& p : points_) {
    const Body& body = bodies_[p.body];
    using T = Dual<3, 1>;
    const Matrix3 G = slope(rotated(read_variables<T>(x, body.rotation, body.arm, 0), constant<T>(p.r)), 0);
    Matrix3 M, turning{};
    std::copy_n(&blocks[9 * std::size_t{p.node}], 9, M.begin());
    const Matrix3 across = product_of(M, G);
    add_transposed_product(G, across, 1, turning);
    for (std::size_t i = 0; i < 9; ++i) {
      blocks[9 * std::size_t{pairs_[p.body][0]} + i] += M[i];
      blocks[9 * std::size_t{pairs_[p.body][1]} + i] += turning[i];
      between[9 * p.body + i] += across[i];
    }
  }
}

bool Bodies::shorten(std::span<const double> start, std::span<double> u, std::span<double> v,
                     std::span<double> a) const {
  // The limit is ¾ of a turn, half-way between half a turn and a whole one. No rotation needs more than half
  // a turn. At a whole turn, the rate of the rotation vector cannot be computed from the spin.
  constexpr double kLongest = 4.71238898038469;
  bool some = false;
  for (const Body& body : bodies_) {
    const auto is_free = [&](std::size_t place) { return place < static_cast<std::size_t>(unknowns_); };
    if (!std::all_of(body.rotation.begin(), body.rotation.end(), is_free)) continue;
    const Vec3<double> psi = (1 / body.arm) * (read(start, body.rotation) + read(u, body.rotation));
    if (!(norm(psi) > kLongest)) continue;
    const Vec3<double> shorter = shortened(psi);
    const auto put = [&](std::span<double> to, const Vec3<double>& value) {
      for (std::size_t k = 0; k < 3 && !to.empty(); ++k)
        to[body.rotation[k]] = body.arm * value[static_cast<int>(k)];
    };
    if (!v.empty()) {
      const auto rate = read(v, body.rotation, body.arm);
      const auto second = a.empty() ? Vec3<double>{} : read(a, body.rotation, body.arm);
      const auto new_rate = rate_of_spin(shorter, spin_of(psi, rate));
      put(v, new_rate);
      // The angular acceleration is linear in the second derivative of the rotation vector. The part that
      // depends on the rates alone is subtracted first.
      put(a, rate_of_spin(shorter, spin_rate_of(psi, rate, second) - spin_rate_of(shorter, new_rate, {})));
    }
    put(u, shorter - (1 / body.arm) * read(start, body.rotation));
    some = true;
  }
  return some;
}

}  // namespace netloft
