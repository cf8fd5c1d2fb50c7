// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/mean_tension.hpp"

namespace netloft {

double stiffness_at(const netloft_member& m, double l) {
  return (l >= m.rest_length ? m.EA : m.EA_compression) / m.rest_length;
}
double tension_at(const netloft_member& m, double l) { return stiffness_at(m, l) * (l - m.rest_length); }
bool is_taut(const netloft_member& m, double l) { return l >= m.rest_length; }

/// a and b are the stretches at both ends of the step. If the member is slack at one end only, a and b have
/// different signs, so that b − a does not suffer from cancellation.
MeanTension mean_tension(const netloft_member& m, double before, double after) {
  const double a = before - m.rest_length, b = after - m.rest_length, k = stiffness_at(m, after);
  if (is_taut(m, before) == is_taut(m, after)) return {0.5 * k * (a + b), 0.5 * k};
  const double mean = 0.5 * (k * b * b - stiffness_at(m, before) * a * a) / (b - a);  // (1)
  return {mean, (k * b - mean) / (b - a)};
}

MeanStiffness mean_stiffness(const netloft_member& m, double before, double after) {
  const double k = stiffness_at(m, after);
  if (is_taut(m, before) == is_taut(m, after)) return {k, 0};
  const double mean = (tension_at(m, after) - tension_at(m, before)) / (after - before);  // (2)
  return {mean, (k - mean) / (after - before)};
}

}  // namespace netloft
