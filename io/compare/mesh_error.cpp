// SPDX-License-Identifier: BSD-3-Clause
#include "io/compare/mesh_error.hpp"

#include "io/compare/richardson.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace netloft::io {

namespace {

/// Cells and the numbers found with them.
struct Level {
  std::int64_t cells;
  std::vector<NamedScalar> scalars, gear;
};

/// Nothing, and why, unless the level was solved.
std::optional<Level> solve_level(CaseSource mesh, Registry& registry, const MeshLevel& level,
                                 const Watch& watch, std::string& why_not) {
  mesh.overrides.insert(mesh.overrides.end(), level.overrides.begin(), level.overrides.end());
  Case one(mesh, registry);
  if (one.open() != Case::State::ready) {
    const auto errors = one.diagnostics().sorted();
    why_not = fmt::format("is not known: with {} cells the scene has an error: {}", level.cells,
                          errors.empty() ? "" : errors.front().message);
    return {};
  }
  RunResult result;
  result.solution = one.solve(watch);
  if (result.solution.status != SolveStatus::converged) {
    why_not =
        fmt::format("is not known: with {} cells it was {}", level.cells, name_of(result.solution.status));
    return {};
  }
  collect(one.loaded(), one.assembler(), result);
  return Level{level.cells, result.scalars, result.gear};
}

using Numbers = std::vector<NamedScalar> Level::*;

/// What a number is on every level; unknown where it is not there.
std::vector<double> values_of(const std::string& name, const std::vector<Level>& levels, Numbers numbers) {
  std::vector<double> values;
  for (const auto& level : levels) {
    const NamedScalar* found = find_scalar(level.*numbers, name);
    values.push_back(found ? found->value : NamedScalar::kUnknown);
  }
  return values;
}

void judge(const std::vector<Level>& levels, std::size_t own, Numbers numbers,
           std::vector<NamedScalar>& judged) {
  std::vector<double> h;
  for (const auto& level : levels) h.push_back(1.0 / static_cast<double>(level.cells));
  for (auto& scalar : judged) {
    const Trend trend = find_trend(values_of(scalar.name, levels, numbers), h, own);
    scalar.mesh_error = trend.error;
    if (trend.steady) scalar.mesh_order = trend.order;
  }
}

std::string note_on(const std::vector<Level>& levels, const std::string& part) {
  std::vector<std::int64_t> cells;
  for (const auto& level : levels) cells.push_back(level.cells);
  return fmt::format("from {} cells of {}, {}", fmt::join(cells, ", "), part,
                     levels.size() > 2 ? "extrapolated where an order is given, else the largest difference"
                                       : "first order assumed");
}

}  // namespace

void find_mesh_errors(const CaseSource& source, Registry& registry, const Case& own,
                      const std::vector<MeshLevel>& levels, const Watch& watch, RunResult& result) {
  const PartGeometry& leading = leading_part(own.loaded());
  if (result.solution.status != SolveStatus::converged) {
    result.mesh_note = "is not known: the scene itself did not converge";
    return;
  }
  std::vector<Level> all{{leading.cells[0], result.scalars, result.gear}};
  for (const auto& level : levels) {
    auto solved = solve_level(source, registry, level, watch, result.mesh_note);
    if (!solved) return;
    all.push_back(std::move(*solved));
  }
  std::sort(all.begin(), all.end(), [](const Level& a, const Level& b) { return a.cells < b.cells; });
  const auto at =
      std::find_if(all.begin(), all.end(), [&](const Level& l) { return l.cells == leading.cells[0]; });
  const auto own_level = static_cast<std::size_t>(at - all.begin());
  judge(all, own_level, &Level::scalars, result.scalars);
  judge(all, own_level, &Level::gear, result.gear);
  result.mesh_note = note_on(all, leading.name);
}

}  // namespace netloft::io
