// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <gtest/gtest.h>
#include <netloft/element.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace netloft {

inline constexpr Water kSeaWater{1025, 9.81};

/// A tile of 64 lanes of one element type, with room for all outputs.
template <int Nodes>
struct TestTile {
  static constexpr std::size_t dofs = 3 * Nodes, entries = dofs * (dofs + 1) / 2;
  explicit TestTile(const Water& water) {
    t.size = sizeof t;
    t.want = NETLOFT_WANT_ENERGY | NETLOFT_WANT_FORCE;
    t.count = NETLOFT_LANES;
    t.cu = 1;
    t.water_density = water.density, t.gravity = water.gravity;
    t.x = x, t.energy = energy, t.force = force;
  }
  void want_tangent() { t.want |= NETLOFT_WANT_TANGENT, t.tangent = tangent; }
  double x[dofs * kLanes] = {}, energy[kLanes] = {}, force[dofs * kLanes] = {},
                  tangent[entries * kLanes] = {};
  netloft_tile t{};
};

/// A family of 64 elements with the same parameters, filled in as its plugin fills it.
template <class E>
Family<E> make_family(const typename E::Parameters& parameters, const std::vector<typename E::Data>& data) {
  Family<E> f;
  f.parameters_ = {parameters};
  f.part_.assign(data.size(), 0);
  f.data_ = data;
  f.lanes_.resize(1);
  for (std::size_t e = 0; e < data.size(); ++e) E::pack(parameters, data[e], f.lanes_[0], e);
  return f;
}

/// The energy Term::oracle in dual numbers, which contain its first and second derivatives.
template <class E, class Term, int Nodes>
Dual<3 * Nodes> oracle(const typename E::Parameters& p, const typename E::Data& d, const Water& w,
                       const TestTile<Nodes>& tile, std::size_t lane) {
  Points<Dual<3 * Nodes>, Nodes> x;
  for (int i = 0; i < 3 * Nodes; ++i)
    x[static_cast<std::size_t>(i / 3)][i % 3] =
        Dual<3 * Nodes>::variable(tile.x[static_cast<std::size_t>(i) * kLanes + lane], i);
  return Term::oracle(p, d, w, x);
}

/// Largest difference between the numbers of a lane and the expected numbers, divided by the largest expected
/// number.
template <class Expected>
double relative_error(const double* found, const Expected& expected, std::size_t lane) {
  double error = 0, size = 0;
  for (std::size_t k = 0; k < expected.size(); ++k) {
    error = std::max(error, std::abs(found[k * kLanes + lane] - expected[k]));
    size = std::max(size, std::abs(expected[k]));
  }
  return error == 0 ? 0 : error / size;
}

/// Compares energy, force and (unless constant) tangent of Term::tile with the oracle in every lane.
template <class E, class Term, int Nodes>
void expect_kernel_matches_oracle(const typename E::Parameters& p, const std::vector<typename E::Data>& data,
                                  const Water& water, TestTile<Nodes>& tile, bool constant) {
  if (!constant) tile.want_tangent();
  const Family<E> family = make_family<E>(p, data);
  ASSERT_EQ(Term::tile(family, tile.t), Status::ok);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const auto e = oracle<E, Term, Nodes>(p, data[lane], water, tile, lane);
    EXPECT_NEAR(tile.energy[lane], e.value, 1e-12 * std::abs(e.value)) << "energy of lane " << lane;
    EXPECT_LT(relative_error(tile.force, e.gradient, lane), 1e-12) << "force of lane " << lane;
    if (constant) continue;
    EXPECT_LT(relative_error(tile.tangent, e.hessian, lane), 1e-12) << "tangent of lane " << lane;
  }
}

inline double uniform(std::mt19937_64& random, double lo, double hi) {
  return lo + (hi - lo) * (static_cast<double>(random() >> 11) * 0x1p-53);
}

}  // namespace netloft
