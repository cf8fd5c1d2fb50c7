// SPDX-License-Identifier: BSD-3-Clause
#include "io/stability/run.hpp"

#include "framework/problem/growth.hpp"
#include "solvers/factorisation/factorisation.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace netloft::io {

namespace {

constexpr std::size_t kHistoryKept = 24;

/// What came of one attempt.
struct Attempt {
  Ended ended;
  bool ran = false;
  std::string why_not;
  bool arrived() const {
    return ran && !ended.unfit && ended.solution.status == SolveStatus::converged && !ended.grows;
  }
};

bool is_fit(const Analysis& analysis, const Plan& plan, Registry& registry) {
  if (analysis.settles) return true;
  const SolverType& solver = registry.solver(analysis.solver);
  std::uint32_t traits = 0;
  if (plan.conservative) traits |= NETLOFT_CONSERVATIVE;
  if (plan.symmetric) traits |= NETLOFT_SYMMETRIC;
  return (solver.solver.needs & ~traits) == 0;
}

class SuiteRun {
 public:
  SuiteRun(const std::vector<StabilityColumn>& columns, References& references, Registry& registry,
           const RunOptions& options)
      : columns_(columns), references_(references), registry_(registry), options_(options) {}

  Row run(const StabilityCase& c, const std::string& size) {
    std::vector<Attempt> attempts;
    for (const auto& column : columns_) attempts.push_back(attempt(c, size, column, c.start));
    const auto reference = find_reference(c, size, attempts);
    Row row{&c, size, {}, 0};
    for (std::size_t i = 0; i < columns_.size(); ++i)
      row.cells.push_back(make_cell(c, size, columns_[i], reference, attempts[i]));
    row.shapes = count_shapes(attempts);
    return row;
  }

  bool interrupted() const { return options_.interrupt && options_.interrupt->load(); }

 private:
  double seconds_for(const std::string& size) const {
    if (options_.seconds > 0) return options_.seconds;
    return size == "large" ? 60 : 10;
  }

  CaseSource source(const StabilityCase& c, const std::string& size, const StabilityColumn& column) const {
    CaseSource source{c.scene, c.overrides, options_.threads};
    const auto add = [&](const std::vector<std::string>& words) {
      source.overrides.insert(source.overrides.end(), words.begin(), words.end());
    };
    add(c.sizes.at(size)), add(solver_overrides(column.word));
    add({"analysis.max_seconds=" + std::to_string(seconds_for(size))});
    add(column.overrides);
    return source;
  }

  Attempt attempt(const StabilityCase& c, const std::string& size, const StabilityColumn& column,
                  const std::vector<StartStep>& start) {
    Attempt a;
    if (interrupted()) return a;
    if (!column.sizes.empty() && std::count(begin(column.sizes), end(column.sizes), size) == 0) {
      a.ran = a.ended.unfit = true, a.why_not = "left out at this size";
      return a;
    }
    Case one(source(c, size, column), registry_);
    if (one.open([&](LoadedScene& loaded) { spoil(loaded.scene, start); }) != Case::State::ready) {
      a.why_not = first_error(one.diagnostics());
      return a;
    }
    a.ran = true;
    Ended& e = a.ended;
    e.unknowns = one.plan().unknowns, e.conservative = one.plan().conservative;
    e.unfit = !is_fit(one.loaded().analysis, one.plan(), registry_);
    if (e.unfit) {
      a.why_not = "the solver needs an energy, which not all forces here have";
      return a;
    }
    e.solution = one.solve({options_.interrupt, {}});
    e.out_of_time = e.solution.books.total_seconds >= seconds_for(size);
    if (!e.solution.x.empty()) e.positions = one.positions(e.solution.x);
    if (!e.conservative && a.arrived())
      e.grows = find_growth(one.assembler(), e.solution.x, make_factorisation, e.solution.x_low).grows();
    return a;
  }

  static std::string first_error(const Diagnostics& diagnostics) {
    const auto all = diagnostics.sorted();
    return all.empty() ? "" : diagnostics.where(all[0].place) + ": " + all[0].message;
  }

