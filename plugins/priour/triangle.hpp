// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "plugins/common/axial.hpp"

#include <array>

namespace netloft::priour {

/// Index of a degree of freedom or matrix entry of element `lane` in the arrays of a tile.
constexpr std::size_t at(int row, std::size_t lane) { return static_cast<std::size_t>(row) * kLanes + lane; }

/// Priour's triangle of netting: the twines of both directions stay straight and parallel inside it. Its
/// corners x₁ x₂ x₃ have twine coordinates (u_i, v_i), counted in bars along the two twine directions.
///   d = (u₂−u₁)(v₃−v₁) − (u₃−u₁)(v₂−v₁);  |d|/2 bars of each direction lie in the triangle      (1)
///   U = Σ a_p x_p,  a = (v₂−v₃, v₃−v₁, v₁−v₂)/d          vector of one u bar                       (2)
///   V = Σ b_p x_p,  b = (u₃−u₂, u₁−u₃, u₂−u₁)/d          vector of one v bar                       (3)
///   E = (|d|/2) [ψ(‖U‖) + ψ(‖V‖)]                        elastic energy                            (4)
///   r_p = (|d|/2) [a_p T_U Û + b_p T_V V̂]                residual ∂E/∂x_p                          (5)
///   K_pq = (|d|/2) [a_p a_q A_U + b_p b_q A_V]           tangent ∂²E/∂x_p∂x_q                      (6)
///   W = |d| (π/4) t² l₀ (ρ − ρ_w) g                       weight in water, a third per corner      (7)
/// ψ [J], T [N] and A [N/m] are the elastic energy, the tension and the stiffness of one bar, by axial.hpp
/// (1)–(6); l₀ [m] is its unstretched length, t [m] the diameter of the twine, ρ [kg/m³] its density. With N
/// twines side by side (double netting), (4)–(7) and all other terms count N |d|/2 bars of each direction,
/// whereas U and V are those of one twine. d may be negative: forces use |d|, whereas (2) and (3) use d
/// itself. Source: Priour 1999; A Finite Element Method for Netting (Springer 2013), as used in the
/// trawl-gear paper, section 2.4.
struct Triangle {
  static constexpr auto stencil = NETLOFT_TRIANGLE;

  struct Parameters {
    double EA = 0, EA_compression = 0, diameter = 0, density = 0;
    double EI = 0, opening_stiffness = 0, opening_angle = 0, knot_size = 0;
    double damping = 0, added_mass = 0, surface = 0, loss_factor = 0, loss_frequency = 10;
    double slowed_by = 0, slowed_front = 0, slowed_radius = 0, slowed_direction = 0;  // see slowed.hpp
    std::int64_t number = 1;  // number N of twines side by side
  };
  struct Data {
    std::array<double, 3> u{}, v{};  // twine coordinates of the corners [bars]
    double bar_length = 0;           // l₀, knot to knot [m]
  };
  struct Lanes {
    double a[3][kLanes], b[3][kLanes];  // a of (2) and b of (3) [1/bar]
    double bars[kLanes];                // number of bars N |d|/2
    double l0[kLanes], EA[kLanes], EA_compression[kLanes];
    double volume[kLanes], density[kLanes];
    double H[kLanes], H_of_EI[kLanes], alpha0[kLanes];  // opening (1), (5)
    double diameter[kLanes], damping[kLanes], added_mass[kLanes];
    double loss[kLanes];      // loss_of() of one twine, see loss.hpp
    double surface[kLanes];   // factor σ of surface.hpp
    double touching[kLanes];  // c_k of knot contact (1); 1 without knots
    // The numbers b, ξ, R and e of slowed.hpp, and whether a catch slows the water at any element.
    double slowed_by[kLanes], slowed_front[kLanes], slowed_radius[kLanes], slowed_x[kLanes], slowed_y[kLanes];
    bool slows = false;
  };

  /// The determinant d of (1) for the first two corners and the corner `third`.
  template <std::size_t Corners>
  static double determinant(const std::array<double, Corners>& u, const std::array<double, Corners>& v,
                            std::size_t third = 2) {
    return (u[1] - u[0]) * (v[third] - v[0]) - (u[third] - u[0]) * (v[1] - v[0]);
  }
  /// The quantities a, b and |d|/2 of (1)–(3) for one triangle.
  struct Shape {
    double a[3], b[3], bars;  // bars: |d|/2
  };
  static Shape shape(const Data& d);
  /// Number of bars of each direction in the triangle, N |d|/2.
  static double bars(const Parameters& p, const Data& d) { return double(p.number) * shape(d).bars; }
  /// One bar of the direction u (`direction` = 0) or v (1), stretched as at the state `s`.
  static axial::Bar stretch(int direction, const Parameters& p, const Data& d, const State<3>& s);
  /// The bars of both directions, (2) and (3).
  static std::array<Member, 2> members(const Parameters& p, const Data& d, double time);
  /// Volume of the unstretched twines in the triangle, as in (7), without knots [m³].
  static double twine_volume(const Parameters& p, const Data& d);
  /// Twine area as the trade defines it: length times diameter [m²].
  static double twine_area(const Parameters& p, const Data& d);
  static double half_angle(const Data& d, const State<3>& s);

  /// The stiffness H of opening.hpp (1) [N·m/rad], as given or from the bending stiffness of the twines.
  static double opening_stiffness(const Parameters& p, const Data& d);
  /// The cosine c_k of the angle between the twines when knots touch, (1) of knot_contact.hpp.
  static double touching_cosine(const Parameters& p, const Data& d);

  static void check(const Parameters&, const Data& d);
  static void pack(const Parameters& p, const Data& d, Lanes& lanes, std::size_t lane);

  struct Elastic {
    static Status tile(const Family<Triangle>& family, netloft_tile& t);
    template <class T>
    static T oracle(const Parameters& p, const Data& d, const Water&, const Points<T, 3>& x) {
      const Shape s = shape(d);
      const Vec3<T> U = s.a[0] * x[0] + s.a[1] * x[1] + s.a[2] * x[2];
      const Vec3<T> V = s.b[0] * x[0] + s.b[1] * x[1] + s.b[2] * x[2];
      const axial::Material m{p.EA, p.EA_compression};
      return bars(p, d) * (axial::energy(U, d.bar_length, m) + axial::energy(V, d.bar_length, m));
    }
  };

  struct Weight {
    static Status tile(const Family<Triangle>& family, netloft_tile& t);
  };
};

}  // namespace netloft::priour
