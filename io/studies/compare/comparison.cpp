// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/compare/comparison.hpp"

#include "framework/judging/correction.hpp"
#include "io/formats/work/long_work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace netloft::studies {

namespace {

// Two answers, improved by polish(), are different equilibria if the largest distance between the two
// positions of a node exceeds two limits: kSame times the size of the gear, and kDoubt times the sum of the
// uncertainties of both answers.
constexpr double kSame = 1e-6, kDoubt = 10;

double diagonal_of(const Scene& scene) {
  double square = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = scene.positions[axis], high = low;
    for (std::size_t d = axis; d < scene.positions.size(); d += 3) {
      low = std::min(low, scene.positions[d]);
      high = std::max(high, scene.positions[d]);
    }
    square += (high - low) * (high - low);
  }
  return std::sqrt(square);
}

std::string mesh_of(const scenes::LoadedScene& loaded) {
  for (const std::size_t directions : {2u, 1u})
    for (const auto& part : loaded.parts)
      if (part.cells.size() == directions)
        return fmt::format("{} cells of {}", fmt::join(part.cells, " x "), part.name);
  return "no cells";
}

class Comparing {
 public:
  Comparing(const runs::CaseSource& source, Registry& registry, const ComparisonTask& task,
            const runs::Watch& watch)
      : source_(source),
        registry_(registry),
        task_(task),
        watch_(watch),
        own_(source, registry),
        references_(source, registry, task.reference, watch),
        paths_(source, registry, task.reference, task.tolerances.back(), watch) {
    if (own_.prepare() != runs::PreparedScene::State::ready)
      throw std::runtime_error(own_.diagnostics().render(false));
  }

  Comparison run() {
    describe();
    try {
      run_all();
    } catch (const formats::Interrupted&) {  // interrupted while a scene was read; results of earlier methods
                                             // remain
    }
    out_.is_interrupted = is_interrupted();
    return std::move(out_);
  }

 private:
  bool is_interrupted() const { return watch_.interrupt && watch_.interrupt->load(); }

  void run_all() {
    for (const Method& method : task_.methods)
      if (!is_interrupted())
        out_.methods.push_back(task_.is_of_motions ? run_in_time(method) : run_method(method));
    if (!is_interrupted() && !task_.is_of_motions) time_factorisation();
    if (task_.cells && !is_interrupted()) find_discretisation();
  }

  void describe() {
    out_.scene = own_.loaded().scene.name;
    out_.mesh = mesh_of(own_.loaded());
    out_.unknowns = own_.plan().unknowns;
    out_.repeats = task_.repeats;
    out_.size = diagonal_of(own_.loaded().scene);
    out_.is_of_motions = task_.is_of_motions;
  }

  MethodResult run_method(const Method& method) {
    MethodResult result{method,
                        run_trials(source_, registry_, method, task_.tolerances, task_.repeats, watch_),
                        {},
                        {},
                        false};
    if (!is_interrupted()) result.reference = references_.find_for(method);
    if (result.reference) result.other = find_other_equilibrium(result);
    if (result.reference && !result.other)
      for (Trial& t : result.trials)
        if (!t.x.empty()) t.error = distance(t.x, result.reference->answer.x);
    return result;
  }

  MethodResult run_in_time(const Method& method) {
    if (const auto absent = task_.absent.find(method.specification); absent != task_.absent.end()) {
      MethodResult result{method, {Trial{}}, {}, {}, true};
      Trial& trial = result.trials.front();
      trial.tolerance = task_.tolerances.front();
      trial.of_motion = "not installed";
      trial.reason = absent->second;
      trial.cpu_seconds = std::numeric_limits<double>::quiet_NaN();
      return result;
    }
    MethodResult result{method,
                        run_trials(source_, registry_, method, task_.tolerances, task_.repeats, watch_),
                        {},
                        {},
                        false};
    if (!is_interrupted()) result.reference = paths_.find_for(method, result.trials.front().is_damped);
    for (Trial& t : result.trials)
      if (t.converged() && result.reference)
        t.error =
            path_distance(own_.loaded().scene, own_.assembler().numbering(), t.path, result.reference->path);
    return result;
  }

  /// Compares the reference with an answer of the method: the one at the tightest tolerance to which the
  /// method converged. nullopt if both answers are the same equilibrium, or if no trial of the method
  /// converged.
  std::optional<OtherEquilibrium> find_other_equilibrium(const MethodResult& result) {
    const auto last = std::find_if(result.trials.rbegin(), result.trials.rend(),
                                   [](const Trial& t) { return t.converged(); });
    if (last == result.trials.rend()) return {};
    runs::PreparedScene fresh(source_for(source_, result.method, last->tolerance), registry_);
    fresh.prepare();
    const Polished limit = polish(fresh, last->u), &goal = result.reference->answer;
    const double apart = distance(limit.x, goal.x);
    const double doubt = kDoubt * (std::max(0.0, limit.uncertainty) + std::max(0.0, goal.uncertainty));
    if (apart <= std::max(kSame * out_.size, doubt)) return {};
    return OtherEquilibrium{apart, limit.energy - goal.energy, own_.plan().conservative};
  }

  double distance(const std::vector<double>& x, const std::vector<double>& y) {
    return largest_node_distance(own_.loaded().scene, own_.assembler().numbering(), x, y);
  }

  void time_factorisation() {
    for (const auto& m : out_.methods)
      if (m.reference) {
        out_.factorisation_seconds = factorisation_seconds(own_, m.reference->answer.u);
        return;
      }
  }

  /// Solves the scene on all meshes with one method, so that answers differ only because of the mesh. It is
  /// the cheapest of the methods that converged at the tightest tolerance.
  void find_discretisation() {
    const CellList& list = *task_.cells;
    out_.discretisation =
        find_discretisation_error(source_, registry_, method_for_meshes(),
                                  list.part.empty() ? leading_part(own_.loaded()).name : list.part,
                                  mesh_levels(own_.loaded(), list), watch_);
  }

  Method method_for_meshes() const {
    const MethodResult* best = nullptr;
    const auto price = [](const MethodResult& m) { return m.trials.back().cpu_seconds; };
    for (const auto& m : out_.methods)
      if (m.trials.back().converged() && !m.other && (!best || price(m) < price(*best))) best = &m;
    if (best) return best->method;
    const auto& first = out_.methods.front();
    return first.reference ? first.reference->method : first.method;
  }

  const runs::CaseSource& source_;
  Registry& registry_;
  const ComparisonTask& task_;
  const runs::Watch& watch_;
  runs::PreparedScene own_;
  ReferenceAnswers references_;
  ReferencePaths paths_;
  Comparison out_;
};

}  // namespace

bool Comparison::any_converged() const {
  return std::any_of(methods.begin(), methods.end(), [](const MethodResult& m) {
    return std::any_of(m.trials.begin(), m.trials.end(), [](const Trial& t) { return t.converged(); });
  });
}

bool Comparison::any_failed() const {
  return std::any_of(methods.begin(), methods.end(), [](const MethodResult& m) {
    return std::any_of(m.trials.begin(), m.trials.end(), [](const Trial& t) { return t.failed; });
  });
}

Comparison compare(const runs::CaseSource& source, Registry& registry, const ComparisonTask& task,
                   const runs::Watch& watch) {
  return Comparing(source, registry, task, watch).run();
}

}  // namespace netloft::studies
