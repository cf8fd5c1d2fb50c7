// SPDX-License-Identifier: BSD-3-Clause
#include "tests/stability/suite/run.hpp"
#include "io/runs/equilibrium.hpp"

#include "framework/judging/growth.hpp"
#include "io/formats/work/long_work.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace netloft::hard_cases {

using namespace formats;
using namespace scenes;
using namespace runs;

namespace {

constexpr std::size_t kHistoryKept = 24;

/// The result of one attempt.
struct Attempt {
  Ended ended;
  bool ran = false;
  bool is_refused_anyhow = false;  // the case is also refused without the settings of the column
  std::string status, why_not;     // the reason why it did not run
};

/// The best stable equilibrium of a case, and which solvers have found a stable one.
struct Answers {
  std::optional<Reference> best;
  std::set<std::string> solvers;

  bool has_another_than(const std::string& solver) const {
    return solvers.size() > (solvers.contains(solver) ? 1u : 0u);
  }
};

constexpr const char* kFromTheSketch = " from the sketch";
constexpr const char* kFromTheStart = " from the start of ";

/// Returns the solver that `found_by` names: "newton" in "newton from the sketch".
std::string solver_of(const std::string& found_by) { return found_by.substr(0, found_by.find(" from the ")); }

Stability find_stability(runs::PreparedScene& one, const Ended& e) {
  if (e.conservative || !e.claims_success()) return e.solution.stability;
  Statistics cost;
  Factors factors(one.factorisations(), cost);
  const Growth growth = find_growth(
      one.assembler(), {e.solution.x, e.solution.x_low, e.solution.correction.x, e.solution.correction.x_low},
      factors);
  if (std::isnan(growth.per_power)) return Stability::unknown;
  return growth.grows() && !growth.is_local ? Stability::unstable : Stability::stable;
}

class SuiteRun {
 public:
  SuiteRun(const std::vector<Column>& columns, References& references, Registry& registry,
           const RunOptions& options)
      : columns_(columns), references_(references), registry_(registry), options_(options) {}

  Row run(const HardCase& c, const std::string& size) {
    std::vector<Attempt> attempts;
    for (const auto& column : columns_) attempts.push_back(attempt(c, size, column, c.start));
    const Answers answers = find_answers(c, size, attempts);
    Row row{&c, size, {}, 0};
    for (std::size_t i = 0; i < columns_.size(); ++i)
      row.cells.push_back(make_cell(c, size, columns_[i], answers, attempts[i]));
    row.shapes = count_shapes(attempts);
    return row;
  }

  /// Reads a case with the settings of a column. Returns the diagnostics if the case is not accepted.
  std::optional<formats::Diagnostics> read(const HardCase& c, const std::string& size, const Column& column) {
    runs::PreparedScene one(source(c, size, column), registry_);
    if (one.prepare([&](scenes::LoadedScene& loaded) { spoil(loaded.scene, c.start); }) ==
        runs::PreparedScene::State::ready)
      return {};
    return one.diagnostics();
  }

  bool interrupted() const { return options_.watch.interrupt && options_.watch.interrupt->load(); }

 private:
  double seconds_for(const std::string& size) const {
    if (options_.seconds > 0) return options_.seconds;
    return size == "large" ? 60 : 10;
  }

  runs::CaseSource source(const HardCase& c, const std::string& size, const Column& column) const {
    runs::CaseSource source{c.scene, c.overrides, options_.threads};
    const auto add = [&](const std::vector<std::string>& words) {
      formats::append(source.changes, formats::read_changes(words));
    };
    add(c.sizes.at(size));
    add({"analysis.max_seconds=" + std::to_string(seconds_for(size))});
    if (options_.work > 0) add({"analysis.work=" + std::to_string(options_.work)});
    add(overrides_of(column));
    return source;
  }

