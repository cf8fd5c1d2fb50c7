// SPDX-License-Identifier: BSD-3-Clause
#include "framework/continuation/journey.hpp"

#include "framework/continuation/shape_finder.hpp"
#include "framework/problem/correction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace netloft {

namespace {

// The scene itself is given up for a detour after so many iterations; after the last one only by the user.
constexpr int kFirstIterations = 300;
// Where the stiffest part could carry all of the load with a stretch below the first of these, the way from
// soft to stiff comes before others; below the second one, the scene is given up for it sooner; below the
// third one it comes first, unless the start is near.
constexpr double kRatherStiff = 1e-2, kStiff = 1e-3, kVeryStiff = 1e-4;
constexpr int kFewIterations = 60;
// Detours may cost so many times the first attempt, and at least so many seconds: what has no equilibrium
// should hear of it soon.
constexpr double kPatience = 12, kLeastPatience = 3;
// One easier scene may cost so many times the first attempt, and at least so many seconds; and so many
// iterations, if nothing else is said.
constexpr double kLegPatience = 5, kLeastLegPatience = 0.2;
constexpr int kLegIterations = 200;
// Whoever may stand otherwise is shaken by this share of an element's size; every other time by less, what
// is stiff by the last of them.
constexpr double kLookShare = 1, kNearShare = 0.1, kMovedShare = 0.3;
// A motion of more unknowns takes longer than a look is worth.
constexpr std::size_t kMostToMove = 1000;
// Where it is known what grows, there are two sides to leave to, and one saddle may lead to another.
constexpr int kTimesAside = 2;
// What flutters, and from another way again, is taken for what it is.
constexpr int kTimesFluttering = 2;
constexpr const char* kMoreDigits = "with more digits";
// Digits that positions round off change a shape by no more than this, over its size.
constexpr double kSameShape = 1e-4;
// A residual of this share of the largest load: all but solved, or if there is no way on, a saddle.
constexpr double kNearly = 1e-5;
// A residual of this share of the largest load: as many iterations again may well be enough; so often, as
// long as they bring it on.
constexpr double kOnItsWay = 0.03;
constexpr int kTimesFurther = 5;
// Unasked, other shapes are looked for after so many iterations, so often, while all iterations times
// unknowns are no more than the first of these; after less where there may well be others, while they are no
// more than the second one; without an own start, where what is pressed bears the last of them of the largest
// load, while they are no more than the third.
constexpr double kLongWay = 100, kLookWork = 1e7, kShortLookWork = 3e6, kSmallLookWork = 3e5,
                 kMuchPressed = 1e-3;
constexpr int kOwnLooks = 6;

bool has_arrived(const Solution& s) { return s.status == SolveStatus::converged; }

bool is_nearly(const Solution& s) {
  return s.status == SolveStatus::not_converged && s.balance.residual < kNearly * s.balance.scale;
}

/// Where forces balance, or nearly, and no step downhill is seen for symmetry.
bool is_at_saddle(const Solution& s) { return s.status == SolveStatus::unstable || is_nearly(s); }

/// Where a few more iterations promise more than another way.
bool is_on_its_way(const Solution& s) {
  return !has_arrived(s) && s.balance.residual < kOnItsWay * s.balance.scale;
}

/// Of two that did not arrive the one to tell of: a stationary point before anything else, then the smaller
/// residual.
bool is_better(const Solution& a, const Solution& b) {
  if (is_stationary(a) != is_stationary(b)) return is_stationary(a);
  return a.balance.residual / a.balance.scale < b.balance.residual / b.balance.scale;
}

void keep_better(Solution& best, Solution next) {
  if (has_arrived(next) || is_better(next, best)) best = std::move(next);
}

}  // namespace

Journey::Journey(const Scene& scene, Assembler& assembler, Registry& registry, JourneyOptions options)
    : scene_(scene),
      assembler_(assembler),
      registry_(registry),
      options_(std::move(options)),
      begun_(wall_seconds()),
      patience_(std::numeric_limits<double>::infinity()),
      leg_patience_(patience_) {}

void Journey::book(const Leg& leg) { legs_.push_back(leg); }

