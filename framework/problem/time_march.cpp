// SPDX-License-Identifier: BSD-3-Clause
#include "framework/problem/time_march.hpp"

#include "framework/problem/shared_unknowns.hpp"
#include "framework/registry/plugin_call.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

namespace netloft {

namespace {

/// Of the stable step that the stiffest state allows: what goes slack and taut near that step makes energy. A
/// chain and a mooring line that do were lost at 0.9; the chain made energy at 0.67 and none at 0.45.
constexpr double kBelowLimit = 0.6;
/// a of (2): the usual accuracy, so that most scenes keep their steps. With p of 3, the order of schemes,
/// errors of a ball that a rope catches and of a net hit by a gust fell by the powers 0.5 and 0.8 of
/// accuracy, with 2 by 1.1 and 1.3.
constexpr double kProportional = 1e-2;
constexpr int kLookEvery = 16;  // short steps to one that is judged, where no budget is kept
/// Steps for which a stable step by the tangent is believed. Waves go through as many elements in them, and
/// what moves at a hundredth of their speed goes less than one element. To ask costs as much as two steps do:
/// with 16, the hard motions of tests/bench/motions take a tenth longer; with 256, the same steps within
/// 1e-3.
constexpr int kBelieved = 64;

/// Those of a step: a budget of work is that of the march.
Limits without_work(Limits limits) {
  limits.model = nullptr;
  return limits;
}

std::string seconds(double t) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g s", t);
  return text;
}

/// Steps of the march that another one is compared with, over its own: longer where they may be.
constexpr double kLonger = 2, kShorter = 0.5;
// By how much the mean steps of both must differ: what is alike cannot tell how far it is off.
constexpr double kTold = 0.1;

/// One march; members are steps in the order they happen.
class March {
 public:
  March(const Scene& scene, Assembler& assembler, IntegratorChoice integrator, SolverChoice solver,
        const MakeFactorisation& make, const Limits& limits, const MarchSettings& settings,
        const MarchWatch& watch, const MarchState* from)
      : scene_(scene),
        assembler_(assembler),
        integrator_(integrator),
        limits_(limits),
        settings_(settings),
        watch_(watch),
        make_(make),
        solver_(solver),
        problem_(assembler, settings.mass_damping, solver, make, without_work(limits)),
        budget_(assembler, settings.mass_damping),
        state_(from ? *from : state_at_rest(assembler)),
        next_(state_),
        shown_(assembler, settings.mass_damping),
        winches_(scene, assembler, limits.tolerance),
        error_(state_.u.size()),
        residual_(assembler.numbering().dofs()),
        mean_forces_(residual_.size()),
        corners_(find_corners()),
        other_start_(state_) {
    winches_.set_state(state_.winches);
  }

  MarchResult run() {
    if (begin() && begin_other())
      while (state_.t < settings_.duration && !has_ended()) {
        if (!shorten_rotations() || !make_step()) break;
        write_outputs();
        tell_of_step();
      }
    return finish();
  }

  /// Goes on to a time or beyond it, without outputs; false: it has failed, or was interrupted.
  bool reach(double t) {
    assembler_.set_memory(state_.memory), winches_.restore();
    bool moves = true;
    while (moves && state_.t < t && !has_ended()) moves = shorten_rotations() && make_step();
    if (state_.t < t) return false;
    keep();
    if (settings_.dense) state_.t_before = previous_, state_.u_before = next_.u, state_.v_before = next_.v;
    return true;
  }

