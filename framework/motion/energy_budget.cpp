// SPDX-License-Identifier: BSD-3-Clause
#include "framework/motion/energy_budget.hpp"

#include "framework/assembler/reports.hpp"

#include <netloft/vectors.hpp>

#include <algorithm>

namespace netloft {

namespace {

/// Fraction of a step over which the power of winches is evaluated. It is so small that a loaded rope stays
/// taut while it is paid out, and so large that differences of energies have 10 digits. Values from 1e-3 to
/// 1e-8 give the same work of a loaded winch within 0.1 %; 1e-2 gives 8 % less.
constexpr double kPartOfStep = 1e-4;

/// Whether a term is a damper: it resists a velocity and depends neither on the flow of water nor on a
/// memory, so that it can be evaluated at any point.
bool is_damper(const netloft_term& term) {
  return (term.traits & NETLOFT_READS_VELOCITY) && (term.traits & NETLOFT_NEEDS_MOTION) &&
         !(term.traits & (NETLOFT_NEEDS_FLOW | NETLOFT_READS_GROUND));
}

}  // namespace

EnergyBudget::EnergyBudget(Assembler& assembler, double mass_damping)
    : assembler_(assembler),
      state_(assembler, 0),
      mass_damping_(mass_damping),
      is_guided_(assembler.is_guided()),
      zero_(static_cast<std::size_t>(assembler.numbering().unknowns()), 0.0),
      scratch_(assembler.numbering().dofs()) {
  const auto account = [](std::vector<Account>& all, const std::string& name) -> Account& {
    for (auto& a : all)
      if (a.name == name) return a;
    return all.emplace_back(Account{name, {}});
  };
  for (std::size_t f = 0; f < assembler.families().size(); ++f)
    for (std::size_t t = 0; t < assembler.families()[f]->active_terms().size(); ++t) {
      const netloft_term& term = assembler.families()[f]->active_terms()[t];
      reads_time_ |= (term.traits & (NETLOFT_READS_TIME | NETLOFT_READS_WAVES)) != 0;
      Account& to = term.traits & NETLOFT_READS_ACCELERATION ? inertia_
                    : term.traits & NETLOFT_CONSERVATIVE     ? account(stored_, term.name)
                                                             : account(work_, term.name);
      to.terms.emplace_back(f, t);
      to.in_the_middle |= is_damper(term);
    }
  for (Moment* m : {&now_, &next_}) m->works.resize(work_.size());
}

bool EnergyBudget::begin(double t, std::span<const double> u, std::span<const double> v,
                         std::span<const double> a) {
  place(t, u, v, a, now_);
  double energy = 0;
  if (!find_forces(now_) || !find_energies(now_.x, t, energy, true)) return false;
  for (Account& s : stored_) s.first = s.value;
  first_kinetic_ = kinetic_;
  return true;
}

bool EnergyBudget::advance(double t, std::span<const double> u, std::span<const double> v,
                           std::span<const double> a, const MeanStep* mean) {
  place(t, u, v, a, next_);
  keep_values();
  if (reads_time_ && !add_winches(mean)) return false;
  const double kinetic_before = kinetic_;
  double energy = 0;
  if (!find_forces(next_) || !find_energies(next_.x, t, energy, true)) return false;
  if (!(mean ? add_means(*mean, kinetic_before) : add_ends())) return false;
  state_.set(t, u, v, a);
  std::swap(now_, next_);
  return true;
}

void EnergyBudget::keep_values() {
  before_ = sums();
  before_.push_back(kinetic_);
  for (const Account& s : stored_) before_.push_back(s.value);
}

void EnergyBudget::retract() {
  set_sums(before_);
  auto value = before_.end() - static_cast<std::ptrdiff_t>(stored_.size()) - 1;
  kinetic_ = *value++;
  for (Account& s : stored_) s.value = *value++;
  std::swap(now_, next_);
}

/// Adds the work of winches in a step, (7) of energy_budget.hpp, from the power ∂E/∂t, at constant positions,
/// at both ends of the step. A difference of E over the whole step at constant positions would be wrong: the
/// rope would be stretched by all the length hauled in during the step, many times its actual strain, and E
/// rises with the square of the strain.
bool EnergyBudget::add_winches(const MeanStep* mean) {
  if (mean) return add_winches_of_means(mean->t);
  const double h = next_.t - now_.t;
  double before = 0, after = 0;
  if (!find_power(now_, h, before) || !find_power(next_, -h, after)) return false;
  winches_ += 0.5 * h * (before + after);
  return true;
}

/// Evaluates the power ∂E/∂t at a moment by a one-sided difference of second order. `h` [s] is negative at
/// the end of a step, so that the difference lies within the step.
bool EnergyBudget::find_power(const Moment& m, double h, double& power) {
  const double tau = kPartOfStep * h;
  double here = 0, near = 0, far = 0;
  if (!find_energies(m.x, m.t, here, false) || !find_energies(m.x, m.t + tau, near, false) ||
      !find_energies(m.x, m.t + 2 * tau, far, false))
    return false;
  power = (4 * (near - here) - (far - here)) / (2 * tau);
  return true;
}

/// Adds the work of winches, (7) of energy_budget.hpp, in a step with mean forces, whose middle is at the
/// time `middle`. This work is the change of the energy minus the work of the mean forces.
bool EnergyBudget::add_winches_of_means(double middle) {
  double early[2], late[2];
  if (!find_energies(now_.x, now_.t, early[0], false) || !find_energies(now_.x, next_.t, late[0], false) ||
      !find_energies(next_.x, now_.t, early[1], false) || !find_energies(next_.x, next_.t, late[1], false))
    return false;
  if (early[0] == late[0] && early[1] == late[1]) return true;
  std::vector<double> u(zero_.size());
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = 0.5 * (now_.q[i] + next_.q[i]);
  force_.assign(scratch_.size(), 0.0);
  middle_ = now_.x;
  assembler_.place(u, middle_, middle);
  const StepEnds ends{now_.x.data(), next_.x.data(), next_.t - now_.t, 0};
  if (!assembler_.evaluate(middle_, {.conservative_only = true,
                                     .residual = force_.data(),
                                     .motion = {.time = middle},
                                     .between = &ends}))
    return false;
  winches_ += late[1] - early[0] - done(force_, force_);
  return true;
}

bool EnergyBudget::add_ends() {
  if (!add_works() || !find_entrained()) return false;
  damped_ += done(now_.damping, next_.damping);
  holds_ += done(now_.holds, next_.holds);
  return true;
}

/// Adds the work of all forces in a step with mean forces, (8) of energy_budget.hpp. For guided degrees of
/// freedom (moved along given paths), the rate is the displacement divided by the step length.
bool EnergyBudget::add_means(const MeanStep& mean, double kinetic_before) {
  state_.set(mean.t, mean.u, mean.v, mean.a);
  middle_ = state_.x();
  const Kinematics motion = state_.motion();
  for (Account& work : work_) {
    if (!sum_force(work, middle_, motion, force_)) return false;
    work.value += done(force_, force_);
  }
  if (!sum_force(inertia_, middle_, motion, force_)) return false;
  find_mean_rates();
  const double h = next_.t - now_.t;
  for (std::size_t i = zero_.size(); i < mean_own_rates_.size(); ++i)
    mean_own_rates_[i] = (next_.q[i] - now_.q[i]) / h;
  entrained_ += h * dot(force_, mean_own_rates_) - (kinetic_ - kinetic_before);
  if (is_guided_) holds_ += done(mean.reactions, mean.reactions, zero_.size());
  if (mass_damping_ == 0) return true;
  Kinematics as_rates = motion;
  as_rates.v = nullptr;
  as_rates.a = state_.v().data();
  if (!sum_force(inertia_, middle_, as_rates, force_)) return false;
  damped_ += mass_damping_ * done(force_, force_);
  return true;
}

/// Sets the state of `to`. The vector to.q contains displacements of unknowns and positions of held degrees
/// of freedom. Positions of held degrees of freedom change only if a guide moves them.
void EnergyBudget::place(double t, std::span<const double> u, std::span<const double> v,
                         std::span<const double> a, Moment& to) {
  const auto put = [](std::span<const double> own, std::vector<double>& all) {
    std::copy(own.begin(), own.end(), all.begin());
  };
  state_.set(t, zero_, zero_, zero_);
  to.q = state_.x();
  to.rates = state_.v();
  put(u, to.q);
  put(v, to.rates);
  state_.set(t, u, v, a);
  to.t = t;
  to.x = state_.x();
  to.v = state_.v();
}

/// Adds the works of drag, damping and friction in a step, (5) of energy_budget.hpp.
bool EnergyBudget::add_works() {
  const double h = next_.t - now_.t;
  middle_.resize(now_.x.size());
  secant_.resize(now_.x.size());
  for (std::size_t i = 0; i < now_.x.size(); ++i) {
    middle_[i] = 0.5 * (now_.x[i] + next_.x[i]);
    secant_[i] = (next_.x[i] - now_.x[i]) / h;
  }
  for (std::size_t k = 0; k < work_.size(); ++k) {
    if (!work_[k].in_the_middle) {
      work_[k].value += done(now_.works[k], next_.works[k]);
      continue;
    }
    Kinematics motion;
    motion.time = now_.t + 0.5 * h;
    motion.v = secant_.data();
    if (!sum_force(work_[k], middle_, motion, force_)) return false;
    work_[k].value += done(force_, force_);
  }
  return true;
}

void EnergyBudget::find_mean_rates() {
  mean_rates_.resize(now_.v.size());
  mean_own_rates_.resize(now_.v.size());
  for (std::size_t i = 0; i < now_.v.size(); ++i) {
    mean_rates_[i] = 0.5 * (now_.v[i] + next_.v[i]);
    mean_own_rates_[i] = 0.5 * (now_.rates[i] + next_.rates[i]);
  }
}

/// Adds the energy that added mass takes in a step, (4) of energy_budget.hpp. For the second term of (4), M v
/// is evaluated at the mean velocity of the step, once with the masses at its end and once with the masses at
/// its start.
bool EnergyBudget::find_entrained() {
  find_mean_rates();
  Kinematics as_rates;
  as_rates.a = mean_rates_.data();
  if (!sum_force(inertia_, now_.x, as_rates, momentum_) || !sum_force(inertia_, next_.x, as_rates, turned_))
    return false;
  entrained_ -= 0.5 * (dot(turned_, mean_own_rates_) - dot(momentum_, mean_own_rates_));
  entrained_ += done(now_.turning, next_.turning);
  return true;
}

bool EnergyBudget::restate(double t, std::span<const double> u, std::span<const double> v,
                           std::span<const double> a) {
  place(t, u, v, a, now_);
  return find_forces(now_);
}

/// Evaluates r_M(0, v) of (4) in energy_budget.hpp at the moment m: the inertia force of bodies that turn at
/// a constant rate. state_ must have been set to m.
bool EnergyBudget::find_turning(Moment& m) {
  m.turning.clear();
  if (!assembler_.has_bodies()) return true;
  std::vector<double> v(m.rates.begin(), m.rates.begin() + static_cast<std::ptrdiff_t>(zero_.size())),
      all_v(m.x.size()), all_a(m.x.size());
  assembler_.move(m.t, m.x, v, zero_, all_v, all_a);
  return sum_force(inertia_, m.x, {.time = m.t, .v = all_v.data(), .a = all_a.data()}, m.turning);
}

/// Evaluates the forces at the moment m; state_ must have been set to m.
bool EnergyBudget::find_forces(Moment& m) {
  const Kinematics motion = state_.motion();
  for (std::size_t k = 0; k < work_.size(); ++k)
    if (!work_[k].in_the_middle && !sum_force(work_[k], m.x, motion, m.works[k])) return false;
  Kinematics as_rates = motion;
  as_rates.v = nullptr;
  as_rates.a = state_.v().data();  // with a = v, the inertia force is the momentum M v
  if (!sum_force(inertia_, m.x, as_rates, m.damping)) return false;
  kinetic_ = 0.5 * dot(m.damping, m.rates);  // (3)
  if (!find_turning(m)) return false;
  for (double& f : m.damping) f *= mass_damping_;
  m.holds.assign(is_guided_ ? m.q.size() : 0, 0.0);
  if (!is_guided_) return true;
  if (!assembler_.evaluate(m.x, {.residual = m.holds.data(), .motion = motion})) return false;
  for (std::size_t i = 0; i < m.holds.size(); ++i)
    m.holds[i] = i < zero_.size() ? 0 : m.holds[i] + m.damping[i];
  return true;
}

bool EnergyBudget::find_energies(const std::vector<double>& x, double t, double& sum, bool keep) {
  sum = 0;
  for (Account& account : stored_) {
    double energy = 0;
    for (const auto& [family, term] : account.terms) {
      double part = 0;
      if (!assembler_.reports().term_energy(x, family, term, part, {.time = t})) return false;
      energy += part;
    }
    if (keep) account.value = energy;
    sum += energy;
  }
  return true;
}

bool EnergyBudget::sum_force(const Account& account, const std::vector<double>& x, const Kinematics& motion,
                             std::vector<double>& force) {
  force.assign(scratch_.size(), 0.0);
  for (const auto& [family, term] : account.terms) {
    if (!assembler_.reports().evaluate_term(x, family, term, scratch_, motion)) return false;
    for (std::size_t i = 0; i < force.size(); ++i) force[i] += scratch_[i];
  }
  return true;
}

/// Work from the state now_ to the state next_ by the trapezoidal rule. `before` and `after` are the forces
/// at now_ and at next_. Degrees of freedom before the index `from` do not count.
double EnergyBudget::done(const std::vector<double>& before, const std::vector<double>& after,
                          std::size_t from) const {
  double sum = 0;
  for (std::size_t i = from; i < after.size(); ++i)
    sum += 0.5 * (before[i] + after[i]) * (next_.q[i] - now_.q[i]);
  return sum;
}

std::vector<std::string> EnergyBudget::names() const {
  std::vector<std::string> names = {"kinetic"};
  for (const auto& s : stored_) names.push_back(s.name);
  names.push_back("entrained");
  for (const auto& w : work_) names.push_back(w.name + "_work");
  names.insert(names.end(), {"mass_damping_work", "work_of_holds", "work_of_winches", "numerical"});
  return names;
}

std::vector<double> EnergyBudget::values() const {
  std::vector<double> values = {kinetic_};
  for (const auto& s : stored_) values.push_back(s.value);
  values.push_back(entrained_);
  for (const auto& w : work_) values.push_back(w.value);
  values.insert(values.end(), {damped_, holds_, winches_, numerical()});
  return values;
}

double EnergyBudget::numerical() const {
  double gained = kinetic_ - first_kinetic_ + entrained_, spent = damped_;
  for (const auto& s : stored_) gained += s.value - s.first;
  for (const auto& w : work_) spent += w.value;
  return holds_ + winches_ - gained - spent;
}

EnergyBudget::Totals EnergyBudget::totals() const {
  Totals all{kinetic_, 0, numerical(), {holds_, winches_}};
  for (const auto& s : stored_) all.stored += s.value;
  for (const auto& w : work_) all.given.push_back(-w.value);
  return all;
}

std::vector<double> EnergyBudget::sums() const {
  std::vector<double> sums = {first_kinetic_, entrained_, damped_, holds_, winches_};
  for (const auto& s : stored_) sums.push_back(s.first);
  for (const auto& w : work_) sums.push_back(w.value);
  return sums;
}

void EnergyBudget::set_sums(std::span<const double> sums) {
  first_kinetic_ = sums[0];
  entrained_ = sums[1];
  damped_ = sums[2];
  holds_ = sums[3];
  winches_ = sums[4];
  std::size_t k = 5;
  for (auto& s : stored_) s.first = sums[k++];
  for (auto& w : work_) w.value = sums[k++];
}

}  // namespace netloft
