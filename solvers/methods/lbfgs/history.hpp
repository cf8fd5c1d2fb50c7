// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace netloft::lbfgs {

/// The last pairs s, y of a limited-memory BFGS method, and the inverse Hessian H that they define by (2) and
/// (3) of lbfgs.hpp.
class Memory {
 public:
  Memory(std::size_t pairs, std::size_t unknowns);

  bool is_empty() const { return count_ == 0; }
  void clear() { count_ = 0; }

  /// Adds s, y and B y. Returns false and changes nothing if (4) of lbfgs.hpp leaves the pair out.
  bool add(std::span<const double> s, std::span<const double> y, std::span<const double> By);

  /// Writes H r to p, given B r. The two loops over the pairs are those of Nocedal and Wright, alg. 7.4; B q
  /// is computed as B r − Σ α_i B y_i, so that a step, including its γ, applies B only once. `q` is scratch
  /// memory.
  void multiply(std::span<const double> r, std::span<const double> Br, std::span<double> q,
                std::span<double> p);

 private:
  struct Pair {
    std::vector<double> s, y, By;
    double sy = 0, alpha = 0;
  };
  /// The i-th pair before the newest one.
  Pair& pair(std::size_t i) { return pairs_[(newest_ + pairs_.size() - i) % pairs_.size()]; }

  std::vector<Pair> pairs_;
  std::size_t newest_ = 0, count_ = 0;
  double gamma_ = 1;
};

}  // namespace netloft::lbfgs