 private:
  bool begin() {
    result_.status = MarchStatus::finished;
    winches_.restore();
    if (!state_.memory.empty()) assembler_.set_memory(state_.memory);
    problem_.set_least_load(state_.least_load);
    if (integrator_.type->is_explicit())
      if (const std::string why = problem_.obstacle_to_explicit(scene_); !why.empty()) return fail(why);
    if (state_.a.empty()) {
      state_.a.resize(state_.u.size());
      if (problem_.start(state_.t, state_.u, state_.v, state_.a) != NETLOFT_OK)
        return fail("there are no forces at the start: " + assembler_.fault_sentence(scene_));
      note_start();
    }
    next_.u.resize(state_.u.size()), next_.v = next_.a = next_.u;
    if (settings_.budget || watches_energy())
      if (!budget_.begin(state_.t, state_.u, state_.v, state_.a)) return fail_at_fault();
    if (!state_.budget.empty()) budget_.set_sums(state_.budget);
    if (state_.judged.empty())
      judge_.begin(budget_.totals(), problem_.least_load() * element_size());
    else
      judge_.set_sums(state_.judged);
    find_limit();
    if (state_.h == 0) state_.h = first_step();
    last_ = previous_ = state_.t;
    if (!state_.u_before.empty())
      previous_ = state_.t_before, next_.u = state_.u_before, next_.v = state_.v_before;
    if (state_.memory.empty()) state_.memory = assembler_.memory();
    if (state_.outputs == 0 && !settings_.check) write_checkpoint(state_.t);
    return true;
  }

  /// The march that this one is compared with goes on from where it was; its first step comes later.
  bool begin_other() {
    if (!settings_.check) return true;
    MarchSettings& s = other_settings_ = settings_;
    s.check = s.judged = false;
    s.pace = stable_step(1) == 0 ? kLonger : kShorter;
    if (s.step > 0) s.step *= s.pace;
    s.longest_step *= s.pace, s.output_interval *= s.pace;
    const std::vector<double> own = assembler_.memory();
    if (state_.outputs == 0) state_.other = {other_start_};
    if (!state_.other.empty()) {
      other_ = std::make_unique<March>(scene_, assembler_, integrator_, solver_, make_, limits_,
                                       other_settings_, nobody_, &state_.other[0]);
      if (!other_->begin()) lose_other();
      assembler_.set_memory(own), winches_.restore();
    }
    if (state_.outputs == 0) write_checkpoint(state_.t);
    return true;
  }
  void lose_other() {
    other_lost_ = other_->result_.reason;
    state_.path_error = std::numeric_limits<double>::infinity(), state_.path_at = other_->state_.t;
    other_.reset(), state_.other.clear();
  }

  /// (3) at an output; false: interrupted.
  bool compare_paths(double t) {
    if (!other_ || !other_->has_output_at(t)) return true;
    const std::vector<double> own = assembler_.memory();
    const bool is_there = other_->reach(t);
    assembler_.set_memory(own), winches_.restore();
    if (!is_there && other_->result_.status == MarchStatus::interrupted) return !has_ended();
    if (!is_there) return lose_other(), true;
    show(t), other_->show(t);
    note_difference(t);
    state_.other = {other_->state_};
    return true;
  }
  void note_difference(double t) {
    const std::vector<double> here = assembler_.node_positions(shown_.x()),
                              there = assembler_.node_positions(other_->shown_.x());
    const double longer = mean_step(other_->state_) / mean_step(state_);  // NaN before the first
    if (!(std::abs(longer - 1) >= kTold)) return;
    for (std::size_t i = 0; i < here.size(); i += 3) {
      const double apart =
          std::hypot(here[i] - there[i], here[i + 1] - there[i + 1], here[i + 2] - there[i + 2]);
      const double error = apart == 0 ? 0 : apart / std::min(1.0, std::abs(longer - 1));
      if (!(error <= state_.path_error))
        state_.path_error = error, state_.path_at = t, state_.path_of = i / 3;
    }
  }
  static double mean_step(const MarchState& s) { return s.t / static_cast<double>(s.steps); }
  /// Of one that is compared, which makes its outputs at other times.
  bool has_output_at(double t) const {
    if (settings_.dense || settings_.output_interval <= 0 || t >= settings_.duration) return true;
    const double outputs = t / settings_.output_interval;
    return std::abs(outputs - std::round(outputs)) < 1e-9;
  }

  void note_start() {
    const Balance b = problem_.balance();
    result_.start = {b.residual, b.scale, assembler_.node_name(scene_, b.worst)};
  }

