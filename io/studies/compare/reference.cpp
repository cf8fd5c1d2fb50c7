// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/compare/reference.hpp"

#include "io/scenes/reading/keys.hpp"

#include <algorithm>
#include <array>

namespace netloft::studies {

namespace {

// Tolerances to try. Most solvers reach the first one; slow solvers may reach only a looser one.
constexpr std::array<double, 3> kTolerances{1e-9, 1e-6, 1e-4};
// Solvers, the most trusted first. The two methods of the plugin newton share little code.
constexpr std::array<const char*, 6> kTrusted{
    "newton", "ptc", "lbfgs", "relaxation", "newton:method=classic", "newton:method=globalised"};

/// Returns the answer of the solver, improved by polish(); nullopt if the solver did not converge to any of
/// the tolerances.
std::optional<ReferenceAnswer> solve_for_reference(const runs::CaseSource& source, Registry& registry,
                                                   const Method& method, const runs::Watch& watch) {
  for (const double tolerance : kTolerances) {
    const Trial trial = run_trial(source, registry, method, tolerance, 1, watch);
    if (!trial.converged()) continue;
    runs::PreparedScene fresh(source_for(source, method, tolerance), registry);
    fresh.prepare();
    return ReferenceAnswer{method, true, tolerance, trial.stability, polish(fresh, trial.u)};
  }
  return {};
}

}  // namespace

std::string plugin_of(const Method& method) {
  const std::string name = method.name();
  return method.kind() == "strategy" ? scenes::kSolver : name.substr(0, name.find_first_of(":/"));
}

std::vector<Method> reference_methods(const Method& method, const std::vector<std::string>& available,
                                      const std::string& wanted) {
  if (!wanted.empty()) return {{wanted}};
  std::vector<Method> others;
  for (const bool own_plugin : {false, true})
    for (const char* specification : kTrusted) {
      const Method other{specification};
      const bool is_there =
          std::find(available.begin(), available.end(), plugin_of(other)) != available.end();
      const bool is_same_plugin = plugin_of(other) == plugin_of(method);
      if (is_there && is_same_plugin == own_plugin && other.specification != method.specification)
        others.push_back(other);
    }
  return others;
}

std::optional<ReferenceAnswer> ReferenceAnswers::find_for(const Method& method) {
  for (const Method& other : reference_methods(method, registry_.available(), wanted_))
    if (std::optional<ReferenceAnswer> reference = answer_of(other)) {
      reference->independent = plugin_of(other) != plugin_of(method);
      return reference;
    }
  return {};
}

const std::optional<ReferenceAnswer>& ReferenceAnswers::answer_of(const Method& method) {
  const auto known = found_.find(method.specification);
  if (known != found_.end()) return known->second;
  return found_[method.specification] = solve_for_reference(source_, registry_, method, watch_);
}

}  // namespace netloft::studies
