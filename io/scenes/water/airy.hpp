// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene.hpp"

#include <limits>
#include <vector>

namespace netloft::scenes {

/// The wave number k > 0 [1/m] that satisfies ω² = g k tanh(k d), accurate to double precision.
double wave_number(double omega, double gravity, double depth);

/// Height at which regular waves of the length λ = 2π/k break: 0.142 λ tanh(k d) [m] (R. Miche, "Mouvements
/// ondulatoires de la mer en profondeur constante ou décroissante", Annales des Ponts et Chaussées, 1944).
double highest_wave(double k, double depth);

/// Whether waves are too long for linear theory: k d < π/10 (R. G. Dean and R. A. Dalrymple, Water Wave
/// Mechanics for Engineers and Scientists, 1991, section 3.5).
bool is_shallow(double k, double depth);

/// Long-crested waves of small steepness: a sum of linear waves (G. B. Airy, "Tides and waves", 1845; R. G.
/// Dean and R. A. Dalrymple, Water Wave Mechanics for Engineers and Scientists, 1991, chapter 3).
///   η = Σ a cos θ,  θ = k s − ω t + ε,  ω² = g k tanh(k d)                                         (1)
///   u = Σ a ω C cos θ,  w = Σ a ω S sin θ                                                          (2)
///   u′ = Σ a ω² C sin θ,  w′ = −Σ a ω² S cos θ                                                     (3)
///   C = cosh k(ζ+d)/sinh kd,  S = sinh k(ζ+d)/sinh kd                                              (4)
///   ζ = d (z − η)/(d + η)                          Wheeler's stretching; ζ = z without it          (5)
/// η [m] is the elevation of the surface; u and w [m/s] are the velocities along the direction of travel and
/// upwards, u′ and w′ [m/s²] their derivatives with respect to time. Each wave has an amplitude a [m], a
/// frequency ω [rad/s] and a phase ε [rad]; d [m] is the depth, infinite in deep water; s [m] is the
/// coordinate along the direction of travel, in a frame that moves with the tow and the drift of the water.
/// Above the surface the motion is that of the surface. (5) is from J. D. Wheeler, "Method for calculating
/// forces produced by irregular waves", J. Petroleum Technology 22, 1970: the motion of linear theory at z =
/// 0 is applied at the surface. (3) omits the change of ζ with time and the advection of the water, both of
/// second order. From time zero, waves grow over the time `ramp` [s]: amplitudes have the factor r = 3 q² − 2
/// q³ with q = t/ramp, and (3) includes its derivative r′.
class AiryWaves : public WaterField {
 public:
  struct Component {
    double amplitude, omega, phase;  // [m], [rad/s], [rad]
  };
  struct Sea {
    std::vector<Component> components;
    double direction = 0;                                    // direction of travel, from x towards y [rad]
    double depth = std::numeric_limits<double>::infinity();  // [m]
    double ramp = 0;                                         // [s]
    bool is_stretched = true;
  };

  /// The waves of `sea` move along with the tow and the drift of `current`.
  AiryWaves(Sea sea, double gravity, Current current);
  WaterMotion at(const std::array<double, 3>& place, double time) const override;
  double height(const std::array<double, 3>& place, double time) const;
  const Sea& sea() const { return sea_; }

 private:
  struct Train {
    double amplitude, omega, k, phase;
  };
  /// Velocity and acceleration along the direction of travel and upwards; derivatives of both velocities with
  /// respect to z.
  struct Plane {
    double u = 0, w = 0, u_rate = 0, w_rate = 0, u_dz = 0, w_dz = 0;
  };
  double along(const std::array<double, 3>& place, double time) const;
  double surface(double s, double time) const;
  Plane plane(double s, double zeta, double slope, double time) const;

  Sea sea_;
  std::vector<Train> trains_;
  Current current_;
  double cosine_, sine_;
};

}  // namespace netloft::scenes
