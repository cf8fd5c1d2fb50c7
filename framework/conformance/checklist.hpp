// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/conformance/checks.hpp"

#include <algorithm>

namespace netloft::conformance {

/// One check of an element, a law or a method (solver, integrator, strategy).
template <class Bench>
struct Check {
  const char* name;
  Finding (*run)(Bench&);
  // Names of other checks. If one of these checks failed, or was skipped because of a failure, this check is
  // skipped.
  std::vector<const char*> depends_on;
  const char* hint;
};

/// Names of checks that failed, and of checks skipped because of them.
class Doubtful {
 public:
  void add(std::string name) { names_.push_back(std::move(name)); }
  const char* among(const std::vector<const char*>& names) const {
    const auto found = std::find_if(names.begin(), names.end(), [this](const char* n) {
      return std::find(names_.begin(), names_.end(), n) != names_.end();
    });
    return found == names.end() ? nullptr : *found;
  }

 private:
  std::vector<std::string> names_;
};

/// Lets all threads read the name of the running check, as long as this object exists.
class UnderWay {
 public:
  explicit UnderWay(const char* name);
  ~UnderWay();
  UnderWay(const UnderWay&) = delete;
  UnderWay& operator=(const UnderWay&) = delete;
};

template <class Bench>
CheckResult run(const Check<Bench>& check, Bench& bench, Doubtful& doubtful) {
  CheckResult r;
  r.name = check.name;
  r.hint = check.hint;
  if (const char* first = doubtful.among(check.depends_on)) {
    doubtful.add(check.name);
    r.skipped = r.depends = true;
    r.detail = std::string("depends on ") + first;
    return r;
  }
  const UnderWay under_way(check.name);
  Finding f = check.run(bench);
  r.passed = f.passed && !f.skipped;
  r.skipped = f.skipped;
  r.figure = f.figure;
  r.limit = f.limit;
  r.detail = std::move(f.detail);
  if (!f.passed) doubtful.add(check.name);
  return r;
}

template <class Bench>
std::vector<CheckResult> run_all(const std::vector<Check<Bench>>& table, Bench& bench, Doubtful& doubtful) {
  std::vector<CheckResult> results;
  for (const auto& check : table) results.push_back(run(check, bench, doubtful));
  return results;
}

template <class Bench>
std::vector<std::string> names_of(const std::vector<Check<Bench>>& table) {
  std::vector<std::string> names;
  for (const auto& check : table) names.push_back(check.name);
  return names;
}

}  // namespace netloft::conformance
