// SPDX-License-Identifier: BSD-3-Clause
#include "io/compare/mesh_error.hpp"

#include "io/compare/richardson.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace netloft::io {

namespace {

/// Cells and the scalars found with them.
struct Level {
  std::int64_t cells;
  std::vector<NamedScalar> scalars;
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
  return Level{level.cells, result.scalars};
}

void judge_scalars(const std::vector<Level>& levels, std::size_t own, RunResult& result) {
  std::vector<double> h;
  for (const auto& level : levels) h.push_back(1.0 / static_cast<double>(level.cells));
  for (std::size_t i = 0; i < result.scalars.size(); ++i) {
    std::vector<double> values;
    for (const auto& level : levels) values.push_back(level.scalars[i].value);
    const Trend trend = find_trend(values, h, own);
    result.scalars[i].mesh_error = trend.error;
    if (trend.steady) result.scalars[i].mesh_order = trend.order;
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
  std::vector<Level> all{{leading.cells[0], result.scalars}};
  for (const auto& level : levels) {
    auto solved = solve_level(source, registry, level, watch, result.mesh_note);
    if (!solved) return;
    all.push_back(std::move(*solved));
  }
  std::sort(all.begin(), all.end(), [](const Level& a, const Level& b) { return a.cells < b.cells; });
  const auto at =
      std::find_if(all.begin(), all.end(), [&](const Level& l) { return l.cells == leading.cells[0]; });
  judge_scalars(all, static_cast<std::size_t>(at - all.begin()), result);
  result.mesh_note = note_on(all, leading.name);
}

}  // namespace netloft::io
