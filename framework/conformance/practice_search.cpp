// SPDX-License-Identifier: BSD-3-Clause
#include "framework/conformance/practice_search.hpp"

#include "framework/registry/hand_out.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace netloft::conformance {

namespace {

constexpr double kSearchTolerance = 1e-8;        // tolerance of the scene, relative to the load on a mass
constexpr std::uint32_t kIterations = 30;        // limit of iterations of a stage
constexpr double kStageCost = 0.1;               // cost of an assessment, in iterations
constexpr std::size_t kRoom = 256, kGuard = 64;  // size of the message, and of the guard behind it

bool is_finite(const double* u, std::size_t n) {
  return std::all_of(u, u + n, [](double v) { return std::isfinite(v); });
}

double largest_residual(const std::vector<double>& r) {
  double most = 0;
  for (const double v : r) most = std::max(most, std::abs(v));
  return most;
}

/// Interpolates the displacements of a chain at the fraction x of its length. The masses are at 1/n, 2/n … 1;
/// the end at 0 is fixed.
double at_fraction(const double* u, std::uint32_t n, double x) {
  const double place = x * n;
  const auto below = static_cast<std::uint32_t>(place);
  if (below >= n) return u[n - 1];
  const double left = below == 0 ? 0 : u[below - 1];
  return left + (place - below) * (u[below] - left);
}

}  // namespace

PracticeSearch::PracticeSearch(const PracticeScene& scene)
    : scene_(scene), start_(scene.start), message_(kRoom + kGuard, kUntouched) {
  const Practice& like = scene_.like;
  auto& s = interface_;
  s.size = sizeof s;
  s.unknowns = like.unknowns;
  s.levels = scene.levels;
  s.host = this;
  s.traits =
      (like.swirl == 0 ? NETLOFT_CONSERVATIVE | NETLOFT_SYMMETRIC : NETLOFT_SEARCH_FLOWS) | scene.claims;
  s.start = start_.empty() ? nullptr : start_.data();
  s.gear_size = 1;
  s.element_size = 1.0 / std::max(like.unknowns, 1u);
  s.largest_load = like.load;
  s.load = like.load * like.unknowns;
  s.stiffness = std::max(like.stiffness, like.grip);
  s.message = message_.data();
  s.message_size = kRoom;
  message_[0] = 0;
  s.size_of = [](void* host, std::uint32_t level) {
    return static_cast<PracticeSearch*>(host)->size_of(level);
  };
  s.solve = forward<&PracticeSearch::solve, netloft_stage*>;
  s.call = forward<&PracticeSearch::call, const char*, const char*, netloft_stage*>;
  s.transfer = forward<&PracticeSearch::transfer, std::uint32_t, const double*, std::uint32_t, double*>;
  s.assess = forward<&PracticeSearch::assess, netloft_stage*>;
  s.problem = forward<&PracticeSearch::problem, netloft_stage*, netloft_problem*>;
  s.members = [](void* host, netloft_stage*, netloft_members*) {
    return static_cast<PracticeSearch*>(host)->fail("this search has no members");
  };
  s.work_left = [](void* host) { return static_cast<PracticeSearch*>(host)->work_left(); };
  s.answer = forward<&PracticeSearch::answer, const double*>;
  s.bending = [](void*, const double*) { return 0.0; };
  std::memcpy(&as_made_, &interface_, sizeof interface_);
}

// ---------------------------------------------------------------- variants

std::uint32_t PracticeSearch::level_of(const netloft_variant& variant) const {
  return std::min(variant.level, scene_.levels - 1);
}

std::uint32_t PracticeSearch::size_of(std::uint32_t level) const {
  const std::uint32_t deflections = scene_.like.buckling > 0 && scene_.like.unknowns > 0 ? 1 : 0;
  const std::uint32_t masses = scene_.like.unknowns - deflections;
  return (masses >> std::min(level, scene_.levels - 1)) + deflections;
}

