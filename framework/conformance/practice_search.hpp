// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/conformance/practice.hpp"

#include <map>
#include <memory>

namespace netloft::conformance {

/// Fills memory that nobody may write.
inline constexpr char kUntouched = 0x5a;

/// A scene for strategies to practise on.
struct PracticeScene {
  Practice like = {};
  std::uint32_t levels = 1;        // meshes, each with half as many masses as the one before
  double budget = 2000;            // work of the search
  int interrupted_at = -1;         // number of the stage in which the user interrupts, from 0; -1: never
  bool breaks = false;             // every stage ends in an error of the host
  bool others_decline = false;     // every other strategy returns at once: it finds nothing to do
  bool knows_growth = true;        // the disturbance that grows is handed out
  std::uint32_t claims = 0;        // traits of the search beyond those that the problem has
  std::vector<double> start = {};  // empty: from the sketch
  std::string by = {};             // type of the strategy that practises, if it may not call itself
};

/// What a strategy has done that it must not, by the promise that it breaks.
enum class Slip {
  stage_without_name,
  stage_not_filled,  // size of a struct, or no displacements
  out_of_range,      // a level, a factor or a limit
  calls_itself,      // on the scene itself, from its start, with its defaults
  over_budget,       // a stage was offered more work than is left
  start_no_number,
  answer_no_number,
  answer_of_variant,
  after_interrupt,  // a stage was asked for after one had said that the user interrupts
  after_budget      // a stage was asked for although no work was left, and the strategy knew
};

/// A search of a practice problem: the chain of practice.hpp, its variants and its coarser meshes, solved by
/// Newton's method with whole steps and |K| in place of an indefinite K,
///   u ← u − |K|⁻¹ r.
/// An iteration on the finest mesh costs 1, on the next 1/2, and so on; every stage and every assessment
/// costs a tenth of that besides; once the user has interrupted no work is left. The cap on stiffness lowers
/// k and S, the factor on the current lowers s and half of f. It offers no members. All that is asked and
/// answered is kept, to be judged.
class PracticeSearch {
 public:
  explicit PracticeSearch(const PracticeScene& scene);
  PracticeSearch(const PracticeSearch&) = delete;
  PracticeSearch& operator=(const PracticeSearch&) = delete;

  netloft_search& interface() { return interface_; }
  const PracticeScene& scene() const { return scene_; }
  std::uint32_t traits() const { return interface_.traits; }

  const std::vector<std::vector<double>>& answers() const { return answers_; }
  /// Largest residual of the scene itself over its load, of the best answer; infinite if there is none.
  double imbalance() const;
  /// Whether an equilibrium of the scene itself was met that no answer is as good as: a stable one where no
  /// answer is stable, or any where none is an equilibrium.
  bool has_kept_an_equilibrium() const;
  /// The first sentence about a slip; empty if there was none.
  std::string slip(Slip kind) const;
  std::string any_slip() const { return slips_.empty() ? "" : slips_.begin()->second; }
  /// Whether the start, the struct of the search and what lies behind the message are as they were.
  bool is_left_alone() const;
  /// All that was asked and answered, bit by bit.
  const std::string& trace() const { return trace_; }

  /// Stages after which the host ends a strategy that goes round in circles, by an error.
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
  std::unique_ptr<PracticeProblem> own_;  // of a strategy that brings a method of its own
  double own_cost_ = 1;                   // of its factorisations
  double spent_ = 0;
  bool interrupted_ = false, knows_interrupt_ = false, knows_budget_ = false;
  std::vector<std::vector<double>> answers_, of_variants_;  // points of the scene; equilibria of variants
  Rank met_;                                                // best equilibrium of the scene in any stage
  std::map<Slip, std::string> slips_;
  std::string trace_, message_;
};

}  // namespace netloft::conformance
