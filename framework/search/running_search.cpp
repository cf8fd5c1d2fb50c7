// SPDX-License-Identifier: BSD-3-Clause
#include "framework/search/running_search.hpp"

#include "framework/judging/reasons.hpp"
#include "framework/registry/hand_out.hpp"
#include "framework/registry/host_function.hpp"
#include "framework/registry/plugin_call.hpp"
#include "framework/search/bending.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace netloft {

namespace {

netloft_ending ending_of(const Solution& s) {
  switch (s.status) {
    case SolveStatus::converged:
      return NETLOFT_ENDED_CONVERGED;
    case SolveStatus::unstable:
      return NETLOFT_ENDED_UNSTABLE;
    case SolveStatus::interrupted:
      return NETLOFT_ENDED_INTERRUPTED;
    default:
      break;
  }
  switch (s.run.stop) {
    case Stop::time:
    case Stop::interrupted:
      return NETLOFT_ENDED_INTERRUPTED;
    case Stop::work:
    case Stop::iterations:
      return NETLOFT_ENDED_OUT_OF_WORK;
    case Stop::unsettled:
    case Stop::ran_away:
      return NETLOFT_ENDED_UNSETTLED;
    default:
      return NETLOFT_ENDED_NOT_CONVERGED;
  }
}

std::uint32_t stability_of(const Solution& s) {
  switch (s.stability) {
    case Stability::stable:
      return NETLOFT_STABLE;
    case Stability::neutral:
      return NETLOFT_NEUTRAL;
    case Stability::marginal:
      return NETLOFT_MARGINAL;
    case Stability::local:
      return NETLOFT_LOCALLY_UNSTABLE;
    case Stability::swinging:
    case Stability::unstable:
      return NETLOFT_UNSTABLE;
    default:
      return NETLOFT_STABILITY_UNKNOWN;
  }
}

/// Names the traits: "conservative, members".
std::string traits_of_search(std::uint32_t traits) {
  std::string text = describe_traits(traits & (NETLOFT_CONSERVATIVE | NETLOFT_SYMMETRIC));
  const std::pair<std::uint32_t, const char*> all[] = {{NETLOFT_SEARCH_REMEMBERS, "elements that remember"},
                                                       {NETLOFT_SEARCH_FLOWS, "a current"},
                                                       {NETLOFT_SEARCH_COMPRESSION, "stiffness when slack"},
                                                       {NETLOFT_SEARCH_MEMBERS, "members that bear tension"},
                                                       {NETLOFT_SEARCH_BENDING, "resistance to bending"}};
  for (const auto& [trait, name] : all)
    if (traits & trait) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

std::size_t count_members(const Assembler& assembler) {
  std::size_t count = 0;
  for (const auto& family : assembler.families())
    if (family->reads(NETLOFT_OF_MEMBERS)) count += family->size() * family->type().members.count;
  return count;
}

std::uint32_t traits_of_scene(const VariantProblem& of, Registry& registry) {
  std::uint32_t traits = traits_of(*of.assembler);
  if (!of.assembler->memory().empty()) traits |= NETLOFT_SEARCH_REMEMBERS;
  if (of.scene->current.flows()) traits |= NETLOFT_SEARCH_FLOWS;
  if (resists_compression(*of.scene, registry)) traits |= NETLOFT_SEARCH_COMPRESSION;
  if (resists_bending(*of.assembler)) traits |= NETLOFT_SEARCH_BENDING;
  if (MemberProblem::serves(*of.scene, *of.assembler)) traits |= NETLOFT_SEARCH_MEMBERS;
  return traits;
}

int call_strategy(const StrategyType& type, const void* parameters, netloft_search& search) {
  netloft_search seen = search;
  const int status = call_plugin({type.type.c_str(), "run", nullptr, CallFrame::Kind::method},
                                 int{NETLOFT_ERROR}, [&] { return type.strategy.run(parameters, &seen); });
  return take_broken_rule({search.message, search.message_size}) ? int{NETLOFT_ERROR} : status;
}

double imbalance(const Solution& s) {
  const double ratio = s.balance.residual / s.balance.scale;
  return std::isfinite(ratio) ? ratio : std::numeric_limits<double>::infinity();
}

}  // namespace

RunningSearch::RunningSearch(SearchHost& host, const netloft_variant& scene, double tolerance, double work,
                             const double* start)
    : host_(host),
      scene_(scene),
      variant_problem_(host.variant_problems().at(scene)),
      tolerance_(tolerance),
      budget_(work),
      begun_(host.spent()),
      unit_(variant_problem_->model.of_iteration() / variant_problem_->model.unit),
      equilibria_(*variant_problem_->scene, *variant_problem_->assembler,
                  Scales(*variant_problem_->assembler).gear_size(),
                  traits_of(*variant_problem_->assembler) & NETLOFT_CONSERVATIVE) {
  fill_interface(start);
}

void RunningSearch::fill_interface(const double* start) {
  Scales scales(*variant_problem_->assembler);
  Registry& registry = *host_.variant_problems().source().registry;
  netloft_search& s = interface_;
  s.size = sizeof s;
  s.host = this;
  s.start = start;
  s.unknowns = static_cast<std::uint32_t>(variant_problem_->assembler->pattern().size);
  s.levels = std::max(1u, host_.variant_problems().most_levels() -
                              std::min(scene_.level, host_.variant_problems().most_levels()));
  s.traits = traits_of_scene(*variant_problem_, registry);
  s.member_count = static_cast<std::uint32_t>(count_members(*variant_problem_->assembler));
  s.gear_size = scales.gear_size();
  s.element_size = scales.element_size();
  const auto load = scales.driving_load();
  s.load = load.sum;
  s.largest_load = load.largest;
  s.stiffness = largest_stiffness(*variant_problem_->scene, registry);
  s.message = message_;
  s.message_size = sizeof message_;

  s.size_of = HostFunction<&RunningSearch::size_of>::call;
  s.solve = HostFunction<&RunningSearch::solve>::call;
  s.call = HostFunction<&RunningSearch::call>::call;
  s.transfer = HostFunction<&RunningSearch::transfer>::call;
  s.assess = HostFunction<&RunningSearch::assess>::call;
  s.problem = HostFunction<&RunningSearch::problem>::call;
  s.members = HostFunction<&RunningSearch::members>::call;
  s.work_left = [](void* search) {
    const HostCall back;
    return static_cast<RunningSearch*>(search)->work_left();
  };
  s.answer = HostFunction<&RunningSearch::answer>::call;
  s.bending = [](void* search, const double* u) {
    const HostCall back;
    return static_cast<RunningSearch*>(search)->bending(u);
  };
}

void RunningSearch::keep_message(const char* text) { std::snprintf(message_, sizeof message_, "%s", text); }

std::optional<std::string> RunningSearch::why_unfit(const StrategyType& type) const {
  const std::uint32_t lacking = type.strategy.needs & ~interface_.traits;
  if (!lacking) return {};
  return "the strategy " + type.type +
         " needs features that this scene does not have: " + traits_of_search(lacking);
}

void RunningSearch::run(const StrategyType& type, const void* parameters) {
  if (const auto why = why_unfit(type)) throw std::invalid_argument(*why);
  const int status = call_strategy(type, parameters, interface_);
  close();
  if (status == NETLOFT_OK) return;
  // If nested strategies fail for the same reason, the message names the innermost one.
  const std::string failed = "the strategy ", why = message_;
  failure_ = why.starts_with(failed) ? why : failed + type.type + " failed" + (why.empty() ? "" : ": ") + why;
  if (!has_any()) throw std::runtime_error(failure_);
}

/// The best point so far. If the strategy failed, the status of this point is not_converged.
Solution RunningSearch::best() const {
  Solution s = equilibria_.has_any() ? equilibria_.best() : closest_.value_or(Solution{});
  if (!has_any()) s.reason = "the strategy solved no stage of the scene itself";
  if (!has_any() && message_[0]) s.reason += std::string(": ") + message_;
  if (!failure_.empty()) {
    s.reason = failure_ + (has_any() ? "; " + s.reason : "");
    if (is_stationary(s)) s.status = SolveStatus::not_converged;
  }
  if (!is_stationary(s)) s.does_not_settle = unsettled_ > 0 && !(interface_.traits & NETLOFT_CONSERVATIVE);
  return s;
}

/// Returns the best point. If strategies are nested, only the outermost one adds why the search ended. It
/// adds nothing if the last stage already reports that the budget or the time is used up. After an interrupt
/// between two stages, the status is `interrupted`.
Solution RunningSearch::explained() const {
  Solution s = best();
  if (is_stationary(s) && equilibria_.has_any()) return s;
  if (host_.is_interrupted() && !host_.is_out_of_time() && s.status != SolveStatus::interrupted) {
    s.status = SolveStatus::interrupted;
    s.reason = "interrupted; " + s.reason;
  }
  if (s.does_not_settle) s.reason += "; a simulation in time did not come to rest";
  const bool was_cut_off = s.run.stop == Stop::work, is_used_up = work_left() == 0;
  if (is_used_up && !was_cut_off && !host_.is_interrupted()) s.reason += "; the budget of work is used up";
  if (was_cut_off && !is_used_up) s.reason += "; the strategy ended with work left";
  if (host_.is_out_of_time() && s.reason.find(kTimeIsOver) == std::string::npos)
    s.reason += "; " + std::string(kTimeIsOver);
  return s;
}

std::uint32_t RunningSearch::size_of(std::uint32_t level) {
  const auto variant_problem = host_.variant_problems().find_level(scene_.level + level);
  return variant_problem ? static_cast<std::uint32_t>(variant_problem->assembler->pattern().size) : 0;
}

/// Returns how the strategy ended: the ending of the stage that found the equilibrium or, without an
/// equilibrium, of the last stage of the scene itself. (The stage closest to balance does not count, because
/// a later stage may have been cut off.) A strategy that solved no stage of its scene although work was left
/// has not run out of work.
netloft_ending RunningSearch::ending() const {
  const Solution found = best();
  if (is_stationary(found)) return ending_of(found);
  if (host_.is_interrupted()) return NETLOFT_ENDED_INTERRUPTED;
  if (work_left() == 0) return NETLOFT_ENDED_OUT_OF_WORK;
  return failure_.empty() ? last_ : NETLOFT_ENDED_NOT_CONVERGED;
}

double RunningSearch::work_left() const {
  return host_.is_interrupted() ? 0 : std::max(0.0, budget_ - (host_.spent() - begun_)) / unit_;
}

/// Checks a stage, and converts its variant and its work: the variant becomes relative to the original scene,
/// and the unit of work becomes a Newton iteration of that scene.
netloft_stage RunningSearch::seen_from_host(const netloft_stage& stage) {
  const netloft_variant& v = stage.variant;
  const bool is_fraction = v.compression >= 0 && v.compression <= 1 && v.current >= 0 && v.current <= 1;
  if (!is_fraction || !(v.stiffness_cap >= 0))
    throw std::invalid_argument("a variant needs factors in [0, 1] and a cap that is not negative");
  if (!host_.variant_problems().find_level(scene_.level + v.level))
    throw std::invalid_argument("there is no level " + std::to_string(v.level));
  netloft_stage seen = stage;
  seen.variant = combined(scene_, v);
  seen.tolerance = std::max(stage.tolerance, tolerance_);
  seen.work = unit_ * (stage.work > 0 ? std::min(stage.work, work_left()) : work_left());
  if (!seen.name) seen.name = "";
  return seen;
}

/// Whether a stage solves the scene of this strategy (no easier variant) to the tolerance of an answer.
bool RunningSearch::is_scene_itself(const netloft_stage& stage) const {
  return is_as_written(stage.variant) && stage.tolerance <= tolerance_;
}

int RunningSearch::solve(netloft_stage* stage) {
  close();
  const double before = host_.spent();
  const Solution s = host_.solve(seen_from_host(*stage), host_.solver_of(*stage));
  if (is_scene_itself(*stage)) {
    keep(*stage, s);
    last_ = ending_of(s);
  }
  fill(*stage, s, host_.spent() - before);
  return NETLOFT_OK;
}

int RunningSearch::assess(netloft_stage* stage) {
  close();
  const double before = host_.spent();
  const Solution s = host_.assess(seen_from_host(*stage));
  if (is_scene_itself(*stage)) keep(*stage, s);
  fill(*stage, s, host_.spent() - before);
  return NETLOFT_OK;
}

int RunningSearch::call(const char* strategy, const char* parameters, netloft_stage* stage) {
  close();
  const netloft_stage seen = seen_from_host(*stage);
  const StrategyType& type = host_.variant_problems().source().registry->strategy(strategy);
  Values values = host_.given_of(type.type);
  values.merge(parse_parameters(type.parameters, parameters ? parameters : ""));  // the user's values prevail
  std::vector<std::string> faults;
  const ParameterBlock block(type.parameters, type.strategy.parameter_bytes, values, faults);
  if (!faults.empty()) throw std::invalid_argument(faults.front());
  const double before = host_.spent();
  StageRequest request{
      .by_strategy = true, .by = type.type, .parameters = std::move(values), .variant = seen.variant};
  request.tolerance = seen.tolerance;
  request.start = {stage->u, stage->u + size_of(stage->variant.level)};
  const KnownStage* known = host_.find_known(request);
  const KnownStage came = known ? *known : run_inner(type, block.data(), seen, std::move(request));
  unsettled_ += came.unsettled;
  if (is_scene_itself(*stage)) {
    if (came.has_solution) keep(*stage, came.solution);
    last_ = came.ending;
  }
  fill(*stage, came.solution, host_.spent() - before);
  stage->ending = came.ending;
  return NETLOFT_OK;
}

/// Runs a strategy that this strategy calls. If work is left at the end, more work would not change the
/// result, which is then stored.
KnownStage RunningSearch::run_inner(const StrategyType& type, const void* parameters,
                                    const netloft_stage& seen, StageRequest request) {
  const SearchHost::InnerCall under_way(host_, type.type);
  RunningSearch inner(host_, seen.variant, seen.tolerance, seen.work, seen.u);
  inner.run(type, parameters);
  KnownStage came{.request = std::move(request), .solution = inner.best(), .has_solution = inner.has_any()};
  came.unsettled = inner.unsettled_;
  came.ending = inner.ending();
  const bool has_ended = inner.work_left() > 0 && came.ending != NETLOFT_ENDED_OUT_OF_WORK;
  if (has_ended) host_.keep_known(came);
  return came;
}

int RunningSearch::transfer(std::uint32_t from, const double* u, std::uint32_t to, double* out) {
  close();
  const auto moved =
      host_.variant_problems().transfer(scene_.level + from, {u, size_of(from)}, scene_.level + to);
  if (moved.empty())
    throw std::invalid_argument("the meshes of these levels are not divisions of the same parts");
  std::copy(moved.begin(), moved.end(), out);
  return NETLOFT_OK;
}

int RunningSearch::problem(netloft_stage* stage, netloft_problem* problem) {
  close();
  open_stage_ = seen_from_host(*stage);
  open_variant_ = host_.variant_problems().at(open_stage_.variant);
  open_problem_ = std::make_unique<StaticProblem>(
      *open_variant_->assembler, host_.variant_problems().source().make,
      host_.limits_of(open_stage_, *open_variant_), host_.observer_of(open_stage_));
  hand_out(open_problem_->interface(), *problem, kFirstProblem);
  problem->u = stage->u;
  return NETLOFT_OK;
}

int RunningSearch::members(netloft_stage* stage, netloft_members* members) {
  close();
  if (!(interface_.traits & NETLOFT_SEARCH_MEMBERS))
    throw std::invalid_argument("this search has no members (NETLOFT_SEARCH_MEMBERS)");
  open_stage_ = seen_from_host(*stage);
  open_variant_ = host_.variant_problems().at(open_stage_.variant);
  open_members_ = std::make_unique<MemberProblem>(
      *open_variant_->assembler, host_.variant_problems().source().make,
      host_.limits_of(open_stage_, *open_variant_), host_.options().on_iteration);
  hand_out(open_members_->interface(), *members, kFirstMembers);
  return NETLOFT_OK;
}

/// Ends a method that the strategy runs by itself, and stores a record of the method's work.
void RunningSearch::close() {
  if (!open_problem_ && !open_members_) return;
  const Statistics statistics = open_problem_ ? open_problem_->statistics() : open_members_->statistics();
  const auto size = static_cast<std::size_t>(open_variant_->assembler->pattern().size);
  host_.record({open_stage_.name ? open_stage_.name : "", open_members_ ? "members" : "own", size,
                SolveStatus::not_converged, "", statistics, open_stage_.variant},
               *open_variant_);
  open_problem_.reset();
  open_members_.reset();
  open_variant_.reset();
}

int RunningSearch::answer(const double* u) {
  close();
  const std::span<const double> answered(u, interface_.unknowns);
  const auto known = std::find_if(stationary_.begin(), stationary_.end(), [&](const Solution& s) {
    return std::equal(s.u.begin(), s.u.end(), answered.begin(), answered.end());
  });
  if (known != stationary_.end()) {
    equilibria_.add(std::move(*known));
    stationary_.erase(known);
    return NETLOFT_OK;
  }
  std::vector<double> own(answered.begin(), answered.end());
  netloft_stage stage{};
  stage.size = sizeof stage;
  stage.variant = as_written();
  stage.name = "answer";
  stage.u = own.data();
  Solution s = host_.assess(seen_from_host(stage));
  if (is_stationary(s))
    equilibria_.add(std::move(s));
  else
    keep(stage, s);
  return NETLOFT_OK;
}

double RunningSearch::bending(const double* u) {
  close();
  Statistics cost;
  Factors factors(host_.variant_problems().source().make, cost);
  const double largest = bending_that_holds(*variant_problem_->assembler, {u, interface_.unknowns}, factors);
  host_.record(
      {"what bending holds", "own", interface_.unknowns, SolveStatus::not_converged, "", cost, scene_},
      *variant_problem_);
  return largest;
}

/// Keeps an equilibrium of the scene itself until the strategy reports it. Updates the point closest to
/// balance.
void RunningSearch::keep(const netloft_stage& stage, const Solution& s) {
  constexpr std::size_t kMostKept = 8;  // strategies report equilibria soon after their stage
  if (is_stationary(s)) {
    if (stationary_.size() == kMostKept) stationary_.erase(stationary_.begin());
    stationary_.push_back(s);
  }
  unsettled_ += stage.path > 0 && ending_of(s) == NETLOFT_ENDED_UNSETTLED;
  const bool is_closer =
      !closest_ || (is_stationary(s) && !is_stationary(*closest_)) ||
      (is_stationary(s) == is_stationary(*closest_) && imbalance(s) < imbalance(*closest_));
  if (is_closer || s.status == SolveStatus::interrupted) closest_ = s;
}

void RunningSearch::fill(netloft_stage& stage, const Solution& s, double spent) {
  if (!s.u.empty()) std::copy(s.u.begin(), s.u.end(), stage.u);
  growing_ = s.growing.mode;
  stage.ending = ending_of(s);
  stage.stability = stability_of(s);
  stage.residual = s.balance.residual;
  stage.load = s.balance.scale;
  stage.energy = s.energy;
  stage.rounding = s.balance.floor;
  stage.spent = spent / unit_;
  stage.iterations_done = static_cast<std::uint32_t>(s.cost.statistics.iterations);
  stage.factorisations = static_cast<std::uint32_t>(s.cost.statistics.factorisations);
  stage.growing = growing_.empty() ? nullptr : growing_.data();
  stage.growth_rate = s.growing.rate;
  stage.growth_frequency = s.growing.frequency;
}

}  // namespace netloft
