// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/motion/time_march.hpp"
#include "framework/scene/scene_plan.hpp"
#include "framework/search/search.hpp"
#include "io/formats/toml/diagnostics.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

#include <atomic>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace netloft::runs {

class Meshes;

/// Which scene, how it is changed, and who works on it.
struct CaseSource {
  std::filesystem::path file;
  std::vector<std::string> overrides;  // "path=value", as --set takes them
  int threads = 1;                     // of the assembly and of large factorisations
};

/// Who looks on while a case is solved.
struct Watch {
  const std::atomic<bool>* interrupt = nullptr;
  std::function<void(const IterationRecord&)> on_iteration = {};
  KeptPoint* kept = nullptr;  // the best point so far, while it is looked for
  std::function<void(const StageRecord&, std::span<const double> u)> on_stage = {};  // after every stage
  /// After every step in time, with the name of the run.
  std::function<void(const StepRecord&, const std::string& run)> on_step = {};
  /// Told the processor time that is allowed from now on [s]; infinite once it is over.
  std::function<void(double)> on_budget = {};
};

/// A scene on its way from a file to an answer: read, planned, assembled, solved. What `run`, `plan`,
/// `compare` and the suite of hard cases share. Not movable: the assembler stands on the scene.
class Case {
 public:
  enum class State { ready, wrong_input, refused };

  /// `make`: of matrices; cases that share one (keep_analyses) order and analyse a common pattern once.
  Case(CaseSource source, Registry& registry, MakeFactorisation make = {});
  ~Case();
  Case(const Case&) = delete;
  Case& operator=(const Case&) = delete;

  /// Reads, checks and assembles, with `change` between reading and planning: another start, another water.
  /// Unless it is ready, diagnostics() say why not.
  State open(const std::function<void(scenes::LoadedScene&)>& change = {});
  const formats::Diagnostics& diagnostics() const { return diagnostics_; }

  /// Finds the equilibrium as the scene's analysis says, from displacements `from` (empty: its start). What
  /// the scene leaves open (Scene::settings) is then as it was found: its numbers change, and with them the
  /// assembler.
  Solution solve(const Watch& watch = {}, const std::vector<double>& from = {});
  /// Seeks the equilibrium near displacements `u` by the solver of the analysis alone, for no more than
  /// so many iterations.
  Solution continue_from(const std::vector<double>& u, int iterations, const Watch& watch = {});
  /// The same; where that ends at an equilibrium that is not stable, as solve() does from there, and where
  /// none is found, as solve() does.
  Solution solve_from(const std::vector<double>& u, const Watch& watch = {});
  /// How the equilibrium x of this scene moves while the scene becomes `near`, whose values differ by a
  /// little and whose topology is the same, to first order:
  ///   K(x) dx = −(r_near(x) − r(x))                                                      (1)
  /// over all dofs, those of holds included. Nothing if K has no factor or x cannot be evaluated there, and
  /// where more than positions is looked for.
  std::optional<std::vector<double>> tangent_towards(Case& near, const std::vector<double>& x,
                                                     Statistics& spent);
  /// Whether displacements of another case can be used in this one: the same unknowns, numbered alike.
  bool has_topology_of(Case& other);
  /// What a point of the scene is worth that nobody says is an equilibrium, by an assembler of its own: where
  /// a plugin does not come back, that of the case is never free again.
  Solution judge(std::span<const double> u, Assembler& assembler) const;
  std::unique_ptr<Assembler> make_another_assembler() const;
  /// Why the solver of the analysis cannot work on this scene (it needs an energy, say); empty: it can.
  std::optional<std::string> why_unfit();
  /// Which loss factors of materials count in the motion, or why none does; empty: no part has one.
  const std::string& material_damping() const { return material_damping_; }
  /// What the strategy of the analysis would try in which order and why, a line each.
  std::string explain_strategy();

  /// Makes elements remember displacements `u` as the last accepted state.
  void remember(std::span<const double> u);
  /// Goes through time as the scene's analysis says, from its start or from what was kept.
  /// `work` bounds its steps together, in Newton iterations of the scene, or of one of 1000 nodes if that is
  /// larger: steps of small scenes are many and cheap.
  MarchResult march(const MarchWatch& watch, const Watch& who, const MarchState* from = nullptr,
                    double work = std::numeric_limits<double>::infinity());
  MarchResult march(const MarchWatch& watch, const std::atomic<bool>* interrupt = nullptr,
                    const MarchState* from = nullptr) {
    return march(watch, Watch{.interrupt = interrupt}, from);
  }

  /// Positions of all nodes [m], 3 per node of the scene, out of a vector over all dofs.
  std::vector<double> positions(std::span<const double> x) const { return assembler_->node_positions(x); }

  scenes::LoadedScene& loaded() { return loaded_; }
  const scenes::LoadedScene& loaded() const { return loaded_; }
  const CaseSource& source() const { return source_; }
  const ScenePlan& plan() const { return plan_; }
  Assembler& assembler() { return *assembler_; }
  Registry& registry() { return registry_; }
  int threads() const { return source_.threads; }
  /// Makes its factorisations: by its threads, with analyses in common.
  const MakeFactorisation& factorisations() const { return make_; }
  double reading_seconds() const { return reading_seconds_; }
  double setup_seconds() const { return setup_seconds_; }

 private:
  State read();
  State assemble();
  void adopt(const Solution& solution);
  void note_length(const Setting& setting);
  Solution settle(const Watch& watch, const std::vector<double>& from);
  VariantSource variants();
  SearchOptions search_options(const Limits& limits, const Watch& watch);
  StrategyUse strategy();
  /// Displacements of the equilibrium that a motion starts from.
  std::vector<double> find_start(const Watch& who, Solution& found);

  CaseSource source_;
  Registry& registry_;
  formats::Diagnostics diagnostics_;
  scenes::LoadedScene loaded_;
  ScenePlan plan_;
  std::string material_damping_;
  std::unique_ptr<Assembler> assembler_;
  std::unique_ptr<Meshes> meshes_;
  MakeFactorisation make_;  // of one pattern in all stages
  double reading_seconds_ = 0, setup_seconds_ = 0;
};

/// What `--solver newton:method=classic` and `--strategy auto:restarts=6` stand for: analysis.solver and
/// analysis.newton.method as overrides. `key` is "solver" or "strategy". Throws std::invalid_argument with a
/// sentence when the specification is not understood.
std::vector<std::string> overrides_of(const std::string& key, const std::string& specification);

}  // namespace netloft::runs
