// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/ext/strategy.h>

#include "framework/conformance/practice.hpp"

#include <map>
#include <memory>

namespace netloft::conformance {

/// The byte with which checks fill memory that a strategy must not write.
inline constexpr char kUntouched = 0x5a;

/// A scene for the strategies under test.
struct PracticeScene {
  Practice like = {};
  std::uint32_t levels = 1;        // number of meshes, each with half as many masses as the previous one
  double budget = 2000;            // work of the search
  int interrupted_at = -1;         // index of the stage in which the user interrupts; -1: never
  bool breaks = false;             // whether every stage ends with an error of the host
  bool others_decline = false;     // whether every other strategy returns at once, without work
  bool knows_growth = true;        // whether the host provides the growing disturbance
  std::uint32_t claims = 0;        // traits of the search in addition to those of the problem
  std::vector<double> start = {};  // empty: the initial shape
  std::string by = {};             // type of the strategy under test, if it must not call itself
};

/// Mistakes of a strategy, one for each rule that it can break.
enum class Slip {
  stage_without_name,
  stage_not_filled,  // the size of a struct or the displacements are missing
  out_of_range,      // a level of mesh, a factor or a limit is out of range
  calls_itself,      // the strategy calls itself with the same scene, start and parameters
  over_budget,       // a stage was offered more work than is left
  start_no_number,
  answer_no_number,
  answer_of_variant,
  after_interrupt,  // a stage was requested after an earlier stage had reported an interrupt
  after_budget      // a stage was requested although the strategy knew that no work was left
};

/// A search (what a strategy sees) of a practice problem: the chain of practice.hpp, its variants and its
/// coarser meshes, solved by Newton's method with full steps and |K| in place of an indefinite K,
///   u ← u − |K|⁻¹ r.
/// An iteration costs 1 on the finest mesh, 1/2 on the next, and so on; every stage and every assessment
/// costs a tenth in addition. After an interrupt, no work is left. In the symbols of practice.hpp, the cap on
/// stiffness reduces k and S, and the factor on the current reduces s and half of f. The search offers no
/// members. All requests and answers are recorded for the checks.
class PracticeSearch {
 public:
  explicit PracticeSearch(const PracticeScene& scene);
  PracticeSearch(const PracticeSearch&) = delete;
  PracticeSearch& operator=(const PracticeSearch&) = delete;

  netloft_search& interface() { return interface_; }
  const PracticeScene& scene() const { return scene_; }
  std::uint32_t traits() const { return interface_.traits; }

  const std::vector<std::vector<double>>& answers() const { return answers_; }
  /// Largest residual of the best answer in the scene itself, relative to the load; infinite without answer.
  double imbalance() const;
  /// Whether some stage found a better equilibrium of the scene itself than all answers: a stable one if no
  /// answer is stable, or any equilibrium if no answer is an equilibrium.
  bool has_kept_an_equilibrium() const;
  /// A sentence about the first mistake of this kind; empty if there was none.
  std::string slip(Slip kind) const;
  std::string any_slip() const { return slips_.empty() ? "" : slips_.begin()->second; }
  /// Whether the strategy changed neither the start, nor the struct of the search, nor the bytes behind the
  /// message.
  bool is_left_alone() const;
  /// A record of all requests and answers, bit by bit.
  const std::string& trace() const { return trace_; }

  /// A strategy that requests more stages than this counts as never ending and receives errors.
  static constexpr int kMostStages = 10000;
  int stages = 0;  // calls of solve, call and problem

 private:
  struct Rank {
    bool balanced = false, stable = false;
  };

  Practice practice(const netloft_variant& variant) const;
  bool is_scene(const netloft_variant& variant) const;
  std::uint32_t level_of(const netloft_variant& variant) const;
  std::uint32_t size_of(std::uint32_t level) const;
  Rank rank(const PracticeProblem& problem, const double* u, double tolerance) const;

  void note(Slip kind, const std::string& sentence) { slips_.emplace(kind, sentence); }
  void check_request(const netloft_stage& stage);
  void check_variant(const netloft_variant& variant);
  void check_order();
  bool is_itself(std::string strategy, const char* parameters, const netloft_stage& stage) const;
  bool is_refused(const netloft_stage& stage);
  void remember(const void* bytes, std::size_t count);
  void remember(const netloft_stage& stage);

  int solve(netloft_stage* stage);
  int call(const char* strategy, const char* parameters, netloft_stage* stage);
  int transfer(std::uint32_t from, const double* u, std::uint32_t to, double* out);
  int assess(netloft_stage* stage);
  int problem(netloft_stage* stage, netloft_problem* problem);
  double work_left();
  int answer(const double* u);

  netloft_ending step_to_balance(PracticeProblem& problem, netloft_stage& stage);
  static double tolerance_of(const netloft_stage& stage);
  void keep(const netloft_stage& stage, const std::vector<double>& u, const PracticeProblem& problem);
  double left() const;
  void judge(const PracticeProblem& problem, netloft_stage& stage, netloft_ending ending);
  void spend(double work) { spent_ = std::min(scene_.budget, spent_ + work); }
  void end_own_method();
  int fail(const char* sentence);

  template <auto Member, class... Args>
  static int forward(void* host, Args... args) {
    return (static_cast<PracticeSearch*>(host)->*Member)(args...);
  }

  PracticeScene scene_;
  netloft_search interface_{}, as_made_{};
  std::vector<double> start_, growing_;
  std::unique_ptr<PracticeProblem> own_;  // problem of a method that the strategy runs by itself
  double own_cost_ = 1;                   // cost of a factorisation of own_
  double spent_ = 0;
  bool interrupted_ = false, knows_interrupt_ = false, knows_budget_ = false;
  // Answers of the strategy, which are points of the scene itself, and equilibria of variants.
  std::vector<std::vector<double>> answers_, of_variants_;
  Rank met_;  // best equilibrium of the scene itself that any stage found
  std::map<Slip, std::string> slips_;
  std::string trace_, message_;
};

}  // namespace netloft::conformance
