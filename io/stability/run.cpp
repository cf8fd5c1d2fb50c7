// SPDX-License-Identifier: BSD-3-Clause
#include "io/stability/run.hpp"

#include <algorithm>

namespace netloft::io {

namespace {

constexpr std::size_t kHistoryKept = 24;

/// What came of one attempt, with all that is needed to judge it.
struct Attempt {
  Solution solution;
  std::size_t unknowns = 0;
  bool ran = false, conservative = true, out_of_time = false;
  std::string why_not;
};

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
    Case one(source(c, size, column), registry_);
    if (one.open([&](LoadedScene& loaded) { spoil(loaded.scene, start); }) != Case::State::ready) {
      a.why_not = first_error(one.diagnostics());
      return a;
    }
    a.unknowns = one.plan().unknowns, a.conservative = one.plan().conservative, a.ran = true;
    a.solution = one.solve({options_.interrupt, {}});
    a.out_of_time = a.solution.books.total_seconds >= seconds_for(size);
    return a;
  }

  static std::string first_error(const Diagnostics& diagnostics) {
    const auto all = diagnostics.sorted();
    return all.empty() ? "" : diagnostics.where(all[0].place) + ": " + all[0].message;
  }

  /// The book's, or the best answer of this run; a case that is drawn is solved from its sketch, too.
  std::optional<Reference> find_reference(const StabilityCase& c, const std::string& size,
                                          const std::vector<Attempt>& attempts) {
    if (c.expected == Expected::none) return {};
    const auto known = c.drawn ? std::nullopt : references_.find(c.reference, size);
    if (known && !options_.update) return known;
    const StabilityColumn gentle{"newton", {"analysis.tolerance=1e-13"}};
    auto best = better(known, attempt(c, size, gentle, {}), "newton from the sketch");
    for (std::size_t i = 0; i < attempts.size(); ++i)
      best = better(best, attempts[i], columns_[i].word + " from the start of " + c.name);
    if (options_.update && best && !c.drawn) references_.offer(c.reference, size, *best);
    return best;
  }

  static std::optional<Reference> better(const std::optional<Reference>& known, const Attempt& a,
                                         const std::string& found_by) {
    if (!a.ran || a.solution.status != SolveStatus::converged) return known;
    const Reference found = make_reference(a.solution, a.unknowns, found_by);
    if (!known) return found;
    const double noise = kSameEnergy * std::max(std::abs(known->energy), known->load * known->size);
    return a.conservative && found.energy < known->energy - noise ? found : known;
  }

  Cell make_cell(const StabilityCase& c, const std::string& size, const StabilityColumn& column,
                 const std::optional<Reference>& reference, const Attempt& a) const {
    Cell cell{c.name, size, column.word, c.expected, a.unknowns, {}, "", "", "", 0, 0, 0, 0, {}};
    if (!a.ran) {
      cell.verdict.where = c.expected == Expected::none ? Where::honest : Where::not_run;
      cell.status = "wrong input", cell.reason = a.why_not;
      return cell;
    }
    const Solution& s = a.solution;
    cell.verdict = judge(c, reference, {s, a.conservative, a.out_of_time});
    cell.status = name_of(s.status), cell.stability = name_of(s.stability), cell.reason = s.reason;
    cell.iterations = s.books.iterations, cell.factorisations = s.books.factorisations;
    cell.cpu_seconds = s.books.total_cpu_seconds, cell.energy = s.energy;
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
      if (!a.ran || a.solution.status != SolveStatus::converged) continue;
      const bool known = std::any_of(found.begin(), found.end(), [&](const Reference& r) {
        const Verdict v = judge(any, r, {a.solution, a.conservative, false});
        return v.distance <= 100 * kSamePlace || v.where == Where::reference;
      });
      if (!known) found.push_back(make_reference(a.solution, a.unknowns, ""));
    }
    return found.size();
  }

  const std::vector<StabilityColumn>& columns_;
  References& references_;
  Registry& registry_;
  const RunOptions& options_;
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
