// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/figures/make_result.hpp"

#include "framework/assembler/reports.hpp"
#include "io/results/figures/dependence.hpp"
#include "io/results/figures/fallen_boards.hpp"
#include "io/results/figures/gear_figures.hpp"
#include "io/results/figures/law_range.hpp"
#include "io/results/figures/materials.hpp"
#include "io/results/figures/overload.hpp"
#include "io/results/figures/passages.hpp"
#include "io/results/figures/uncounted_pull.hpp"
#include "io/results/figures/whereabouts.hpp"
#include "io/runs/hold_force.hpp"
#include "io/scenes/reading/result_request.hpp"

#include <algorithm>
#include <iterator>

namespace netloft::results {

namespace {

std::vector<HoldForce> find_hold_forces(const scenes::LoadedScene& loaded, const Assembler& assembler,
                                        std::span<const double> residual) {
  std::vector<HoldForce> forces;
  for (const auto& hold : loaded.holds)
    forces.push_back({hold.name, runs::force_of(hold, assembler, residual)});
  return forces;
}

void add(const std::array<double, 3>& force, std::array<double, 3>& sum) {
  for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += force[axis];
}

/// The force of every term on every part, zeros included, sorted by term and then in the order of the parts.
/// A companion is a part that adds further elements to another part and has the name of that part; the force
/// on the companion counts as a force on the other part.
std::vector<PartLoad> find_part_loads(const Scene& scene, const std::vector<PartForce>& forces) {
  std::map<std::string, std::map<std::string, std::array<double, 3>>> sums;  // sums by term, then by part
  for (const auto& f : forces) add(f.force, sums[f.term][f.part]);
  std::vector<PartLoad> rows;
  for (auto& [term, of_parts] : sums)
    for (const auto& part : scene.parts)
      if (!part.companion) rows.push_back({part.name, term, of_parts[part.name]});
  return rows;
}

std::vector<std::string> find_warnings(const scenes::LoadedScene& loaded, const Assembler& assembler,
                                       const Response& answer, const std::vector<LawUse>& laws,
                                       std::span<const double> residual, const Result& result) {
  std::vector<std::string> all = load_warnings(result.materials);
  for (const auto& more :
       {overload_warnings(loaded, assembler, answer), law_range_warnings(loaded.scene, laws),
        doubt_warnings(loaded, assembler, answer), whereabouts_warnings(loaded, assembler, answer),
        passage_warnings(loaded, assembler, answer),
        uncounted_pull_warnings(loaded, assembler, residual, result.figures)})
    all.insert(all.end(), more.begin(), more.end());
  for (auto& board : find_fallen_boards(loaded, result.figures)) all.push_back(std::move(board.sentence));
  return all;
}

std::optional<FoundShapes> found_shapes(const Shapes& shapes) {
  if (shapes.restarts == 0) return {};
  FoundShapes found{shapes.restarts, shapes.times, shapes.by_energy, {}};
  for (const OtherShape& other : shapes.others)
    found.others.push_back({other.energy, other.distance, other.furthest, other.times});
  return found;
}

void add_solve(const Solution& s, Result& result) {
  result.factorisation = s.run.factorisation;
  result.work = s.cost.work;
  result.statistics = s.cost.statistics;
  for (const StageRecord& stage : s.cost.stages)
    result.stages.push_back({stage.name, stage.solver, name_of(stage.status), stage.reason, stage.variant,
                             static_cast<std::int64_t>(stage.unknowns), stage.statistics, stage.work});
  for (const IterationRecord& r : s.run.history)
    result.iterations.push_back(
        {r.iteration, r.factorisations, r.residual, r.scale, r.energy, r.seconds, r.note});
}

void add_verdict(const Solution& s, Result& result) {
  result.outcome = name_of(s.status);
  result.sentence = s.reason;
  result.stability = name_of(s.stability);
  result.at_fault = s.status == SolveStatus::converged ? "" : s.at_fault;
  result.diagnostics = s.diagnostics;
  result.energy = s.energy;
  result.residual = s.balance.residual;
  result.largest_load = s.balance.scale;
  result.node_error = s.correction.length;
}

}  // namespace

const NamedScalar* find_scalar(const std::vector<NamedScalar>& scalars, const std::string& name) {
  const auto at =
      std::find_if(scalars.begin(), scalars.end(), [&](const NamedScalar& s) { return s.name == name; });
  return at == scalars.end() ? nullptr : &*at;
}

Kinematics at_rest(const Solution& s) { return {.x_low = s.x_low.empty() ? nullptr : s.x_low.data()}; }

std::vector<NamedScalar> find_figures(const scenes::LoadedScene& loaded, const Assembler& assembler,
                                      const Response& answer) {
  std::vector<NamedScalar> figures;
  for (auto& figure : find_gear_figures(loaded, assembler, answer))
    figures.push_back({figure.name, figure.unit, figure.doc, figure.value});
  return figures;
}

std::vector<NamedScalar> find_scalars(const scenes::LoadedScene& loaded, const Assembler& assembler,
                                      const Solution& solution, const FamilyOutputs& outputs) {
  std::vector<NamedScalar> scalars;
  for (const auto& request : loaded.results)
    scalars.push_back({request.name, request.unit, request.take + " of " + request.of,
                       scenes::value_of(request, loaded, assembler, solution, outputs)});
  return scalars;
}

std::optional<Numbers> numbers_at(const scenes::LoadedScene& loaded, Assembler& assembler, Solution there) {
  there.residual.assign(there.x.size(), 0.0);
  const Kinematics motion = at_rest(there);
  if (there.x.empty() || !assembler.evaluate(there.x, {.residual = there.residual.data(), .motion = motion}))
    return {};
  const Response answer = ask_elements(loaded.scene, assembler, there.x, motion);
  return Numbers{find_scalars(loaded, assembler, there, answer.outputs),
                 find_figures(loaded, assembler, answer),
                 reactions_of(find_hold_forces(loaded, assembler, there.residual))};
}

std::vector<NamedScalar> reactions_of(const std::vector<HoldForce>& holds) {
  std::vector<NamedScalar> reactions;
  for (const HoldForce& hold : holds)
    for (std::size_t axis = 0; axis < 3; ++axis)
      reactions.push_back(
          {"held/" + hold.name + "/" + "xyz"[axis], "N", "force of a hold on the gear", hold.force[axis]});
  return reactions;
}

Result describe_scene(const scenes::LoadedScene& loaded, const Assembler& assembler) {
  Result result;
  result.title = loaded.scene.name;
  result.solver = loaded.analysis.solver;
  result.strategy = loaded.analysis.strategy;
  result.nodes = loaded.scene.node_count();
  result.unknowns = assembler.numbering().unknowns();
  if (loaded.gear) result.gear = GearNames{loaded.gear->times, loaded.gear->headline, loaded.gear->footrope};
  result.materials = find_bill(loaded);
  if (loaded.gear) result.netting = loaded.gear->netting;
  return result;
}

Result make_result(const scenes::LoadedScene& loaded, Assembler& assembler, const Solution& solution) {
  Result result = describe_scene(loaded, assembler);
  add_verdict(solution, result);
  add_solve(solution, result);
  result.shapes = found_shapes(solution.shapes);
  const Response answer = ask_elements(loaded.scene, assembler, solution.x, at_rest(solution));
  result.scalars = find_scalars(loaded, assembler, solution, answer.outputs);
  result.figures = find_figures(loaded, assembler, answer);
  const auto laws = assembler.reports().find_law_use(solution.x, at_rest(solution));
  result.part_forces = find_part_loads(loaded.scene, answer.forces);
  result.hold_forces = find_hold_forces(loaded, assembler, solution.residual);
  for (const auto& f : answer.forces) add(f.force, result.balance);
  for (const auto& h : result.hold_forces) add(h.force, result.balance);
  add_dependence(loaded, assembler, solution, result);
  add_loads(result.figures, result.materials);
  result.warnings = find_warnings(loaded, assembler, answer, laws, solution.residual, result);
  if (result.outcome == "unstable" && result.swing && result.swing->frequency > 0)
    result.diagnostics.push_back(
        "analysis.swinging = \"accepted\" accepts this equilibrium as the mean of the oscillation, which is "
        "reasonable if the figures change little per metre of motion of " +
        result.swing->furthest);
  return result;
}

}  // namespace netloft::results
