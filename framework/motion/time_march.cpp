// SPDX-License-Identifier: BSD-3-Clause
#include "framework/motion/time_march.hpp"

#include "framework/balance/shared_unknowns.hpp"
#include "framework/motion/energy_watch.hpp"
#include "framework/motion/march_times.hpp"
#include "framework/motion/scheme_probe.hpp"
#include "framework/motion/shown_state.hpp"
#include "framework/motion/step_control.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace netloft {

namespace {

/// The limits without the budget of work, which applies to the whole march and not to one step.
Limits without_work(Limits limits) {
  limits.model = nullptr;
  return limits;
}

/// Times at which prescribed motions have corners [s].
std::vector<double> corners_of(const AssembledScene& of, const Winches& winches) {
  std::vector<double> all = of.scene.corners_in_time();
  for (const auto& family : of.assembler.families()) family->add_corners_in_time(all);
  winches.add_corners(all);
  return all;
}

/// One march (an integration in time). The methods follow the order of events in a step.
class March {
 public:
  March(const AssembledScene& of, const StepMethods& methods, const Limits& limits,
        const MarchSettings& settings, const MarchWatch& watch, const MarchState* from)
      : of_(of),
        methods_(methods),
        limits_(limits),
        other_limits_(limits_of_comparison(limits)),
        settings_(settings),
        watch_(watch),
        scheme_(methods.integrator),
        problem_(of.assembler, settings.mass_damping, methods.solver, of.make, without_work(limits)),
        control_(settings, scheme_, problem_.algebra().scales().element_size()),
        energy_(of.assembler, settings, scheme_.has_limit()),
        earlier_(from ? from->statistics : Statistics{}),
        state_(from ? *from : state_at_rest(of.assembler)),
        next_(state_),
        shown_(of.assembler, settings.mass_damping),
        winches_(of.scene, of.assembler, limits.tolerance),
        times_(settings, corners_of(of, winches_)),
        error_(state_.u.size()),
        residual_(of.assembler.numbering().dofs()),
        mean_forces_(residual_.size()),
        other_start_(state_) {
    winches_.set_state(state_.winches);
  }

  MarchResult run() {
    if (begin() && begin_other() && follows())
      while (state_.t < settings_.duration && !has_ended()) {
        if (!shorten_rotations() || !make_step()) break;
        write_outputs();
        report_step();
      }
    if (!is_over_ && state_.steps > 0) follows();
    return finish();
  }

  /// Continues to the time t or beyond, without outputs. Returns false if it failed or was interrupted.
  bool reach(double t) {
    assembler_.set_memory(state_.memory);
    winches_.restore();
    bool moves = true;
    while (moves && state_.t < t && !has_ended()) moves = shorten_rotations() && make_step();
    if (state_.t < t) return false;
    keep();
    if (settings_.dense) {
      state_.t_before = next_.t;
      state_.u_before = next_.u;
      state_.v_before = next_.v;
    }
    return true;
  }

 private:
  bool begin() {
    result_.status = MarchStatus::finished;
    winches_.restore();
    if (!state_.memory.empty()) assembler_.set_memory(state_.memory);
    problem_.set_least_load(state_.least_load);
    if (scheme_.is_explicit())
      if (const std::string why = problem_.obstacle_to_explicit(scene_); !why.empty()) return fail(why);
    if (state_.a.empty()) {
      state_.a.resize(state_.u.size());
      if (problem_.start(state_.t, state_.u, state_.v, state_.a) != NETLOFT_OK)
        return fail("there are no forces at the start: " + assembler_.fault_sentence(scene_));
      note_start();
    }
    next_.u.resize(state_.u.size());
    next_.v = next_.a = next_.u;
    if (!energy_.begin(state_, problem_.least_load() * control_.element_size())) return fail_at_fault();
    control_.find_limit(problem_, state_);
    result_.stable_step = control_.stable_step();
    if (state_.h == 0) state_.h = control_.first_step(state_.a);
    if (!state_.u_before.empty()) {
      next_.t = state_.t_before;
      next_.u = state_.u_before;
      next_.v = state_.v_before;
    }
    if (state_.memory.empty()) state_.memory = assembler_.memory();
    if (state_.outputs == 0 && !has_companion()) write_checkpoint(state_.t);
    return true;
  }

  /// Whether the scheme follows the equation of motion from the current state (scheme_probe.hpp); if not, the
  /// march fails. A march that only searches for an equilibrium is not tested, because only its end matters.
  bool follows() {
    if (!settings_.judged) return true;
    SchemeProbe probe(assembler_, settings_.mass_damping, methods_.solver, of_.make, without_work(limits_));
    const std::string fault = probe.fault_of(scheme_, state_);
    return fault.empty() || fail_at(fault);
  }

