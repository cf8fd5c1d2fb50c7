// SPDX-License-Identifier: BSD-3-Clause
#include "io/report/write_result.hpp"

#include "io/report/provenance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace netloft::io {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// What makes a cell of the picture: elements on nodes of their own, and whatever sits on single nodes.
/// Pairs, and what rides on elements that are drawn already, would hide those.
bool is_drawn(const LoadedScene& loaded, const ElementFamily& family) {
  if (family.type().element.stencil == NETLOFT_NODE) return true;
  return family.type().element.stencil <= 0xff && !loaded.parts[family.parts()[0]].nodes.empty();
}

Mesh make_mesh(const LoadedScene& loaded, const Assembler& assembler) {
  Mesh mesh;
  mesh.n_points = loaded.scene.node_count();
  for (const auto& family : assembler.families()) {
    if (!is_drawn(loaded, *family)) continue;
    const int corners = family->nodes_per_element();
    const auto cell = corners == 1 ? kVertex : corners == 2 ? kLine : kTriangle;
    for (std::size_t e = 0; e < family->size(); ++e) {
      for (int c = 0; c < corners; ++c) mesh.connectivity.push_back(family->node(e, c));
      mesh.offsets.push_back(static_cast<std::int64_t>(mesh.connectivity.size()));
      mesh.types.push_back(cell);
    }
  }
  return mesh;
}

std::vector<StaticField> label_points(const LoadedScene& loaded) {
  const std::size_t n = loaded.scene.node_count();
  std::vector<double> part(n), node(n), panel(2 * n, kNone);
  for (std::size_t i = 0; i < n; ++i) {
    const NodeLabel label = loaded.scene.labels[i];
    part[i] = label.part, node[i] = label.id;
    const auto& coordinates = loaded.parts[label.part].panel;
    if (!coordinates.empty())
      panel[2 * i] = coordinates[label.id][0], panel[2 * i + 1] = coordinates[label.id][1];
  }
  return {
      {{"part", "1", "part the node was made for, index into /netloft/parts/name", Location::kPoint, 1, true},
       part},
      {{"node", "1", "number of the node within its part", Location::kPoint, 1, true}, node},
      {{"panel_uv", "1", "panel coordinates U, V in meshes", Location::kPoint, 2, false}, panel}};
}

StaticField label_cells(const LoadedScene& loaded, const Assembler& assembler) {
  std::vector<double> part;
  for (const auto& family : assembler.families())
    for (std::size_t e = 0; e < family->size() && is_drawn(loaded, *family); ++e)
      part.push_back(family->part(e));
  return {{"part", "1", "part of the element, index into /netloft/parts/name", Location::kCell, 1, true},
          part};
}

/// Outputs of all families under one name each; elements without it have none.
struct CellField {
  FieldSpec spec;
  std::vector<double> values;
};

std::vector<CellField> gather_outputs(const LoadedScene& loaded, const Assembler& assembler,
                                      const RunResult& result) {
  std::size_t cells = 0, first = 0;
  for (const auto& family : assembler.families())
    if (is_drawn(loaded, *family)) cells += family->size();
  std::vector<CellField> fields;
  for (std::size_t f = 0; f < assembler.families().size(); ++f) {
    if (!is_drawn(loaded, *assembler.families()[f])) continue;
    const auto& outputs = assembler.families()[f]->type().outputs;
    for (std::size_t k = 0; k < outputs.size(); ++k) {
      auto at = std::find_if(fields.begin(), fields.end(),
                             [&](const CellField& c) { return c.spec.name == outputs[k].name; });
      if (at == fields.end())
        at = fields.insert(at, {{outputs[k].name, outputs[k].unit, outputs[k].doc, Location::kCell, 1, false},
                                std::vector<double>(cells, kNone)});
      std::copy(result.outputs[f][k].begin(), result.outputs[f][k].end(),
                at->values.begin() + static_cast<std::ptrdiff_t>(first));
    }
    first += assembler.families()[f]->size();
  }
  return fields;
}

