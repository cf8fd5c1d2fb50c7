// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/optimum/scene_optimum.hpp"

#include "framework/balance/statistics.hpp"
#include "io/formats/toml/document.hpp"
#include "io/formats/toml/spelled_value.hpp"
#include "io/formats/work/long_work.hpp"
#include "io/gears/catalogue/part_choice.hpp"
#include "io/runs/equilibrium.hpp"
#include "io/runs/tangent.hpp"
#include "io/studies/sensitivity/sensitivity.hpp"
#include "io/studies/sweep/path_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace netloft::studies {

namespace {

// Limit of iterations of a solve that starts from the accepted equilibrium. tests/bench/optimum.md compares
// the costs with lower limits.
constexpr int kIterationsFromAccepted = 100;

/// Changes "path=value" that set the variables to these values.
std::vector<std::string> words_of(const OptimumFile& file, const std::vector<double>& parameters) {
  std::vector<std::string> words;
  for (std::size_t v = 0; v < parameters.size(); ++v) {
    const Variable& variable = file.variables[v].variable;
    for (auto& word : variable.overrides(variable.value_of(parameters[v]))) words.push_back(std::move(word));
  }
  return words;
}

/// A model whose figures are the objective and the constraints, as functions of the variables.
class FiguresModel : public Model {
 public:
  FiguresModel(const OptimumFile& file, const CheckedOptimum& checked, const std::filesystem::path& folder,
               Registry& registry, PointHistory& history, const runs::Watch& watch)
      : file_(file),
        checked_(checked),
        source_(folder / file.scene, file.set),
        registry_(registry),
        history_(history),
        watch_(watch) {}

  bool is_interrupted() const override { return watch_.interrupt && watch_.interrupt->load(); }
  int solves() const { return solves_; }
  const std::string& trouble() const { return trouble_; }

  std::optional<std::vector<double>> predict(const std::vector<double>& p) override {
    if (!history_.find(p) && (!restore() || !solve(p))) return std::nullopt;
    const KnownPoint& known = *history_.find(p);
    trouble_ = known.reason;
    std::vector<double> values;
    for (const std::string& name : checked_.figures) {
      const auto at = std::ranges::find(known.figures, name, &StudyFigure::name);
      if (at != known.figures.end() && std::isfinite(at->value)) values.push_back(at->value);
    }
    if (known.reason.empty() && values.size() < checked_.figures.size())
      trouble_ = "a figure has no value there";
    return values.size() == checked_.figures.size() ? std::optional(std::move(values)) : std::nullopt;
  }

  std::optional<std::vector<std::vector<double>>> slopes(const std::vector<double>& p) override {
    accepted_ = p;
    const auto is_known = [&] {
      return std::ranges::all_of(checked_.figures,
                                 [&](const auto& name) { return history_.find(p)->slopes.contains(name); });
    };
    if (!is_known() && (!restore() || !differentiate() || !is_known())) return std::nullopt;
    std::vector<std::vector<double>> rows;
    for (const std::string& name : checked_.figures) rows.push_back(history_.find(p)->slopes.at(name));
    return rows;
  }

 private:
  /// An equilibrium from which searches for other equilibria start.
  struct Solved {
    std::vector<double> parameters;
    std::unique_ptr<runs::PreparedScene> scene;
    Solution solution;
    std::unique_ptr<runs::Tangent> tangent;
  };

  /// Makes the equilibrium of the accepted point available: solves the point if only its figures are known,
  /// from the history.
  bool restore() {
    if (accepted_.empty() || base_.parameters == accepted_) return true;
    if (last_.parameters != accepted_ && !solve(accepted_)) return false;
    if (last_.solution.status != SolveStatus::converged) {
      trouble_ = "the equilibrium of the history is not found again: " + last_.solution.reason;
      return false;
    }
    base_ = std::move(last_);
    last_ = {};
    base_.tangent = std::make_unique<runs::Tangent>(*base_.scene, base_.solution.x);
    return true;
  }

