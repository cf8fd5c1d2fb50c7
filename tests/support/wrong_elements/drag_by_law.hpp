// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tests/support/wrong_elements/spring.hpp"

#include <netloft/law.hpp>

#include <algorithm>
#include <cmath>

namespace netloft::wrong {

/// A bar with drag by a law, correct except for the length that it passes to the law.
struct DragByLaw {
  static constexpr auto stencil = NETLOFT_BAR;
  using Parameters = wrong::Parameters;
  using Data = wrong::Data;

  struct Term {
    static Status tile(const Family<DragByLaw>& family, netloft_tile& t) {
      static constexpr double kNobody[kLanes] = {};
      FlowLanes f;
      double inverse[kLanes];
      for (std::size_t i = 0; i < t.count; ++i) inverse[i] = fill_lane(t, i, f);
      f.call(family.law(0), t, t.tangent != nullptr, kNobody);
      for (std::size_t i = 0; i < t.count; ++i) add_lane(f, inverse[i], i, t);
      return Status::ok;
    }

   private:
    static constexpr std::size_t at(std::size_t row, std::size_t lane) { return row * kLanes + lane; }
    static double entry(const double* field, std::size_t row, std::size_t lane) {
      return field ? field[at(row, lane)] : 0;
    }

    /// Fills in mean velocity, direction and a diameter of 1 cm; returns one over the length of the bar.
    static double fill_lane(const netloft_tile& t, std::size_t i, FlowLanes& f) {
      double w[3], square = 0;
      for (std::size_t a = 0; a < 3; ++a) {
        f.flow[a][i] = 0.5 * (entry(t.current, a, i) + entry(t.current, a + 3, i) - entry(t.v, a, i) -
                              entry(t.v, a + 3, i));
        w[a] = t.x[at(a + 3, i)] - t.x[at(a, i)], square += w[a] * w[a];
      }
      const double inverse = 1 / std::max(std::sqrt(square), 1e-9);
      for (std::size_t a = 0; a < 3; ++a) f.direction[a][i] = inverse * w[a];
      f.diameter[i] = 0.01, f.solidity[i] = 0;
      return inverse;
    }

    /// Adds half of the force on a metre to each node, and its derivatives.
    static void add_lane(const FlowLanes& f, double inverse, std::size_t i, netloft_tile& t) {
      for (std::size_t r = 0; r < 3; ++r) {
        double along = 0;
        for (std::size_t c = 0; c < 3; ++c) {
          if (t.tangent) along += f.d_direction[3 * r + c][i] * f.direction[c][i];
          if (t.force && c < 2) t.force[at(r + 3 * c, i)] -= 0.5 * f.force[r][i];
        }
        if (t.tangent) add_row(f, inverse, along, r, i, t);
      }
    }

    static void add_row(const FlowLanes& f, double inverse, double along, std::size_t r, std::size_t i,
                        netloft_tile& t) {
      for (std::size_t q = 0; q < 2; ++q) {
        double shear = 0;
        for (std::size_t c = 0; c < 3; ++c)
          shear += 0.5 * f.d_flow[3 * r + c][i] * entry(t.current_dz, 3 * q + c, i);
        for (std::size_t c = 0; c < 3; ++c) {
          const double turn = inverse * (f.d_direction[3 * r + c][i] - along * f.direction[c][i]);
          const double d = -0.5 * (t.cu * ((q ? turn : -turn) + (c == 2 ? shear : 0)) -
                                   t.cv * 0.5 * f.d_flow[3 * r + c][i]);
          for (std::size_t p = 0; p < 2; ++p) t.tangent[at(6 * (3 * p + r) + 3 * q + c, i)] += d;
        }
      }
    }
  };
};

}  // namespace netloft::wrong
