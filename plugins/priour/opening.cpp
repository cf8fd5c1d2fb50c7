// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/priour/opening.hpp"

namespace netloft::priour {

namespace {

constexpr int kTerms = 13;  // (kSeries/2)^kTerms is 1e-17

/// The coefficients A_k of (4) in opening.hpp, and their products with k and with k(k−1).
struct Series {
  double A[kTerms + 1] = {}, kA[kTerms + 1] = {}, kkA[kTerms + 1] = {};
  constexpr Series() {
    double power = 1, binomial = 2;  // 2^(k−1), C(2k, k)
    for (int k = 1; k <= kTerms; ++k) {
      A[k] = power / (k * k * binomial);
      kA[k] = k * A[k];
      kkA[k] = (k - 1) * kA[k];
      power *= 2;
      binomial *= 2.0 * (2 * k + 1) / (k + 1);
    }
  }
};
constexpr Series kSeriesOf;

/// Returns Σ a_k e^(k−from) over k ≥ from.
double sum(const double (&a)[kTerms + 1], int from, double e) {
  double total = 0;
  for (int k = kTerms; k >= from; --k) total = total * e + a[k];
  return total;
}

}  // namespace

Status Opening::tile(const double* stiffness, const Triangle::Lanes& p, netloft_tile& t) {
  const angle::Meshes m(p, t);
  angle::Function f;
  for (std::uint32_t i = 0; i < t.count; ++i) {
    const double H = p.bars[i] * stiffness[i], a0 = p.alpha0[i], c = m.c[i], s = m.s[i];
    if (H == 0) {
      f.E[i] = f.E1[i] = f.E2[i] = 0;
      continue;
    }
    const double e = s * s / (1 + c);  // 1 − c without cancellation when meshes close
    if (a0 == 0 && c > 0 && e < kSeries) {
      f.E[i] = H * e * sum(kSeriesOf.A, 1, e);
      f.E1[i] = -H * sum(kSeriesOf.kA, 1, e);  // (4)
      f.E2[i] = H * sum(kSeriesOf.kkA, 2, e);
      continue;
    }
    if (s < kCusp) {
      t.lane_at_fault = i;
      throw OutsideDomain(c > 0 ? "the resistance to opening of a closed mesh has no direction"
                                : "the resistance to opening of a mesh opened flat has no direction");
    }
    const double turned = 0.5 * std::atan2(s, c) - a0, slope = turned / s;
    f.E[i] = H * turned * turned;               // (1)
    f.E1[i] = -H * slope;                       // (2)
    f.E2[i] = H * (0.5 - slope * c) / (s * s);  // (3)
  }
  angle::add(p, m, f, t);
  return Status::ok;
}

}  // namespace netloft::priour