Solution Journey::arrive(Displacements start) {
  options_.limits.ask_growth = true;
  begun_cpu_ = cpu_seconds();
  stretch_ = stretch_of_stiffest();
  is_conservative_ = StaticProblem(assembler_, options_.make, options_.limits).conservative();
  is_nearby_ = options_.nearby && !start.empty();
  const std::vector<Way> ways = ways_from(start);
  Limits limits = options_.limits;
  const bool few = is_stiff() || sticks() || (options_.detours && options_.own_start.soon);
  limits.iterations = std::min(options_.limits.iterations, few ? kFewIterations : kFirstIterations);
  const Displacements first = *(this->*ways[0].to)(start, {});
  Solution best = solve_itself(ways[0].name, first, limits);
  be_patient(best, limits);
  const bool goes_on =
      best.books.iterations >= limits.iterations && !is_stationary(best) && is_on_its_way(best);
  if (!goes_on) leave_saddles(best, ways[0].name, limits);
  limits.iterations = std::min(options_.limits.iterations, kFirstIterations);
  if (goes_on) go_further(best, std::string(ways[0].name) + ", further", limits);
  if (!has_arrived(best)) gain_digits(best);
  try_other_ways(best, ways, start, limits);
  try_once_more(best, start, limits);
  if (options_.looks != 0) look_for_other_shapes(best, start, limits);
  gain_digits(best);
  tell_of_restlessness(best);
  return finish(std::move(best));
}

/// Until it has arrived, or swings on wherever it is brought to.
void Journey::try_other_ways(Solution& best, const std::vector<Way>& ways, const Displacements& start,
                             const Limits& limits) {
  int fluttering = flutters(best);
  for (std::size_t i = 1; i < ways.size() && !has_arrived(best) && !out_of_time(); ++i) {
    const auto nearer = (this->*ways[i].to)(start, best);
    if (!nearer) continue;
    Solution next = solve_itself_off_saddles(ways[i].name, *nearer, limits);
    fluttering += flutters(next);
    keep_better(best, std::move(next));
    if (fluttering >= kTimesFluttering) return;
  }
}

/// In the order in which they promise something; the first one always leads somewhere.
std::vector<Journey::Way> Journey::ways_from(const Displacements& start) const {
  const Way as_it_is{"as it is", &Journey::over_nothing},
      soft{"from soft to stiff", &Journey::over_stiffness};
  if (!options_.detours) return {as_it_is};
  std::vector<Way> ways{as_it_is, {"shaken", &Journey::over_shaking}};
  const bool soft_first = start.empty() && stretch_ < kVeryStiff, soft_soon = stretch_ < kRatherStiff;
  if (soft_soon) ways.insert(soft_first ? ways.begin() : ways.end(), soft);
  const Way relaxed{"from a relaxed shape", &Journey::over_relaxation};
  const Way moved{"from where it moves to", &Journey::over_motion},
      moved_on{"from where it moves on to", &Journey::over_more_motion};
  if (sticks())
    ways.insert(ways.begin() + 1, relaxed);
  else
    ways.insert(is_conservative_ || soft_soon ? ways.end() : ways.begin() + 1, {moved, moved_on});
  const OwnStart& own = options_.own_start;
  if (own.find)
    ways.insert(own.soon ? ways.begin() + 1 : ways.end(), {own.name.c_str(), &Journey::over_own_start});
  ways.push_back({"from tension only", &Journey::over_tension_only});
  ways.push_back({"from still water", &Journey::over_current});
  if (!soft_soon) ways.push_back(soft);
  if (!sticks()) ways.push_back(relaxed);
  return ways;
}

/// How much longer the stiffest part would be if it carried all that drives the gear: the load over its
/// stiffness. 1 where nothing does.
double Journey::stretch_of_stiffest() const {
  const double load = StaticProblem(assembler_, options_.make, options_.limits).driving_load().sum;
  return load == 0 ? 1 : load / std::max(load, largest_stiffness(scene_, registry_));
}

/// Some elements remember: dry friction. Where it flickers, no tangent helps, and motion with its damping
/// does.
bool Journey::sticks() const { return options_.detours && !assembler_.memory().empty(); }

