// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/search/known_stages.hpp"
#include "framework/search/search.hpp"

namespace netloft {

/// All strategies of one search share this: the variants, the solvers, the record of all stages and their
/// work.
class SearchHost {
 public:
  SearchHost(const VariantSource& source, const SearchOptions& options);

  VariantProblems& variant_problems() { return variant_problems_; }
  const SearchOptions& options() const { return options_; }
  double spent() const { return cost_.work + asked_again_; }
  /// By the user, or the user's time is over.
  bool is_interrupted() const;
  bool is_out_of_time() const { return seconds_left() == 0; }

  /// Who solves a stage; throws std::invalid_argument where its parameters are wrong.
  SolverUse solver_of(const netloft_stage& stage) const;
  /// What the user says of a solver or a strategy.
  Values given_of(const std::string& type) const;
  /// What a stage may use: tolerance and budget are those of the stage, by whoever asks for it.
  Limits limits_of(const netloft_stage& stage, const VariantProblem& variant_problem);
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
  void record(StageRecord stage, const VariantProblem& variant_problem);

  /// With the sum and the record of all stages.
  Solution finish(Solution solution) const;

  /// While it lives a strategy is under way that another one called. Throws std::invalid_argument beyond
  /// kDeepestCall: each call stands on the stack of the one before, and a strategy that calls itself without
  /// end would use it up.
  class InnerCall {
   public:
    InnerCall(SearchHost& host, const std::string& strategy);
    ~InnerCall() { --host_.inner_calls_; }
    InnerCall(const InnerCall&) = delete;
    InnerCall& operator=(const InnerCall&) = delete;

   private:
    SearchHost& host_;
  };

 private:
  double seconds_left() const;

  SearchOptions options_;
  VariantProblems variant_problems_;
  KnownStages known_;
  double asked_again_ = 0;  // work
  double begun_;
  Cost cost_;
  JudgedPoint judged_;  // of the scene as it is written
  int inner_calls_ = 0;
};

}  // namespace netloft