  /// The book's, or the best answer of this run; a case that is drawn is solved from its sketch, too, in
  /// more ways where nobody found one.
  std::optional<Reference> find_reference(const StabilityCase& c, const std::string& size,
                                          const std::vector<Attempt>& attempts) {
    if (c.expected == Expected::none) return {};
    auto best = known_reference(c, size);
    if (best && !options_.update) return best;
    const StabilityColumn gentle{"newton", {"analysis.tolerance=1e-13"}};
    best = better(best, attempt(c, size, gentle, {}), "newton from the sketch");
    for (std::size_t i = 0; i < attempts.size(); ++i)
      best = better(best, attempts[i], columns_[i].word + " from the start of " + c.name);
    if (c.drawn && !best)
      for (const char* word : {"ptc", "relaxation"})
        best = better(best, attempt(c, size, {word, {}}, {}), std::string(word) + " from the sketch");
    if (options_.update && best && !c.drawn) {
      references_.keep(c.reference, size, *best);
      renewed_.insert({c.reference, size});
    }
    return best;
  }

  /// Of a book that is being renewed, only what this run has written counts.
  std::optional<Reference> known_reference(const StabilityCase& c, const std::string& size) const {
    if (c.drawn || (options_.update && !renewed_.contains({c.reference, size}))) return {};
    return references_.find(c.reference, size);
  }

  static std::optional<Reference> better(const std::optional<Reference>& known, const Attempt& a,
                                         const std::string& found_by) {
    if (!a.arrived()) return known;
    const Reference found = make_reference(a.ended, found_by);
    if (!known) return found;
    const bool lower =
        a.ended.conservative && found.energy < known->energy - energy_noise(*known, a.ended.solution);
    return lower || is_closer(a.ended, *known) ? found : known;
  }

  Cell make_cell(const StabilityCase& c, const std::string& size, const StabilityColumn& column,
                 const std::optional<Reference>& reference, const Attempt& a) const {
    Cell cell{c.name, size, column.head(), c.expected, a.ended.unknowns, {}, "", "", "", 0, 0, 0, 0, {},
              {},     {}};
    if (!a.ran) {
      cell.verdict.where = c.expected == Expected::none ? Where::honest : Where::not_run;
      cell.status = "wrong input", cell.reason = a.why_not;
      return cell;
    }
    const Solution& s = a.ended.solution;
    cell.verdict = judge(c, reference, a.ended);
    if (a.ended.unfit) {
      cell.status = "not run", cell.reason = a.why_not;
      return cell;
    }
    cell.status = name_of(s.status), cell.stability = name_of(s.stability), cell.reason = s.reason;
    if (a.ended.grows) cell.stability = "unstable: a small disturbance grows";
    cell.iterations = s.books.iterations, cell.factorisations = s.books.factorisations;
    cell.cpu_seconds = s.books.total_cpu_seconds, cell.energy = s.energy;
    cell.legs = s.legs, cell.shapes = s.shapes;
    cell.history = thinned(s.history);
    return cell;
  }

  static std::vector<IterationRecord> thinned(const std::vector<IterationRecord>& all) {
    if (all.size() <= kHistoryKept) return all;
    std::vector<IterationRecord> some;
    for (std::size_t i = 0; i < kHistoryKept; ++i)
      some.push_back(all[i * (all.size() - 1) / (kHistoryKept - 1)]);
    return some;
  }

  /// Places where solvers say that the gear is in stable equilibrium, each counted once.
  static std::size_t count_shapes(const std::vector<Attempt>& attempts) {
    std::vector<Reference> found;
    const StabilityCase any;
    for (const Attempt& a : attempts) {
      if (!a.arrived()) continue;
      const bool known = std::any_of(found.begin(), found.end(), [&](const Reference& r) {
        const Verdict v = judge(any, r, a.ended);
        return v.distance <= kSameShape;
      });
      if (!known) found.push_back(make_reference(a.ended, ""));
    }
    return found.size();
  }

  const std::vector<StabilityColumn>& columns_;
  References& references_;
  Registry& registry_;
  const RunOptions& options_;
  std::set<std::pair<std::string, std::string>> renewed_;  // name and size of answers found anew
};

bool is_wanted(const StabilityCase& c, const std::string& size, const std::string& pattern) {
  return c.sizes.contains(size) && c.name.find(pattern) != std::string::npos;
}

}  // namespace

std::vector<Row> run_suite(const StabilitySuite& suite, const std::vector<StabilityColumn>& columns,
                           References& references, Registry& registry, const RunOptions& options) {
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

}  // namespace netloft::io