  Attempt attempt(const HardCase& c, const std::string& size, const Column& column,
                  const std::vector<StartStep>& start) try {
    Attempt a;
    if (interrupted()) return a;
    if (!column.sizes.empty() && std::count(begin(column.sizes), end(column.sizes), size) == 0) {
      a.ran = a.ended.unfit = true, a.why_not = "left out at this size";
      return a;
    }
    runs::PreparedScene one(source(c, size, column), registry_);
    if (one.prepare([&](scenes::LoadedScene& loaded) { spoil(loaded.scene, start); }) !=
        runs::PreparedScene::State::ready) {
      a.status = "wrong input", a.why_not = first_error(one.diagnostics());
      runs::PreparedScene as_written(source(c, size, {}), registry_);
      a.is_refused_anyhow =
          as_written.prepare([](scenes::LoadedScene&) {}) != runs::PreparedScene::State::ready &&
          first_error(as_written.diagnostics()) == a.why_not;
      return a;
    }
    a.ran = true;
    Ended& e = a.ended;
    e.unknowns = one.plan().unknowns, e.conservative = one.plan().conservative;
    if (const auto why_not = runs::why_unfit(one)) {
      e.unfit = true, a.why_not = *why_not;
      return a;
    }
    try {
      e.solution = runs::find_equilibrium(one, options_.watch);
    } catch (const PluginRefused&) {
      throw;
    } catch (const std::runtime_error& failed) {  // the plugin fails in this case, but may succeed in others
      a.ran = false, a.status = "failed", a.why_not = failed.what();
      return a;
    }
    e.out_of_budget = e.solution.cost.statistics.total_cpu_seconds >= seconds_for(size) ||
                      (options_.work > 0 && e.solution.cost.work >= options_.work);
    if (!e.solution.x.empty()) e.positions = one.assembler().node_positions(e.solution.x);
    e.stability = find_stability(one, e);
    return a;
  } catch (const formats::Interrupted&) {
    return {};
  }

  static std::string first_error(const formats::Diagnostics& diagnostics) {
    const auto all = diagnostics.sorted();
    return all.empty() ? "" : diagnostics.where(all[0].place) + ": " + all[0].message;
  }

  /// Returns the known equilibrium; if there is none, the best of this run and of a solve by newton from the
  /// sketch. For a random case, further solvers start from the sketch until two have found a stable
  /// equilibrium.
  Answers find_answers(const HardCase& c, const std::string& size, const std::vector<Attempt>& attempts) {
    Answers all;
    if (c.expected == Expected::none) return all;
    const bool is_known = add_known(all, c, size);
    if (!is_known) add(all, sketch_attempt(c, size, "newton", {"analysis.tolerance=1e-13"}), "newton");
    for (std::size_t i = 0; i < attempts.size(); ++i)
      if (attempts[i].ended.is_at_rest()) {
        if (!is_known) keep_better(all, attempts[i], columns_[i].head() + kFromTheStart + c.name);
        all.solvers.insert(columns_[i].head());
      }
    for (const char* solver : {"ptc", "relaxation"})
      if (c.is_random && all.solvers.size() < 2) add(all, sketch_attempt(c, size, solver, {}), solver);
    if (options_.update && !c.is_random) renew(c, size, all, attempts);
    return all;
  }

  /// Replaces the reference of a case by the best stable equilibrium. If none was found, an old reference is
  /// removed only if it proved to be unstable.
  void renew(const HardCase& c, const std::string& size, const Answers& all,
             const std::vector<Attempt>& attempts) {
    const auto old = references_.find(c.reference, size);
    const auto refutes = [&](const Attempt& a) {
      return a.ended.solution.status == SolveStatus::unstable &&
             judge(c, old, a.ended).distance <= kSameShape;
    };
    if (all.best)
      keep_reference(c, size, *all.best);
    else if (old && std::any_of(attempts.begin(), attempts.end(), refutes))
      references_.forget(c.reference, size);
  }

  /// Adds the reference of a case and returns whether it is final. While references are renewed, only
  /// references that this run has written are used, and a better equilibrium may replace them.
  bool add_known(Answers& all, const HardCase& c, const std::string& size) const {
    if (c.is_random || (options_.update && !renewed_.contains({c.reference, size}))) return false;
    all.best = references_.find(c.reference, size);
    if (all.best) all.solvers.insert(solver_of(all.best->found_by));
    return all.best && !options_.update;
  }

  Attempt sketch_attempt(const HardCase& c, const std::string& size, const char* solver,
                         std::vector<std::string> overrides) {
    return attempt(c, size, {.solver = solver, .strategy = "", .overrides = std::move(overrides)}, {});
  }

  static void add(Answers& all, const Attempt& a, const std::string& solver) {
    if (!a.ended.is_at_rest()) return;
    keep_better(all, a, solver + kFromTheSketch);
    all.solvers.insert(solver);
  }

  static void keep_better(Answers& all, const Attempt& a, const std::string& found_by) {
    if (!all.best || is_better(a, *all.best)) all.best = make_reference(a.ended, found_by);
  }