  /// Between two steps, when the last one has been told: positions and velocities stay as they are.
  bool shorten_rotations() {
    if (!assembler_.shorten_rotations(state_.u, state_.v, state_.a) || !settings_.budget) return true;
    return budget_.restate(state_.t, state_.u, state_.v, state_.a) || fail_at_fault();
  }

  /// Longest step that is stable: with all members taut, and by a tangent of the last kBelieved steps, which
  /// has what members do not bound.
  void find_limit() {
    limit_ = settings_.longest_step;
    if (stable_step(1) == 0) return;
    result_.stable_step = stable_step(problem_.highest_frequency());
    if (is_bounded() && state_.stable_step == 0) ask_tangent();
    if (is_bounded()) bound_steps();
  }
  bool is_bounded() const { return result_.stable_step > 0 && (settings_.adaptive || settings_.step == 0); }
  void ask_tangent() { state_.stable_step = stable_step(problem_.highest_frequency_at(state_.u)); }
  void bound_steps() {
    limit_ = std::min(settings_.longest_step, bound() * std::min(result_.stable_step, state_.stable_step));
  }

  double bound() const { return kBelowLimit * settings_.pace; }

  /// As given; else the time in which the start's acceleration leads as far as a step's error may be.
  double first_step() const {
    if (settings_.step > 0) return std::min(settings_.step, settings_.adaptive ? limit_ : settings_.step);
    double fastest = 0;
    for (const double a : state_.a) fastest = std::max(fastest, std::abs(a));
    const double h = std::sqrt(2 * tolerated() / std::max(fastest, 1e-6));
    return std::clamp(h, settings_.shortest_step, std::min(limit_, settings_.duration));
  }

  /// (2)
  double allowed() const {
    const double asked = settings_.accuracy,
                 order = integrator_.type->integrator.order(integrator_.parameters);
    return (asked >= kProportional ? asked : asked * asked / kProportional) * std::pow(settings_.pace, order);
  }
  double tolerated() const { return allowed() * element_size(); }
  double element_size() const { return problem_.algebra().scales().element_size(); }

  bool has_ended() {
    if (limits_.interrupt && limits_.interrupt->load())
      return end(MarchStatus::interrupted, "interrupted at t = " + seconds(state_.t));
    if (cpu_seconds() - cpu_begun_ > limits_.seconds)
      return end(MarchStatus::out_of_time, "the time limit was reached at t = " + seconds(state_.t));
    if (limits_.model && limits_.model->of(work_done()) >= limits_.work)
      return end(MarchStatus::out_of_work, "the budget of work was spent at t = " + seconds(state_.t));
    return is_over_;
  }
  /// By this march and the one that it is compared with.
  Statistics work_done() const {
    Statistics all = problem_.statistics();
    if (other_) all.add(other_->problem_.statistics());
    return all;
  }

  /// Tries steps until one is accepted.
  bool make_step() {
    for (;;) {
      const double corner = next_corner(), rest = corner - state_.t;
      const double parts = std::max(1.0, std::ceil(rest / std::min(state_.h, limit_) - 1e-9));
      const double h = rest / parts;
      const double end = parts == 1 ? corner : state_.t + h;
      const int status = try_step(h);
      double error = status == NETLOFT_OK && settings_.adaptive ? error_over_tolerated() : 0;
      if (status == NETLOFT_OK && error <= 1 && is_looked_at() && !keep_account(end, error))
        return fail_at_fault();
      if (status == NETLOFT_OK && error <= 1) return accept(end, h, error);
      if (status < 0) return fail_in_step();
      ++state_.rejected;
      if (!settings_.adaptive) return fail_at("the step " + seconds(h) + " is too long: " + trouble());
      state_.h = h * (status == NETLOFT_OK ? std::max(0.2, growth(error)) : 0.25);
      if (state_.h < settings_.shortest_step)
        return fail_at("no step longer than " + seconds(settings_.shortest_step) + " serves: " + trouble());
    }
  }