  bool has_companion() const { return settings_.check || settings_.disturb; }

  /// Creates the march for comparison, at the start or at its last stored state, without making a step.
  bool begin_other() {
    if (!has_companion()) return true;
    other_settings_ = settings_.check ? settings_of_comparison(settings_, scheme_.has_limit())
                                      : settings_of_disturbed(settings_);
    const std::vector<double> own = assembler_.memory();
    if (state_.outputs == 0) {
      state_.other = {other_start_};
      if (settings_.disturb) disturb(state_.other[0], control_.element_size());
    }
    if (!state_.other.empty()) {
      other_ =
          std::make_unique<March>(of_, methods_, other_limits_, other_settings_, nobody_, &state_.other[0]);
      if (!other_->begin() || !other_->begin_other()) lose_other();
      assembler_.set_memory(own);
      winches_.restore();
    }
    if (state_.outputs == 0) write_checkpoint(state_.t);
    return true;
  }
  void lose_other() {
    state_.why_lost = other_->result_.reason;
    state_.path_error = std::numeric_limits<double>::infinity();
    state_.path_at = other_->state_.t;
    other_.reset();
    state_.other.clear();
  }

  /// Compares this march and the march for comparison at an output (achieved_accuracy.hpp). Returns false if
  /// interrupted.
  bool compare_paths(double t) {
    if (!other_ || !other_->times_.is_output(t)) return true;
    const std::vector<double> own = assembler_.memory();
    const bool is_there = other_->reach(t) && other_->compare_paths(t);
    assembler_.set_memory(own);
    winches_.restore();
    if (!is_there && other_->result_.status == MarchStatus::interrupted) return !has_ended();
    if (!is_there) return lose_other(), true;
    show(t);
    other_->show(t);
    const auto here = assembler_.node_positions(shown_.x()),
               there = assembler_.node_positions(other_->shown_.x());
    if (settings_.disturb)
      note_parting(here, there, t, settings_.accuracy * control_.element_size(), state_);
    else if (std::isinf(other_->state_.parted_at))
      note_path_error(here, there, t, other_->state_.mean_step() / state_.mean_step(), state_);
    state_.other = {other_->state_};
    return true;
  }
  void note_start() {
    const Balance b = problem_.balance();
    state_.start = {b.residual, b.scale, assembler_.node_name(scene_, b.worst)};
  }

  /// Shortens rotation vectors between two steps, after the report of the last step. Positions and velocities
  /// do not change. Returns false if an element failed.
  bool shorten_rotations() {
    if (!assembler_.shorten_rotations(state_.u, state_.v, state_.a)) return true;
    return energy_.restate(state_) || fail_at_fault();
  }

  bool has_ended() {
    if (limits_.interrupt && limits_.interrupt->load())
      return end(MarchStatus::interrupted, "interrupted at t = " + seconds_text(state_.t));
    if (cpu_seconds() - cpu_begun_ > limits_.seconds)
      return end(MarchStatus::out_of_time, "the time limit was reached at t = " + seconds_text(state_.t));
    if (limits_.model && limits_.model->of(work_done()) >= limits_.work)
      return end(MarchStatus::out_of_work, "the budget of work was spent at t = " + seconds_text(state_.t));
    return is_over_;
  }
  /// Work of this march and of the marches for comparison.
  Statistics work_done() const {
    Statistics all = own_work();
    if (other_) all.add(other_->work_done());
    return all;
  }
  /// Work of this march, including its work before an interruption.
  Statistics own_work() const {
    Statistics all = earlier_;
    all.add(problem_.statistics());
    return all;
  }
  void add_times(Statistics& work) const {
    work.total_seconds = earlier_.total_seconds + wall_seconds() - begun_;
    work.total_cpu_seconds = earlier_.total_cpu_seconds + cpu_seconds() - cpu_begun_;
  }

