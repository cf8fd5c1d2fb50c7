// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/file/write_result.hpp"
#include "io/results/file/groups.hpp"
#include "io/results/file/no_number.hpp"

#include "io/formats/hdf5/read.hpp"
#include "io/results/file/grid_fields.hpp"
#include "io/results/file/provenance.hpp"
#include "io/results/file/write_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace netloft::results {

namespace {

/// What changes from state to state, in one order of fields.
struct StateFields {
  std::vector<formats::FieldSpec> specs = {
      {"displacement", "m", "movement from the start", formats::Location::kPoint, 3, false},
      {"residual", "N", "force out of balance that the solver left", formats::Location::kPoint, 3, false},
      {"reaction", "N", "force of the hold on the node", formats::Location::kPoint, 3, false}};
  std::vector<std::vector<double>> values;
  std::vector<double> points;
};

/// `residual` is empty where it is not known.
StateFields fields_at(const scenes::LoadedScene& loaded, const Assembler& assembler,
                      std::span<const double> x, std::span<const double> residual,
                      const FamilyOutputs& outputs) {
  StateFields state;
  state.points = assembler.node_positions(x);
  std::vector<double> displacement(state.points.size()), left(state.points.size(), kNone), held = left;
  for (std::size_t d = 0; d < displacement.size(); ++d)
    displacement[d] = state.points[d] - loaded.scene.positions[d];
  for (std::uint32_t node = 0; node < loaded.scene.node_count() && !residual.empty(); ++node) {
    const auto unbalanced = assembler.unbalanced(node, residual),
               reaction = assembler.reaction(node, residual);
    std::copy(unbalanced.begin(), unbalanced.end(), left.begin() + 3 * std::ptrdiff_t{node});
    std::copy(reaction.begin(), reaction.end(), held.begin() + 3 * std::ptrdiff_t{node});
  }
  state.values = {std::move(displacement), std::move(left), std::move(held)};
  if (auto rotations = rotation_field(loaded, assembler, x)) {
    state.specs.push_back(rotations->first);
    state.values.push_back(std::move(rotations->second));
  }
  for (auto& cell : OutputFields(loaded, assembler).gather(outputs)) {
    state.specs.push_back(cell.spec);
    state.values.push_back(std::move(cell.values));
  }
  return state;
}

void write_state(formats::ResultFile& file, double number, const StateFields& state) {
  const std::vector<std::span<const double>> values(state.values.begin(), state.values.end());
  file.write_state(number, state.points, values);
}

/// The stages of the solve, if they were kept, and where it ended.
void write_picture(formats::ResultFile& file, const scenes::LoadedScene& loaded, Assembler& assembler,
                   const RunResult& result) {
  const StateFields end =
      fields_at(loaded, assembler, result.solution.x, result.solution.residual, result.outputs);
  auto fixed = label_points(loaded);
  fixed.push_back(label_cells(loaded, assembler));
  fixed.push_back(label_corners(loaded, assembler));
  file.begin(make_mesh(loaded, assembler), end.specs, fixed, result.stages.size() + 1);
  for (std::size_t i = 0; i < result.stages.size(); ++i) {
    const auto& x = result.stages[i].x;
    write_state(file, static_cast<double>(i),
                fields_at(loaded, assembler, x, {}, ask_elements(loaded.scene, assembler, x).outputs));
  }
  write_state(file, static_cast<double>(result.stages.size()), end);
}

void write_stages(formats::Tree& tree, const RunResult& result) {
  if (result.stages.empty()) return;
  std::vector<std::string> names;
  for (const auto& stage : result.stages) names.push_back(stage.name);
  names.push_back(std::string(name_of(result.solution.status)));
  tree.write_strings("/netloft/stages", names,
                     "what each state is: the start, stages of the solve, and its end");
}

void write_provenance(formats::Tree& tree, const scenes::LoadedScene& loaded, const RunContext& context) {
  const std::string at = "/netloft/provenance/";
  tree.write_text(at + "version", program_version());
  tree.write_strings(at + "command", context.command);
  tree.write_text(at + "machine", machine_description());
  tree.write_text(at + "compiler", compiler_description());
  tree.write_text(at + "started", context.started);
  tree.write_text(at + "scene/path", loaded.files.empty() ? "" : loaded.files[0].path);
  tree.write_text(at + "scene/text", loaded.files.empty() ? "" : loaded.files[0].text);
  std::vector<std::string> path, hash, text;
  for (const auto& f : loaded.files) {
    path.push_back(f.path);
    hash.push_back(f.hash);
    text.push_back(f.text);
  }
  tree.write_strings(at + "files/path", path);
  tree.write_strings(at + "files/hash", hash);
  tree.write_strings(at + "files/text", text);
  std::vector<std::string> name, version, file, fingerprint;
  for (const auto* p : context.plugins) {
    name.push_back(p->name);
    version.push_back(p->version);
    file.push_back(p->file);
    fingerprint.push_back("fnv1a64-words:" + p->fingerprint);
  }
  tree.write_strings(at + "plugins/name", name);
  tree.write_strings(at + "plugins/version", version);
  tree.write_strings(at + "plugins/path", file);
  tree.write_strings(at + "plugins/hash", fingerprint);
}

void write_status(formats::Tree& tree, const Solution& s) {
  tree.set_attribute("/netloft/status", "outcome", std::string_view(name_of(s.status)));
  tree.set_attribute("/netloft/status", "sentence", std::string_view(s.reason));
  tree.set_attribute("/netloft/status", "stability", std::string_view(name_of(s.stability)));
  tree.set_attribute("/netloft/status", "at_fault",
                     std::string_view(s.status == SolveStatus::converged ? "" : s.at_fault));
}

void write_convergence(formats::Tree& tree, const Solution& s) {
  std::vector<std::int64_t> iteration, factorisations;
  std::vector<double> residual, scale, energy, seconds;
  std::vector<std::string> note;
  for (const auto& r : s.run.history) {
    iteration.push_back(r.iteration);
    factorisations.push_back(r.factorisations);
    residual.push_back(r.residual);
    scale.push_back(r.scale);
    energy.push_back(r.energy);
    seconds.push_back(r.seconds);
    note.push_back(r.note);
  }
  const std::string at = "/netloft/convergence/";
  tree.write_ints(at + "iteration", iteration, "1", "accepted steps before this point");
  tree.write_ints(at + "factorisations", factorisations, "1", "factorisations before this point");
  tree.write_reals(at + "residual", residual, "N", "largest nodal residual");
  tree.write_reals(at + "load", scale, "N", "largest nodal load, to which the tolerance is relative");
  tree.write_reals(at + "energy", energy, "J", "energy, if all forces have one");
  tree.write_reals(at + "seconds", seconds, "s", "wall time since the solver began");
  tree.write_strings(at + "note", note, "the solver's remark on the step to this point");
}

void write_books(formats::Tree& tree, const Statistics& b) {
  const std::string at = "/netloft/cost/";
  tree.write_int(at + "iterations", b.iterations, "1", "accepted steps");
  tree.write_int(at + "factorisations", b.factorisations, "1", "factorisations, refused ones included");
  tree.write_int(at + "residuals", b.residuals, "1", "evaluations of the residual");
  tree.write_int(at + "matrices", b.matrices, "1", "evaluations of a matrix");
  tree.write_int(at + "solves", b.solves, "1", "solutions with a factor");
  tree.write_real(at + "assembly", b.assembly_seconds, "s", "wall time of evaluations");
  tree.write_real(at + "analysis", b.analysis_seconds, "s", "wall time of orderings");
  tree.write_real(at + "factorisation", b.factorisation_seconds, "s", "wall time of factorisations");
  tree.write_real(at + "solve", b.solve_seconds, "s", "wall time of solutions with a factor");
  tree.write_real(at + "total", b.total_seconds, "s", "wall time of the solver, checks included");
  tree.write_real(at + "cpu", b.total_cpu_seconds, "s", "processor time of the solver, checks included");
}

/// Writes a value unless it is unknown.
void write_known(formats::Tree& tree, const std::string& at, double error, const std::string& unit,
                 const char* doc) {
  if (std::isfinite(error)) tree.write_real(at, error, unit, doc);
}

void write_errors_of(formats::Tree& tree, const std::string& at, const std::vector<NamedScalar>& scalars) {
  for (const auto& s : scalars) {
    write_known(tree, at + "solver/" + s.name, s.solver_error, s.unit, "its change by the next Newton step");
    write_known(tree, at + "mesh/" + s.name, s.mesh_error, s.unit,
                "estimated distance from its limit on finer meshes");
    write_known(tree, at + "mesh_order/" + s.name, s.mesh_order, "1", "observed order of convergence");
  }
}

void write_errors(formats::Tree& tree, const RunResult& result) {
  write_known(tree, kErrors + "nodes", result.solution.correction.length, "m",
              "estimated error: largest nodal move of the next Newton step");
  write_errors_of(tree, kErrors, result.scalars);
  write_errors_of(tree, kErrors + "gear/", result.gear);
  if (!result.mesh_note.empty())
    tree.write_text(kErrors + "mesh_note", result.mesh_note,
                    "the meshes that mesh errors were estimated from");
}

void write_forces(formats::Tree& tree, const scenes::LoadedScene& loaded, const RunResult& result) {
  std::size_t parts = 0;  // companions come last and count with the part that they ride on
  while (parts < loaded.scene.parts.size() && !loaded.scene.parts[parts].companion) ++parts;
  std::map<std::string, std::vector<double>> terms;
  for (const auto& f : result.part_forces) {
    auto& rows = terms.try_emplace(f.term, 3 * parts, 0.0).first->second;
    for (std::size_t p = 0; p < parts; ++p)
      if (loaded.scene.parts[p].name == f.part)
        for (std::size_t axis = 0; axis < 3; ++axis) rows[3 * p + axis] += f.force[axis];
  }
  for (const auto& [term, rows] : terms)
    tree.write_matrix("/netloft/forces/" + term, rows, 3, "N",
                      "sum of this force over each part, in the direction in which it acts on the gear");
  std::vector<double> held;
  std::vector<std::string> names;
  for (const auto& h : result.hold_forces) {
    names.push_back(h.name);
    held.insert(held.end(), h.force.begin(), h.force.end());
  }
  tree.write_matrix("/netloft/forces/held", held, 3, "N", "force of each hold on the gear");
  tree.write_strings("/netloft/forces/held_name", names);
  tree.write_reals("/netloft/forces/balance", result.balance, "N",
                   "sum of all forces on the gear, those of the holds included");
}

void write_spread_of(formats::Tree& tree, const std::string& at, const std::vector<NamedScalar>& scalars) {
  for (const auto& s : scalars) {
    write_known(tree, at + "least/" + s.name, s.least, s.unit, "over all equilibria that were found");
    write_known(tree, at + "largest/" + s.name, s.largest, s.unit, "over all equilibria that were found");
  }
}

void write_swing(formats::Tree& tree, const RunResult& result) {
  if (result.swings_most.empty()) return;
  const char* doc = "its change for each metre that the furthest node of what grows moves";
  tree.write_text(kSwing + "furthest", result.swings_most, "the node that moves furthest");
  for (const auto& s : result.scalars)
    write_known(tree, kSwing + "per_metre/" + s.name, s.per_swing, s.unit, doc);
  for (const auto& s : result.gear)
    write_known(tree, kSwing + "gear/per_metre/" + s.name, s.per_swing, s.unit, doc);
}

/// How good an outcome is; the names are those of name_of().
int rank_of(const std::string& outcome) {
  if (outcome == "converged" || outcome == "finished") return 2;
  return outcome == "unstable" ? 1 : 0;
}

std::string outcome_in(const std::filesystem::path& result) {
  try {
    return formats::Reader(result).text_attribute("/netloft/status", "outcome");
  } catch (const formats::FileError&) {
    return {};  // no result of ours, which is kept as NAME.hdf~ like any
  }
}

}  // namespace

