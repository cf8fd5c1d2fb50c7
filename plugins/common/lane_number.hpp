// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <bit>
#include <cmath>
#include <cstdint>

namespace netloft {

/// ln x and eˣ without branches, tables or calls, so that a compiler vectorises loops over lanes:
///   x = 2ᵏ m, √½ < m < √2,  f = m − 1,  s = f/(2 + f)
///   ln x = k ln 2 + f − ½ f² + s (½ f² + R(s²))                          (1)
///   k = round(x/ln 2),  r = x − k ln 2,  c = r − r² P(r²),  eˣ = 2ᵏ (1 + r + r c/(2 − c))     (2)
/// R and P are the polynomials of fdlibm (Sun Microsystems 1993, e_log.c, e_exp.c), and ln 2 is the sum of
/// two constants. The error of both functions is within one unit in the last place. Plugins are compiled so
/// that sums and products are rounded one by one (-ffp-contract=off); a result therefore has the same bits in
/// any lane, in the vectorised part or the remainder of a loop, and on any processor. Arguments are not
/// checked; callers have to bound them or to discard the result:
///   ln x    normal numbers above zero. Zero and subnormal numbers give −709.1; negative and infinite numbers
///           and NaN give finite numbers without a meaning, such as ln(−1) = 1420 and ln(NaN) = 710.
///   eˣ      |x| < 708. Beyond that, the result may be any number, even negative or NaN.
namespace lane {

inline constexpr double kLn2High = 6.93147180369123816490e-01, kLn2Low = 1.90821492927058770002e-10;
inline constexpr double kRoot[] = {
    6.666666666666735130e-01, 3.999999999940941908e-01, 2.857142874366239149e-01, 2.222219843214978396e-01,
    1.818357216161805012e-01, 1.531383769920937332e-01, 1.479819860511658591e-01};  // R(z) = Σ kRoot[i] zⁱ⁺¹
inline constexpr double kPower[] = {1.66666666666666019037e-01, -2.77777777770155933842e-03,
                                    6.61375632143793436117e-05, -1.65339022054652515390e-06,
                                    4.13813679705723846039e-08};  // P(z) = Σ kPower[i] zⁱ

inline double log(double x) {
  constexpr std::uint64_t kOne = 0x3ff0000000000000, kRootHalf = 0x3fe6a09e00000000,
                          kMantissa = (1ull << 52) - 1;
  const std::uint64_t shifted = std::bit_cast<std::uint64_t>(x) + (kOne - kRootHalf);
  // The bits of the double 2⁵² + n are those of 2⁵² with the integer n < 2⁵² added to the mantissa.
  const double k = std::bit_cast<double>((shifted >> 52) | 0x4330000000000000) - (0x1p52 + 1023);
  const double f = std::bit_cast<double>((shifted & kMantissa) + kRootHalf) - 1;
  const double s = f / (2 + f), z = s * s, w = z * z, half = 0.5 * f * f;
  const double even = w * (kRoot[1] + w * (kRoot[3] + w * kRoot[5]));
  const double odd = z * (kRoot[0] + w * (kRoot[2] + w * (kRoot[4] + w * kRoot[6])));
  return k * kLn2High - ((half - (s * (half + (odd + even)) + k * kLn2Low)) - f);  // (1)
}

inline double exp(double x) {
  constexpr double kInverse = 1.44269504088896338700e+00, kToInteger = 0x1.8p52;
  const double shifted = kInverse * x + kToInteger, k = shifted - kToInteger;
  const double high = x - k * kLn2High, low = k * kLn2Low, r = high - low, z = r * r;
  const double c = r - z * (kPower[0] + z * (kPower[1] + z * (kPower[2] + z * (kPower[3] + z * kPower[4]))));
  const double y = 1 - ((low - (r * c) / (2 - c)) - high);  // (2)
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(y) +
                               (std::bit_cast<std::uint64_t>(shifted) << 52));
}

}  // namespace lane

/// A number that depends on one variable v, and its derivative with respect to ln v. Loops over lanes use it
/// because Dual<1, 1> is slower there. If a loop takes several powers of one number, a compiler may compute
/// its logarithm only once.
struct LaneNumber {
  double value = 0, slope = 0;

  LaneNumber() = default;
  LaneNumber(double v) : value(v) {}  // NOLINT: a plain number is a constant
  LaneNumber(double v, double s) : value(v), slope(s) {}
  static LaneNumber variable(double v) { return {v, v}; }

  friend LaneNumber operator-(const LaneNumber& a) { return {-a.value, -a.slope}; }
  friend LaneNumber operator+(const LaneNumber& a, const LaneNumber& b) {
    return {a.value + b.value, a.slope + b.slope};
  }
  friend LaneNumber operator-(const LaneNumber& a, const LaneNumber& b) {
    return {a.value - b.value, a.slope - b.slope};
  }
  friend LaneNumber operator*(const LaneNumber& a, const LaneNumber& b) {
    return {a.value * b.value, a.value * b.slope + a.slope * b.value};
  }
  friend LaneNumber operator/(const LaneNumber& a, const LaneNumber& b) {
    const double inverse = 1 / b.value, quotient = a.value * inverse;
    return {quotient, (a.slope - quotient * b.slope) * inverse};
  }
  friend bool operator<(const LaneNumber& a, const LaneNumber& b) { return a.value < b.value; }
  friend bool operator<=(const LaneNumber& a, const LaneNumber& b) { return a.value <= b.value; }
  friend bool operator>=(const LaneNumber& a, const LaneNumber& b) { return a.value >= b.value; }

  /// At zero, the slope of the root is set to zero.
  friend LaneNumber sqrt(const LaneNumber& a) {
    const double root = std::sqrt(a.value);
    return {root, root > 0 ? 0.5 * a.slope / root : 0};
  }
  friend LaneNumber log(const LaneNumber& a) { return {lane::log(a.value), a.slope / a.value}; }
  friend LaneNumber pow(const LaneNumber& a, double p) {
    const double power = lane::exp(p * lane::log(a.value));
    return {power, p * power * (a.slope / a.value)};
  }
};

/// x with a lower bound, below which the slope is zero.
template <class T>
T at_least(const T& x, double bound) {
  return x < T(bound) ? T(bound) : x;
}
/// x with an upper bound, above which the slope is zero.
template <class T>
T at_most(const T& x, double bound) {
  return T(bound) < x ? T(bound) : x;
}

}  // namespace netloft
