// SPDX-License-Identifier: BSD-3-Clause
#include "framework/motion/winches.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace netloft {

namespace {

// Largest error of a speed, relative to the largest speed; it corresponds to an error of the tension of a
// thousandth of the band.
constexpr double kSettled = 1e-3;
// Limit of attempts per step. After half of them, the matrix S of (3) in winches.hpp is measured again, in
// attempts that do not count.
constexpr int kMostTries = 12;
constexpr double kMeasured = 0.02;  // change of speed to measure S, relative to the largest speed
// Number of sweeps over the winches to solve (2) and (3) of winches.hpp. A few sweeps suffice, because the
// gear couples winches only weakly.
constexpr int kSweeps = 30;
constexpr double kLeastLeft =
    0.05;  // least fraction of a rope that remains; bars of a shorter rest would be too stiff for any step

double straight_between(const std::vector<std::array<double, 2>>& rows, double t) {
  const auto next = std::upper_bound(rows.begin(), rows.end(), t,
                                     [](double time, const auto& row) { return time < row[0]; });
  if (next == rows.begin()) return rows.front()[1];
  if (next == rows.end()) return rows.back()[1];
  const auto& [t0, T0] = next[-1];
  return T0 + ((*next)[1] - T0) * (t - t0) / ((*next)[0] - t0);
}

using Follows = WinchStage::Follows;

}  // namespace

Winches::Winches(const Scene& scene, const Assembler& assembler, double tolerance)
    : scene_(scene), assembler_(assembler), tolerance_(tolerance), ropes_(scene.winches.size()) {
  for (std::size_t k = 0; k < ropes_.size(); ++k) {
    const Winch& winch = scene.winches[k];
    for (std::uint32_t p = 0; p < scene.parts.size(); ++p)
      for (const auto& family : assembler.families())
        if (scene.parts[p].name == winch.part && ropes_[k].table.empty())
          ropes_[k].table = family->table(p, winch.parameter);
    if (ropes_[k].table.size() != 4)
      throw SceneError({{winch.part, "has no table " + winch.parameter + " of two rows for its winch"}});
  }
  restore();
}

void Winches::write() {
  for (std::size_t k = 0; k < ropes_.size(); ++k) {
    const double end = ropes_[k].now + h_ * ropes_[k].w / scene_.winches[k].length;  // (1)
    const double rows[] = {t_, ropes_[k].now, t_ + h_, end};
    std::copy(std::begin(rows), std::end(rows), ropes_[k].table.begin());
  }
}

void Winches::restore() {
  for (const Rope& rope : ropes_) {
    const double rows[] = {from_, rope.before, until_, rope.now};
    std::copy(std::begin(rows), std::end(rows), rope.table.begin());
  }
}

const WinchStage& Winches::stage_at(std::size_t k, double t) const {
  const auto& stages = scene_.winches[k].stages;
  const auto later = std::upper_bound(stages.begin(), stages.end(), t,
                                      [](double time, const WinchStage& one) { return time < one.from; });
  return later == stages.begin() ? stages.front() : later[-1];
}

std::vector<std::size_t> Winches::holding_at(double t) const {
  std::vector<std::size_t> all;
  for (std::size_t k = 0; k < ropes_.size(); ++k)
    if (stage_at(k, t).follows == Follows::tension) all.push_back(k);
  return all;
}

void Winches::add_corners(std::vector<double>& times) const {
  for (const Winch& winch : scene_.winches)
    for (const WinchStage& stage : winch.stages) {
      times.push_back(stage.from);
      for (const auto& row : stage.rows) times.push_back(row[0]);
    }
}

/// Speed of a winch that follows speeds or lengths, in a step during which its table has no corner.
double Winches::given_speed(std::size_t k) const {
  const WinchStage& stage = *ropes_[k].stage;
  if (stage.follows == Follows::speed) {
    const double middle = t_ + 0.5 * h_;
    return middle < stage.rows.back()[0] ? straight_between(stage.rows, middle) : 0;
  }
  const double L = scene_.winches[k].length;
  return (straight_between(stage.rows, t_ + h_) - L * (ropes_[k].now - 1)) / h_;
}

