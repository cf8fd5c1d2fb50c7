// SPDX-License-Identifier: BSD-3-Clause
#include <netloft/strategy.hpp>

namespace {

using namespace netloft;

/// Where things stick and slide no tangent tells what happens next; a matrix-free solver brings the gear
/// near, and the solver of the analysis goes on from there. Where that does not converge either, the
/// matrix-free one goes on to the end.
/// Without a tangent an iteration costs next to nothing; the budget of work ends them.
constexpr unsigned kAsManyAsItTakes = 10000000;

struct Relaxed {
  struct Parameters {
    const char* solver = nullptr;
  };

  static void run(const Parameters& p, Study& study) {
    const Stage near = study.solve(
        {.name = "relaxation", .solver = p.solver, .tolerance = kOnlyAStart, .iterations = kAsManyAsItTakes},
        study.start());
    if (study.work_left() == 0) return;
    Stage stage = study.solve({.name = "from a relaxed shape"}, near.u);
    if (!stage.is_stationary() && study.work_left() > 0)
      stage =
          study.solve({.name = "by relaxation", .solver = p.solver, .iterations = kAsManyAsItTakes}, near.u);
    if (stage.is_stationary()) study.answer(stage.u);
  }

  static std::string explain(const Parameters& p, Study&) {
    return std::string("near by ") + p.solver +
           ", which needs no tangent, then the scene itself from there\n";
  }
};

}  // namespace

NETLOFT_PLUGIN("relaxed", "0.1.0", "From a relaxed shape") {
  auto& s = plugin.strategy<Relaxed>("relaxed", "From where a matrix-free solver has brought the gear near");
  using P = Relaxed::Parameters;
  s.text("solver", &P::solver, "solver that needs no tangent", "relaxation");
}
