// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/water/airy.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace netloft::scenes {

/// Solves x tanh x = y for x = k d, y = ω² d/g, by Newton's method. The method starts from the limit of deep
/// or shallow water, whichever is nearer, and converges quadratically to rounding.
double wave_number(double omega, double gravity, double depth) {
  const double deep = omega * omega / gravity, y = deep * depth;
  if (!std::isfinite(depth) || y > 40) return deep;  // 1 − tanh 40 is below rounding
  double x = y > 1 ? y : std::sqrt(y);
  for (int i = 0; i < 50; ++i) {
    const double t = std::tanh(x), next = x - (x * t - y) / (t + x * (1 - t * t));
    if (std::abs(next - x) <= 1e-16 * x) break;
    x = next;
  }
  return x / depth;
}

double highest_wave(double k, double depth) {
  const double length = 2 * std::numbers::pi / k, relative = std::isfinite(depth) ? std::tanh(k * depth) : 1;
  return 0.142 * length * relative;
}

bool is_shallow(double k, double depth) { return k * depth < std::numbers::pi / 10; }

namespace {

/// The factor r of the ramp, and its derivative with respect to time.
struct Ramp {
  double value = 1, rate = 0;
};

Ramp ramp_at(double length, double time) {
  if (length <= 0 || time >= length) return {};
  const double q = std::max(0.0, time / length);
  return {q * q * (3 - 2 * q), 6 * q * (1 - q) / length};
}

/// The functions C and S, (4) in airy.hpp, at the height ζ, written with powers of e that do not overflow.
struct Profile {
  Profile(double k, double d, double zeta) {
    const double down = std::exp(k * zeta), up = std::exp(-k * (zeta + 2 * d)),
                 base = -std::expm1(-2 * k * d);
    C = (down + up) / base;
    S = (down - up) / base;
  }
  double C, S;
};

}  // namespace

AiryWaves::AiryWaves(Sea sea, double gravity, Current current)
    : sea_(std::move(sea)),
      current_(std::move(current)),
      cosine_(std::cos(sea_.direction)),
      sine_(std::sin(sea_.direction)) {
  for (const Component& c : sea_.components)
    trains_.push_back({c.amplitude, c.omega, wave_number(c.omega, gravity, sea_.depth), c.phase});
}

double AiryWaves::along(const std::array<double, 3>& place, double time) const {
  const auto carried = current_.carried(time);
  return cosine_ * (place[0] - carried[0]) + sine_ * (place[1] - carried[1]);
}

double AiryWaves::surface(double s, double time) const {
  double sum = 0;
  for (const Train& a : trains_) sum += a.amplitude * std::cos(a.k * s - a.omega * time + a.phase);  // (1)
  return sum;
}

double AiryWaves::height(const std::array<double, 3>& place, double time) const {
  return ramp_at(sea_.ramp, time).value * surface(along(place, time), time);
}

AiryWaves::Plane AiryWaves::plane(double s, double zeta, double slope, double time) const {
  Plane sum;
  for (const Train& a : trains_) {
    const double theta = a.k * s - a.omega * time + a.phase, c = std::cos(theta), r = std::sin(theta);
    const Profile p(a.k, sea_.depth, zeta);
    const double speed = a.amplitude * a.omega;
    sum.u += speed * p.C * c;
    sum.w += speed * p.S * r;  // (2)
    sum.u_rate += speed * a.omega * p.C * r;
    sum.w_rate -= speed * a.omega * p.S * c;  // (3)
    sum.u_dz += slope * speed * a.k * p.S * c;
    sum.w_dz += slope * speed * a.k * p.C * r;
  }
  return sum;
}

WaterMotion AiryWaves::at(const std::array<double, 3>& place, double time) const {
  const double s = along(place, time), d = sea_.depth;
  const Ramp ramp = ramp_at(sea_.ramp, time);
  WaterMotion water;
  water.surface = ramp.value * surface(s, time);
  const double eta = water.surface, stretch = sea_.is_stretched && std::isfinite(d) ? d / (d + eta) : 1;
  const double above = place[2] - (sea_.is_stretched ? eta : 0.0),
               zeta = stretch * std::min(above, 0.0);  // (5)
  const Plane p = plane(s, std::max(zeta, -d), above < 0 ? stretch : 0.0, time);
  const double rate = ramp.value * p.u_rate + ramp.rate * p.u;
  water.velocity = {ramp.value * p.u * cosine_, ramp.value * p.u * sine_, ramp.value * p.w};
  water.acceleration = {rate * cosine_, rate * sine_, ramp.value * p.w_rate + ramp.rate * p.w};
  water.velocity_dz = {ramp.value * p.u_dz * cosine_, ramp.value * p.u_dz * sine_, ramp.value * p.w_dz};
  return water;
}

}  // namespace netloft::scenes