bool Journey::is_stiff() const { return options_.detours && stretch_ < kStiff; }

/// From where it is.
void Journey::go_further(Solution& best, const std::string& name, const Limits& limits) {
  if (!is_conservative_ && !options_.own_start.soon)
    return keep_better(best, solve_itself_off_saddles(name, best.u, limits));
  Solution last = best;
  for (int times = 0; times < kTimesFurther && !out_of_time(); ++times) {
    Solution next = solve_itself(name, last.u, limits);
    const bool goes_on =
        next.books.iterations >= limits.iterations && is_on_its_way(next) && comes_on(next, last);
    last = next;
    keep_better(best, std::move(next));
    if (!goes_on) break;
  }
  leave_saddles(best, name, limits);
}

/// Where it ended at the rounding of its positions, or that is all that keeps it from balance, from there
/// with all their digits.
void Journey::gain_digits(Solution& best) {
  const bool arrived = has_arrived(best), is_rounded = best.balance.residual <= best.balance.floor &&
                                                       (!arrived || best.balance.at_round_off);
  const bool has_them = !legs_.empty() && legs_.back().name == kMoreDigits;
  if (!options_.detours || !is_rounded || has_them || best.balance.scale == 0 ||
      best.status == SolveStatus::unstable || sticks() || assembler_.has_bodies() || out_of_time())
    return;
  Limits limits = options_.limits;
  limits.iterations = std::min(limits.iterations, kFewIterations), limits.ask_growth = !arrived;
  Solution s = solve_itself(kMoreDigits, options_.solver, best.u, limits, Digits::all);
  const double moved = largest_node_distance(scene_, assembler_.numbering(), best.x, s.x),
               size = StaticProblem(assembler_, options_.make, options_.limits).gear_size();
  if (!has_arrived(s) || s.balance.residual > best.balance.residual || (arrived && moved > kSameShape * size))
    return;
  s.shapes = std::move(best.shapes);
  if (arrived && !is_conservative_) s.stability = best.stability;
  for (IterationRecord& record : s.history) record.iteration += best.books.iterations;
  s.history.insert(s.history.begin(), best.history.begin(), best.history.end());
  best = std::move(s);
}

/// Forces without an energy may keep a gear in motion for ever. With one, its damping would end it.
void Journey::tell_of_restlessness(Solution& best) const {
  const bool was_cut_off = best.status == SolveStatus::interrupted || seconds_left() == 0;
  if (has_arrived(best) || flutters(best) || is_conservative_ || restless_ == 0 || was_cut_off) return;
  best.is_restless = true;
  best.reason +=
      "; its motion did not come to rest over " + std::to_string(std::lround(kLongestWay)) +
      " times its size" +
      (motions_ > 1 ? ", from " + std::to_string(restless_) + " of " + std::to_string(motions_) + " starts"
                    : "");
}

/// By its energy; the residual flickers where many members are just taut.
bool Journey::comes_on(const Solution& now, const Solution& before) const {
  return is_conservative_ ? now.energy < before.energy : now.balance.residual < before.balance.residual;
}

/// Others may cost a multiple of the first attempt, with what led to its start; of one that had few
/// iterations or ended near, as if it had had some more.
void Journey::be_patient(const Solution& first, const Limits& limits) {
  const int iterations = first.books.iterations;
  const bool is_short = is_stationary(first) || iterations >= limits.iterations;
  const double share =
      is_short ? double(kFirstIterations) / std::clamp(iterations, kFewIterations, kFirstIterations) : 1;
  double first_attempt = 0;
  for (const Leg& leg : legs_)
    if (leg.unknowns == first.u.size()) first_attempt += share * leg.books.total_cpu_seconds;
  patience_ = std::max(kLeastPatience, kPatience * first_attempt);
  leg_patience_ = std::max(kLeastLegPatience, kLegPatience * first_attempt);
}