  static bool is_better(const Attempt& a, const Reference& known) {
    const bool lower = a.ended.conservative &&
                       a.ended.solution.energy < known.energy - energy_noise(known, a.ended.solution);
    return lower || is_closer(a.ended, known);
  }

  void keep_reference(const HardCase& c, const std::string& size, const Reference& reference) {
    references_.keep(c.reference, size, reference);
    renewed_.insert({c.reference, size});
  }

  Cell make_cell(const HardCase& c, const std::string& size, const Column& column, const Answers& answers,
                 const Attempt& a) const {
    Cell cell;
    cell.name = c.name, cell.size = size, cell.solver = column.head(), cell.expected = c.expected;
    cell.unknowns = a.ended.unknowns;
    if (!a.ran) {
      cell.verdict.where =
          c.expected == Expected::none && a.is_refused_anyhow ? Where::honest : Where::not_run;
      cell.status = a.status, cell.reason = a.why_not;
      return cell;
    }
    const Solution& s = a.ended.solution;
    cell.verdict = judge(c, answers.best, a.ended);
    cell.confirmed = !is_answer(cell.verdict.where) || answers.has_another_than(column.head());
    if (a.ended.unfit) {
      cell.status = "not run", cell.reason = a.why_not;
      return cell;
    }
    cell.status = name_of(s.status), cell.stability = name_of(a.ended.stability), cell.reason = s.reason;
    if (a.ended.claims_success() && a.ended.stability == Stability::unstable && !a.ended.conservative)
      cell.stability = "unstable: a small disturbance grows";
    cell.iterations = s.cost.statistics.iterations, cell.factorisations = s.cost.statistics.factorisations;
    cell.cpu_seconds = s.cost.statistics.total_cpu_seconds, cell.energy = s.energy;
    cell.stages = s.cost.stages, cell.shapes = s.shapes;
    cell.history = thinned(s.run.history);
    return cell;
  }

  static std::vector<IterationRecord> thinned(const std::vector<IterationRecord>& all) {
    if (all.size() <= kHistoryKept) return all;
    std::vector<IterationRecord> some;
    for (std::size_t i = 0; i < kHistoryKept; ++i)
      some.push_back(all[i * (all.size() - 1) / (kHistoryKept - 1)]);
    return some;
  }

  /// Counts the different stable equilibria among the results.
  static std::size_t count_shapes(const std::vector<Attempt>& attempts) {
    std::vector<Reference> found;
    const HardCase any;
    for (const Attempt& a : attempts) {
      if (!a.ended.is_at_rest()) continue;
      const bool known = std::any_of(found.begin(), found.end(), [&](const Reference& r) {
        const Verdict v = judge(any, r, a.ended);
        return v.distance <= kSameShape;
      });
      if (!known) found.push_back(make_reference(a.ended, ""));
    }
    return found.size();
  }

  const std::vector<Column>& columns_;
  References& references_;
  Registry& registry_;
  const RunOptions& options_;
  std::set<std::pair<std::string, std::string>> renewed_;  // name and size of answers found anew
};

bool is_wanted(const HardCase& c, const std::string& size, const std::string& pattern) {
  return c.sizes.contains(size) && c.name.find(pattern) != std::string::npos;
}

}  // namespace

std::optional<formats::Diagnostics> refuse_settings(const Suite& suite, const std::vector<Column>& columns,
                                                    References& references, Registry& registry,
                                                    const RunOptions& options) {
  SuiteRun run(columns, references, registry, options);
  for (const auto& column : columns) {
    std::optional<formats::Diagnostics> first;
    bool is_accepted = column.overrides.empty();
    for (const auto& size : options.sizes)
      for (const auto& c : suite.cases) {
        if (is_accepted || !is_wanted(c, size, options.pattern)) continue;
        auto refused = run.read(c, size, column);
        is_accepted = !refused;
        if (refused && !first && !run.read(c, size, {})) first = std::move(refused);
      }
    if (!is_accepted && first) return first;
  }
  return {};
}

std::vector<Row> run_suite(const Suite& suite, const std::vector<Column>& columns, References& references,
                           Registry& registry, const RunOptions& options) {
  SuiteRun run(columns, references, registry, options);
  std::vector<Row> rows;
  for (const auto& size : options.sizes)
    for (const auto& c : suite.cases) {
      if (!is_wanted(c, size, options.pattern)) continue;
      Row row = run.run(c, size);
      if (run.interrupted()) return rows;
      if (options.on_row) options.on_row(row);
      rows.push_back(std::move(row));
    }
  return rows;
}

}  // namespace netloft::hard_cases
