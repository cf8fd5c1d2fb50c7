// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/element.hpp>

namespace netloft::femnet {

/// FEMNET's bending between bars i-j and j-k, the moment EI times the curvature of the circle through the
/// three nodes:
///   A = x_j − x_i,  B = x_k − x_j,  a = ‖A‖,  b = ‖B‖,  c = ‖x_k − x_i‖      (1)
///   F_i = (2 EI/abc) [A (A·B)/a² − B],  F_k = (2 EI/abc) [A − B (A·B)/b²]      (2)
///   F_j = −F_i − F_k                                                           (3)
/// The forces have no potential, unlike those of rope/bending. Source: FEMNET (D. Priour).
struct Bend {
  static constexpr auto stencil = NETLOFT_BAR_PAIR;
  struct Parameters {
    double EI = 0;  // [N m²]
  };
  struct Data {
    std::array<double, 2> rest_length{};  // of both bars [m]
  };

  struct Moment {
    using T = Dual<9, 1>;
    static Points<T, 3> force(const Parameters& p, const Points<T, 3>& x) {
      const Vec3<T> A = x[1] - x[0], B = x[2] - x[1];
      const T along = dot(A, B), aa = dot(A, A), bb = dot(B, B);
      const T factor = T(2 * p.EI) / (sqrt(aa * bb) * norm(x[2] - x[0]));
      const Vec3<T> first = factor * ((along / aa) * A - B), last = factor * (A - (along / bb) * B);  // (2)
      return {first, -(first + last), last};                                                          // (3)
    }
    static Status evaluate(const Parameters& p, const Data& d, const State<3>& s, Local<3>& out) {
      const auto short_of = [&](std::size_t i, std::size_t j) {
        return !(norm(s.x[j] - s.x[i]) > 1e-9 * (d.rest_length[0] + d.rest_length[1]));
      };
      if (short_of(0, 1) || short_of(1, 2) || short_of(0, 2)) return Status::outside_domain;
      Points<T, 3> x;
      for (int i = 0; i < 9; ++i)
        x[static_cast<std::size_t>(i / 3)][i % 3] =
            T::variable(s.x[static_cast<std::size_t>(i / 3)][i % 3], i);
      const Points<T, 3> F = force(p, x);
      for (int i = 0; i < 9; ++i) {
        const T& component = F[static_cast<std::size_t>(i / 3)][i % 3];
        out.force[static_cast<std::size_t>(i / 3)][i % 3] = -component.value;
        for (std::size_t c = 0; c < 9; ++c) out.tangent[i][c] = -s.cu * component.gradient[c];
      }
      return Status::ok;
    }
  };
};

}  // namespace netloft::femnet
