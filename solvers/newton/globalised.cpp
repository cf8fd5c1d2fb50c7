// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/newton/aside_search.hpp"
#include "solvers/newton/least_curvature.hpp"
#include "solvers/newton/line_search.hpp"
#include "solvers/newton/methods.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace netloft::newton {

namespace {

double dot(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// Energies this close cannot be told apart: rounding of a sum of many terms. Of so many such steps none goes
/// uphill.
constexpr double kEnergyNoise = 1e-13, kRoundings = 10;
// Damping never needs to exceed the metric itself by much, and below the lower end it no longer matters.
constexpr double kLargestDamping = 64, kSmallestDamping = 1e-12;
// K is hardly indefinite where a σ between the latter two makes it positive definite; only asked where
// damping is below the first, or no step leads on.
constexpr double kHardlyDamped = 1e-6, kLeastSigma = 1e-7, kMostSigma = 1e-4;
// Less of the convex part is as good as none.
constexpr double kLeastShare = 1.0 / 4096;
// Steps along which the search ends beyond the first of these are not short. Where none leads on, the bend is
// found by forces so near. A bent step must gain so many times what the straight one does.
constexpr double kHardlyShort = 0.9, kShortBend = 1e-2, kBentGain = 1.5;
// So many steps in a row that promise no less to gain than before: (8) leads nowhere.
constexpr int kStalled = 5;

class Globalised {
 public:
  Globalised(const Newton::Parameters& parameters, Problem& problem)
      : p_(parameters),
        problem_(problem),
        mu_(parameters.damping),
        r_(problem.size()),
        s_(problem.size()),
        trial_(problem.size()),
        r_trial_(problem.size()),
        curvature_(problem.symmetric() ? problem.size() : 0),
        d_(problem.conservative() ? 0 : problem.size()) {
    for (auto* v : {&left_, &bend_}) v->reserve(problem.size());
  }

  Outcome run() {
    if (problem_.evaluate(problem_.u(), energy_, r_, Matrix::exact) != Evaluation::ok)
      return Outcome::left_domain;
    bool first = true;
    while (problem_.progress(problem_.u(), energy_, r_, note_)) {
      if (!find_d()) return Outcome::left_domain;
      if (!(std::exchange(first, false) && find_short_step()) && !find_step()) return Outcome::linear_solve;
      const bool moved = search_line();
      if (std::exchange(at_saddle_, false) && leave_saddle()) continue;
      if (!moved && !go_on_softly()) {
        if (mu_ >= kLargestDamping) return Outcome::step_too_short;
        mu_ = std::clamp(mu_ * 16, 1e-6, kLargestDamping);
      }
    }
    return Outcome::stopped;
  }

 private:
  /// d = r − g of (3).
  bool find_d() {
    if (d_.empty()) return true;
    double energy = 0;
    if (problem_.evaluate_gradient(problem_.u(), energy, d_) != Evaluation::ok) return false;
    for (std::size_t i = 0; i < d_.size(); ++i) d_[i] = r_[i] - d_[i];
    return true;
  }

  /// A start that is near needs no damping: then Newton's own step is no longer than an element.
  bool find_short_step() {
    if (problem_.factorise(Matrix::exact, 0) != Factor::ok) return false;
    solve_for_step();
    if (problem_.step_length(s_) > 1 || dot(r_, s_) >= 0) return false;
    mu_ = 0;
    return true;
  }

  bool find_step() { return problem_.symmetric() ? find_symmetric_step() : find_downhill_step(); }

  /// Solves (2) for s; the factorisation itself tells whether the matrix is positive definite.
  bool find_symmetric_step() {
    note_ = "";
    Factor factor = problem_.factorise(Matrix::exact, mu_);
    if (factor == Factor::ok) may_be_hardly_ = true;
    if (factor == Factor::not_positive && (may_be_hardly_ = is_hardly_indefinite())) factor = Factor::ok;
    if (factor == Factor::not_positive) {
      if (problem_.evaluate(problem_.u(), Matrix::convex) != Evaluation::ok) return false;
      factor = factorise_partly_convex();
    }
    if (factor != Factor::ok) return false;
    solve_for_step();
    return true;
  }

  /// K + θ (K₊ − K), with half the θ of the last time or as much more as it takes, by powers of two.
  Factor factorise_partly_convex() {
    note_ = "convex part";
    double shift = std::max(mu_, 1e-10);
    for (share_ = std::max(0.5 * share_, kLeastShare); share_ < 1; share_ *= 2)
      if (const Factor factor = problem_.factorise_between(share_, shift); factor != Factor::not_positive)
        return factor;
    Factor factor = problem_.factorise(Matrix::convex, shift);
    for (; factor == Factor::not_positive && shift < kLargestDamping;
         factor = problem_.factorise(Matrix::convex, shift))
      shift = std::max(shift * 100, 1e-8);
    return factor;
  }

  /// Whether K + σM is positive definite with a small σ: then (7) tells more of K than K₊ does. Where it was
  /// not the last time, it is not asked again before K itself is.
  bool is_hardly_indefinite() {
    if (!d_.empty() || !may_be_hardly_ || mu_ >= kHardlyDamped || !factorise_with_sigma()) return false;
    mu_ = sigma_, at_saddle_ = true;
    note_ = "hardly indefinite";
    return true;
  }

  /// By decades, from one below the last that did.
  bool factorise_with_sigma() {
    for (sigma_ = std::max(kLeastSigma, 0.1 * sigma_); sigma_ < 2 * kMostSigma; sigma_ *= 10)
      if (problem_.factorise(Matrix::exact, sigma_) == Factor::ok) return true;
    sigma_ = kLeastSigma;
    return false;
  }

  /// Where what a step would gain is no longer seen in the energy and damping leads nowhere: by Newton's own
  /// step, or if this is a saddle, by (7), or if K is singular, by a step of K + σM.
  bool go_on_softly() {
    if (!is_in_noise_ || mu_ == 0 || std::exchange(tried_softly_, true) || !d_.empty() ||
        !problem_.symmetric())
      return false;
    if (problem_.factorise(Matrix::exact, 0) == Factor::ok) {
      solve_for_step();
      move_trial(1);
      const bool is_short = problem_.step_length(s_) <= 1;
      if (!(is_short && (accept_blindly(0.25) || accept_shortening())) &&
          !accept_by_slope({0, energy_, dot(r_, s_)}))
        return false;
      mu_ = 0;
      return true;
    }
    if (!factorise_with_sigma()) return false;
    const bool is_saddle = curvature_.find(problem_, sigma_) < 0;
    if (!is_saddle) solve_for_step();
    if (!(is_saddle ? go_aside() : accept_by_slope({0, energy_, dot(r_, s_)}))) return false;
    mu_ = sigma_;
    return true;
  }

  bool leave_saddle() { return curvature_.find(problem_, sigma_) < 0 && go_aside(); }

  /// Moves u along the v of (7) to where the energy no longer falls; false if it never does.
  bool go_aside() {
    std::copy_n(curvature_.direction().begin(), s_.size(), s_.begin());
    const double one_element = (dot(r_, s_) > 0 ? -1 : 1) / problem_.step_length(s_);
    for (double& v : s_) v *= one_element;
    const auto found = AsideSearch{}([&](double t) { return merit(t); }, {0, energy_, dot(r_, s_)},
                                     kEnergyNoise * std::abs(energy_));
    if (!found) return false;
    move_trial(found->t);
    forget_gains();
    return accept();
  }

  /// Solves (2) for s with an unsymmetric matrix, raising μ until s leads downhill.
  bool find_downhill_step() {
    for (note_ = "";; mu_ = std::clamp(mu_ * 10, 1e-4, kLargestDamping)) {
      const Factor factor = problem_.factorise(Matrix::exact, mu_);
      if (factor == Factor::ok) {
        solve_for_step();
        if (dot(r_, s_) < 0) return true;
      }
      if (mu_ >= kLargestDamping || factor == Factor::failed || static_cast<int>(factor) < 0) return false;
      note_ = "more damping";
    }
  }

  void solve_for_step() {
    problem_.solve(r_, s_);
    for (double& v : s_) v = -v;
  }

  /// Moves u along s as (4) wants it; false when no length will do.
  bool search_line() {
    const Sample first{0, energy_, dot(r_, s_)};
    const double noise = kEnergyNoise * (std::abs(energy_) + std::abs(dot(d_, s_)));
    move_trial(1);
    is_in_noise_ = -first.slope <= noise;
    if (is_in_noise_) return accept_blindly(1) || accept_shortening() || (mu_ == 0 && accept_by_slope(first));
    if (!d_.empty() && mu_ < 1e-3 && accept_blindly(0.0625)) return true;
    LineSearch search{.decrease = p_.decrease, .flatness = p_.flatness, .shortest = p_.shortest_step};
    auto found = whole_step_uphill(first);
    if (!found) found = search_straight_or_bent(search, first);
    if (!found) {
      problem_.evaluate(problem_.u(), energy_, r_);  // tolerances are a part of the last reactions evaluated
      return false;
    }
    move_trial(found->t);
    is_bent_ = false;
    if (!accept()) return false;  // a force without an energy has no value there
    adapt_damping(found->t);
    return true;
  }

  /// (5): a whole step, if m falls or the last step did not go uphill.
  std::optional<Sample> whole_step_uphill(const Sample& first) {
    const auto whole = was_uphill_ ? std::nullopt : merit(1);
    was_uphill_ =
        whole && whole->value > first.value && whole->value <= first.value - p_.uphill * first.slope;
    return whole && (was_uphill_ || whole->value <= first.value) ? whole : std::nullopt;
  }

  /// By (4); where that ends short, by (9), too, if that gains much more.
  std::optional<Sample> search_straight_or_bent(const LineSearch& search, const Sample& first) {
    const auto along = [&](double t) { return merit(t); };
    const auto straight = search(along, first);
    if (straight && straight->t > kHardlyShort) return straight;
    if (!find_bend(straight ? straight->t : kShortBend)) return straight;
    is_bent_ = true;
    const auto bent = search(along, first);
    is_bent_ = bent && (!straight || energy_ - bent->value > kBentGain * (energy_ - straight->value));
    return is_bent_ ? bent : straight;
  }

  /// a of (9), by differences of r over ± t s.
  bool find_bend(double t) {
    if (!d_.empty() || !problem_.symmetric()) return false;
    left_.assign(s_.size(), 0.0), bend_.resize(s_.size());
    for (const double side : {t, -t}) {
      double energy = 0;
      move_trial(side);
      if (problem_.evaluate(trial_, energy, r_trial_) != Evaluation::ok) return false;
      for (std::size_t i = 0; i < left_.size(); ++i) left_[i] += (r_[i] - r_trial_[i]) / (t * t);
    }
    problem_.solve(left_, bend_);
    return true;
  }

  void move_trial(double t) {
    for (std::size_t i = 0; i < s_.size(); ++i) trial_[i] = problem_.u()[i] + t * s_[i];
    if (!is_bent_) return;
    for (std::size_t i = 0; i < s_.size(); ++i) trial_[i] += 0.5 * t * t * bend_[i];
  }

  /// (3) and its derivative.
  std::optional<Sample> merit(double t) {
    move_trial(t);
    double energy = 0;
    if (problem_.evaluate(trial_, energy, r_trial_) != Evaluation::ok) return {};
    const double slope = dot(r_trial_, s_) + (is_bent_ ? t * dot(r_trial_, bend_) : 0);
    if (d_.empty()) return Sample{t, energy, slope};
    if (problem_.evaluate_gradient(trial_, energy, r_trial_) != Evaluation::ok) return {};
    const double work = 0.5 * t * (dot(d_, s_) + slope - dot(r_trial_, s_));
    return Sample{t, energy + work, slope};
  }

  /// Takes the trial if it brings ‖r‖² down to `share` of what it is.
  bool accept_blindly(double share) {
    double energy = 0;
    if (problem_.evaluate(trial_, energy, r_trial_, Matrix::exact) == Evaluation::ok &&
        dot(r_trial_, r_trial_) <= share * dot(r_, r_)) {
      mu_ = lowered(0.1);
      take(energy);
      return true;
    }
    // The matrix kept is that of the trial; the next factorisation wants that of u.
    problem_.evaluate(problem_.u(), energy_, r_, Matrix::exact);
    return false;
  }

  /// (6): takes the trial if the step that is left there, by the matrix of here, is at most half as long.
  /// What rounding leaves of ‖r‖ in stiff parts then does not hide how far soft ones still are off.
  bool accept_shortening() {
    double energy = 0;
    if (problem_.evaluate(trial_, energy, r_trial_) != Evaluation::ok) return false;
    left_.resize(s_.size());
    problem_.solve(r_trial_, left_);
    if (problem_.step_length(left_) > 0.5 * problem_.step_length(s_)) return false;
    return accept();
  }

  /// (8).
  bool accept_by_slope(const Sample& first) {
    if (!d_.empty() || first.slope >= 0 || has_stalled(-first.slope)) return false;
    const SlopeSearch search{.noise = kRoundings * kEnergyNoise * std::abs(energy_)};
    const auto found = search([&](double t) { return merit(t); }, first);
    if (!found) return false;
    move_trial(found->t);
    return accept();
  }

  /// Whether what Newton's steps promise to gain has not halved for so long.
  bool has_stalled(double gain) {
    const bool is_less = gain < 0.5 * least_gain_;
    if (is_less) least_gain_ = gain;
    times_no_less_ = is_less ? 0 : times_no_less_ + 1;
    return times_no_less_ > kStalled;
  }

  void forget_gains() { least_gain_ = std::numeric_limits<double>::infinity(), times_no_less_ = 0; }

  /// A whole step means that the model is trusted; a short one that it reaches too far.
  void adapt_damping(double t) {
    if (t > 0.9)
      mu_ = lowered(0.1);
    else if (t > 0.5)
      mu_ = lowered(0.5);
    else if (t < 0.25)
      mu_ = std::clamp(mu_ * (t < 0.1 ? 4 : 2), 1e-6, kLargestDamping);
  }
  double lowered(double factor) const { return mu_ * factor < kSmallestDamping ? 0 : mu_ * factor; }

  bool accept() {
    double energy = 0;
    if (problem_.evaluate(trial_, energy, r_trial_, Matrix::exact) != Evaluation::ok) {
      // The matrix kept is half that of the trial; the next factorisation wants that of u.
      problem_.evaluate(problem_.u(), energy_, r_, Matrix::exact);
      return false;
    }
    take(energy);
    return true;
  }
  void take(double energy) {
    std::copy(trial_.begin(), trial_.end(), problem_.u().begin());
    std::swap(r_, r_trial_);
    energy_ = energy, tried_softly_ = false;
    if (!is_in_noise_) forget_gains();
  }

  const Newton::Parameters& p_;
  Problem& problem_;
  double mu_, sigma_ = kLeastSigma, share_ = 1, energy_ = 0,
              least_gain_ = std::numeric_limits<double>::infinity();
  int times_no_less_ = 0;
  bool was_uphill_ = false, may_be_hardly_ = true, at_saddle_ = false, is_in_noise_ = false,
       tried_softly_ = false, is_bent_ = false;
  const char* note_ = "";
  std::vector<double> r_, s_, trial_, r_trial_, left_, bend_;
  LeastCurvature curvature_;
  std::vector<double> d_;  // forces without an energy at u; empty if there are none
};

}  // namespace

Outcome solve_globalised(const Newton::Parameters& parameters, Problem& problem) {
  return Globalised(parameters, problem).run();
}

}  // namespace netloft::newton
