// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/path_run.hpp"
#include "io/formats/work/long_work.hpp"
#include "io/runs/equilibrium.hpp"

#include "framework/balance/statistics.hpp"
#include "io/results/figures/make_result.hpp"
#include "io/results/file/provenance.hpp"
#include "io/studies/sweep/branch.hpp"
#include "solvers/factorisation/kept_analyses.hpp"
#include "solvers/factorisation/make_factorisation.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace netloft::studies {

namespace {

std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

std::vector<Variable> variables_of_path(const Study& study) {
  std::vector<Variable> variables;
  for (const StudyColumn& column : study.columns)
    if (column.is_in_path) variables.push_back(column.variable);
  return variables;
}

/// Solves the points of one item.
class PathRun {
 public:
  PathRun(const Study& study, const StudyItem& item, const PathContext& context)
      : study_(study),
        item_(item),
        context_(context),
        source_(source_of(study, item, context)),
        make_(keep_analyses(make_factorisation)),
        watch_(context.watch),
        branch_(
            variables_of_path(study), [this](const auto& values) { return open_at(values); }, watch_) {}

  std::optional<ItemRecord> run() try {
    ItemRecord record;
    record.hash = item_.hash;
    record.program = results::program_version();
    record.cost.host = host_name();
    record.cost.started = results::utc_now();
    const double wall = wall_seconds(), cpu = cpu_seconds();
    for (const StudyPoint& point : item_.points) {
      record.points.push_back(solve(point));
      if (is_interrupted()) return std::nullopt;
    }
    record.cost.wall_seconds = wall_seconds() - wall;
    record.cost.cpu_seconds = cpu_seconds() - cpu;
    return record;
  } catch (const formats::Interrupted&) {
    return std::nullopt;
  }

 private:
  bool is_interrupted() const { return watch_.interrupt && watch_.interrupt->load(); }

  std::shared_ptr<runs::PreparedScene> make_case(const std::vector<formats::Change>& changes) const {
    runs::CaseSource source = source_;
    formats::append(source.changes, changes);
    return std::make_shared<runs::PreparedScene>(std::move(source), *context_.registry, make_);
  }

  /// Opens the scene at values between two points of the path.
  std::shared_ptr<runs::PreparedScene> open_at(const std::vector<VariableValue>& values) const {
    std::vector<formats::Change> changes;
    std::size_t v = 0;
    for (const StudyColumn& column : study_.columns)
      if (column.is_in_path) formats::append(changes, column.variable.changes(values[v++]));
    auto scene = make_case(changes);
    return scene->prepare() == runs::PreparedScene::State::ready ? scene : nullptr;
  }

  PointRecord solve(const StudyPoint& point) {
    const auto scene = make_case(formats::read_changes(point.set));
    PointRecord record;
    if (scene->prepare() != runs::PreparedScene::State::ready) {
      record.status = "wrong input";
      record.reason = first_fault(scene->diagnostics());
      return record;
    }
    require_same_files(*scene);
    if (const auto why_not = runs::why_unfit(*scene)) throw StudyError(*why_not);
    const Reached reached = branch_.reach(scene, point.values);
    record.start = reached.was_continued ? "continued" : "anew";
    record.events = reached.events;
    fill(record, *scene, reached.solution);
    return record;
  }

  void require_same_files(runs::PreparedScene& scene) const {
    for (const formats::SourceFile& file : scene.loaded().files)
      if (std::none_of(study_.files.begin(), study_.files.end(),
                       [&](const auto& known) { return known.second == file.hash; }))
        throw StudyError(file.path + " has changed since the study was planned; plan it again");
  }

  void fill(PointRecord& record, runs::PreparedScene& scene, const Solution& s) const {
    record.status = name_of(s.status);
    record.stability = name_of(s.stability);
    record.reason = s.reason;
    record.iterations = s.cost.statistics.iterations;
    record.factorisations = s.cost.statistics.factorisations;
    record.work = s.cost.work;
    record.figures = figures_of(scene, s);
    if (study_.figures.empty()) return;
    std::erase_if(record.figures, [&](const StudyFigure& figure) {
      return std::find(study_.figures.begin(), study_.figures.end(), figure.name) == study_.figures.end();
    });
  }

  const Study& study_;
  const StudyItem& item_;
  const PathContext& context_;
  runs::CaseSource source_;
  MakeFactorisation make_;
  runs::Watch watch_;
  Branch branch_;
};

}  // namespace

std::optional<ItemRecord> run_path(const Study& study, const StudyItem& item, const PathContext& context) {
  return PathRun(study, item, context).run();
}

runs::CaseSource source_of(const Study& study, const StudyItem& item, const PathContext& context) {
  runs::CaseSource source{context.folder / study.scene, study.set, context.threads};
  formats::append(source.changes, formats::read_changes(item.set));
  return source;
}

std::string first_fault(const formats::Diagnostics& diagnostics) {
  for (const formats::Diagnostic& d : diagnostics.sorted())
    if (d.severity == formats::Severity::error) return diagnostics.where(d.place) + ": " + d.message;
  return "a plugin is missing";
}

std::vector<StudyFigure> figures_of(runs::PreparedScene& scene, const Solution& solution) {
  const results::Result result = results::make_result(scene.loaded(), scene.assembler(), solution);
  std::vector<StudyFigure> figures;
  for (const results::NamedScalar& s : result.scalars)
    figures.push_back({"results/" + s.name, s.unit, s.value});
  for (const results::NamedScalar& s : result.figures) figures.push_back({"gear/" + s.name, s.unit, s.value});
  for (const results::NamedScalar& s : results::reactions_of(result.hold_forces))
    figures.push_back({s.name, s.unit, s.value});
  return figures;
}

}  // namespace netloft::studies
