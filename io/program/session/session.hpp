// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/program/session/find_plugins.hpp"
#include "io/program/session/terminal.hpp"
#include "io/results/text/plan_text.hpp"
#include "io/runs/prepared_scene.hpp"
#include "io/runs/watch.hpp"

namespace netloft::program {

/// The scene of a command line, and the terminal for its errors.
class Session {
 public:
  explicit Session(const MethodOptions& options);
  /// `source` replaces the scene that the options name.
  Session(const MethodOptions& options, runs::CaseSource source);

  /// Reads, checks and assembles the scene. Returns kDone; if the scene is not ready, reports the reason and
  /// returns the exit code.
  int open();

  runs::PreparedScene& scene() { return scene_; }
  Terminal& terminal() { return terminal_; }

 private:
  Terminal terminal_;
  bool names_strategy_;
  Registry registry_;
  runs::PreparedScene scene_;
};

/// Throws a UsageError if one change of --set undoes another one completely.
void refuse_undone(const std::vector<std::string>& set);

/// The scene of a command line with the changes of --set and, if the command has them, --strategy and
/// --solver.
runs::CaseSource source_of(const SceneOptions& options);
runs::CaseSource source_of(const MethodOptions& options);

/// Returns `threads`, or the number of cores of the machine if `threads` is 0.
int threads_for(int threads);

/// The files that a scene was read from.
std::vector<std::string> paths_of(const scenes::LoadedScene& loaded);

/// The facts about a prepared scene that the command `plan` prints, except the memory forecast.
results::PlanExtras plan_extras(runs::PreparedScene& scene);

/// Reports on the terminal, and as JSON, why a scene is not ready. Returns the exit code.
int report_unready(const formats::Diagnostics& diagnostics, runs::PreparedScene::State state,
                   Terminal& terminal);

}  // namespace netloft::program