/// The chain of a variant. Each coarser mesh has half as many masses with twice the load, on springs of twice
/// the length.
Practice PracticeSearch::practice(const netloft_variant& v) const {
  Practice like = scene_.like;
  const double coarser = std::exp2(level_of(v)), cap = v.stiffness_cap > 0 ? v.stiffness_cap : HUGE_VAL;
  const double current = interface_.traits & NETLOFT_SEARCH_FLOWS ? v.current : 1;
  like.unknowns = size_of(v.level);
  like.stiffness = std::min(like.stiffness, cap) / coarser;
  like.grip = std::min(like.grip, cap) * coarser;
  like.load *= coarser * (1 + current) / 2;
  like.swirl *= current;
  return like;
}

bool PracticeSearch::is_scene(const netloft_variant& v) const {
  const Practice variant = practice(v), &own = scene_.like;
  return level_of(v) == 0 && variant.stiffness == own.stiffness && variant.grip == own.grip &&
         variant.load == own.load && variant.swirl == own.swirl;
}

double PracticeSearch::tolerance_of(const netloft_stage& s) {
  return s.tolerance > 0 ? s.tolerance : kSearchTolerance;
}

// ---------------------------------------------------------------- requests

void PracticeSearch::check_variant(const netloft_variant& v) {
  const auto is_factor = [](double x) { return x >= 0 && x <= 1; };
  if (v.level >= scene_.levels)
    note(Slip::out_of_range,
         "requests level " + std::to_string(v.level) + " of " + std::to_string(scene_.levels));
  if (!(v.stiffness_cap >= 0))
    note(Slip::out_of_range, "caps stiffness at " + std::to_string(v.stiffness_cap) + " N");
  if (!is_factor(v.compression) || !is_factor(v.current))
    note(Slip::out_of_range, "requests a factor on compression or current outside [0, 1]");
}

void PracticeSearch::check_request(const netloft_stage& s) {
  if (s.size != sizeof s || s.variant.size != sizeof s.variant)
    note(Slip::stage_not_filled, "passes a stage or a variant without its size");
  check_variant(s.variant);
  if (!(s.tolerance >= 0) || !(s.path >= 0))
    note(Slip::out_of_range, "requests a tolerance or a path that is negative or not a number");
  if (!(s.work >= 0 && s.work <= left() * (1 + 1e-12)))
    note(Slip::over_budget,
         "offers " + std::to_string(s.work) + " of work to a stage, " + std::to_string(left()) + " are left");
  if (s.u && !is_finite(s.u, size_of(s.variant.level)))
    note(Slip::start_no_number,
         std::string("starts \"") + (s.name ? s.name : "") + "\" from displacements that are not finite");
}

void PracticeSearch::check_order() {
  if (knows_interrupt_) note(Slip::after_interrupt, "requests a stage after an interrupt by the user");
  if (knows_budget_) note(Slip::after_budget, "requests a stage after the work was used up");
}

/// Checks a requested stage. Returns whether a host must refuse it.
bool PracticeSearch::is_refused(const netloft_stage& s) {
  end_own_method();
  check_order();
  check_request(s);
  if (!s.name || !*s.name) note(Slip::stage_without_name, "a stage has no name");
  if (!s.u && size_of(s.variant.level) > 0)
    note(Slip::stage_not_filled, "passes a stage without displacements");
  remember(s);
  return ++stages >= kMostStages || scene_.breaks || (!s.u && size_of(s.variant.level) > 0);
}

void PracticeSearch::remember(const void* bytes, std::size_t count) {
  if (count > 0) trace_.append(static_cast<const char*>(bytes), count);
}

void PracticeSearch::remember(const netloft_stage& s) {
  const double numbers[] = {double(s.variant.level),
                            s.variant.stiffness_cap,
                            s.variant.compression,
                            s.variant.current,
                            s.tolerance,
                            s.work,
                            s.path,
                            double(s.iterations),
                            double(s.flags)};
  remember(numbers, sizeof numbers);
  for (const char* text : {s.name, s.solver, s.parameters}) trace_ += text ? text : "";
  if (s.u) remember(s.u, size_of(s.variant.level) * sizeof(double));
}

