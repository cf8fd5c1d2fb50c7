// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/descriptors.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace netloft {

struct ConformanceOptions {
  // Seed of the sampled parameters, data and states; the same seed always gives the same report.
  std::uint64_t seed = 1;
  int elements = 100;  // sampled elements, 1 … 640
  int directions = 3;  // number of directions in checks of slopes, 1 … 100
  bool timings = true;
  std::uint32_t law_kind = 0;  // kind of laws that the element uses in the tests; 0: one kind after the
                               // other, as far as it accepts them
};

/// Result of one check. A check is skipped if it does not apply, or if another check that it depends on
/// failed, so that one mistake shows as one failure.
struct CheckResult {
  std::string name;  // name of the check, such as "force-is-gradient"
  bool passed = false, skipped = false;
  bool depends = false;          // whether it was skipped because a check on which it depends failed
  double figure = 0, limit = 0;  // worst figure, and the largest allowed one; 0: a yes-or-no check
  std::string detail;            // where the worst figure occurred, or why the check was skipped
  std::string hint;              // a likely cause of the failure
};

struct TermTiming {
  std::string term;
  std::string want;        // what was computed: "force", "force + tangent"
  double nanoseconds = 0;  // time per element, in full tiles that stay in the cache
  std::string per = "element";
};

struct ConformanceReport {
  std::string type;
  std::vector<CheckResult> checks;
  std::vector<TermTiming> timings;
  bool passed() const;
};

/// Checks that an element keeps the promises of its description (ranges, traits, derivatives …). Samples are
/// drawn from the description (sampler.hpp). A failure of the element is reported and never throws; an
/// element that crashes ends the program.
ConformanceReport check_element(const ElementType& type, const ConformanceOptions& options = {});

/// Checks a hydrodynamic law, with 64 flows for each sampled set of parameters.
ConformanceReport check_law(const LawType& type, const ConformanceOptions& options = {});

/// Checks a solver, with small problems whose solutions are known (practice.hpp).
ConformanceReport check_solver(const SolverType& type, const ConformanceOptions& options = {});

/// Checks an integrator, with a motion whose solution is known (practice_motion.hpp).
ConformanceReport check_integrator(const IntegratorType& type, const ConformanceOptions& options = {});

/// Checks a strategy, with searches of small scenes (practice_search.hpp).
ConformanceReport check_strategy(const StrategyType& type, const ConformanceOptions& options = {});

ConformanceReport check_file(const std::filesystem::path& file);

/// Name of the check that is running, for the report of a crash; nullptr between checks.
const char* check_under_way();

/// Names of all checks in the order in which they run: of elements, laws, solvers, integrators and
/// strategies.
std::vector<std::string> conformance_checks();
std::vector<std::string> law_checks();
std::vector<std::string> solver_checks();
std::vector<std::string> integrator_checks();
std::vector<std::string> strategy_checks();

/// One line per failed check; empty if all passed.
std::string failures(const ConformanceReport& report);

}  // namespace netloft
