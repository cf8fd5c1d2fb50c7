// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/result.hpp"

namespace netloft::results {

// Each function visits members of a Result together with their place in the file, below /netloft
// (io/formats/hdf5/LAYOUT.md). The same functions write and read: `file` and `r` are a RecordWriter and a
// constant Result, or a RecordReader and the Result that it fills.

template <class File, class AnyOrigins>
void visit_origins(File&& file, AnyOrigins& o) {
  file.text("provenance/version", o.version);
  file.texts("provenance/command", o.command);
  file.text("provenance/machine", o.machine);
  file.text("provenance/compiler", o.compiler);
  file.text("provenance/started", o.started);
  using SourceText = Origins::File;
  file.column("provenance/files/path", o.files, &SourceText::path, "");
  file.column("provenance/files/hash", o.files, &SourceText::hash, "");
  file.column("provenance/files/text", o.files, &SourceText::text, "");
  using Plugin = Origins::Plugin;
  file.column("provenance/plugins/name", o.plugins, &Plugin::name, "");
  file.column("provenance/plugins/version", o.plugins, &Plugin::version, "");
  file.column("provenance/plugins/path", o.plugins, &Plugin::path, "");
  file.column("provenance/plugins/hash", o.plugins, &Plugin::hash, "");
  file.text("plan", o.plan, "forces that are evaluated, and why others are not");
}

/// Visits the members that are known when a run begins.
template <class File, class AnyResult>
void visit_inputs(File&& file, AnyResult& r) {
  visit_origins(file, r.origins);
  file.text("method/solver", r.solver);
  file.text("method/strategy", r.strategy);
  file.number("cost/unknowns", r.unknowns, "1", "unknowns of the scene");
  file.sometimes("gear@times", r.gear, [&](auto& gear) {
    file.attribute("gear", "times", gear.times);
    file.attribute("gear", "headline", gear.headline);
    file.attribute("gear", "footrope", gear.footrope);
  });
  auto& bill = r.materials;
  const auto item = [](auto member) {
    return [member](auto& row) -> auto& { return row.item.*member; };
  };
  using Item = scenes::BillItem;
  file.names("bill/kind", bill, item(&Item::kind));
  file.names("bill/name", bill, item(&Item::name));
  file.names("bill/part", bill, item(&Item::part_name), "in the catalogue; empty: written in the plan");
  file.column("bill/number", bill, item(&Item::number), "1", "in the whole gear");
  file.column("bill/length", bill, item(&Item::length), "m", "of one rope, unstretched");
  file.column("bill/diameter", bill, item(&Item::diameter), "m", "of a twine, a rope or a piece");
  file.column("bill/breaking_load", bill, item(&Item::breaking_load), "N",
              "breaking load of a rope, or of the twines of a bar");
  file.column("bill/mass", bill, item(&Item::mass), "kg", "mass of one piece or body in air");
  file.column("bill/area", bill, item(&Item::area), "m2", "projected area of one body");
  using Sheet = scenes::NettingSheet;
  file.names("netting/name", r.netting, &Sheet::name);
  file.column("netting/number", r.netting, &Sheet::number, "1", "in the whole gear");
  file.column("netting/mesh", r.netting, &Sheet::mesh, "m", "stretched mesh size");
  file.names("netting/twine", r.netting, &Sheet::twine, "in the catalogue; empty: written in the plan");
  file.column("netting/twines", r.netting, &Sheet::twines, "1", "side by side");
  file.names("netting/laid", r.netting, &Sheet::laid, "diamond, square or t90");
  file.column("netting/fore", r.netting, &Sheet::fore, "1", "meshes of the fore edge");
  file.column("netting/aft", r.netting, &Sheet::aft, "1", "meshes of the aft edge");
  file.column("netting/deep", r.netting, &Sheet::deep, "1", "meshes from fore to aft");
  file.column("netting/pieces", r.netting, &Sheet::pieces, "1", "sewn mesh to mesh in a row");
  file.names("netting/outer", r.netting, &Sheet::outer, "cuttings, each with the meshes that it goes aft");
  file.names("netting/inner", r.netting, &Sheet::inner, "empty for a panel in the middle");
}

template <class File, class AnyStatistics>
void visit_cost(File&& file, AnyStatistics& s) {
  file.number("cost/iterations", s.iterations, "1", "accepted steps");
  file.number("cost/factorisations", s.factorisations, "1", "factorisations, refused ones included");
  file.number("cost/residuals", s.residuals, "1", "evaluations of the residual");
  file.number("cost/matrices", s.matrices, "1", "evaluations of a matrix");
  file.number("cost/solves", s.solves, "1", "solutions with a factor");
  file.number("cost/assembly", s.assembly_seconds, "s", "wall time of evaluations");
  file.number("cost/analysis", s.analysis_seconds, "s", "wall time of orderings");
  file.number("cost/factorisation", s.factorisation_seconds, "s", "wall time of factorisations");
  file.number("cost/solve", s.solve_seconds, "s", "wall time of solutions with a factor");
  file.number("cost/total", s.total_seconds, "s", "wall time of the solver, checks included");
  file.number("cost/cpu", s.total_cpu_seconds, "s", "processor time of the solver, checks included");
  file.number("cost/solver_cpu", s.solver_cpu_seconds, "s", "processor time of the solver without checks");
}

template <class File, class AnyResult>
void visit_stages(File&& file, AnyResult& r) {
  const auto variant = [](auto member) {
    return [member](auto& row) -> auto& { return row.variant.*member; };
  };
  const auto cost = [](auto member) {
    return [member](auto& row) -> auto& { return row.statistics.*member; };
  };
  using Variant = netloft_variant;
  file.column("solve/name", r.stages, &Stage::name, "", "stages on the way to the equilibrium");
  file.column("solve/solver", r.stages, &Stage::solver, "");
  file.column("solve/outcome", r.stages, &Stage::outcome, "");
  file.column("solve/sentence", r.stages, &Stage::sentence, "");
  file.column("solve/level", r.stages, variant(&Variant::level), "1", "times the mesh was halved");
  file.column("solve/stiffness_cap", r.stages, variant(&Variant::stiffness_cap), "N",
              "cap on axial stiffnesses; 0: none");
  file.column("solve/compression", r.stages, variant(&Variant::compression), "1",
              "factor on the stiffness of slack members");
  file.column("solve/current", r.stages, variant(&Variant::current), "1", "factor on the current");
  file.column("solve/unknowns", r.stages, &Stage::unknowns, "1");
  file.column("solve/iterations", r.stages, cost(&Statistics::iterations), "1", "accepted steps");
  file.column("solve/factorisations", r.stages, cost(&Statistics::factorisations), "1");
  file.column("solve/seconds", r.stages, cost(&Statistics::total_seconds), "s", "wall time");
  file.column("solve/work", r.stages, &Stage::work, "1", "work, in the units of framework/balance/work.hpp");
}

template <class File, class AnyResult>
void visit_iterations(File&& file, AnyResult& r) {
  auto& rows = r.iterations;
  file.column("convergence/iteration", rows, &Iteration::iteration, "1", "accepted steps before this point");
  file.column("convergence/factorisations", rows, &Iteration::factorisations, "1",
              "factorisations before this point");
  file.column("convergence/residual", rows, &Iteration::residual, "N", "largest nodal residual");
  file.column("convergence/load", rows, &Iteration::load, "N",
              "largest nodal load, to which the tolerance is relative");
  file.column("convergence/energy", rows, &Iteration::energy, "J", "energy, if all forces have one");
  file.column("convergence/seconds", rows, &Iteration::seconds, "s", "wall time since the solver began");
  file.column("convergence/note", rows, &Iteration::note, "",
              "the solver's remark on the step to this point");
}

template <class File, class AnyMotion>
void visit_motion(File&& file, AnyMotion& m) {
  file.text("motion/integrator", m.integrator);
  file.text("motion/start_from", m.start_from, "shape from which the motion began at rest");
  file.number("motion/time", m.time, "s", "reached");
  file.number("motion/resumed_from", m.resumed_from, "s", "time from which this run continued");
  file.number("cost/steps", m.steps, "1", "accepted time steps");
  file.number("cost/rejected_steps", m.rejected, "1", "rejected time steps");
  file.number("motion/shortest_step", m.shortest, "s", "shortest step");
  file.number("motion/longest_step", m.longest, "s", "longest step");
  file.number("motion/stable_step", m.stable_step, "s", "longest stable step with taut members; 0: no limit");
  file.sometimes("motion/start", m.start, [&](auto& s) {
    file.text("motion/start/node", s.node, "node furthest out of balance at the start");
    file.number("motion/start/residual", s.residual, "N", "force out of balance at that node");
    file.number("motion/start/load", s.load, "N", "largest load on a node");
  });
  file.sometimes("accuracy", m.accuracy, [&](auto& a) {
    file.number("accuracy/asked", a.asked, "1", "accuracy of the path, over the longest element");
    file.number("accuracy/longest_element", a.element, "m", "longest element along one axis");
    file.number("accuracy/allowed", a.allowed, "1", "error allowed for one step");
    file.number("accuracy/largest", a.largest, "1", "largest error of a step");
    file.number("accuracy/time", a.t, "s", "time of the step with the largest error");
    file.text("accuracy/node", a.node, "node of the largest error of a step");
    file.number("accuracy/sum", a.sum, "1", "sum of the errors of all steps");
    if (!file.is_there("accuracy/path", a.is_checked)) return;
    file.number("accuracy/path", a.path, "1", "error of the path, compared with a run in other steps");
    file.number("accuracy/path_time", a.path_at, "s", "time of the error of the path");
    file.text("accuracy/path_node", a.path_of, "node of the error of the path");
    file.known("accuracy/unpredictable_from", a.unpredictable_from, "s",
               "time after which no accuracy gives the path");
  });
  file.sometimes("motion/loss", m.loss, [&](auto& l) {
    file.number("motion/loss/lost", l.lost, "J", "energy that the time scheme removed");
    file.number("motion/loss/given", l.given, "J", "energy that was supplied");
    file.number("motion/loss/negligible", l.negligible, "J", "work that counts as negligible");
    file.number("motion/loss/worst", l.worst, "J", "most energy removed between two outputs");
    file.number("motion/loss/from", l.from, "s", "time of the first of these two outputs");
    file.number("motion/loss/until", l.until, "s", "time of the second of these two outputs");
    file.text("motion/loss/node", l.node, "node whose velocity changed most between these two outputs");
  });
}

/// Visits other equilibria that were found, and the motion into which a disturbance of the solution grows.
template <class File, class AnyResult>
void visit_others(File&& file, AnyResult& r) {
  file.sometimes("shapes", r.shapes, [&](auto& s) {
    file.number("shapes/restarts", s.restarts, "1", "number of searches for other equilibria");
    file.number("shapes/times", s.times, "1", "how often the solution was found");
    file.number("shapes/by_energy", s.by_energy, "1",
                "1: the answer has the least energy; 0: it was found first");
    using Other = FoundShapes::Other;
    file.column("shapes/energy", s.others, &Other::energy, "J", "energy of the other equilibria");
    file.column("shapes/distance", s.others, &Other::distance, "m",
                "largest distance of a node from the solution");
    file.column("shapes/furthest", s.others, &Other::furthest, "", "node with the largest distance");
    file.column("shapes/found", s.others, &Other::times, "1", "how often the equilibrium was found");
  });
  file.sometimes("swing", r.swing, [&](auto& s) {
    file.text("swing/furthest", s.furthest, "the node that moves furthest");
    file.number("swing/rate", s.rate, "1/s", "rate of growth");
    file.number("swing/frequency", s.frequency, "rad/s", "frequency of the swing; 0: none");
    file.number("swing/share", s.share, "1", "fraction of the gear's mass that moves");
  });
}

template <class File, class AnyResult>
void visit_sensitivities(File&& file, AnyResult& r) {
  file.sometimes("key_sensitivities", r.sensitivities, [&](auto& s) {
    using Row = KeySensitivities::Row;
    file.text("key_sensitivities/note", s.note, "how many numbers were examined, or why the table is empty");
    file.names("key_sensitivities/figure", s.rows, &Row::figure,
               "a key figure, and a number that it depends on");
    file.names("key_sensitivities/figure_unit", s.rows, &Row::figure_unit);
    file.names("key_sensitivities/path", s.rows, &Row::path, "name of the number, as for --set");
    file.names("key_sensitivities/unit", s.rows, &Row::unit, "as written in the scene");
    file.column("key_sensitivities/value", s.rows, &Row::value, "unit");
    file.column("key_sensitivities/derivative", s.rows, &Row::derivative, "figure_unit per unit",
                "derivative of the figure with respect to the number");
  });
}

/// Visits the members that are known when a run has ended, except named numbers and forces.
template <class File, class AnyResult>
void visit_ending(File&& file, AnyResult& r) {
  file.attribute("status", "outcome", r.outcome);
  file.attribute("status", "sentence", r.sentence);
  file.attribute("status", "stability", r.stability);
  file.attribute("status", "at_fault", r.at_fault);
  file.texts("diagnostics", r.diagnostics, "possible reasons why the solve did not converge");
  file.texts("warnings", r.warnings, "what is doubtful about the result");
  file.text("provenance/finished", r.origins.finished);
  file.text("method/factorisation", r.factorisation);
  visit_cost(file, r.statistics);
  file.number("cost/work", r.work, "1", "work, in the units of framework/balance/work.hpp");
  file.number("cost/reading", r.reading_seconds, "s", "wall time of reading the scene");
  file.number("cost/setup", r.setup_seconds, "s", "wall time of assembling it");
  visit_iterations(file, r);
  visit_stages(file, r);
  file.known("residual", r.residual, "N", "largest nodal residual at the end");
  file.known("largest_load", r.largest_load, "N", "largest nodal load at the end");
  file.known("energy", r.energy, "J", "energy at the end, if all forces have one");
  file.known("errors/nodes", r.node_error, "m",
             "estimated error: largest nodal move of the next Newton step");
  visit_others(file, r);
  visit_sensitivities(file, r);
}

/// Errors and ranges of the number `s`; `below` is "gear/" for a figure of a gear, otherwise empty.
template <class File, class AnyScalar>
void visit_errors(File&& file, const std::string& below, AnyScalar& s) {
  const std::string error = "errors/" + below, spread = "spread/" + below;
  file.known(error + "solver/" + s.name, s.solver_error, s.unit, "change by the next Newton step");
  file.known(error + "mesh/" + s.name, s.mesh_error, s.unit,
             "estimated distance from the limit on finer meshes");
  file.known(error + "mesh_order/" + s.name, s.mesh_order, "1", "observed order of convergence");
  file.known(spread + "least/" + s.name, s.least, s.unit, "value over all equilibria that were found");
  file.known(spread + "largest/" + s.name, s.largest, s.unit, "value over all equilibria that were found");
  file.known("swing/" + below + "per_metre/" + s.name, s.per_swing, s.unit,
             "change for each metre by which the furthest node of the growing disturbance moves");
}

}  // namespace netloft::results