/// A vector over all dofs, node by node; without what elements share, which is in no place.
std::vector<double> by_node(const LoadedScene& loaded, const Assembler& assembler,
                            const std::vector<double>& v) {
  std::vector<double> nodes(3 * loaded.scene.node_count());
  for (std::size_t d = 0; d < nodes.size(); ++d)
    nodes[d] = v[static_cast<std::size_t>(
        assembler.numbering().index(static_cast<std::uint32_t>(d / 3), static_cast<int>(d % 3)))];
  return nodes;
}

void write_picture(ResultFile& file, const LoadedScene& loaded, const Assembler& assembler,
                   const RunResult& result) {
  const auto points = by_node(loaded, assembler, result.solution.x);
  std::vector<double> displacement(points.size()), residual, reaction;
  for (std::size_t d = 0; d < points.size(); ++d) displacement[d] = points[d] - loaded.scene.positions[d];
  for (std::uint32_t node = 0; node < loaded.scene.node_count(); ++node) {
    const auto left = assembler.unbalanced(node, result.solution.residual);
    const auto held = assembler.reaction(node, result.solution.residual);
    residual.insert(residual.end(), left.begin(), left.end());
    reaction.insert(reaction.end(), held.begin(), held.end());
  }
  const auto cells = gather_outputs(loaded, assembler, result);
  std::vector<FieldSpec> changing = {
      {"displacement", "m", "movement from the start", Location::kPoint, 3, false},
      {"residual", "N", "force out of balance: what the solver left", Location::kPoint, 3, false},
      {"reaction", "N", "force of what holds the node", Location::kPoint, 3, false}};
  std::vector<std::span<const double>> values = {displacement, residual, reaction};
  for (const auto& cell : cells) changing.push_back(cell.spec), values.push_back(cell.values);
  auto fixed = label_points(loaded);
  fixed.push_back(label_cells(loaded, assembler));
  file.begin(make_mesh(loaded, assembler), changing, fixed);
  file.write_state(0, points, values);
}

void write_provenance(Tree& tree, const LoadedScene& loaded, const RunContext& context) {
  const std::string at = "/netloft/provenance/";
  tree.write_text(at + "version", program_version());
  tree.write_strings(at + "command", context.command);
  tree.write_text(at + "machine", machine_description());
  tree.write_text(at + "compiler", compiler_description());
  tree.write_text(at + "started", context.started);
  tree.write_text(at + "finished", utc_now());
  tree.write_text(at + "scene/path", loaded.files.empty() ? "" : loaded.files[0].path);
  tree.write_text(at + "scene/text", loaded.files.empty() ? "" : loaded.files[0].text);
  std::vector<std::string> path, hash, text;
  for (const auto& f : loaded.files) path.push_back(f.path), hash.push_back(f.hash), text.push_back(f.text);
  tree.write_strings(at + "files/path", path);
  tree.write_strings(at + "files/hash", hash);
  tree.write_strings(at + "files/text", text);
  std::vector<std::string> name, version, file, fingerprint;
  for (const auto* p : context.plugins)
    name.push_back(p->name), version.push_back(p->version), file.push_back(p->file),
        fingerprint.push_back("fnv1a64:" + p->fingerprint);
  tree.write_strings(at + "plugins/name", name);
  tree.write_strings(at + "plugins/version", version);
  tree.write_strings(at + "plugins/path", file);
  tree.write_strings(at + "plugins/hash", fingerprint);
}

void write_status(Tree& tree, const LoadedScene& loaded, const Solution& s) {
  tree.set_attribute("/netloft/status", "outcome", std::string_view(name_of(s.status)));
  tree.set_attribute("/netloft/status", "sentence", std::string_view(s.reason));
  tree.set_attribute("/netloft/status", "stability", std::string_view(name_of(s.stability)));
  tree.set_attribute("/netloft/status", "at_fault",
                     std::string_view(s.status == SolveStatus::converged ? "" : s.at_fault));
  std::vector<std::string> names, types;
  for (const auto& p : loaded.scene.parts)
    if (!p.companion) names.push_back(p.name), types.push_back(p.type);
  tree.write_strings("/netloft/parts/name", names);
  tree.write_strings("/netloft/parts/type", types);
}

