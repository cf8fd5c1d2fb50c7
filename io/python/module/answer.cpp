// SPDX-License-Identifier: BSD-3-Clause
#include "io/python/module/answer.hpp"

#include "framework/assembler/reports.hpp"
#include "io/formats/work/interruptible_work.hpp"
#include "io/program/session/session.hpp"
#include "io/python/module/python_plugin.hpp"
#include "io/results/file/provenance.hpp"
#include "io/results/text/plan_text.hpp"
#include "io/runs/equilibrium.hpp"
#include "io/studies/compare/mesh_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace netloft::python {

namespace {

void require_equilibrium_of(const scenes::LoadedScene& loaded) {
  if (loaded.analysis.kind == AnalysisKind::dynamics)
    throw std::invalid_argument(
        "solve() finds equilibria, but this scene is a motion; use simulate(), or with_({\"analysis.kind\": "
        "\"static\"})");
}

void require_finite(const std::vector<double>& values, const char* what) {
  if (!std::ranges::all_of(values, [](double v) { return std::isfinite(v); }))
    throw std::invalid_argument(std::string(what) + " has numbers that are not finite");
}

Solution solve_from(runs::PreparedScene& scene, const std::vector<double>& start, const runs::Watch& watch) {
  if (start.empty()) return runs::find_equilibrium(scene, watch);
  const std::size_t expected = 3 * scene.loaded().scene.node_count();
  if (start.size() != expected)
    throw std::invalid_argument(
        fmt::format("the start has {} coordinates, and the scene has {} nodes with {}; start from a result "
                    "of the same mesh",
                    start.size(), expected / 3, expected));
  require_finite(start, "the start");
  return runs::find_equilibrium_near(scene, scene.assembler().displacements(start), watch);
}

}  // namespace

Answer::Answer(const OpenedScene& source, const SolveRequest& request, const std::atomic<bool>& interrupt)
    : started_(results::utc_now()), command_(source.command()) {
  if (request.with_mesh_errors) command_.push_back("--error");
  const formats::InterruptibleWork reading(interrupt);
  scene_ = source.prepare(request.like.get());
  require_equilibrium_of(scene_->loaded());
  if (request.like && !runs::have_same_topology(*request.like, *scene_))
    throw std::invalid_argument(
        "mesh_of has a mesh that this scene cannot have; give an equilibrium of the same gear");
  if (const auto why_not = runs::why_unfit(*scene_)) throw PluginRefused(*why_not);
  solution_ =
      solve_from(*scene_, request.start, {.interrupt = &interrupt, .on_iteration = request.on_iteration});
  raised_ = take_error();
  result_ = results::make_result(scene_->loaded(), scene_->assembler(), solution_);
  result_.reading_seconds = scene_->seconds().reading;
  result_.setup_seconds = scene_->seconds().setup;
  if (request.with_mesh_errors) find_mesh_errors(interrupt);
  points_ = scene_->assembler().node_positions(solution_.x);
  find_elements();
}

void Answer::find_mesh_errors(const std::atomic<bool>& interrupt) {
  const ReadingLock lock;
  studies::find_mesh_errors(scene_->source(), scene_->registry(), *scene_, solution_,
                            studies::levels_around(scene_->loaded()), {.interrupt = &interrupt}, result_);
}