  /// Finds the equilibrium at a point, and stores its figures in the history. Returns false after an
  /// interruption.
  bool solve(const std::vector<double>& p) try {
    last_ = {p, nullptr, {}, nullptr};
    KnownPoint known{p, {}, {}};
    runs::CaseSource source = source_;
    formats::append(source.changes, formats::read_changes(words_of(file_, p)));
    last_.scene =
        std::make_unique<runs::PreparedScene>(std::move(source), registry_, checked_.scene->factorisations());
    // All points have the mesh topology of the original scene. Their figures then depend only on the
    // variables, and are smooth functions even of mesh counts and mesh sizes.
    if (last_.scene->prepare_like(*checked_.scene) != runs::PreparedScene::State::ready) {
      known.reason = first_fault(last_.scene->diagnostics());
    } else {
      ++solves_;
      last_.solution = find();
      if (is_interrupted()) return false;
      if (last_.solution.status == SolveStatus::converged)
        known.figures = figures_of(*last_.scene, last_.solution);
      else
        known.reason = std::string(name_of(last_.solution.status)) + ": " + last_.solution.reason;
    }
    if (!history_.find(p)) history_.store(std::move(known));
    return true;
  } catch (const formats::Interrupted&) {
    return false;
  }

  /// Finds the equilibrium of the last scene. Starts from the accepted equilibrium if both scenes have the
  /// same mesh topology.
  Solution find() {
    if (!base_.scene || !runs::have_same_topology(*base_.scene, *last_.scene))
      return runs::find_equilibrium(*last_.scene, watch_);
    std::vector<double> x = base_.solution.x;
    if (const auto change = base_.tangent->towards(*last_.scene))
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += (*change)[i];
    return runs::continue_equilibrium(*last_.scene, last_.scene->assembler().displacements_to(x),
                                      kIterationsFromAccepted, watch_);
  }

  /// Finds the derivatives at the accepted point, and stores them.
  bool differentiate() {
    std::vector<SceneNumber> numbers;
    for (std::size_t v = 0; v < accepted_.size(); ++v)
      numbers.push_back(number_of(file_.variables[v].variable, accepted_[v]));
    const FigureSlopes slopes =
        slopes_of(*base_.scene, base_.solution, checked_.figures, numbers, watch_.interrupt);
    if (slopes.rows.empty()) return trouble_ = slopes.why_not, false;
    KnownPoint known = *history_.find(accepted_);
    for (std::size_t f = 0; f < checked_.figures.size(); ++f)
      known.slopes[checked_.figures[f]] = slopes.rows[f];
    history_.store(std::move(known));
    return true;
  }

  const OptimumFile& file_;
  const CheckedOptimum& checked_;
  runs::CaseSource source_;
  Registry& registry_;
  PointHistory& history_;
  const runs::Watch& watch_;
  std::vector<double> accepted_;  // the point that the search accepted last
  Solved base_, last_;            // the accepted equilibrium, and the result of the last search
  int solves_ = 0;
  std::string trouble_;
};

/// The two multiples of a step on either side of a number, the nearer one first.
std::array<double, 2> multiples_beside(double number, double step) {
  const double nearest = std::round(number / step), other = nearest + (nearest * step < number ? 1 : -1);
  const auto multiple = [&](double times) { return std::stod(fmt::format("{:.12g}", times * step)); };
  return {multiple(nearest), multiple(other)};
}

/// Sets the variables that have a step to whole multiples of this step.
class Rounding {
 public:
  using OnPoint = std::function<void(const OptimumPoint&)>;
  Rounding(SceneOptimum& done, Model& model, const OnPoint& on_point)
      : done_(done), model_(model), on_point_(on_point), problem_(done.checked.problem) {}

  void run() {
    for (std::size_t v = 0; v < done_.file.variables.size() && done_.found.converged; ++v)
      if (done_.file.variables[v].step) round(v);
  }

 private:
  void round(std::size_t v) {
    const OptimumVariable& variable = done_.file.variables[v];
    const OptimumPoint before = done_.found.best;
    if (!done_.unrounded) done_.unrounded = before.predictions[0];
    for (const double multiple : multiples_beside(before.parameters[v], *variable.step)) {
      if (!variable.variable.interval->contains(multiple)) continue;
      problem_.start = before.parameters;
      problem_.start[v] = multiple;
      problem_.parameters[v] = {multiple, multiple};
      if (seek() || model_.is_interrupted() || left() <= 0) return;
    }
    done_.found.reason = variable.variable.name +
                         " cannot be a whole multiple of its step: with those beside "
                         "the optimum, no other values were found that satisfy the constraints";
  }