std::filesystem::path name_beside_better(const std::filesystem::path& wanted, const std::string& outcome) {
  if (!std::filesystem::exists(wanted) || rank_of(outcome_in(wanted)) <= rank_of(outcome)) return wanted;
  std::string suffix = outcome;
  std::replace(suffix.begin(), suffix.end(), ' ', '-');
  std::filesystem::path own = wanted;
  return own.replace_filename(wanted.stem().string() + "." + suffix + wanted.extension().string());
}

void write_inputs(formats::Tree& tree, const scenes::LoadedScene& loaded, const RunContext& context) {
  write_provenance(tree, loaded, context);
  write_parts(tree, loaded);
  tree.write_text("/netloft/plan", context.plan_text,
                  "forces that are evaluated, and why the others are off");
}

void write_origins(formats::Tree& tree, const scenes::LoadedScene& loaded, const RunContext& context,
                   const Statistics& statistics) {
  write_inputs(tree, loaded, context);
  tree.write_text("/netloft/provenance/finished", utc_now());
  write_books(tree, statistics);
}

namespace {

/// Numbers by name, which HDF5 lists by their letters, and the order in which reports have them.
void write_scalars(formats::Tree& tree, const std::string& group, const std::vector<NamedScalar>& scalars) {
  if (scalars.empty()) return;
  std::vector<std::string> order;
  for (const auto& s : scalars) {
    tree.write_real(kRoot + group + "/" + s.name, s.value, s.unit, s.doc);
    order.push_back(s.name);
  }
  tree.write_strings(kRoot + "order/" + group, order, "names of " + group + "/ in the order of reports");
}

}  // namespace