  /// With winches that hold tensions, until their speeds and what they bear agree.
  int try_step(double h) {
    if (winches_.empty()) return try_once(h);
    // Of the ropes as they are at the beginning of this step, whether or not the march has come from far.
    problem_.algebra().forget_metric();
    for (winches_.begin(state_.t, h);;) {
      const int status = try_once(h);
      if (status != NETLOFT_OK || !winches_.hold_tensions()) return status;
      if (!problem_.find_step_forces(state_.t + h, next_.u, next_.v, next_.a, residual_))
        return NETLOFT_ERROR;
      forces_after_ = -1;
      const auto verdict = winches_.judge(residual_);
      if (verdict == Winches::Verdict::settled) return NETLOFT_OK;
      if (verdict == Winches::Verdict::lost) return winches_are_lost_ = true, NETLOFT_OUTSIDE_DOMAIN;
    }
  }

  int try_once(double h) {
    winches_are_lost_ = false;
    std::fill(error_.begin(), error_.end(), 0.0);
    netloft_motion& m = problem_.interface();
    m.t = state_.t, m.h = h;
    m.u = state_.u.data(), m.v = state_.v.data(), m.a = state_.a.data();
    m.u_new = next_.u.data(), m.v_new = next_.v.data(), m.a_new = next_.a.data(), m.error = error_.data();
    const int status = call_step(m);
    if (status != NETLOFT_OK) return status;
    for (std::size_t i = 0; i < error_.size(); ++i)
      if (is_shared(assembler_, i)) error_[i] = 0;  // of another unit, and without a memory
    double sum = 0;
    for (std::size_t i = 0; i < next_.u.size(); ++i) sum += next_.u[i] - next_.u[i] + next_.v[i] - next_.v[i];
    return sum == 0 ? NETLOFT_OK : NETLOFT_OUTSIDE_DOMAIN;
  }

  int call_step(netloft_motion& motion) const {
    const PluginCall call({integrator_.type->type.c_str(), "step", nullptr, CallFrame::Kind::method});
    return integrator_.type->integrator.step(integrator_.parameters, &motion);
  }
  double stable_step(double omega) const {
    const PluginCall call({integrator_.type->type.c_str(), "stable_step", nullptr, CallFrame::Kind::method});
    return integrator_.type->integrator.stable_step(integrator_.parameters, omega);
  }

  double error_over_tolerated() const {
    double largest = 0;
    for (const double e : error_) largest = std::max(largest, std::abs(e));
    return largest / tolerated();
  }

  double growth(double error) const {  // (1)
    const double order = integrator_.type->integrator.order(integrator_.parameters);
    return std::min(2.0, 0.9 * std::pow(std::max(error, 1e-12), -1 / order));
  }

  bool accept(double t, double h, double error) {
    previous_ = state_.t, last_ = t;
    state_.t = t;
    if (settings_.adaptive) state_.h = std::min(h * growth(error), settings_.longest_step), note_error(t);
    std::swap(state_.u, next_.u), std::swap(state_.v, next_.v), std::swap(state_.a, next_.a);
    if (is_looked_at()) judge_ = tried_;
    ++state_.steps;
    result_.shortest = state_.steps == 1 ? h : std::min(result_.shortest, h);
    result_.longest = std::max(result_.longest, h);
    if (!find_mean_forces()) return fail_at_fault();
    if (!winches_.empty()) winches_.accept();
    if (const std::string why = winches_.obstacle(); !why.empty()) return fail_at(why);
    if (!problem_.accept(state_.u)) return fail_at("an element does not tell its members");
    problem_.state().set(t, state_.u, state_.v, state_.a);
    if (!assembler_.remember(problem_.state().x(), problem_.state().motion())) return fail_at_fault();
    if (is_bounded() && state_.steps % kBelieved == 0) ask_tangent(), bound_steps();
    if (settings_.judged && judge_.is_lost(t >= settings_.duration))
      return fail_at(judge_.sentence() + "; " + fastest_node());
    return true;
  }

