// SPDX-License-Identifier: BSD-3-Clause
#include <netloft/strategy.hpp>

#include <utility>

namespace {

using namespace netloft;

/// Limit of iterations that is never reached: iterations without a matrix cost next to nothing, and only the
/// budget of work limits them.
constexpr unsigned kAsManyAsItTakes = 10000000;

/// A strategy for elements that stick and slide, whose tangent does not predict the next state. A matrix-free
/// solver brings the gear close to equilibrium; the solver of the analysis continues from there. If that
/// solver does not converge, the matrix-free solver continues to the end.
struct Relaxed {
  struct Parameters {
    const char* solver = nullptr;
  };

  static void run(const Parameters& p, Search& search) {
    const Specification by = specification_of(p.solver);
    const auto relax = [&](const char* name, double tolerance, Displacements u) {
      return search.solve({.name = name,
                           .solver = by.name.c_str(),
                           .parameters = by.parameters.c_str(),
                           .tolerance = tolerance,
                           .iterations = kAsManyAsItTakes},
                          std::move(u));
    };
    const Stage near = relax("relaxation", kOnlyAStart, search.start());
    if (search.work_left() == 0) return;
    Stage stage = search.solve({.name = "from a relaxed shape"}, near.u);
    if (!stage.is_stationary() && search.work_left() > 0) stage = relax("by relaxation", 0, near.u);
    if (stage.is_stationary()) search.answer(stage.u);
  }

  static std::string explain(const Parameters& p, Search&) {
    return std::string("near the solution by ") + p.solver +
           ", which needs no tangent, then the scene itself from there\n";
  }
};

}  // namespace

NETLOFT_PLUGIN("relaxed", "0.1.0", "From a relaxed shape") {
  auto& s = plugin.strategy<Relaxed>(
      "relaxed", "A solver without matrices comes near the solution; from there, the scene itself is solved");
  using P = Relaxed::Parameters;
  s.solver("solver", &P::solver, "solver that needs no tangent", "relaxation");
}
