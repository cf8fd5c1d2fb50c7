// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/search/known_stages.hpp"
#include "framework/search/search.hpp"

namespace netloft {

/// Data that all strategies of a search share: the variants, the solvers, and the records and work of all
/// stages.
class SearchHost {
 public:
  SearchHost(const VariantSource& source, const SearchOptions& options);

  VariantProblems& variant_problems() { return variant_problems_; }
  const SearchOptions& options() const { return options_; }
  double spent() const { return cost_.work + repeated_; }
  /// Whether the user interrupted the search or its time is over.
  bool is_interrupted() const;
  bool is_out_of_time() const { return seconds_left() == 0; }

  /// The solver of a stage. Throws std::invalid_argument if its parameters are wrong.
  SolverUse solver_of(const netloft_stage& stage) const;
  /// Parameters that the user gave for a solver or strategy of this type.
  Values given_of(const std::string& type) const;
  /// Limits of a stage. The tolerance, the budget, and the limits of iterations and path that a stage sets
  /// are those of the stage; all others are those of the search.
  Limits limits_of(const netloft_stage& stage, const VariantProblem& variant_problem);
  /// Observer of a stage; it stores points of the original scene only.
  Observer observer_of(const netloft_stage& stage) const;
  /// The stored result of a request, or nullptr. Using a stored result costs as much work as one evaluation;
  /// otherwise a strategy could repeat a request forever.
  const KnownStage* find_known(const StageRequest& request);
  void keep_known(KnownStage stage);
  /// Solves `stage`, whose variant is relative to the original scene, and stores its record. A stage whose
  /// result is stored is neither solved nor recorded again.
  Solution solve(const netloft_stage& stage, const SolverUse& solver);
  Solution assess(const netloft_stage& stage);
  /// Adds the record of a stage. On input, `stage.work` is the work of its assessment.
  void record(StageRecord stage, const VariantProblem& variant_problem);

  /// Adds the cost and the records of all stages to a solution.
  Solution finish(Solution solution) const;

  /// Counts nested calls of strategies during the lifetime of the object. Throws std::invalid_argument beyond
  /// kDeepestCall, because a strategy that calls itself without end would use up the stack.
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
  double repeated_ = 0;  // work charged for requests whose result was known
  double begun_;
  Cost cost_;
  JudgedPoint judged_;  // the last judged point of the original scene
  int inner_calls_ = 0;
};

}  // namespace netloft