  /// Of the step that was made, before elements remember its end; for outputs within it.
  bool find_mean_forces() {
    has_means_ = problem_.is_between() && output_time(state_.outputs) <= state_.t;
    return !has_means_ || problem_.find_step_forces(state_.t, state_.u, state_.v, state_.a, mean_forces_);
  }

  void note_error(double t) {
    const double error = error_over_tolerated();
    state_.error_sum += error * allowed();
    if (error * allowed() <= state_.largest_error) return;
    state_.largest_error = error * allowed(), state_.largest_at = t;
    std::size_t worst = 0;
    for (std::size_t i = 0; i < error_.size(); ++i)
      if (std::abs(error_[i]) > std::abs(error_[worst])) worst = i;
    state_.largest_of = assembler_.numbering().node(Dof(worst));
  }

  /// Steps that one which is looked at stands for: several where stability makes them short and many.
  int look_every() const {
    const bool any_is_stable = stable_step(1) == 0;
    return settings_.budget || any_is_stable ? 1 : kLookEvery;
  }
  bool is_looked_at() const {
    return settings_.budget || (watches_energy() && (state_.steps + 1) % look_every() == 0);
  }
  bool watches_energy() const { return settings_.judged || settings_.adaptive; }

  /// Of the step to next_ at time t, which is tried; raises its error to that by (4).
  bool keep_account(double t, double& error) {
    if (!settings_.budget && !budget_.begin(state_.t, state_.u, state_.v, state_.a)) return false;
    const EnergyBudget::Totals before = budget_.totals();
    const MeanStep* mean = problem_.mean_step(next_.u);
    if (problem_.is_between() && !mean) return false;
    if (!budget_.advance(t, next_.u, next_.v, next_.a, mean)) return false;
    const EnergyBudget::Totals after = budget_.totals();
    tried_ = judge_, tried_.note(before, after, look_every());
    if (!settings_.adaptive) return true;
    error = std::max(error, std::abs(after.numerical - before.numerical) / tolerated_energy());
    if (error > 1) budget_.retract();
    return true;
  }

  /// (4); in proportion to the length of steps where these are compared with others.
  double tolerated_energy() const { return settings_.accuracy * settings_.pace * tried_.scale(); }

  std::string fastest_node() const {
    const auto node = [&](std::size_t i) { return assembler_.numbering().node(Dof(i)); };
    double fastest = 0;
    std::uint32_t which = 0;
    for (std::size_t i = 0; i < state_.v.size();) {
      const std::uint32_t at = node(i);
      double sum = 0;
      for (; i < state_.v.size() && node(i) == at; ++i) sum += state_.v[i] * state_.v[i];
      if (!(sum <= fastest)) fastest = sum, which = at;
    }
    char speed[32];
    std::snprintf(speed, sizeof speed, "%.3g m/s", std::sqrt(fastest));
    return assembler_.node_name(scene_, which) + " moves at " + speed;
  }

  /// Ends of steps: outputs, corners of what moves the scene, the end.
  std::vector<double> find_corners() const {
    std::vector<double> all = scene_.corners_in_time();
    for (const auto& family : assembler_.families()) family->add_corners_in_time(all);
    winches_.add_corners(all);
    if (!settings_.dense)
      for (std::size_t i = 0; i < output_count(); ++i) all.push_back(output_time(i));
    all.push_back(settings_.duration);
    std::sort(all.begin(), all.end());
    return all;
  }
  /// The next one, leaving out those that rounding alone has left.
  double next_corner() const {
    const double least = state_.t + 1e-12 * std::max(1.0, settings_.duration);
    const auto next = std::upper_bound(corners_.begin(), corners_.end(), least);
    return next == corners_.end() ? settings_.duration : std::min(*next, settings_.duration);
  }
  std::size_t output_count() const {
    if (settings_.output_interval <= 0) return 2;
    return static_cast<std::size_t>(std::ceil(settings_.duration / settings_.output_interval - 1e-9)) + 1;
  }
  double output_time(std::size_t i) const {
    return i + 1 >= output_count() ? settings_.duration : static_cast<double>(i) * settings_.output_interval;
  }