void Answer::find_elements() {
  const Scene& scene = scene_->loaded().scene;
  Assembler& assembler = scene_->assembler();
  const results::Response response =
      results::ask_elements(scene, assembler, solution_.x, results::at_rest(solution_), false);
  for (std::size_t f = 0; f < assembler.families().size(); ++f) {
    const ElementFamily& family = *assembler.families()[f];
    if (family.repeated()) continue;
    const auto corners = static_cast<std::size_t>(family.nodes_per_element());
    for (std::size_t p = 0; p < family.parts().size(); ++p) {
      const std::size_t begin = family.part_begin()[p], end = family.part_begin()[p + 1];
      PartElements& of = elements_.emplace_back(
          PartElements{scene.parts[family.parts()[p]].name, family.type().type, corners, {}, {}});
      for (std::size_t e = begin; e < end; ++e)
        for (std::size_t n = 0; n < corners; ++n) of.nodes.push_back(family.node(e, static_cast<int>(n)));
      for (std::size_t o = 0; o < family.type().outputs.size(); ++o) {
        const netloft_output& output = family.type().outputs[o];
        const std::vector<double>& all = response.outputs[f][o];
        if (all.size() < end) continue;
        of.outputs.push_back({output.name,
                              output.unit,
                              output.doc,
                              {all.begin() + static_cast<std::ptrdiff_t>(begin),
                               all.begin() + static_cast<std::ptrdiff_t>(end)}});
      }
    }
  }
}

/// Requires a number for every unknown.
void Answer::require_unknowns(const std::vector<double>& values, const char* what) const {
  const auto unknowns = static_cast<std::size_t>(scene_->assembler().numbering().unknowns());
  if (values.size() != unknowns)
    throw std::invalid_argument(
        fmt::format("{} has {} numbers, and the scene has {} unknowns", what, values.size(), unknowns));
  require_finite(values, what);
}

std::vector<double> Answer::residual(const std::vector<double>& u) {
  Assembler& assembler = scene_->assembler();
  require_unknowns(u, "u");
  std::vector<double> x = assembler.start(), residual(x.size());
  assembler.place(u, x);
  if (!assembler.evaluate(x, {.residual = residual.data()}))
    throw std::invalid_argument(assembler.fault_sentence(scene_->loaded().scene));
  residual.resize(u.size());
  return residual;
}

std::vector<double> Answer::solve(const std::vector<double>& b, bool transposed) {
  require_unknowns(b, "the right-hand side");
  if (!tangent_) tangent_ = std::make_unique<runs::Tangent>(*scene_, solution_.x);
  auto found = transposed ? tangent_->adjoint(b) : tangent_->solved(b);
  if (!found) throw std::invalid_argument("the tangent at the answer cannot be factorised");
  return *found;
}

TangentMatrix Answer::tangent() {
  Assembler& assembler = scene_->assembler();
  std::vector<double> slots(assembler.value_slots()), values;
  if (!assembler.evaluate(
          solution_.x,
          {.matrix = MatrixKind::exact, .values = slots.data(), .motion = results::at_rest(solution_)}))
    throw std::invalid_argument(assembler.fault_sentence(scene_->loaded().scene));
  const SparsePattern& pattern = assembler.pattern();
  for (std::size_t entry = 0; entry < pattern.entries(); ++entry)
    values.push_back(slots[pattern.slot_of(entry)]);
  return {values, pattern};
}

studies::Sensitivities Answer::sensitivities(const std::vector<std::string>& paths, bool with_long_step,
                                             const std::atomic<bool>& interrupt) {
  for (const auto& why_not :
       {studies::why_no_derivatives(solution_), studies::why_no_derivatives(scene_->loaded())})
    if (why_not) throw std::invalid_argument(*why_not);
  const ReadingLock lock;
  const auto numbers = studies::chosen_numbers(*scene_, paths);
  return studies::find_sensitivities(
      *scene_, solution_, {studies::all_figures(result_), numbers, with_long_step, &interrupt, {}});
}

void Answer::write(const std::filesystem::path& path) {
  formats::ResultFile file(path);
  const results::RunContext context{command_, started_, scene_->registry().opened(),
                                    results::plan_text(scene_->plan(), program::plan_extras(*scene_))};
  result_.origins = results::make_origins(scene_->loaded(), context);
  result_.origins.finished = results::utc_now();
  result_.path = path.string();
  results::write_result(file, scene_->loaded(), scene_->assembler(), {solution_, {}}, result_);
  file.finish();
}

}  // namespace netloft::python
