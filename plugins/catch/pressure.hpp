// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/element.hpp>

#include <array>

namespace netloft::catches {

/// Pressure of the flow that the catch stops, on the netting behind the catch front, from inside:
///   p = p₀ + C_d ½ ρ V²                                                                (1)
///   n = (x₂−x₁)×(x₃−x₁) = x₁×x₂ + x₂×x₃ + x₃×x₁     outwards, twice the area              (2)
///   r_i = −(φ p/6) n,  i = 1, 2, 3                  a third of the force per corner       (3)
///   K_ij = (φ p/6) [w_j]×,  w₁ = x₂−x₃, w₂ = x₃−x₁, w₃ = x₁−x₂,  [w]× v = w×v              (4)
///   φ = share of the triangle with s < m                                                  (5)
/// p₀ [Pa] a pressure that is given, V [m/s] speed of the water through the gear, C_d drag coefficient of the
/// catch; s meshes from a corner to the aft edge of its panel, m meshes of it that are filled. s is linear in
/// the triangle, so φ is of the unstretched one and stays what it is. Corners counter-clockwise seen from
/// outside. Source: the paper's catch, p with C_d = 1.4; (3) after Priour, A Finite Element Method for
/// Netting (Springer 2013).
///
/// A follower force without an energy: over a closed surface, or one whose rim is fixed, the sum of (3) is
/// the gradient of −p × volume and the sum of (4) symmetric, but a catch front that cuts through a cod-end
/// is a rim that moves. An energy −p Σ x₁·(x₂×x₃)/6 would add forces on that rim that depend on where the
/// origin is.
struct Pressure {
  static constexpr auto stencil = NETLOFT_TRIANGLE;

  struct Parameters {
    double pressure = 0, speed = 0, drag_coefficient = 0, meshes = 0;
  };
  struct Data {
    std::array<double, 3> to_aft{};  // s [meshes]
  };

  static double share_behind_front(const std::array<double, 3>& to_aft, double meshes);  // (5)
  static double on(const Parameters& p, const Data& d, const Water& w);                  // φ p [Pa]

  struct Push {
    static Status evaluate(const Parameters& p, const Data& d, const State<3>& s, Local<3>& out);
  };
};

}  // namespace netloft::catches
