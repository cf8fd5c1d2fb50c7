// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/search/member_problem.hpp"
#include "framework/search/search_host.hpp"
#include "framework/search/shapes.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace netloft {

/// One strategy's search for the equilibrium of a scene. If another strategy called this one, the scene can
/// be a variant of the original scene, and the budget is part of the total budget. The unit of the budget is
/// a Newton iteration of the strategy's own scene.
class RunningSearch {
 public:
  /// `tolerance` is the tolerance for the scene of the strategy; `work` is the budget in Newton iterations of
  /// the original scene.
  RunningSearch(SearchHost& host, const netloft_variant& scene, double tolerance, double work,
                const double* start);
  RunningSearch(const RunningSearch&) = delete;
  RunningSearch& operator=(const RunningSearch&) = delete;

  netloft_search& interface() { return interface_; }
  void run(const StrategyType& type, const void* parameters);
  /// The reason why a strategy cannot search this scene; nullopt if it can.
  std::optional<std::string> why_unfit(const StrategyType& type) const;

  /// The best answer; if there is none, the stage of the scene itself that came closest to balance.
  Solution best() const;
  /// Returns best(). If the strategy gave no answer, the result says why.
  Solution explained() const;
  /// Whether some stage of the scene itself has been solved.
  bool has_any() const { return equilibria_.has_any() || closest_.has_value(); }

  std::uint32_t size_of(std::uint32_t level);
  int solve(netloft_stage* stage);
  int call(const char* strategy, const char* parameters, netloft_stage* stage);
  int transfer(std::uint32_t from, const double* u, std::uint32_t to, double* out);
  int assess(netloft_stage* stage);
  int problem(netloft_stage* stage, netloft_problem* problem);
  int members(netloft_stage* stage, netloft_members* members);
  double work_left() const;
  netloft_ending ending() const;
  int answer(const double* u);
  double bending(const double* u);
  void keep_message(const char* text);

 private:
  void fill_interface(const double* start);
  KnownStage run_inner(const StrategyType& type, const void* parameters, const netloft_stage& seen,
                       StageRequest request);
  netloft_stage seen_from_host(const netloft_stage& stage);
  bool is_scene_itself(const netloft_stage& stage) const;
  void keep(const netloft_stage& stage, const Solution& solution);
  void fill(netloft_stage& stage, const Solution& solution, double spent);
  void close();

  SearchHost& host_;
  netloft_variant scene_;
  std::shared_ptr<VariantProblem> variant_problem_;  // the problem of scene_
  // unit_: work of one iteration of scene_, in iterations of the original scene.
  double tolerance_, budget_, begun_, unit_;
  netloft_search interface_{};
  char message_[256] = "";
  std::vector<double> growing_;                        // growing disturbance of the last stage
  std::vector<Solution> stationary_;                   // equilibria of the scene itself, not yet reported
  std::optional<Solution> closest_;                    // the point closest to balance
  netloft_ending last_ = NETLOFT_ENDED_NOT_CONVERGED;  // ending of the last stage of the scene itself
  std::string failure_;                                // why the strategy failed; empty if it did not
  int unsettled_ = 0;                                  // number of stages that did not come to rest
  EquilibriumChoice equilibria_;
  // The method that the strategy is running by itself, with its stage and problem.
  netloft_stage open_stage_{};
  std::shared_ptr<VariantProblem> open_variant_;
  std::unique_ptr<StaticProblem> open_problem_;
  std::unique_ptr<MemberProblem> open_members_;
};

}  // namespace netloft