void write_convergence(Tree& tree, const Solution& s) {
  std::vector<std::int64_t> iteration, factorisations;
  std::vector<double> residual, scale, energy, seconds;
  std::vector<std::string> note;
  for (const auto& r : s.history) {
    iteration.push_back(r.iteration), factorisations.push_back(r.factorisations);
    residual.push_back(r.residual), scale.push_back(r.scale), energy.push_back(r.energy),
        seconds.push_back(r.seconds);
    note.push_back(r.note);
  }
  const std::string at = "/netloft/convergence/";
  tree.write_ints(at + "iteration", iteration, "1", "accepted steps before this point");
  tree.write_ints(at + "factorisations", factorisations, "1", "factorisations before this point");
  tree.write_reals(at + "residual", residual, "N", "largest nodal residual");
  tree.write_reals(at + "load", scale, "N", "largest nodal load: what the tolerance is a part of");
  tree.write_reals(at + "energy", energy, "J", "energy, if all forces have one");
  tree.write_reals(at + "seconds", seconds, "s", "wall time since the solver began");
  tree.write_strings(at + "note", note, "what the solver said of the step that led here");
}

void write_books(Tree& tree, const Books& b) {
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
  tree.write_real(at + "cpu", b.total_cpu_seconds, "s", "processor time of the same");
}

/// What is not known is not written.
void write_errors(Tree& tree, const RunResult& result) {
  const std::string at = "/netloft/errors/";
  const auto write = [&](const std::string& name, double error, const std::string& unit, const char* doc) {
    if (std::isfinite(error)) tree.write_real(at + name, error, unit, doc);
  };
  write("nodes", result.solution.correction, "m", "largest nodal move of the step that is left: an estimate");
  for (const auto& s : result.scalars) {
    write("solver/" + s.name, s.solver_error, s.unit, "change of the scalar by the step that is left");
    write("mesh/" + s.name, s.mesh_error, s.unit, "its distance from what finer meshes tend to, an estimate");
    write("mesh_order/" + s.name, s.mesh_order, "1", "order of convergence that was observed");
  }
  if (!result.mesh_note.empty())
    tree.write_text(at + "mesh_note", result.mesh_note, "what mesh errors were found from");
}

void write_forces(Tree& tree, const LoadedScene& loaded, const RunResult& result) {
  std::size_t parts = 0;  // companions come last and count with the part they ride on
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
                      "sum of this force over each part, as the gear feels it");
  std::vector<double> held;
  std::vector<std::string> names;
  for (const auto& h : result.hold_forces)
    names.push_back(h.name), held.insert(held.end(), h.force.begin(), h.force.end());
  tree.write_matrix("/netloft/forces/held", held, 3, "N", "force of each hold on the gear");
  tree.write_strings("/netloft/forces/held_name", names);
  tree.write_reals("/netloft/forces/balance", result.balance, "N",
                   "sum of all forces on the gear, what holds it included");
}

}  // namespace

void write_result(ResultFile& file, const LoadedScene& loaded, const Assembler& assembler,
                  const RunResult& result, const RunContext& context) {
  write_picture(file, loaded, assembler, result);
  Tree& tree = file.tree();
  write_provenance(tree, loaded, context);
  write_status(tree, loaded, result.solution);
  tree.write_text("/netloft/plan", context.plan_text, "what the scene needs, and why not the rest");
  write_convergence(tree, result.solution);
  write_books(tree, result.solution.books);
  write_forces(tree, loaded, result);
  tree.write_real("/netloft/energy", result.solution.energy, "J",
                  "energy at the end, if all forces have one");
  write_errors(tree, result);
  for (const auto& s : result.scalars) tree.write_real("/netloft/scalars/" + s.name, s.value, s.unit, s.doc);
  file.finish();
}

}  // namespace netloft::io
