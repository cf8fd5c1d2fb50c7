// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/continuation/journey.hpp"
#include "framework/problem/time_march.hpp"
#include "framework/problem/verdict.hpp"
#include "framework/scene/plan.hpp"
#include "io/scene/loaded_scene.hpp"
#include "io/toml/diagnostics.hpp"

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace netloft::io {

/// Which scene, how it is changed, and who works on it.
struct CaseSource {
  std::filesystem::path file;
  std::vector<std::string> overrides;  // "path=value", as --set takes them
  int threads = 1;                     // of the assembly
};

/// Who looks on while a case is solved.
struct Watch {
  const std::atomic<bool>* interrupt = nullptr;
  std::function<void(const IterationRecord&)> on_iteration;
  bool detours = true;  // over easier scenes, where the analysis allows continuation
};

/// A scene on its way from a file to an answer: read, planned, assembled, solved. What `run`, `plan`,
/// `compare` and `stability` share. Not movable: the assembler stands on the scene.
class Case {
 public:
  enum class State { ready, wrong_input, refused };

  Case(CaseSource source, Registry& registry);
  Case(const Case&) = delete;
  Case& operator=(const Case&) = delete;

  /// Reads, checks and assembles, with `change` between reading and planning: another start, another water.
  /// Unless it is ready, diagnostics() say why not.
  State open(const std::function<void(LoadedScene&)>& change = {});
  const Diagnostics& diagnostics() const { return diagnostics_; }

  /// Solves as the scene's analysis says, from its start.
  Solution solve(const Watch& watch = {});

  /// Goes through time as the scene's analysis says, from its start or from what was kept.
  MarchResult march(const MarchWatch& watch, const std::atomic<bool>* interrupt = nullptr,
                    const MarchState* from = nullptr);

  /// Positions of all nodes [m], 3 per node of the scene, out of a vector over all dofs.
  std::vector<double> positions(std::span<const double> x) const;

  /// An interior-point method is to find the start that the solver gets (cone_use.hpp).
  bool begins_in_cones() const;

  LoadedScene& loaded() { return loaded_; }
  const LoadedScene& loaded() const { return loaded_; }
  const Plan& plan() const { return plan_; }
  Assembler& assembler() { return *assembler_; }
  Registry& registry() { return registry_; }
  int threads() const { return source_.threads; }
  double reading_seconds() const { return reading_seconds_; }
  double setup_seconds() const { return setup_seconds_; }

 private:
  State read();
  State assemble();
  Solution solve_plainly(const Watch& watch);
  std::optional<SolverUse> nearby(SolverUse solver) const;
  Solution solve_by_journey(const Watch& watch);
  Solution settle(const Watch& watch);
  Solution find_equilibrium(const std::atomic<bool>* interrupt, double tolerance);
  std::optional<std::vector<double>> start_in_cones(const Watch& watch, const std::vector<double>& from,
                                                    const Limits& limits, std::vector<Leg>& legs);
  std::vector<double> start_in_stages(const Watch& watch, std::vector<Leg>& legs);
  std::vector<double> start_from_coarser(const std::function<Solution(Case&)>& solve, double seconds,
                                         std::vector<Leg>& legs);

  CaseSource source_;
  Registry& registry_;
  Diagnostics diagnostics_;
  LoadedScene loaded_;
  Plan plan_;
  std::unique_ptr<Assembler> assembler_;
  MakeFactorisation make_;  // of one pattern in all stages
  double reading_seconds_ = 0, setup_seconds_ = 0;
};

/// What `--solver newton:method=classic` stands for: analysis.solver and analysis.newton.method as
/// overrides. Throws std::invalid_argument with a sentence when the word is not understood.
std::vector<std::string> solver_overrides(const std::string& word);

}  // namespace netloft::io