// ---------------------------------------------------------------- stages

int PracticeSearch::fail(const char* sentence) {
  std::snprintf(message_.data(), kRoom, "%s", sentence);
  return NETLOFT_ERROR;
}

PracticeSearch::Rank PracticeSearch::rank(const PracticeProblem& problem, const double* u,
                                          double tolerance) const {
  const std::vector<double> point(u, u + problem.size());
  const bool balanced = is_finite(u, point.size()) && problem.imbalance(point) <= tolerance;
  return {balanced, balanced && !problem.is_unstable(u)};
}

int PracticeSearch::solve(netloft_stage* stage) {
  if (is_refused(*stage)) return fail("the host broke down");
  stage->spent = 0;
  stage->iterations_done = stage->factorisations = 0;
  PracticeProblem problem(practice(stage->variant));
  interrupted_ = interrupted_ || stages - 1 == scene_.interrupted_at;
  judge(problem, *stage, interrupted_ ? NETLOFT_ENDED_INTERRUPTED : step_to_balance(problem, *stage));
  return NETLOFT_OK;
}

/// Whether a strategy calls itself in the same way as it was called; such calls would never end.
bool PracticeSearch::is_itself(std::string strategy, const char* parameters,
                               const netloft_stage& stage) const {
  if (strategy.find('/') == std::string::npos) strategy += "/" + strategy;
  if (strategy != scene_.by || (parameters && *parameters) || !is_scene(stage.variant) || !stage.u)
    return false;
  const std::size_t size = size_of(0);
  return start_.empty() ? std::all_of(stage.u, stage.u + size, [](double u) { return u == 0; })
                        : std::equal(start_.begin(), start_.end(), stage.u);
}

/// Pretends to run another strategy: solves one stage, or returns at once without any work.
int PracticeSearch::call(const char* strategy, const char* parameters, netloft_stage* stage) {
  if (!strategy || !*strategy) note(Slip::out_of_range, "calls a strategy without a name");
  if (strategy && is_itself(strategy, parameters, *stage))
    note(Slip::calls_itself, "calls itself without end on the scene itself, from its start");
  for (const char* text : {strategy, parameters}) trace_ += text ? text : "";
  if (!scene_.others_decline) return solve(stage);
  if (is_refused(*stage)) return fail("the host broke down");
  stage->ending = NETLOFT_ENDED_OUT_OF_WORK;
  stage->stability = NETLOFT_STABILITY_UNKNOWN;
  stage->spent = stage->residual = stage->load = stage->energy = 0;
  stage->growing = nullptr;
  return NETLOFT_OK;
}

netloft_ending PracticeSearch::step_to_balance(PracticeProblem& problem, netloft_stage& stage) {
  netloft_problem& p = problem.interface();
  const double cost = std::exp2(-double(level_of(stage.variant)));
  const double budget = stage.work > 0 ? std::min(stage.work, left()) : left();
  const std::uint32_t limit = stage.iterations > 0 ? stage.iterations : kIterations;
  const double tolerance = tolerance_of(stage) * problem.load();
  const double path = stage.path > 0 ? stage.path * interface_.gear_size : HUGE_VAL;
  std::vector<double> u(stage.u, stage.u + p.unknowns), r(u.size()), moved(u.size());
  for (stage.spent = kStageCost * cost;; stage.spent += cost) {
    if (p.evaluate(&problem, NETLOFT_WANT_FORCE | NETLOFT_WANT_CONVEX, u.data(), nullptr, r.data()) !=
        NETLOFT_OK)
      return NETLOFT_ENDED_NOT_CONVERGED;
    std::copy(u.begin(), u.end(), stage.u);
    if (largest_residual(r) <= tolerance) return NETLOFT_ENDED_CONVERGED;
    if (stage.iterations_done == limit || stage.spent + cost > budget) return NETLOFT_ENDED_OUT_OF_WORK;
    ++stage.iterations_done;
    ++stage.factorisations;
    if (p.factorise(&problem, NETLOFT_CONVEX | NETLOFT_INDEFINITE, 0) != NETLOFT_FACTOR_OK)
      return NETLOFT_ENDED_NOT_CONVERGED;
    p.solve(&problem, r.data(), r.data());
    for (std::size_t i = 0; i < u.size(); ++i) {
      u[i] -= r[i];
      moved[i] += std::abs(r[i]);
    }
    if (largest_residual(moved) > path) return NETLOFT_ENDED_UNSETTLED;
  }
}