/// Where forces flicker (sticking and sliding), no tangent helps, and motion with its damping does. Else with
/// all the iterations that the user allows.
void Journey::try_once_more(Solution& best, const Displacements& start, const Limits& before) {
  if (!options_.detours || flutters(best)) return;
  const auto relaxation = !is_stationary(best) && !out_of_time() ? other_solver("relaxation") : std::nullopt;
  if (relaxation)
    keep_better(best, solve_itself("by relaxation", *relaxation, relaxed_.empty() ? start : relaxed_,
                                   options_.limits));
  if (has_arrived(best) || out_of_time() || options_.limits.iterations <= before.iterations) return;
  const Displacements from = is_stationary(best) ? shaken(best.u, kLeaveShare) : best.u;
  keep_better(best, solve_itself_off_saddles("once more", from, options_.limits));
}

/// As often as was asked for, or as suits; the best becomes that of the least energy.
void Journey::look_for_other_shapes(Solution& best, const Displacements& start, const Limits& limits) {
  const bool as_suits = options_.looks == JourneyOptions::kLooksThatSuit;
  const bool was_long = work() >= kLongWay * static_cast<double>(best.u.size());
  const double worth = !as_suits                 ? std::numeric_limits<double>::infinity()
                       : was_long                ? kLookWork
                       : options_.own_start.soon ? kShortLookWork
                                                 : kSmallLookWork;
  // What sticks stands in any number of ways.
  if (as_suits && (sticks() || work() > worth || !(was_long || may_well_stand_otherwise(best)))) return;
  const int looks = as_suits ? kOwnLooks : options_.looks;
  patience_ = leg_patience_ = std::numeric_limits<double>::infinity();
  may_move_ = !as_suits;
  const StaticProblem problem(assembler_, options_.make, options_.limits);
  ShapeFinder finder(scene_, assembler_, problem.gear_size(), problem.conservative());
  finder.add(best);
  for (int look = 1; look <= looks && work() <= worth && has_arrived(best) && !out_of_time(); ++look)
    finder.add(solve_itself_off_saddles("look " + std::to_string(look),
                                        start_of_look(look, start, finder.best()), limits));
  best = finder.best();
}

/// There are many ways in which what is pressed may fold, and this is one of them. Where nothing is pressed,
/// the gear would stand so if it bore tension only: under dead loads the shape of least energy.
bool Journey::may_well_stand_otherwise(const Solution& best) const {
  if (!is_conservative_) return false;
  const auto easier = without_compression(scene_, registry_);
  return easier && imbalance(*easier, best.u) > (options_.own_start.soon ? 0 : kMuchPressed);
}

/// Largest residual over the largest load, 0 where that is balance.
double Journey::imbalance(const Scene& scene, const Displacements& u) const {
  const Plan plan = make_plan(scene, registry_, options_.tangent);
  Assembler assembler(scene, plan, options_.threads);
  StaticProblem problem(assembler, options_.make, options_.limits);
  std::vector<double> x, residual;
  double energy = 0;
  if (!problem.recompute(u, x, residual, energy)) return std::numeric_limits<double>::infinity();
  const Balance b = problem.balance(x, residual);
  return b.balanced ? 0 : b.residual / b.scale;
}

/// At first where it stands with nothing pressed; then from the best that is known, shaken each time
/// otherwise, by an element's size and by less in turns. Of what is stiff that leaves strains which Newton's
/// steps do not undo: it goes from soft to stiff, and in turns to where it moves.
Journey::Displacements Journey::start_of_look(int look, const Displacements& start, const Solution& best) {
  if (look == 1)
    if (const auto convex = over_tension_only(start, best)) return *convex;
  ++turn_;
  const bool is_near = look > 1 && look % 2 == 1;
  if (!is_stiff()) return shaken(best.u, is_near ? kNearShare : kLookShare);
  if (is_near && !sticks() && best.u.size() <= kMostToMove)
    if (const auto moved = move(shaken(best.u, kMovedShare))) return moved->u;
  const Displacements from = shaken(best.u, kLookShare);
  return over_stiffness(from, best).value_or(from);
}

/// Iterations of all legs, each times its unknowns.
double Journey::work() const {
  double sum = 0;
  for (const Leg& leg : legs_)
    sum += static_cast<double>(leg.books.iterations) * static_cast<double>(leg.unknowns);
  return sum;
}