  void write_outputs() {
    while (state_.outputs < output_count() && output_time(state_.outputs) <= state_.t) {
      const double t = output_time(state_.outputs);
      const bool is_last = state_.outputs + 1 >= output_count() || output_time(state_.outputs + 1) > state_.t;
      if (!compare_paths(t)) return;
      if (is_last)
        write_checkpoint(t);
      else
        write_between(t);
    }
  }

  /// From here on nothing depends on how the march has come here but through what is kept.
  void keep() {
    problem_.algebra().forget_factor();
    state_.memory = assembler_.memory();
    if (settings_.budget && !state_.memory.empty()) budget_.refresh();  // else forces are what they were
    if (settings_.budget) state_.budget = budget_.sums();
    state_.judged = judge_.sums();
    find_forces();
    if (state_.steps == 0) winches_.note_rest(residual_);
    state_.winches = winches_.state();
    problem_.note_loads(residual_);
    state_.least_load = problem_.least_load();
    ++state_.outputs;
  }
  void write_checkpoint(double t) {
    show(t);
    keep();
    tell(t, &state_);
  }
  void write_between(double t) {
    show(t);
    find_forces();
    ++state_.outputs;
    tell(t, nullptr);
  }

  /// At the end of the last step, once for all outputs within it.
  void find_forces() {
    if (forces_after_ == state_.steps) return;
    forces_after_ = state_.steps;
    problem_.state().set(state_.t, state_.u, state_.v, state_.a);
    assembler_.evaluate(problem_.state().x(),
                        {.residual = residual_.data(), .motion = problem_.state().motion()});
  }

  /// The cubic through positions and velocities of the step's ends.
  void show(double t) {
    if (t == state_.t) {
      shown_u_ = state_.u;
      shown_.set(t, state_.u, state_.v, state_.a);
      return;
    }
    std::vector<double> v(state_.u.size()), a(v);
    shown_u_.resize(v.size());
    Course course;
    course.knots = {{previous_, {}, {}}, {last_, {}, {}}};
    Course::Knot &begin = course.knots[0], &end = course.knots[1];
    for (std::size_t i = 0; i < v.size(); i += 3) {  // three unknowns as if they were a place
      const std::size_t some = std::min<std::size_t>(3, v.size() - i);
      std::copy_n(&next_.u[i], some, begin.d.begin()), std::copy_n(&next_.v[i], some, begin.v.begin());
      std::copy_n(&state_.u[i], some, end.d.begin()), std::copy_n(&state_.v[i], some, end.v.begin());
      const Course::Moment m = course.at(t);
      std::copy_n(m.d.begin(), some, &shown_u_[i]);
      std::copy_n(m.v.begin(), some, &v[i]), std::copy_n(m.a.begin(), some, &a[i]);
    }
    shown_.set(t, shown_u_, v, a);
  }

  void tell(double t, const MarchState* state) {
    if (!watch_.on_output) return;
    const std::vector<WinchMoment> winches = winches_.moments(t);
    watch_.on_output(
        {t,
         shown_u_,
         shown_.x(),
         shown_.v(),
         {state_.t, problem_.state().x(), has_means_ ? mean_forces_ : residual_, problem_.state().motion()},
         settings_.budget ? &budget_ : nullptr,
         state,
         winches});
  }
  void tell_of_step() {
    if (is_over_ || !watch_.on_step) return;
    if (watch_.on_step({state_.t, last_ - previous_, settings_.duration, state_.steps, state_.rejected,
                        wall_seconds() - begun_},
                       state_.u))
      end(MarchStatus::stopped, "stopped at t = " + seconds(state_.t));
  }