/// Writes the result of a stage to `s`. If the result reports an interrupt or an exhausted budget, the
/// strategy is expected to know it from now on.
void PracticeSearch::judge(const PracticeProblem& problem, netloft_stage& s, netloft_ending ending) {
  const std::vector<double> u(s.u, s.u + size_of(s.variant.level));
  const Rank found = rank(problem, s.u, tolerance_of(s));
  if (found.balanced && ending != NETLOFT_ENDED_INTERRUPTED)
    ending = found.stable ? NETLOFT_ENDED_CONVERGED : NETLOFT_ENDED_UNSTABLE;
  const bool grows = found.balanced && !found.stable;
  s.ending = ending;
  s.stability = grows ? NETLOFT_UNSTABLE : found.balanced ? NETLOFT_STABLE : NETLOFT_STABILITY_UNKNOWN;
  s.load = problem.load();
  s.residual = problem.imbalance(u) * s.load;
  s.energy = problem.energy(s.u);
  s.rounding = 1e-15 * s.load;
  growing_.assign(u.size() + 1, 0.0);
  if (grows) growing_[u.size() - 1] = 1;
  s.growing = grows && scene_.knows_growth ? growing_.data() : nullptr;
  s.growth_rate = s.growing ? 1 : 0;
  s.growth_frequency = 0;
  keep(s, u, problem);
  spend(s.spent);
  knows_interrupt_ = knows_interrupt_ || ending == NETLOFT_ENDED_INTERRUPTED;
  knows_budget_ = knows_budget_ || (ending == NETLOFT_ENDED_OUT_OF_WORK && left() == 0);
}

void PracticeSearch::keep(const netloft_stage& s, const std::vector<double>& u,
                          const PracticeProblem& problem) {
  const Rank found = rank(problem, u.data(), kSearchTolerance);
  if (is_scene(s.variant))
    met_ = {met_.balanced || found.balanced, met_.stable || found.stable};
  else if (found.balanced && level_of(s.variant) == 0)
    of_variants_.push_back(u);
}

int PracticeSearch::assess(netloft_stage* stage) {
  end_own_method();
  check_request(*stage);
  remember(*stage);
  if (!stage->u && size_of(stage->variant.level) > 0) return fail("there is nothing to assess");
  stage->spent = kStageCost * std::exp2(-double(level_of(stage->variant)));
  stage->iterations_done = stage->factorisations = 0;
  const PracticeProblem problem(practice(stage->variant));
  judge(problem, *stage, left() > 0 ? NETLOFT_ENDED_NOT_CONVERGED : NETLOFT_ENDED_OUT_OF_WORK);
  return NETLOFT_OK;
}

/// Hands a problem to a strategy that runs its own method. The budget of the stage, or the remaining work if
/// the stage has none, limits the iterations of that method. Each iteration counts as a factorisation on the
/// mesh of the stage.
int PracticeSearch::problem(netloft_stage* stage, netloft_problem* problem) {
  if (is_refused(*stage)) return fail("the host broke down");
  const double budget = stage->work > 0 ? stage->work : left();
  Practice like = practice(stage->variant);
  interrupted_ = interrupted_ || stages - 1 == scene_.interrupted_at;
  own_cost_ = std::exp2(-double(level_of(stage->variant)));
  like.interrupted_after = interrupted_ ? 1 : std::max(1, static_cast<int>(budget / own_cost_));
  own_ = std::make_unique<PracticeProblem>(like);
  hand_out(own_->interface(), *problem, kFirstProblem);
  problem->u = stage->u;
  return NETLOFT_OK;
}

