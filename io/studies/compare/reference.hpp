// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/studies/compare/polish.hpp"
#include "io/studies/compare/timed_trial.hpp"

namespace netloft::studies {

/// The answer against which errors of a method are measured. Another solver found it, and Newton steps
/// improved it until only round-off was left.
struct ReferenceAnswer {
  Method method;
  bool independent = true;  // whether its solver and the tested method come from different plugins
  double tolerance = 0;     // tolerance to which this solver converged
  Stability stability = Stability::unknown;
  Polished answer;
  // For a motion: its path, and whether loss factors of materials are used. answer.uncertainty is then the
  // largest distance from the path of another integrator with the same accuracy.
  std::vector<std::vector<double>> path = {};
  bool is_damped = true;
};

/// The solvers that may compute a reference for `method`, in the order in which they are tried. Solvers of
/// the method's own plugin come last, so that a method is compared with its own plugin only if no other
/// solver is installed. `available` lists the installed plugins. If `wanted` is not empty, it is the only
/// candidate.
std::vector<Method> reference_methods(const Method& method, const std::vector<std::string>& available,
                                      const std::string& wanted);

/// The solver plugin of a method: "newton" for "newton:method=classic". For a strategy, it is the default
/// solver, which the stages of the strategy use.
std::string plugin_of(const Method& method);

/// The answers of reference solvers to one scene, each computed on first use.
class ReferenceAnswers {
 public:
  ReferenceAnswers(const runs::CaseSource& source, Registry& registry, std::string wanted,
                   const runs::Watch& watch)
      : source_(source), registry_(registry), wanted_(std::move(wanted)), watch_(watch) {}

  /// The reference for a method; nullopt if no solver converges.
  std::optional<ReferenceAnswer> find_for(const Method& method);

 private:
  const std::optional<ReferenceAnswer>& answer_of(const Method& method);

  const runs::CaseSource& source_;
  Registry& registry_;
  std::string wanted_;  // specification of a solver
  const runs::Watch& watch_;
  std::map<std::string, std::optional<ReferenceAnswer>> found_;
};

}  // namespace netloft::studies
