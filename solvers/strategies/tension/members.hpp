// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/strategy.hpp>
#include <netloft/vectors.hpp>

#include <array>
#include <cmath>
#include <limits>

namespace netloft::tension {

using Member = netloft_member;
using Vector = std::array<double, 3>;

/// Whether no number is infinite or NaN.
inline bool all_finite(std::span<const double> v) {
  double sum = 0;
  for (const double a : v) sum += a - a;
  return sum == 0;
}

/// The stiffness K of a member, row by row.
using Block = std::array<double, 9>;

/// The force f t [N] of a member with unit vector t, and its stiffness K = a t tᵀ + b I [N/m].
struct Line {
  Vector t;
  double f, a, b;
};

/// netloft_members with C++ types: the members of a scene (straight lines that bear tension), and all other
/// forces r(u). A member has the force vector f, and the number n and coefficients c of netloft_member.
class Members {
 public:
  explicit Members(netloft_members& m) : m_(m) {}

  std::size_t size() const { return m_.count; }
  std::size_t unknowns() const { return m_.unknowns; }
  std::size_t dofs() const { return m_.dofs; }
  std::size_t parts() const { return m_.parts; }
  bool symmetric() const { return m_.traits & NETLOFT_SYMMETRIC; }
  const Member& operator[](std::size_t e) const { return m_.member[e]; }
  std::uint32_t part(std::size_t e) const { return m_.part[e]; }
  /// Error [m] that the rounding of the start coordinates causes in a length.
  double rounding() const { return 4 * std::numeric_limits<double>::epsilon() * m_.largest_coordinate; }

  void find_chords(std::span<const double> u, std::vector<Vector>& w) {
    check(m_.chords(m_.host, u.data(), w.data()->data()));
  }
  void find_changes(std::span<const double> step, std::vector<Vector>& w) {
    check(m_.changes(m_.host, step.data(), w.data()->data()));
  }
  /// Computes r(u) over all degrees of freedom and stores its tangent. Returns false if elements cannot
  /// compute their forces at u.
  bool evaluate(std::span<const double> u, std::vector<double>& residual) {
    const int status = m_.evaluate(m_.host, u.data(), residual.data());
    check(status);
    return status == NETLOFT_OK;
  }
  /// Adds the forces f of all members to the residual: residual ← residual + Σ n c f.
  void add_forces(const std::vector<Vector>& f, std::vector<double>& residual) {
    check(m_.add_forces(m_.host, f.data()->data(), residual.data()));
  }
  /// Sets the matrix to the tangent of r plus Σ n c cᵀ K over all members. `K` has the stiffness of each.
  void set_matrix(const std::vector<Block>& K) { check(m_.set_matrix(m_.host, K.data()->data())); }
  /// Sets the matrix from the stiffness K of each member in `lines`, and adds their forces to the residual.
  void set_matrix(const std::vector<Line>& lines, std::vector<double>& residual) {
    static_assert(sizeof(Line) == 6 * sizeof(double));
    check(m_.set_matrix_along(m_.host, lines.data()->t.data(), residual.data()));
  }
  Factor factorise() { return static_cast<Factor>(m_.factorise(m_.host, 0)); }
  Factor factorise_indefinite() { return static_cast<Factor>(m_.factorise(m_.host, NETLOFT_INDEFINITE)); }
  void solve(std::span<const double> rhs, std::span<double> x) {
    check(m_.solve(m_.host, rhs.data(), x.data()));
  }
  /// Counts an iteration. If it returns false, the method must end.
  bool progress(double residual, const char* note) {
    return m_.progress(m_.host, residual, note) == NETLOFT_GO_ON;
  }

 private:
  static void check(int status) {
    if (status < 0) throw std::runtime_error("");  // empty, because the host reports the cause
  }
  netloft_members& m_;
};

}  // namespace netloft::tension
