// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/compare/polish.hpp"
#include "io/compare/trial.hpp"

namespace netloft::io {

/// What errors of a method are measured against: the answer of another solver, brought to the round-off
/// floor.
struct ReferenceAnswer {
  Method method;
  bool independent = true;  // found by another solver plugin than the method it judges
  double tolerance = 0;     // to which that solver converged by itself
  Stability stability = Stability::unknown;
  Polished answer;
};

/// Solvers to ask for a reference for `method`, the best first; those of its own plugin come last, for no
/// method grades itself while there is another. `available` are names of plugins; `wanted`, if not empty, is
/// the only one asked.
std::vector<Method> reference_methods(const Method& method, const std::vector<std::string>& available,
                                      const std::string& wanted);

/// The plugin of a method: "newton" of "newton:method=classic", and of "auto", which is newton with
/// continuation.
std::string plugin_of(const Method& method);

/// The answers of reference solvers to one scene, each found when first asked for.
class ReferenceAnswers {
 public:
  ReferenceAnswers(const CaseSource& source, Registry& registry, std::string wanted, const Watch& watch)
      : source_(source), registry_(registry), wanted_(std::move(wanted)), watch_(watch) {}

  /// Nothing if none of the solvers arrives.
  std::optional<ReferenceAnswer> find_for(const Method& method);

 private:
  const std::optional<ReferenceAnswer>& answer_of(const Method& method);

  const CaseSource& source_;
  Registry& registry_;
  std::string wanted_;
  const Watch& watch_;
  std::map<std::string, std::optional<ReferenceAnswer>> found_;
};

}  // namespace netloft::io