  /// Attempts steps until one is accepted.
  bool make_step() {
    for (;;) {
      const double corner = times_.next_corner(state_.t), rest = corner - state_.t;
      const double parts = std::max(1.0, std::ceil(rest / std::min(state_.h, control_.limit()) - 1e-9));
      const double h = rest / parts;
      const double end = parts == 1 ? corner : state_.t + h;
      const int status = try_step(h);
      double error = status == NETLOFT_OK && settings_.adaptive ? control_.error_over_tolerated(error_) : 0;
      if (status == NETLOFT_OK && error <= 1 && energy_.watches_step_after(state_) &&
          !energy_.examine(problem_, state_, next_, end, error))
        return fail_at_fault();
      if (status == NETLOFT_OK && error <= 1) return accept(end, h, error);
      // The step may have failed because a limit of the whole march was reached.
      if (status != NETLOFT_OK && has_ended()) return false;
      if (status < 0) return fail_in_step();
      ++state_.rejected;
      if (!settings_.adaptive) return fail_at("the step " + seconds_text(h) + " is too long: " + trouble());
      state_.h = status == NETLOFT_OK ? control_.shorter_step(h, error) : 0.25 * h;
      if (state_.h < settings_.shortest_step)
        return fail_at("all steps down to " + seconds_text(settings_.shortest_step) +
                       " failed: " + trouble());
    }
  }

  /// Attempts a step. If some winches hold a tension, repeats the step until the speeds of these winches fit
  /// their tensions.
  int try_step(double h) {
    if (winches_.empty()) return try_once(h);
    // The linear stiffness depends on rope lengths. It is evaluated anew here because a resumed march also
    // evaluates it here.
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
    m.t = state_.t;
    m.h = h;
    m.u = state_.u.data();
    m.v = state_.v.data();
    m.a = state_.a.data();
    m.u_new = next_.u.data();
    m.v_new = next_.v.data();
    m.a_new = next_.a.data();
    m.error = error_.data();
    const int status = scheme_.step(m);
    if (status != NETLOFT_OK) return status;
    for (std::size_t i = 0; i < error_.size(); ++i)
      // An unknown that the elements of a part share is not a length and does not depend on the past, so it
      // has no error.
      if (is_shared(assembler_, i)) error_[i] = 0;
    double sum = 0;
    for (std::size_t i = 0; i < next_.u.size(); ++i) sum += next_.u[i] - next_.u[i] + next_.v[i] - next_.v[i];
    return sum == 0 ? NETLOFT_OK : NETLOFT_OUTSIDE_DOMAIN;
  }

  bool accept(double t, double h, double error) {
    next_.t = state_.t;
    state_.t = t;
    if (settings_.adaptive) {
      state_.h = control_.next_step(h, error);
      note_step_error(control_, assembler_.numbering(), error_, t, state_);
    }
    std::swap(state_.u, next_.u);
    std::swap(state_.v, next_.v);
    std::swap(state_.a, next_.a);
    if (energy_.watches_step_after(state_)) energy_.accept();
    ++state_.steps;
    state_.shortest = state_.steps == 1 ? h : std::min(state_.shortest, h);
    state_.longest = std::max(state_.longest, h);
    if (!find_mean_forces()) return fail_at_fault();
    if (!winches_.empty()) winches_.accept();
    if (const std::string why = winches_.obstacle(); !why.empty()) return fail_at(why);
    if (!problem_.accept(state_.u)) return fail_at("an element does not report its members");
    problem_.state().set(t, state_.u, state_.v, state_.a);
    if (!assembler_.remember(problem_.state().x(), problem_.state().motion())) return fail_at_fault();
    control_.follow_tangent(problem_, state_);
    if (energy_.is_lost(t >= settings_.duration))
      return fail_at(energy_.sentence() + "; " + fastest_node(of_, state_.v));
    return true;
  }

  /// Computes the mean forces of the last step, for outputs within this step. Must be called before elements
  /// store the end of the step in their memory. Returns false if an element failed.
  bool find_mean_forces() {
    has_means_ = problem_.is_between() && times_.output(state_.outputs) <= state_.t;
    return !has_means_ || problem_.find_step_forces(state_.t, state_.u, state_.v, state_.a, mean_forces_);
  }

  void write_outputs() {
    const std::size_t count = times_.output_count();
    while (state_.outputs < count && times_.output(state_.outputs) <= state_.t) {
      const double t = times_.output(state_.outputs);
      const bool is_last = state_.outputs + 1 >= count || times_.output(state_.outputs + 1) > state_.t;
      if (!compare_paths(t)) return;
      if (is_last)
        write_checkpoint(t);
      else
        write_between(t);
    }
  }

  /// Stores the state. The rest of the march depends on this state alone, not on anything before.
  void keep() {
    problem_.algebra().forget_factor();
    state_.memory = assembler_.memory();
    energy_.keep_in(state_, !state_.memory.empty());
    find_forces();
    if (state_.steps == 0) winches_.note_rest(residual_);
    state_.winches = winches_.state();
    problem_.note_loads(residual_);
    state_.least_load = problem_.least_load();
    state_.statistics = own_work();
    add_times(state_.statistics);
    ++state_.outputs;
  }
  void write_checkpoint(double t) {
    show(t);
    keep();
    report(t, &state_);
  }
  void write_between(double t) {
    show(t);
    find_forces();
    ++state_.outputs;
    report(t, nullptr);
  }

