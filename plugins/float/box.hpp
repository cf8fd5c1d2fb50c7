// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/element.hpp>

namespace netloft::floats {

/// An upright box that does not rotate, with the middle of its lower or upper face at a node. Its part below
/// the surface displaces water. s is the number of boxes at the node, ½ on a plane of symmetry.
///   d = clamp(η − z_b, 0, H),  z_b = z of the node, or z − H if the box hangs     immersed height  (1)
///   E = s ρ g A D(z),  −dD/dz = d,  r = −s ρ g A d e_z,  A = L_x L_y              buoyancy         (2)
///   E = s m g z                                                                   weight           (3)
///   F_i = s k_i d |W| W_i,  k_x = ½ ρ C_x L_y,  k_y = ½ ρ C_y L_x,  k_z = ½ ρ C_z A/H   drag       (4)
///   r = s (m + m_a) ẍ                                                             inertia          (5)
///   r_x = −s (ρ A d + m_a) u′_x,  r_y alike,  r_z = −s m_a u′_z                   waves            (6)
/// L_x, L_y, H [m] sides, m [kg] mass, m_a [kg] added mass, C drag coefficients along the axes, W [m/s]
/// velocity of the water relative to the node, η [m] height of the surface above z = 0, u′ [m/s²]
/// acceleration of the water at the node. Vertical drag is proportional to the immersed fraction d/H. Source:
/// hydrostatics; Morison's equation for each axis. The vertical pressure force of waves that are long
/// compared with the box is in (2), through η. The model neglects the variation of this force over the depth
/// of the box (a fraction k d of it, with the wave number k), diffraction, and the dependence of added mass
/// on the period.
struct Box {
  static constexpr auto stencil = NETLOFT_NODE;

  struct Parameters {
    double mass = 0, length_x = 0, length_y = 0, height = 0;
    double drag_x = 0, drag_y = 0, drag_z = 0, added_mass = 0;
    bool hangs = false;
  };
  struct Data {
    double pieces = 0;  // number s of boxes
  };
  /// The immersed height d of (1), and its derivative with respect to z.
  struct Depth {
    double d, slope;
  };

  static void check(const Parameters& p, const Data& d);
  /// Returns the immersed height; `above` is the height of the node above the surface, z − η.
  static Depth immersed(const Parameters& p, double above);

  struct Buoyancy {
    static Status evaluate(const Parameters& p, const Data& d, const State<1>& s, Local<1>& out);
  };
  struct Weight {
    static Status evaluate(const Parameters& p, const Data& d, const State<1>& s, Local<1>& out);
  };
  struct Drag {
    static Status evaluate(const Parameters& p, const Data& d, const State<1>& s, Local<1>& out);
  };
  struct Inertia {
    static Status evaluate(const Parameters& p, const Data& d, const State<1>& s, Local<1>& out);
  };
  struct Waves {
    static Status evaluate(const Parameters& p, const Data& d, const State<1>& s, Local<1>& out);
  };
};

}  // namespace netloft::floats
