// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/program/session/commands.hpp"
#include "io/program/session/terminal.hpp"
#include "io/results/text/run_text.hpp"
#include "io/runs/prepared_scene.hpp"
#include "io/runs/watch.hpp"

namespace netloft::program {

/// The case that a command line speaks of, with the terminal that tells what is wrong with it: what `run` and
/// `plan` share.
class Session {
 public:
  explicit Session(const Options& options);

  /// Reads, checks and assembles the scene. Anything but kDone: it was said why, stop with that code.
  int open();

  runs::PreparedScene& scene() { return scene_; }
  scenes::LoadedScene& loaded() { return scene_.loaded(); }
  const ScenePlan& plan() const { return scene_.plan(); }
  Assembler& assembler() { return scene_.assembler(); }
  Registry& registry() { return registry_; }
  Terminal& terminal() { return terminal_; }
  results::PlanExtras plan_extras();

 private:
  const Options& options_;
  Terminal terminal_;
  Registry registry_;
  runs::PreparedScene scene_;
};

/// The case of a command line: its scene, --set and --solver.
runs::CaseSource source_of(const Options& options);
int threads_for(const Options& options);

/// The files that a scene was read from.
std::vector<std::string> paths_of(const scenes::LoadedScene& loaded);

/// Says on the terminal, or as JSON, what is wrong with a scene that is not ready. Returns the exit code.
int tell_why_not(const formats::Diagnostics& diagnostics, runs::PreparedScene::State state,
                 const Options& options, Terminal& terminal);

}  // namespace netloft::program