  std::string trouble() const {
    if (problem_.message()[0]) return problem_.message();
    if (winches_are_lost_) return "no speed of the winches goes with what they bear";
    if (!problem_.trouble().empty()) return problem_.trouble();
    return integrator_.type->is_explicit() ? "motions grow without bound" : "the step does not settle";
  }
  bool fail_in_step() {
    if (limits_.interrupt && limits_.interrupt->load()) return !has_ended();
    if (assembler_.fault().status == NETLOFT_ERROR) return fail_at_fault();
    return fail_at(trouble());
  }
  bool fail_at_fault() { return fail_at(assembler_.fault_sentence(scene_)); }
  bool fail_at(const std::string& why) { return fail("at t = " + seconds(state_.t) + ": " + why); }
  bool fail(const std::string& why) { return !end(MarchStatus::failed, why); }
  bool end(MarchStatus status, const std::string& why) {
    result_.status = status, result_.reason = why;
    return is_over_ = true;
  }

  AchievedAccuracy achieved() const {
    AchievedAccuracy a{.asked = settings_.accuracy, .element = element_size(), .allowed = allowed()};
    a.largest = state_.largest_error, a.t = state_.largest_at, a.sum = state_.error_sum;
    if (a.largest > 0) a.node = assembler_.node_name(scene_, static_cast<std::uint32_t>(state_.largest_of));
    if (!settings_.check) return a;
    a.is_checked = true, a.path = state_.path_error / element_size(), a.path_at = state_.path_at;
    a.path_of =
        std::isfinite(a.path) ? scene_.node_name(static_cast<std::uint32_t>(state_.path_of)) : other_lost_;
    return a;
  }

  MarchResult finish() {
    result_.u = state_.u, result_.t = state_.t;
    result_.steps = state_.steps, result_.rejected = state_.rejected;
    if (settings_.adaptive || settings_.check) result_.accuracy = achieved();
    result_.statistics = work_done();
    result_.statistics.total_seconds = wall_seconds() - begun_;
    result_.statistics.total_cpu_seconds = cpu_seconds() - cpu_begun_;
    if (result_.status == MarchStatus::finished)
      result_.reason =
          "t = " + seconds(state_.t) + " was reached in " + std::to_string(state_.steps) + " steps";
    return std::move(result_);
  }

  const Scene& scene_;
  Assembler& assembler_;
  IntegratorChoice integrator_;
  const Limits& limits_;
  const MarchSettings& settings_;
  const MarchWatch& watch_;
  const MakeFactorisation& make_;
  SolverChoice solver_;
  TransientProblem problem_;
  EnergyBudget budget_;
  EnergyJudge judge_, tried_;  // tried_: with the step that is tried
  MarchState state_, next_;    // next_: the end of the step that is tried; after it, the state before
  MovingState shown_;          // at the output
  Winches winches_;
  std::vector<double> error_, residual_, mean_forces_, shown_u_, corners_;
  double limit_ = 0, previous_ = 0, last_ = 0;
  std::int64_t forces_after_ = -1;  // steps, that residual_ is of
  double begun_ = wall_seconds(), cpu_begun_ = cpu_seconds();
  bool is_over_ = false, winches_are_lost_ = false, has_means_ = false;
  MarchResult result_;
  MarchSettings other_settings_;
  MarchWatch nobody_;
  MarchState other_start_;  // of the march that this one is compared with, if both are at the beginning
  std::unique_ptr<March> other_;
  std::string other_lost_;  // why
};

}  // namespace

MarchResult march(const Scene& scene, Assembler& assembler, IntegratorChoice integrator, SolverChoice solver,
                  const MakeFactorisation& make, const Limits& limits, const MarchSettings& settings,
                  const MarchWatch& watch, const MarchState* from) {
  return March(scene, assembler, integrator, solver, make, limits, settings, watch, from).run();
}

MarchState state_at_rest(const Assembler& assembler, std::span<const double> u) {
  MarchState state;
  state.u.assign(static_cast<std::size_t>(assembler.pattern().size), 0.0);
  std::copy(u.begin(), u.end(), state.u.begin());
  state.v.assign(state.u.size(), 0.0);
  return state;
}

const char* name_of(MarchStatus status) {
  switch (status) {
    case MarchStatus::finished:
      return "finished";
    case MarchStatus::interrupted:
      return "interrupted";
    default:
      return "not finished";
  }
}

}  // namespace netloft
