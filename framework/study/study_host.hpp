// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/study/known_stages.hpp"
#include "framework/study/member_problem.hpp"
#include "framework/study/shapes.hpp"
#include "framework/study/study.hpp"

#include <memory>
#include <optional>

namespace netloft {

/// What all strategies of one study share: the variants, the solvers, the record of all stages and their
/// work.
class StudyHost {
 public:
  StudyHost(const SiteSource& source, const StudyOptions& options);

  Sites& sites() { return sites_; }
  const StudyOptions& options() const { return options_; }
  double spent() const { return cost_.work + asked_again_; }
  /// By the user, or the user's time is over.
  bool is_interrupted() const;
  bool is_out_of_time() const { return seconds_left() == 0; }

  /// Who solves a stage; throws std::invalid_argument where its parameters are wrong.
  SolverUse solver_of(const netloft_stage& stage) const;
  /// What the user says of a solver or a strategy.
  Values given_of(const std::string& type) const;
  /// What a stage may use: tolerance and budget are those of the stage, by whoever asks for it.
  Limits limits_of(const netloft_stage& stage, const Site& site);
  /// Points of the scene as it is written are kept, of no variant.
  Observer observer_of(const netloft_stage& stage) const;
  /// What came of the same request before; null: nothing is known of it. To be told costs an evaluation: a
  /// strategy that asks for the same without end comes to its end.
  const KnownStage* find_known(const StageRequest& request);
  void keep_known(KnownStage stage);
  /// Solves `stage`, whose variant is seen from the scene as it is written; keeps the record. What is known
  /// is not solved again, and no stage.
  Solution solve(const netloft_stage& stage, const SolverUse& solver);
  /// Judges the point of a stage by a solver that returns at once.
  Solution assess(const netloft_stage& stage);
  /// `stage.work` is what its judgement took.
  void record(StageRecord stage, const Site& site);

  /// With the sum and the record of all stages.
  Solution finish(Solution solution) const;

  /// While it lives a strategy is under way that another one called. Throws std::invalid_argument beyond
  /// kDeepestCall: each call stands on the stack of the one before, and a strategy that calls itself without
  /// end would use it up.
  class InnerCall {
   public:
    InnerCall(StudyHost& host, const std::string& strategy);
    ~InnerCall() { --host_.inner_calls_; }
    InnerCall(const InnerCall&) = delete;
    InnerCall& operator=(const InnerCall&) = delete;

   private:
    StudyHost& host_;
  };

 private:
  double seconds_left() const;

  StudyOptions options_;
  Sites sites_;
  KnownStages known_;
  double asked_again_ = 0;  // work
  double begun_;
  Cost cost_;
  JudgedPoint judged_;  // of the scene as it is written
  int inner_calls_ = 0;
};

/// A study as one strategy sees it: a variant of the scene is its scene, a part of the work its budget, which
/// is told to it in Newton iterations of that scene.
class RunningStudy {
 public:
  /// `tolerance`: of its scene; `work`: in iterations of the scene as it is written, as the host counts.
  RunningStudy(StudyHost& host, const netloft_variant& scene, double tolerance, double work,
               const double* start);
  RunningStudy(const RunningStudy&) = delete;
  RunningStudy& operator=(const RunningStudy&) = delete;

  netloft_study& interface() { return interface_; }
  void run(const StrategyType& type, const void* parameters);

  /// The best answer; where there is none, the stage of the scene itself that came closest.
  Solution best() const;
  /// With why there is none.
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

  StudyHost& host_;
  netloft_variant scene_;
  std::shared_ptr<Site> site_;                // of that
  double tolerance_, budget_, begun_, unit_;  // unit_: an iteration of its scene, in work of the host
  netloft_study interface_{};
  char message_[256] = "";
  std::vector<double> growing_;                        // of the last stage
  std::vector<Solution> stationary_;                   // of the scene itself, not yet answered
  std::optional<Solution> closest_;                    // of those that are no equilibria
  netloft_ending last_ = NETLOFT_ENDED_NOT_CONVERGED;  // of the last stage of the scene itself
  std::string failure_;                                // of the strategy itself, which ended with an error
  int unsettled_ = 0;                                  // stages that did not come to rest
  EquilibriumChoice equilibria_;
  // A method of the strategy's own at work: its stage, and on what.
  netloft_stage open_stage_{};
  std::shared_ptr<Site> open_site_;
  std::unique_ptr<StaticProblem> open_problem_;
  std::unique_ptr<MemberProblem> open_members_;
};

}  // namespace netloft
