// SPDX-License-Identifier: BSD-3-Clause
//
// A plugin with one component of each kind, written with the C++ headers like a plugin of a user. It is built
// once for an interface and kept as a file; every later program must load it. See rebuild.sh.
#include <netloft/integrator.hpp>
#include <netloft/law.hpp>
#include <netloft/solver.hpp>
#include <netloft/strategy.hpp>

using namespace netloft;

/// E = k/2 (l − l₀)²; reports its tension k (l − l₀).
struct Spring {
  static constexpr auto stencil = NETLOFT_BAR;
  struct Parameters {
    double k = 0;
  };
  struct Data {
    double rest_length = 0;
  };
  struct Elastic {
    template <class T>
    static T energy(const Parameters& p, const Data& d, const Water&, const Points<T, 2>& x) {
      const T e = norm(x[1] - x[0]) - d.rest_length;
      if (e <= T(-0.999999 * d.rest_length)) throw OutsideDomain("a spring of no length");
      return 0.5 * p.k * e * e;
    }
  };
  static double tension(const Parameters& p, const Data& d, const State<2>& s) {
    return p.k * (norm(s.x[1] - s.x[0]) - d.rest_length);
  }
};

/// F = ½ ρ C D |W| W per metre.
struct Square {
  static constexpr auto kind = NETLOFT_TWINE_LAW;
  struct Parameters {
    double coefficient = 0;
  };
  template <class T>
  static Vec3<T> force(const Parameters& p, const Flow<T>& f) {
    using std::sqrt;
    const T speed = sqrt(dot(f.flow, f.flow) + T(1e-24));
    return (0.5 * f.density * p.coefficient * f.diameter) * (speed * f.flow);
  }
};

/// Newton's method, as in the guide of solvers.
struct Newton {
  struct Parameters {
    std::int64_t most = 0;
  };
  static Outcome solve(const Parameters& p, Problem& problem) {
    std::vector<double> r(problem.size()), s(problem.size());
    double energy = 0;
    for (std::int64_t i = 0; i < p.most; ++i) {
      if (problem.evaluate(problem.u(), energy, r, Matrix::exact) != Evaluation::ok)
        return Outcome::left_domain;
      if (!problem.progress(problem.u(), energy, r)) return Outcome::stopped;
      if (problem.factorise_indefinite(Matrix::exact, 0) != Factor::ok) return Outcome::linear_solve;
      problem.solve(r, s);
      for (std::size_t k = 0; k < r.size(); ++k) problem.u()[k] -= s[k];
    }
    return Outcome::step_too_short;
  }
};

/// v ← v + h a, u ← u + h v: semi-implicit Euler.
struct Euler {
  struct Parameters {};
  static double order(const Parameters&) { return 2; }
  static double stable_step(const Parameters&, double omega) { return 2 / omega; }
  static Step step(const Parameters&, Motion& m) {
    for (std::size_t i = 0; i < m.size(); ++i) {
      m.next_v()[i] = m.v()[i] + m.h() * m.a()[i];
      m.next_u()[i] = m.u()[i] + m.h() * m.next_v()[i];
    }
    return m.accelerate(m.t() + m.h(), m.next_u(), m.next_v(), m.next_a());
  }
};

/// Solves a few steps by its own Newton's method, then calls the solver.
struct Own {
  struct Parameters {
    std::int64_t steps = 0;
  };
  static void run(const Parameters& p, Search& search) {
    const Displacements u = search.with_problem({.name = "own"}, search.start(), [&](Problem& problem) {
      std::vector<double> r(problem.size()), s(problem.size());
      double energy = 0;
      for (std::int64_t i = 0; i < p.steps; ++i) {
        if (problem.evaluate(problem.u(), energy, r, Matrix::exact) != Evaluation::ok ||
            !problem.progress(problem.u(), energy, r) ||
            problem.factorise_indefinite(Matrix::exact, 0) != Factor::ok)
          return;
        problem.solve(r, s);
        for (std::size_t k = 0; k < r.size(); ++k) problem.u()[k] -= s[k];
      }
    });
    if (search.work_left() == 0) return;
    const Stage stage = search.solve({.name = "from there"}, u);
    if (stage.is_stationary()) search.answer(stage.u);
  }
};

NETLOFT_PLUGIN("released", "1.0", "One of everything") {
  auto& e = plugin.element<Spring>("spring", "Spring");
  e.real("k", &Spring::Parameters::k, "N/m", "stiffness", {.lo = 0, .hi = 1e6});
  e.data("rest_length", &Spring::Data::rest_length, "m", "length without load");
  e.term<Spring::Elastic>("elastic", "pull of the spring");
  e.output("tension", "N", "pull of the spring", &Spring::tension);
  auto& l = plugin.law<Square>("square", "Drag by the square of the speed");
  l.real("coefficient", &Square::Parameters::coefficient, "1", "drag coefficient",
         {.lo = 0, .hi = 10, .fallback = 1});
  auto& s = plugin.solver<Newton>("newton", "Newton's method");
  plugin.integrator<Euler>("euler", "Semi-implicit Euler").traits(NETLOFT_EXPLICIT);
  auto& own = plugin.strategy<Own>("own", "Newton's method of its own, then the solver");
  own.integer("steps", &Own::Parameters::steps, "steps of its own", 0, 100, 2);
  s.integer("most", &Newton::Parameters::most, "most iterations", 1, 1000, 100);
}
