// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <gtest/gtest.h>
#include <netloft/law.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace netloft {

inline constexpr double kDensity = 1025, kViscosity = 1.19e-6;

/// A tile of 64 flows for a law, with room for all its outputs.
struct TestFlow {
  explicit TestFlow(std::uint32_t count = NETLOFT_LANES) {
    f.size = sizeof f, f.count = count;
    f.water_density = kDensity, f.water_viscosity = kViscosity;
    f.flow = lanes.flow[0], f.direction = lanes.direction[0];
    f.diameter = lanes.diameter, f.solidity = lanes.solidity;
    f.force = lanes.force[0], f.d_flow = lanes.d_flow[0];
    f.d_direction = lanes.d_direction[0], f.d_solidity = lanes.d_solidity[0];
  }
  void set(std::size_t i, const Vec3<double>& flow, const Vec3<double>& direction, double diameter,
           double solidity) {
    for (int a = 0; a < 3; ++a) {
      lanes.flow[a][i] = flow[a];
      lanes.direction[a][i] = direction[a] / norm(direction);
    }
    lanes.diameter[i] = diameter, lanes.solidity[i] = solidity;
  }
  Vec3<double> force(std::size_t i) const {
    return {lanes.force[0][i], lanes.force[1][i], lanes.force[2][i]};
  }
  FlowLanes lanes{};
  netloft_law_tile f{};
};

inline double uniform(std::mt19937_64& random, double lo, double hi) {
  return lo + (hi - lo) * (static_cast<double>(random() >> 11) * 0x1p-53);
}
inline Vec3<double> any_vector(std::mt19937_64& random) {
  return {uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
}

/// Flows from 1 mm/s to 10 m/s, any direction, diameters from 0.1 mm to 10 cm, solidities from 0 to 0.9.
inline TestFlow sample_flows(unsigned seed) {
  std::mt19937_64 random(seed);
  TestFlow t;
  for (std::size_t i = 0; i < kLanes; ++i) {
    const double speed = std::exp(uniform(random, std::log(1e-3), std::log(10.0)));
    const Vec3<double> flow = any_vector(random);
    t.set(i, (speed / norm(flow)) * flow, any_vector(random),
          std::exp(uniform(random, std::log(1e-4), std::log(0.1))), uniform(random, 0, 0.9));
  }
  return t;
}

/// Largest difference in a lane, relative to the largest expected number.
template <std::size_t Rows>
double lane_error(const double (&found)[Rows][kLanes], const double (&expected)[Rows][kLanes],
                  std::size_t i) {
  double error = 0, size = 0;
  for (std::size_t r = 0; r < Rows; ++r) {
    error = std::max(error, std::abs(found[r][i] - expected[r][i]));
    size = std::max(size, std::abs(expected[r][i]));
  }
  return error == 0 ? 0 : error / size;
}

/// Compares L::lanes with L::force, differentiated by dual numbers.
template <class L>
void expect_lanes_match_oracle(const typename L::Parameters& p, TestFlow& t) {
  TestFlow oracle = t;
  oracle.f.force = oracle.lanes.force[0], oracle.f.d_flow = oracle.lanes.d_flow[0];
  oracle.f.d_direction = oracle.lanes.d_direction[0], oracle.f.d_solidity = oracle.lanes.d_solidity[0];
  L::lanes(p, t.f);
  detail::differentiate_law<L>(p, oracle.f);
  for (std::size_t i = 0; i < kLanes; ++i) {
    EXPECT_LT(lane_error(t.lanes.force, oracle.lanes.force, i), 1e-11) << "force of lane " << i;
    EXPECT_LT(lane_error(t.lanes.d_flow, oracle.lanes.d_flow, i), 1e-11) << "d_flow of lane " << i;
    EXPECT_LT(lane_error(t.lanes.d_direction, oracle.lanes.d_direction, i), 1e-11)
        << "d_direction of lane " << i;
    EXPECT_LT(lane_error(t.lanes.d_solidity, oracle.lanes.d_solidity, i), 1e-11)
        << "d_solidity of lane " << i;
  }
}

template <class L>
Vec3<double> force_of(const typename L::Parameters& p, const Vec3<double>& flow,
                      const Vec3<double>& direction, double diameter, double solidity = 0) {
  TestFlow t(1);
  t.set(0, flow, direction, diameter, solidity);
  L::lanes(p, t.f);
  return t.force(0);
}

}  // namespace netloft