  /// Evaluates the forces at the end of the last step, only once even if several outputs are within the step.
  void find_forces() {
    if (forces_after_ == state_.steps) return;
    forces_after_ = state_.steps;
    problem_.state().set(state_.t, state_.u, state_.v, state_.a);
    assembler_.evaluate(problem_.state().x(),
                        {.residual = residual_.data(), .motion = problem_.state().motion()});
  }

  void show(double t) { t == state_.t ? shown_.show(state_) : shown_.show_between(next_, state_, t); }

  void report(double t, const MarchState* state) {
    if (!watch_.on_output) return;
    const std::vector<WinchMoment> winches = winches_.moments(t);
    watch_.on_output(
        {t,
         shown_.u(),
         shown_.x(),
         shown_.v(),
         {state_.t, problem_.state().x(), has_means_ ? mean_forces_ : residual_, problem_.state().motion()},
         energy_.budget(),
         state,
         winches,
         energy_.judge()});
  }
  void report_step() {
    if (is_over_ || !watch_.on_step) return;
    if (watch_.on_step({state_.t, state_.t - next_.t, settings_.duration, state_.steps, state_.rejected,
                        wall_seconds() - begun_},
                       state_.u))
      end(MarchStatus::stopped, "stopped at t = " + seconds_text(state_.t));
  }

  std::string trouble() const {
    if (problem_.message()[0]) return problem_.message();
    if (winches_are_lost_) return "no speed of the winches agrees with their tensions";
    if (!problem_.trouble().empty()) return problem_.trouble();
    return scheme_.is_explicit() ? "motions grow without bound" : "the step does not settle";
  }
  bool fail_in_step() {
    if (assembler_.fault().status == NETLOFT_ERROR) return fail_at_fault();
    return fail_at(trouble());
  }
  bool fail_at_fault() { return fail_at(assembler_.fault_sentence(scene_)); }
  bool fail_at(const std::string& why) { return fail("at t = " + seconds_text(state_.t) + ": " + why); }
  bool fail(const std::string& why) { return !end(MarchStatus::failed, why); }
  bool end(MarchStatus status, const std::string& why) {
    result_.status = status;
    result_.reason = why;
    return is_over_ = true;
  }

  MarchResult finish() {
    result_.u = state_.u;
    result_.t = state_.t;
    result_.steps = state_.steps;
    result_.rejected = state_.rejected;
    result_.shortest = state_.shortest;
    result_.longest = state_.longest;
    result_.start = state_.start;
    if (settings_.adaptive || settings_.check)
      result_.accuracy = achieved_accuracy(of_, settings_, control_, state_);
    result_.statistics = work_done();
    add_times(result_.statistics);
    if (result_.status == MarchStatus::finished)
      result_.reason =
          "t = " + seconds_text(state_.t) + " was reached in " + std::to_string(state_.steps) + " steps";
    result_.reason += state_.remark;
    return std::move(result_);
  }

  const AssembledScene& of_;
  const Scene& scene_ = of_.scene;
  Assembler& assembler_ = of_.assembler;
  const StepMethods& methods_;
  const Limits& limits_;
  const Limits other_limits_;  // limits of the march for comparison
  const MarchSettings& settings_;
  const MarchWatch& watch_;
  StepScheme scheme_;
  TransientProblem problem_;
  StepControl control_;
  EnergyWatch energy_;
  const Statistics earlier_;  // cost before an interruption, if this march was resumed
  // state_ is the end of the last accepted step, next_ the end of the attempted step. Accepting a step swaps
  // the two, so that next_ is then the beginning of the accepted step.
  MarchState state_, next_;
  ShownState shown_;
  Winches winches_;
  MarchTimes times_;
  std::vector<double> error_, residual_, mean_forces_;
  std::int64_t forces_after_ = -1;  // number of steps when residual_ was evaluated
  double begun_ = wall_seconds(), cpu_begun_ = cpu_seconds();
  bool is_over_ = false, winches_are_lost_ = false, has_means_ = false;
  MarchResult result_;
  MarchSettings other_settings_;
  MarchWatch nobody_;
  MarchState other_start_;  // start of the march for comparison, unless this march was resumed
  std::unique_ptr<March> other_;
};

}  // namespace

MarchResult march(const AssembledScene& scene, const StepMethods& methods, const Limits& limits,
                  const MarchSettings& settings, const MarchWatch& watch, const MarchState* from) {
  return March(scene, methods, limits, settings, watch, from).run();
}

}  // namespace netloft
