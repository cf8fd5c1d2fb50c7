// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/methods/lbfgs/history.hpp"

#include <netloft/vectors.hpp>

#include <algorithm>

namespace netloft::lbfgs {

namespace {

/// The ε of (4) in lbfgs.hpp: curvature below this is only rounding.
constexpr double kLeastCurvature = 1e-12;

}  // namespace

Memory::Memory(std::size_t pairs, std::size_t unknowns) : pairs_(pairs) {
  for (Pair& pair : pairs_) {
    pair.s.resize(unknowns);
    pair.y.resize(unknowns);
    pair.By.resize(unknowns);
  }
}

bool Memory::add(std::span<const double> s, std::span<const double> y, std::span<const double> By) {
  const double sy = dot(s, y);
  if (!(sy > kLeastCurvature * norm(s) * norm(y))) return false;  // (4)
  newest_ = (newest_ + 1) % pairs_.size();
  count_ = std::min(count_ + 1, pairs_.size());
  Pair& newest = pair(0);
  std::copy(s.begin(), s.end(), newest.s.begin());
  std::copy(y.begin(), y.end(), newest.y.begin());
  std::copy(By.begin(), By.end(), newest.By.begin());
  newest.sy = sy;
  gamma_ = sy / dot(y, By);  // (3)
  return true;
}

void Memory::multiply(std::span<const double> r, std::span<const double> Br, std::span<double> q,
                      std::span<double> p) {
  std::copy(r.begin(), r.end(), q.begin());
  std::copy(Br.begin(), Br.end(), p.begin());
  for (std::size_t i = 0; i < count_; ++i) {
    Pair& k = pair(i);
    k.alpha = dot(k.s, q) / k.sy;
    axpy(-k.alpha, k.y, q);
    axpy(-k.alpha, k.By, p);
  }
  if (count_ > 0)
    for (double& v : p) v *= gamma_;
  for (std::size_t i = count_; i-- > 0;) {
    const Pair& k = pair(i);
    axpy(k.alpha - dot(k.y, p) / k.sy, k.s, p);
  }
}

}  // namespace netloft::lbfgs
