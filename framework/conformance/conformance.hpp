// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/descriptors.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace netloft {

struct ConformanceOptions {
  std::uint64_t seed = 1;  // of the sampled parameters, data and states; the same seed gives the same report
  int elements = 100;      // sampled elements, 1 … 640
  int directions = 3;      // directions of each directional check, 1 … 100
  bool timings = true;
  std::uint32_t law_kind = 0;  // in the slots of an element; 0: every kind that they take, in turn
};

/// Answer to one question about an element. A check that leans on one that failed is skipped, so that one
/// mistake shows as one failure.
struct CheckResult {
  std::string name;  // "force-is-gradient"
  bool passed = false, skipped = false;
  double figure = 0, limit = 0;  // the worst found, and what is allowed; both zero for questions of yes or no
  std::string detail;            // where the worst was found, or why the check was skipped
  std::string hint;              // what to look for in the element
};

struct TermTiming {
  std::string term;
  std::string want;        // "force", "force + tangent"
  double nanoseconds = 0;  // in full tiles that stay in the cache
  std::string per = "element";
};

struct ConformanceReport {
  std::string type;
  std::vector<CheckResult> checks;
  std::vector<TermTiming> timings;
  bool passed() const;
};

/// Does an element keep what its description promises? Everything asked is sampled from the description, see
/// sampler.hpp. Never throws on account of the element; an element that crashes takes the program with it.
ConformanceReport check_element(const ElementType& type, const ConformanceOptions& options = {});

/// The same of a hydrodynamic law. Its elements are 64 flows of each sampled set of parameters.
ConformanceReport check_law(const LawType& type, const ConformanceOptions& options = {});

/// The same of a solver, which is given small problems with known answers; see practice.hpp.
ConformanceReport check_solver(const SolverType& type, const ConformanceOptions& options = {});

/// The same of an integrator, which is given a motion that is known; see practice_motion.hpp.
ConformanceReport check_integrator(const IntegratorType& type, const ConformanceOptions& options = {});

/// The same of a strategy, which is given searches of small scenes; see practice_search.hpp.
ConformanceReport check_strategy(const StrategyType& type, const ConformanceOptions& options = {});

/// The same of the file that a plugin came from.
ConformanceReport check_file(const std::filesystem::path& file);

/// The check that is being made, for those who must explain a crash; null between checks.
const char* check_under_way();

/// Names of all checks, in the order they are made: of elements, of laws, of solvers, of integrators, of
/// strategies.
std::vector<std::string> conformance_checks();
std::vector<std::string> law_checks();
std::vector<std::string> solver_checks();
std::vector<std::string> integrator_checks();
std::vector<std::string> strategy_checks();

/// One line per failed check; empty when all passed.
std::string failures(const ConformanceReport& report);

}  // namespace netloft
