// SPDX-License-Identifier: BSD-3-Clause
#include <netloft/strategy.hpp>
#include <netloft/vectors.hpp>

#include <cmath>
#include <utility>

namespace {

using namespace netloft;

/// Finds several equilibria by deflation: the known roots uᵢ are divided out of the residual,
///   r(u) Π ηᵢ(u) = 0,   ηᵢ = L²/qᵢ + 1,   qᵢ = ‖u − uᵢ‖²                                 (1)
/// which has all roots of r except the known ones. Its tangent differs from that of r by a matrix of rank
/// one. Its Newton step is therefore a multiple of the Newton step of r (Sherman and Morrison), computed with
/// the factor of K, the tangent of r:
///   u ← u + τ s,   s = −K⁻¹ r,   τ = 1/(1 − Σ s·∇ηᵢ/ηᵢ)                                  (2)
///   s·∇η/η = −2 L² s·(u − uᵢ)/(q (L² + q))                                               (3)
/// (P. E. Farrell, Á. Birkisson, S. W. Funke, Deflation techniques for finding distinct solutions of
/// nonlinear partial differential equations, SIAM J. Sci. Comput. 37, 2015.) L is the size of an element;
/// translations count in m, rotations in rad. A step moves no node by more than L. There is no other
/// globalisation: the method is meant for stiff structures (struts, frames), stable or not, and seldom solves
/// slack netting. A body that rotates by a full turn has the same shape, but counts as another root.
struct Deflation {
  struct Parameters {
    const char* by = nullptr;
    std::int64_t searches = 0, iterations = 0;
  };

  static void run(const Parameters& p, Search& search) {
    const Specification by = specification_of(p.by);
    const Stage first =
        search.call(by.name.c_str(), by.parameters.c_str(), {.name = "the first shape"}, search.start());
    if (!first.is_stationary()) return;
    search.answer(first.u);
    std::vector<Displacements> known{first.u};
    for (int number = 0; number < p.searches && search.work_left() > 0; ++number) {
      const Stage next = search_from(start_of(number, first, search), known, p, search);
      if (!next.is_stationary()) continue;
      search.answer(next.u);
      known.push_back(next.u);
    }
  }

  static std::string explain(const Parameters& p, Search&) {
    return std::string("one shape by ") + p.by +
           ", then others by Newton's method, with the known ones divided out of the equations\n";
  }

 private:
  /// Returns the initial guess: the start of the search, then perturbations of the first equilibrium.
  static Displacements start_of(int number, const Stage& first, const Search& search) {
    return number == 0 ? search.start() : perturbed(first.u, search.element_size(), number);
  }

  static Stage search_from(Displacements from, const std::vector<Displacements>& known, const Parameters& p,
                           Search& search) {
    const Ask ask{.name = "deflated", .iterations = static_cast<unsigned>(p.iterations)};
    auto u = search.with_problem(ask, std::move(from),
                                 [&](Problem& problem) { solve(problem, known, search.element_size()); });
    return search.assess({.name = "deflated"}, std::move(u));
  }

  /// Iterates to a root of r, or until a limit is reached or a matrix cannot be factorised.
  static void solve(Problem& problem, const std::vector<Displacements>& known, double L) {
    std::vector<double> r(problem.size()), s(problem.size());
    double energy = 0;
    while (problem.evaluate(problem.u(), energy, r, Matrix::exact) == Evaluation::ok &&
           problem.progress(problem.u(), energy, r, "deflated") &&
           problem.factorise_indefinite(Matrix::exact, 0) == Factor::ok) {
      problem.solve(r, s);
      scale(-1, s);
      const double t = multiple(problem.u(), s, known, L), length = std::abs(t) * problem.step_length(s);
      if (!std::isfinite(length)) return;
      axpy(length > 1 ? t / length : t, s, problem.u());
    }
  }

  /// Computes τ of (2), the multiple of the Newton step s.
  static double multiple(std::span<const double> u, std::span<const double> s,
                         const std::vector<Displacements>& known, double L) {
    double sum = 0;
    std::vector<double> d(u.size());
    for (const Displacements& root : known) {
      add_scaled(u, -1, root, d);
      const double q = dot(d, d);
      if (q > 0) sum -= 2 * L * L * dot(s, d) / (q * (L * L + q));  // (3)
    }
    return 1 / (1 - sum);
  }
};

}  // namespace

NETLOFT_PLUGIN("deflation", "0.1.0", "Several equilibria, by deflation") {
  auto& s = plugin.strategy<Deflation>(
      "deflation",
      "One equilibrium, then others, stable or not, with the known ones divided out of the equations");
  using P = Deflation::Parameters;
  s.strategy("by", &P::by, "strategy that finds the first equilibrium", "auto");
  s.integer("searches", &P::searches, "number of searches for another equilibrium", 0, 1000, 10);
  s.integer("iterations", &P::iterations, "largest number of Newton steps in one search", 1, 100000, 100);
}