  int left() const { return done_.file.solves - static_cast<int>(done_.found.history.size()); }

  /// Searches for the optimum of the problem, and adds the points of this search to the history.
  bool seek() {
    std::vector<OptimumPoint> points = std::move(done_.found.history);
    const int most = std::max(1, done_.file.solves - static_cast<int>(points.size()));
    done_.found = optimise(model_, problem_, {.evaluations = most}, on_point_);
    points.insert(points.end(), done_.found.history.begin(), done_.found.history.end());
    done_.found.history = std::move(points);
    return done_.found.converged;
  }

  SceneOptimum& done_;
  Model& model_;
  const OnPoint& on_point_;
  OptimumProblem problem_;  // fixes the variables that were rounded
};

std::vector<StudyFigure> figures_at(const PointHistory& history, const std::vector<double>& parameters) {
  const KnownPoint* known = history.find(parameters);
  return known ? known->figures : std::vector<StudyFigure>{};
}

/// Writes the keys of `changed` that differ from `base` as lines of TOML.
void write_changes(const formats::Value* base, const formats::Value& changed, const std::string& path,
                   std::string& text) {
  if (base && *base == changed) return;
  const auto *table = changed.as<formats::Table>(), *before = base ? base->as<formats::Table>() : nullptr;
  if (table && before) {
    for (const formats::Member& member : table->members) {
      const formats::Member* old = before->find(member.key);
      write_changes(old ? &old->value : nullptr, member.value, formats::join_path(path, member.key), text);
    }
    return;
  }
  const std::string item = formats::spell_value({{}, formats::Array{{changed}}});  // texts with quotes
  text += path + " = " + item.substr(1, item.size() - 2) + "\n";
}

}  // namespace

std::vector<std::string> overrides_of(const OptimumFile& file, const std::vector<double>& parameters) {
  std::vector<std::string> words = file.set;
  for (auto& word : words_of(file, parameters)) words.push_back(std::move(word));
  return words;
}

SceneOptimum optimise_scene(OptimumFile file, CheckedOptimum checked, const std::filesystem::path& folder,
                            Registry& registry, PointHistory& history, const runs::Watch& watch,
                            const std::function<void(const OptimumPoint&)>& on_point) {
  SceneOptimum done;
  done.file = std::move(file);
  done.checked = std::move(checked);
  const double before = cpu_seconds();
  FiguresModel model(done.file, done.checked, folder, registry, history, watch);
  done.found = optimise(model, done.checked.problem, {.evaluations = done.file.solves}, on_point);
  Rounding(done, model, on_point).run();
  done.cpu_seconds = cpu_seconds() - before;
  done.solves = model.solves();
  done.is_interrupted = model.is_interrupted() && !done.found.converged;
  if (!done.found.converged) done.trouble = model.trouble();
  done.before = figures_at(history, done.checked.problem.start);
  done.after = figures_at(history, done.found.best.parameters);
  return done;
}

std::string scene_text(const SceneOptimum& optimum, const std::filesystem::path& folder,
                       const std::filesystem::path& place) {
  namespace fs = std::filesystem;
  const fs::path scene = folder / optimum.file.scene;
  formats::Diagnostics unheard;  // errors were reported when the scene was opened
  const formats::Value base = formats::Document::load(scene, {}, unheard).root();
  formats::Value changed = base;
  for (const auto& change : formats::read_changes(overrides_of(optimum.file, optimum.found.best.parameters)))
    formats::apply(changed, change, unheard, gears::keys_that_name_parts());
  const std::string path = fs::proximate(fs::absolute(scene), fs::absolute(place)).string();
  std::string text = "# The scene at the best point that netloft optimise found for " + optimum.file.name +
                     ".\ninclude = " + formats::spell_value({{}, formats::Array{{{{}, path}}}}) + "\n\n";
  write_changes(&base, changed, "", text);
  return text;
}

}  // namespace netloft::studies