void write_gear(formats::Tree& tree, const scenes::LoadedScene& loaded,
                const std::vector<NamedScalar>& figures) {
  write_scalars(tree, "gear", figures);
  if (!loaded.gear) return;
  tree.set_attribute("/netloft/gear", "times", loaded.gear->times);
  tree.set_attribute("/netloft/gear", "headline", std::string_view(loaded.gear->headline));
  tree.set_attribute("/netloft/gear", "footrope", std::string_view(loaded.gear->footrope));
  write_bill(tree, loaded);
}

void write_result(formats::ResultFile& file, const scenes::LoadedScene& loaded, Assembler& assembler,
                  const RunResult& result, const RunContext& context) {
  write_picture(file, loaded, assembler, result);
  formats::Tree& tree = file.tree();
  write_stages(tree, result);
  write_status(tree, result.solution);
  write_origins(tree, loaded, context, result.solution.cost.statistics);
  write_convergence(tree, result.solution);
  write_forces(tree, loaded, result);
  tree.write_real("/netloft/energy", result.solution.energy, "J",
                  "energy at the end, if all forces have one");
  write_errors(tree, result);
  write_spread_of(tree, kSpread, result.scalars);
  write_spread_of(tree, kSpread + "gear/", result.gear);
  write_swing(tree, result);
  write_gear(tree, loaded, result.gear);
  if (const auto memory = assembler.memory(); !memory.empty())
    tree.write_reals("/netloft/memory", memory, "1", "state of the elements, one after another: friction");
  write_scalars(tree, "scalars", result.scalars);
  file.finish_as(result.output_file);
}

}  // namespace netloft::results
