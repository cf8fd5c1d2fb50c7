// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/file/write_result.hpp"

#include "io/formats/hdf5/read.hpp"
#include "io/results/file/grid_fields.hpp"
#include "io/results/file/layout.hpp"
#include "io/results/file/no_number.hpp"
#include "io/results/file/provenance.hpp"
#include "io/results/file/records.hpp"
#include "io/results/file/write_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace netloft::results {

namespace {

/// Point and cell fields of a state, and its node positions.
struct StateFields {
  std::vector<formats::FieldSpec> specs = {
      {"displacement", "m", "movement from the start", formats::Location::kPoint, 3, false},
      {"residual", "N", "force out of balance that the solver left", formats::Location::kPoint, 3, false},
      {"reaction", "N", "force of the hold on the node", formats::Location::kPoint, 3, false}};
  std::vector<std::vector<double>> values;
  std::vector<double> points;
};

/// The fields at positions x; `residual` is empty if it is not known.
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

/// Writes the states of the solve: the end of each stage, if these were saved, and the end of the solve.
void write_picture(formats::ResultFile& file, const scenes::LoadedScene& loaded, Assembler& assembler,
                   const SolvedShapes& shapes) {
  const Solution& s = shapes.end;
  const StateFields end = fields_at(loaded, assembler, s.x, s.residual,
                                    ask_elements(loaded.scene, assembler, s.x, at_rest(s), false).outputs);
  auto fixed = label_points(loaded);
  fixed.push_back(label_cells(loaded, assembler));
  fixed.push_back(label_corners(loaded, assembler));
  file.begin(make_mesh(loaded, assembler), end.specs, fixed, shapes.stages.size() + 1);
  for (std::size_t i = 0; i < shapes.stages.size(); ++i) {
    const auto& x = shapes.stages[i].x;
    write_state(file, static_cast<double>(i),
                fields_at(loaded, assembler, x, {}, ask_elements(loaded.scene, assembler, x).outputs));
  }
  write_state(file, static_cast<double>(shapes.stages.size()), end);
}

void write_stages(formats::Tree& tree, const SolvedShapes& shapes) {
  if (shapes.stages.empty()) return;
  std::vector<std::string> names;
  for (const auto& stage : shapes.stages) names.push_back(stage.name);
  names.push_back(std::string(name_of(shapes.end.status)));
  tree.write_strings("/netloft/stages", names,
                     "what each state is: the start, stages of the solve, and its end");
}

/// Writes each number as a dataset of its name, and a list of the names in the order of reports, because HDF5
/// lists names alphabetically.
void write_scalars(formats::Tree& tree, const std::string& group, const std::string& errors,
                   const std::vector<NamedScalar>& scalars) {
  std::vector<std::string> order;
  for (const auto& s : scalars) {
    tree.write_real(kRoot + group + "/" + s.name, s.value, s.unit, s.doc);
    visit_errors(RecordWriter(tree), errors, s);
    order.push_back(s.name);
  }
  if (!order.empty())
    tree.write_strings(kRoot + "order/" + group, order, "names of " + group + "/ in the order of reports");
}

void write_forces(formats::Tree& tree, const Result& result) {
  std::map<std::string, std::vector<double>> terms;
  for (const auto& f : result.part_forces)
    terms[f.term].insert(terms[f.term].end(), f.force.begin(), f.force.end());
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

/// The rank of an outcome: a better outcome has a higher rank. `outcome` is a name that name_of() returns.
int rank_of(const std::string& outcome) {
  if (outcome == "converged" || outcome == "finished") return 2;
  return outcome == "unstable" ? 1 : 0;
}

std::string outcome_in(const std::filesystem::path& result) {
  try {
    return formats::Reader(result).text_attribute("/netloft/status", "outcome");
  } catch (const formats::FileError&) {
    return {};  // not a result of this program: it may be replaced, and is kept as NAME.hdf~
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

Origins make_origins(const scenes::LoadedScene& loaded, const RunContext& context) {
  Origins o{program_version(),
            machine_description(),
            compiler_description(),
            context.started,
            "",
            context.command,
            {},
            {},
            context.plan_text};
  for (const auto& f : loaded.files) o.files.push_back({f.path, f.hash, f.text});
  for (const auto* p : context.plugins)
    o.plugins.push_back({p->name, p->version, p->file, "fnv1a64-words:" + p->fingerprint});
  return o;
}

void write_inputs(formats::Tree& tree, const scenes::LoadedScene& loaded, const Result& result) {
  visit_inputs(RecordWriter(tree), result);
  const auto& files = result.origins.files;
  tree.write_text("/netloft/provenance/scene/path", files.empty() ? "" : files[0].path);
  tree.write_text("/netloft/provenance/scene/text", files.empty() ? "" : files[0].text);
  write_parts(tree, loaded);
}

void write_ending(formats::Tree& tree, const Result& result) {
  RecordWriter file(tree);
  visit_ending(file, result);
  if (result.motion) visit_motion(file, *result.motion);
  write_scalars(tree, "scalars", "", result.scalars);
  write_scalars(tree, "gear", "gear/", result.figures);
  if (!result.mesh_note.empty())
    tree.write_text(kErrors + "mesh_note", result.mesh_note,
                    "the meshes that mesh errors were estimated from");
}

void write_result(formats::ResultFile& file, const scenes::LoadedScene& loaded, Assembler& assembler,
                  const SolvedShapes& shapes, const Result& result) {
  write_picture(file, loaded, assembler, shapes);
  formats::Tree& tree = file.tree();
  write_stages(tree, shapes);
  write_inputs(tree, loaded, result);
  write_ending(tree, result);
  write_forces(tree, result);
  if (const auto memory = assembler.memory(); !memory.empty())
    tree.write_reals("/netloft/memory", memory, "1", "state of the elements, one after another: friction");
}

}  // namespace netloft::results