/// The scene itself, if it is all but solved with as many iterations again, and where that ends at a saddle,
/// away from it.
Solution Journey::solve_itself_off_saddles(const std::string& name, const Displacements& start,
                                           const Limits& limits) {
  Solution s = solve_itself(name, start, limits);
  const bool may_go_on = options_.detours && limits.iterations < options_.limits.iterations && !out_of_time();
  if (may_go_on && s.books.iterations >= limits.iterations && is_nearly(s))
    keep_better(s, solve_itself(name + ", further", s.u, limits));
  leave_saddles(s, name, limits);
  return s;
}

void Journey::leave_saddles(Solution& s, const std::string& name, const Limits& limits) {
  for (int times = 0; options_.detours && is_at_saddle(s) && !flutters(s) && !out_of_time(); ++times) {
    if (times > 0 && (times == kTimesAside || s.growing.empty())) break;
    keep_better(s, solve_itself(name + ", shaken", away_from(s), limits));
  }
}

std::optional<SolverUse> Journey::other_solver(const std::string& name) const {
  try {
    return SolverUse{&registry_.solver(name), {}};
  } catch (const PluginRefused&) {
    return {};
  }
}

Solution Journey::solve_itself(const std::string& name, const Displacements& start, const Limits& limits) {
  const bool nearby = std::exchange(is_nearby_, false);
  return solve_itself(name, nearby ? *options_.nearby : options_.solver, start, limits);
}

Solution Journey::solve_itself(const std::string& name, const SolverUse& solver, const Displacements& start,
                               const Limits& limits, Digits digits) {
  std::vector<std::string> faults;
  const SolverType& type = *solver.type;
  const ParameterBlock parameters(type.parameters, type.solver.parameter_bytes, solver.parameters, faults);
  Limits left = limits;
  left.seconds = std::min(seconds_left(), patience_left());
  Solution s = solve_static(scene_, assembler_, type, parameters.data(), left, options_.make,
                            options_.on_iteration, start, digits);
  legs_.push_back({name, type.type, s.u.size(), s.status, s.reason, s.books});
  return s;
}

Solution Journey::solve_leg(const std::string& name, const Scene& easier, const SolverUse& solver,
                            const Displacements& start, double tolerance, int iterations) {
  std::vector<std::string> faults;
  const ParameterBlock parameters(solver.type->parameters, solver.type->solver.parameter_bytes,
                                  solver.parameters, faults);
  const Plan plan = make_plan(easier, registry_, options_.tangent);
  Assembler assembler(easier, plan, options_.threads);
  Solution s =
      solve_static(easier, assembler, *solver.type, parameters.data(), limits_of_leg(tolerance, iterations),
                   options_.make, options_.on_iteration, start);
  legs_.push_back({name, solver.type->type, s.u.size(), s.status, s.reason, s.books});
  return s;
}

Limits Journey::limits_of_leg(double tolerance, int iterations) const {
  Limits limits = options_.limits;
  limits.tolerance = std::max(tolerance, limits.tolerance);
  limits.ask_growth = false;
  limits.way = leg_way_;
  limits.iterations = iterations > 0 ? iterations : std::min(kLegIterations, limits.iterations);
  limits.seconds = std::min({seconds_left(), patience_left(), leg_patience_});
  return limits;
}

/// Of what the user allows [s].
double Journey::seconds_left() const {
  return std::max(0.0, options_.limits.seconds - (cpu_seconds() - begun_cpu_));
}

/// Of what all attempts together are worth, by that of the processor: other programs do not count [s].
double Journey::patience_left() const { return std::max(0.0, patience_ - (cpu_seconds() - begun_cpu_)); }

bool Journey::out_of_time() const {
  return seconds_left() == 0 || patience_left() == 0 ||
         (options_.limits.interrupt && options_.limits.interrupt->load());
}

Solution Journey::finish(Solution solution) const {
  if (legs_.size() < 2) return solution;
  solution.legs = legs_;
  solution.books = {};
  for (const Leg& leg : legs_) solution.books.add(leg.books);
  return solution;
}

}  // namespace netloft
