// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/compare/numbers_on_mesh.hpp"
#include "io/formats/work/long_work.hpp"
#include "io/runs/equilibrium.hpp"

#include <fmt/format.h>

#include <cmath>

namespace netloft::studies {

NumbersOnMesh numbers_of(runs::PreparedScene& solved, const Solution& solution,
                         const results::Result& result) {
  const auto outputs = results::ask_elements(solved.loaded().scene, solved.assembler(), solution.x,
                                             results::at_rest(solution), false);
  return {count_mesh(solved.loaded()),
          solved.plan().unknowns,
          result.statistics.total_seconds,
          result.is_answer(),
          result.scalars,
          result.figures,
          results::find_rope_tensions(solved.loaded(), solved.assembler(), outputs)};
}

std::optional<NumbersOnMesh> solve_on(const MeshLevel& level, const runs::CaseSource& source,
                                      Registry& registry, const runs::Watch& watch,
                                      std::string& why_not) try {
  runs::CaseSource divided = source;
  formats::append(divided.changes, level.changes);
  runs::PreparedScene one(divided, registry);
  if (one.prepare() != runs::PreparedScene::State::ready) {
    const auto errors = one.diagnostics().sorted();
    std::vector<std::string> texts;
    for (const formats::Change& change : level.changes) texts.push_back(change.text);
    why_not = fmt::format("with {} the scene has an error: {}", fmt::join(texts, ", "),
                          errors.empty() ? "" : errors.front().message);
    return {};
  }
  const Solution solution = runs::find_equilibrium(one, watch);
  const MeshSize mesh = count_mesh(one.loaded());
  if (!is_stationary(solution)) {
    why_not = fmt::format("with {} {} the result was {}: {}", mesh.count, mesh.of, name_of(solution.status),
                          solution.reason);
    return {};
  }
  return numbers_of(one, solution, results::make_result(one.loaded(), one.assembler(), solution));
} catch (const formats::Interrupted&) {
  why_not = "a mesh was not read: the user interrupted";
  return {};
}

Trend find_trend_of(const std::string& name, NumberGroup numbers, const std::vector<NumbersOnMesh>& meshes,
                    std::size_t asked) {
  std::vector<double> values, widths;
  for (const auto& mesh : meshes) {
    const results::NamedScalar* found = results::find_scalar(mesh.*numbers, name);
    if (!found || !std::isfinite(found->value)) return {};
    values.push_back(found->value);
    widths.push_back(mesh.mesh.width);
  }
  return find_trend(values, widths, asked, meshes[asked].mesh.is_similar);
}

}  // namespace netloft::studies