void Winches::begin(double t, double h) {
  const std::vector<std::size_t> held_before = holding_at(0.5 * (from_ + until_));
  t_ = t;
  h_ = h;
  tries_ = 0;
  measured_.clear();
  last_w_.clear();
  holding_ = holding_at(t + 0.5 * h);
  if (holding_ != held_before) slopes_.clear();
  for (std::size_t k = 0; k < ropes_.size(); ++k) {
    Rope& rope = ropes_[k];
    rope.stage = &stage_at(k, t + 0.5 * h);
    const bool holds = rope.stage->follows == Follows::tension;
    rope.w = holds ? rope.speed : given_speed(k);
    if (holds) rope.wanted = straight_between(rope.stage->rows, t + 0.5 * h);
  }
  write();
}

/// The speed w of a winch at a tension, by (2) of winches.hpp.
double Winches::speed_at(std::size_t k, double tension) const {
  const WinchStage& stage = *ropes_[k].stage;
  const double e = tension - ropes_[k].wanted, beyond = std::max(std::abs(e) - stage.dead_band, 0.0);
  return stage.max_speed * std::copysign(std::min(beyond / stage.band, 1.0), e);
}

/// Possible error of the tension in an attempt [N].
double Winches::doubt(std::size_t k) const { return tolerance_ * std::max(ropes_[k].wanted, ropes_[k].T); }

/// Whether the speeds satisfy (2) of winches.hpp, up to the accuracy of the forces of a step.
bool Winches::is_settled() const {
  for (const std::size_t k : holding_) {
    const WinchStage& stage = *ropes_[k].stage;
    const double known = kSettled + doubt(k) / stage.band;
    if (!(std::abs(ropes_[k].w - speed_at(k, ropes_[k].T)) <= known * stage.max_speed)) return false;
  }
  return true;
}

std::vector<double> Winches::tensions_of(std::span<const double> residual) const {
  std::vector<double> tensions;
  for (const Winch& winch : scene_.winches) {
    const auto force = assembler_.reaction(winch.block, residual);
    tensions.push_back(std::hypot(force[0], force[1], force[2]));
  }
  return tensions;
}

void Winches::note_rest(std::span<const double> residual) {
  const std::vector<double> tensions = tensions_of(residual);
  for (std::size_t k = 0; k < ropes_.size(); ++k) ropes_[k].tension = tensions[k];
}

Winches::Verdict Winches::judge(std::span<const double> residual) {
  const std::vector<double> tensions = tensions_of(residual);
  if (!measured_.empty()) return measure_slopes(tensions);
  improve_slopes(tensions);
  take(tensions);
  if (is_settled()) return Verdict::settled;
  if (slopes_.empty() || ++tries_ == kMostTries / 2) return measure_slopes(tensions);
  if (tries_ > kMostTries) return slopes_.clear(), Verdict::lost;
  solve_all();
  write();
  return Verdict::again;
}

void Winches::take(std::span<const double> tensions) {
  last_w_.clear();
  for (std::size_t k = 0; k < ropes_.size(); ++k) {
    ropes_[k].T = tensions[k];
    last_w_.push_back(ropes_[k].w);
  }
}

/// Updates S of (3) in winches.hpp by Broyden's formula, from the changes of speeds and tensions since the
/// last attempt.
void Winches::improve_slopes(std::span<const double> tensions) {
  if (slopes_.empty() || last_w_.empty()) return;
  // Squared change of the speeds; largest ratio of the expected change of a tension to its possible error.
  double square = 0, largest = 0;
  for (const std::size_t j : holding_) {
    const double change = ropes_[j].w - last_w_[j];
    square += change * change;
    largest = std::max(largest, std::abs(change * slope(j, j)) / doubt(j));
  }
  if (largest <= 1) return;
  for (const std::size_t k : holding_) {
    double missing = tensions[k] - ropes_[k].T;
    for (const std::size_t j : holding_) missing -= slope(k, j) * (ropes_[j].w - last_w_[j]);
    for (const std::size_t j : holding_) slope(k, j) += missing * (ropes_[j].w - last_w_[j]) / square;
  }
}