/// Counts the work of a method that a strategy ran itself, after the method has ended.
void PracticeSearch::end_own_method() {
  // The growing disturbance of the last stage must not be used after this point.
  std::fill(growing_.begin(), growing_.end(), std::numeric_limits<double>::quiet_NaN());
  if (!own_) return;
  spend((std::max(own_->iterations, own_->factorisations) + kStageCost) * own_cost_);
  knows_interrupt_ = knows_interrupt_ || (interrupted_ && own_->told_to_stop());
  own_.reset();
}

// ---------------------------------------------------------------- everything else

int PracticeSearch::transfer(std::uint32_t from, const double* u, std::uint32_t to, double* out) {
  end_own_method();
  if (std::max(from, to) >= scene_.levels)
    note(Slip::out_of_range, "transfers between levels that do not exist");
  const std::uint32_t source = size_of(from), target = size_of(to), bends = scene_.like.buckling > 0 ? 1 : 0;
  if (target == 0) return NETLOFT_OK;
  const std::uint32_t masses = target - bends;
  for (std::uint32_t i = 0; i < masses; ++i)
    out[i] = at_fraction(u, source - bends, (i + 1) / double(masses));
  if (bends) out[masses] = u[source - bends];
  return NETLOFT_OK;
}

/// The remaining work; zero if it is less than the cheapest iteration.
double PracticeSearch::left() const {
  const double left = scene_.budget - spent_;
  return left < (1 + kStageCost) * std::exp2(1 - double(scene_.levels)) ? 0 : left;
}

double PracticeSearch::work_left() {
  end_own_method();
  knows_budget_ = knows_budget_ || (left() == 0 && !interrupted_);
  return interrupted_ ? 0 : left();
}

int PracticeSearch::answer(const double* u) {
  end_own_method();
  const std::size_t n = interface_.unknowns;
  if (!u && n > 0) return fail("an answer without displacements");
  answers_.emplace_back(u, u + n);
  remember(u, n * sizeof(double));
  if (!is_finite(u, n)) note(Slip::answer_no_number, "answers with displacements that are not finite");
  const bool is_of_variant =
      std::find(of_variants_.begin(), of_variants_.end(), answers_.back()) != of_variants_.end();
  if (is_of_variant && !rank(PracticeProblem(scene_.like), u, kSearchTolerance).balanced)
    note(Slip::answer_of_variant, "answers with the equilibrium of an easier variant");
  return NETLOFT_OK;
}

double PracticeSearch::imbalance() const {
  const PracticeProblem scene(scene_.like);
  double least = std::numeric_limits<double>::infinity();
  for (const auto& u : answers_) {
    const double here = scene.imbalance(u);
    least = is_finite(u.data(), u.size()) ? std::min(least, here) : least;
  }
  return least;
}

bool PracticeSearch::has_kept_an_equilibrium() const {
  const PracticeProblem scene(scene_.like);
  Rank best;
  for (const auto& u : answers_) {
    const Rank one = rank(scene, u.data(), kSearchTolerance);
    best = {best.balanced || one.balanced, best.stable || one.stable};
  }
  return (met_.stable && !best.stable) || (met_.balanced && !best.balanced);
}

std::string PracticeSearch::slip(Slip kind) const {
  const auto at = slips_.find(kind);
  return at == slips_.end() ? "" : at->second;
}

bool PracticeSearch::is_left_alone() const {
  const auto behind = message_.begin() + kRoom;
  return std::memcmp(&as_made_, &interface_, sizeof interface_) == 0 && start_ == scene_.start &&
         std::all_of(behind, message_.end(), [](char c) { return c == kUntouched; });
}

}  // namespace netloft::conformance
