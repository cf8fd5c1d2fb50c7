// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/element.hpp>

#include <array>

namespace netloft::catches {

/// Pressure of the flow that the catch stops, from inside on the netting behind the front of the catch:
///   p = p₀ + C_d ½ ρ V²                                                                (1)
///   n = o (x₂−x₁)×(x₃−x₁)                           outward normal, length twice the area    (2)
///   r_i = −(φ_i p/2) n,  i = 1, 2, 3                  the part of the force on each corner   (3)
///   K_ij = o (φ_i p/2) [w_j]×,  w₁ = x₂−x₃, w₂ = x₃−x₁, w₃ = x₁−x₂,  [w]× v = w×v            (4)
///   φ_i(m) = (∫ N_i over the part of the triangle with s < m)/(its area),  φ = Σ φ_i        (5)
/// p₀ [Pa] given pressure, V [m/s] speed of the water through the gear, C_d drag coefficient of the catch; s
/// is the number of meshes to the aft end of the netting, counted through all panels in a row and given at
/// the corners; m is the number of filled meshes, so that the front is at s = m; N_i is linear, 1 at corner i
/// and 0 at the others. φ_i is computed for the unstretched triangle. o is 1 for corners that are
/// counter-clockwise seen from outside, else −1. Source: the trawl-gear paper, p with C_d = 1.4; (3) after
/// Priour.
///
/// The pressure is a follower force without a potential. Over a closed surface, or a surface with a fixed
/// rim, the sum of (3) is the gradient of −p × volume, and the sum of (4) is symmetric. A front through a
/// cod-end, however, is a moving rim: the forces of a potential −p Σ x₁·(x₂×x₃)/6 would depend on the origin.
///
/// All triangles of a part share the front m. It is the given number of `meshes`, or an unknown whose
/// equation is that the catch has the given volume:
///   v = (ȳ − y₀) n_y/2,  ȳ = (y₁ + y₂ + y₃)/3         ∮ (y − y₀) dA_y over the triangle      (6)
///   r_m = k (Σ φ v − σ V₀) = 0,  k = p/∛V₀                                                (7)
///   ∂r_i/∂m = −φ_i′ (p/2) n,   ∂r_m/∂m = k φ′ v                                           (8)
///   ∂r_m/∂x_j = k φ [ n_y/6 e_y − o ½ (ȳ − y₀) e_yᵀ[w_j]× ]                                 (9)
/// V₀ [m³] is the volume of the catch; σ [1] the fraction of V₀ at a given time, from a table, or 1; y the
/// axis across the cod-end, y₀ the middle of the cod-end. By the theorem of Gauss, Σ φ v is the volume behind
/// the front, closed there by a surface of straight lines from side to side. A cut triangle contributes φ v,
/// with the v of the whole triangle. The volume is exact for every cod-end that is symmetric about the plane
/// y = y₀, and for a half of it that ends in this plane. If the cod-end is turned by ψ, the error is the area
/// of the front times sin ψ times the distance of its middle from y₀. The factor k makes (7) a force; its
/// ratio to the drag on the front is the ratio of the missing volume to V₀.
struct Pressure {
  static constexpr auto stencil = NETLOFT_TRIANGLE;
  static constexpr int globals = 1;  // shared unknown: m

  struct Parameters {
    double pressure = 0, speed = 0, drag_coefficient = 0, meshes = 0, volume = 0, middle = 0;
    std::int64_t across = 0;
    netloft_table growth{};  // columns: time t [s], fraction σ
  };
  struct Data {
    std::array<double, 3> to_aft{};  // distance s of each corner [meshes]
    double outward = 1;              // sign o of (2)
  };
  struct Whole {
    double triangles = 0, length = 0;  // length: largest s [meshes]
  };
  /// The filled fractions φ_i of (5) at the corners of one triangle, and their derivatives with respect to m.
  struct Fraction {
    std::array<double, 3> at{}, slope_at{};
    double value() const { return at[0] + at[1] + at[2]; }
    double slope() const { return slope_at[0] + slope_at[1] + slope_at[2]; }
  };

  /// Throws std::invalid_argument unless a pressure or a speed is given, and either `meshes` or `volume`. A
  /// growth must have a volume.
  static void check(const Parameters& p, const Data& d);
  /// Throws std::invalid_argument if more meshes are filled than the netting has along its length.
  static void check_whole(const Parameters& p, const Whole& whole);
  static void gather(const Parameters& p, const Data& d, Whole& whole);
  static double first_front(const Parameters& p, const Whole& whole);

  static Fraction fraction_behind_front(const std::array<double, 3>& to_aft, double meshes);  // (5)
  static double full(const Parameters& p, const Water& w);                      // pressure p [Pa]
  static double on(const Parameters& p, const Data& d, const State<4>& s);      // mean pressure φ p [Pa]
  static double volume(const Parameters& p, const Data& d, const State<4>& s);  // volume φ v [m³]

  struct Push {
    static Status evaluate(const Parameters& p, const Data& d, const Whole& whole, const State<4>& s,
                           Local<4>& out);
  };
};

}  // namespace netloft::catches