/// Measures the matrix S of (3) in winches.hpp. In each attempt after the first, one winch runs a little
/// faster than in the first, a different winch each time. After the last attempt, the speeds of all winches
/// follow from (2) and (3).
Winches::Verdict Winches::measure_slopes(std::span<const double> tensions) {
  const std::size_t n = ropes_.size(), done = measured_.size() / n;
  if (measured_.empty())
    measured_.assign(tensions.begin(), tensions.end());
  else
    for (std::size_t k = 0; k < n; ++k)
      measured_.push_back((tensions[k] - ropes_[k].T) /
                          (kMeasured * ropes_[holding_[done - 1]].stage->max_speed));
  for (const std::size_t k : holding_) ropes_[k].w = last_w_[k];
  if (done < holding_.size()) {
    const std::size_t next = holding_[done];
    ropes_[next].w += kMeasured * ropes_[next].stage->max_speed;
  } else {
    slopes_.assign(n * n, 0);
    for (std::size_t m = 0; m < holding_.size(); ++m)
      for (const std::size_t k : holding_) slope(k, holding_[m]) = measured_[(m + 1) * n + k];
    measured_.clear();
    solve_all();
  }
  write();
  return Verdict::again;
}

/// Solves (2) of winches.hpp for the speeds of all winches, winch by winch, with tensions T̄ from (3).
void Winches::solve_all() {
  std::vector<double> w = last_w_;
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    for (const std::size_t k : holding_) {
      double others = 0;
      for (const std::size_t j : holding_)
        if (j != k) others += slope(k, j) * (w[j] - last_w_[j]);
      w[k] = solve_one(k, others);
    }
  for (const std::size_t k : holding_) ropes_[k].w = w[k];
}

/// Solves (2) of winches.hpp for the speed of winch k. `others` is the change of its tension that the other
/// winches cause [N].
double Winches::solve_one(std::size_t k, double others) const {
  const WinchStage& stage = *ropes_[k].stage;
  const double S = std::min(slope(k, k), 0.0);
  const double e = ropes_[k].T + others - S * last_w_[k] - ropes_[k].wanted;  // error of the tension at w = 0
  const double beyond = std::max(std::abs(e) - stage.dead_band, 0.0), v = stage.max_speed;
  return std::copysign(std::min(v * beyond / (stage.band - v * S), v), e);
}

void Winches::accept() {
  from_ = t_;
  until_ = t_ + h_;
  for (std::size_t k = 0; k < ropes_.size(); ++k) {
    Rope& rope = ropes_[k];
    rope.before = rope.now;
    rope.now = rope.table[3];
    rope.speed = rope.w;
    rope.tension = rope.T;
  }
}

std::string Winches::obstacle() const {
  for (std::size_t k = 0; k < ropes_.size(); ++k)
    if (!(ropes_[k].now > kLeastLeft))
      return "the winch of " + scene_.winches[k].part + " has hauled in all of its rope";
  return "";
}

std::vector<WinchMoment> Winches::moments(double t) const {
  std::vector<WinchMoment> all;
  for (std::size_t k = 0; k < ropes_.size(); ++k) {
    const Rope& rope = ropes_[k];
    const double L = scene_.winches[k].length;
    all.push_back(
        {scene_.winches[k].part, L * rope.now - (until_ - t) * rope.speed, rope.speed, rope.tension});
  }
  return all;
}

std::vector<double> Winches::state() const {
  std::vector<double> all;
  if (ropes_.empty()) return all;
  for (const Rope& rope : ropes_) all.push_back(rope.now);
  for (const Rope& rope : ropes_) all.insert(all.end(), {rope.before, rope.speed, rope.tension});
  all.insert(all.end(), {from_, until_});
  all.insert(all.end(), slopes_.begin(), slopes_.end());
  return all;
}

void Winches::set_state(std::span<const double> state) {
  const std::size_t n = ropes_.size();
  if (state.empty() || n == 0) return;
  for (std::size_t k = 0; k < n; ++k) ropes_[k].now = ropes_[k].before = state[k];
  if (state.size() > n) {
    const double* next = state.data() + n;
    for (Rope& rope : ropes_) {
      rope.before = *next++;
      rope.speed = *next++;
      rope.tension = *next++;
    }
    from_ = *next++;
    until_ = *next++;
    slopes_.assign(next, state.data() + state.size());
  }
  restore();
}

std::vector<double> Winches::state_at_rest(std::span<const double> factors) {
  return {factors.begin(), factors.end()};
}

}  // namespace netloft
