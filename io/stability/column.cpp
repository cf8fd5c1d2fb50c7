// SPDX-License-Identifier: BSD-3-Clause
#include "io/stability/column.hpp"

#include "io/analysis/case.hpp"

namespace netloft::io {

namespace {

constexpr const char* kAuto = "auto";

/// The keys of `analysis` for a specification: of a strategy as of a solver.
std::vector<std::string> strategy_overrides(const std::string& specification) {
  auto all = solver_overrides(specification);
  all.front() = "analysis.strategy=\"" + component_of(specification) + "\"";
  return all;
}

void append(std::vector<std::string>& all, const std::vector<std::string>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

std::string StabilityColumn::head() const {
  if (!title.empty()) return title;
  if (strategy.empty() || solver.empty()) return strategy + solver;
  return strategy + " with " + solver;
}

StabilityColumn column_of(const std::string& solver) {
  return component_of(solver) == kAuto ? StabilityColumn{"", solver} : StabilityColumn{solver, ""};
}

void leave_out(const std::vector<std::string>& parts, StabilityColumn& column) {
  if (parts.empty() || component_of(column.strategy) != kAuto) return;
  std::string all;
  for (const auto& part : parts) all += (all.empty() ? "" : "+") + part;
  column.strategy += (column.strategy == kAuto ? ":" : ",") + ("without=" + all);
}

std::string component_of(const std::string& specification) {
  return specification.substr(0, specification.find(':'));
}

std::vector<std::string> overrides_of(const StabilityColumn& column) {
  std::vector<std::string> all;
  if (!column.solver.empty()) append(all, solver_overrides(column.solver));
  // Until analysis.strategy is a key of scenes, auto is the solver of that name.
  if (column.strategy == kAuto) append(all, solver_overrides(kAuto));
  if (!column.strategy.empty() && column.strategy != kAuto) append(all, strategy_overrides(column.strategy));
  append(all, column.overrides);
  return all;
}

}  // namespace netloft::io
