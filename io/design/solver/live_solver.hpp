// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/design/live/live_scene.hpp"
#include "io/design/solver/solver_call.hpp"

namespace netloft::design {

/// Answers all requests of a session that need the scene and not only its text. For use by one thread.
class LiveSolver {
 public:
  LiveSolver(const std::filesystem::path& file, Registry& registry, int threads)
      : registry_(registry), threads_(threads), scene_(file, registry, threads) {}

  /// The requests are those of DESIGN.md that need the scene, and some that a session makes:
  ///   follow: the outcome for the texts of the body, with `words`, the number words that are new;
  ///   rerun: the outcome of a run of the last text from its sketch;
  ///   consider: all messages about the plan of other texts;
  ///   points: the points of the plan in the last equilibrium;
  ///   beside: figures and picture of another scene or result, or of this one without a `file`.
  /// Throws WrongRequest, Refused and formats::Interrupted.
  Json answer(const std::string& name, const Json& body, const std::atomic<bool>& interrupt,
              const OnProgress& on_progress);

  /// Sets the function that is told how much processor time a search may take (runs::Watch::on_budget).
  void on_budget(std::function<void(double)> act) { scene_.on_budget = std::move(act); }

 private:
  Json follow(const Json& body, const std::atomic<bool>& interrupt);
  Json beside(const Json& body, const std::atomic<bool>& interrupt);
  Json new_words();

  Registry& registry_;
  int threads_;
  LiveScene scene_;
  std::map<std::string, Json> words_;  // those that were answered
};

}  // namespace netloft::design
