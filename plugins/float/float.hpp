// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/element.hpp>

#include <cmath>

namespace netloft::floats {

/// Floats at a node. s is the number of floats that the node has of those along a rope; it need not be an
/// integer. Weights are floats with B < 0.
///   B = the given buoyancy, or (ρ V − m) g                                  (1)
///   r = −s B e_z,  E = −s B z                  net upward force             (2)
///   r = −s κ C_d |W| W,  κ = ½ ρ A             drag                         (3)
///   D = −∂r/∂W = s κ (C_d |W| I + (C_d + Re C_d′) W Wᵀ/|W|),  ∂W/∂x = (dc/dz) e_zᵀ,  ∂W/∂ẋ = −I (4)
///   r = s (m + C_a ρ V) ẍ                      inertia, added mass included (5)
///   r = −s (1 + C_a) ρ V u′                    waves                        (6)
/// B [N] net upward force of one float in water, V [m³] volume, m [kg] mass, A [m²] area across the flow (π
/// D²/4 if only the diameter D is given), W = c − ẋ [m/s] velocity of the water relative to the float, u′
/// [m/s²] acceleration of the water, C_d drag and C_a added-mass coefficient. (6) is the pressure of the
/// waves on the displaced volume (Froude and Krylov) and added mass. Source: Morison's equation for a body
/// that is small compared with the scale of the flow; C_a = ½ is the sphere in potential flow, C_d = 0.47 the
/// smooth sphere at Reynolds numbers of 1e3 to 2e5 (Hoerner, Fluid-Dynamic Drag, 1965, chapter III). With the
/// law `sphere`, C_d depends on Re = |W| D/ν, across the drag crisis (plugins/common/sphere.hpp). A float
/// with lugs or growth is rough and reaches the crisis earlier.
struct Float {
  static constexpr auto stencil = NETLOFT_NODE;

  struct Parameters {
    double buoyancy = 0, volume = 0, mass = 0, diameter = 0, area = 0;
    double drag_coefficient = 0, added_mass = 0;
    std::int64_t drag_law = 0;
  };
  enum Law : std::int64_t { kConstant, kSphere };

  struct Data {
    double pieces = 0;  // number s of floats
  };

  static void check(const Parameters&, const Data& d);
  static double net_buoyancy(const Parameters& p, const Water& w);  // (1)
  static double drag_factor(const Parameters& p, const Water& w);   // factor κ of (3) [kg/m]

  struct Buoyancy {
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
