// SPDX-License-Identifier: BSD-3-Clause
// Derivatives are compared with central differences over a range of steps. For each state, only the best step
// counts: large steps suffer from curvature, small ones from rounding, and steps across a kink from the kink.
// If a state fails with every step, it is on a kink if its one-sided differences differ by more than half of
// the error. States on a kink are ignored, but at most a tenth of all states may be on one.
#include "framework/conformance/checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace netloft::conformance {

namespace {

constexpr double kSteps[] = {1e-2, 1e-3, 1e-4, 1e-5, 1e-6};  // steps relative to the distance of the nodes
constexpr double kKinkStep = 1e-5;
constexpr double kDerivativeLimit = 1e-6;
constexpr double kLeftOutLimit = 0.1;

using Lanes = std::vector<double>;  // one number per element of a tile

double packed_or_full(const netloft_term& term, const std::vector<double>& matrix, std::size_t dofs,
                      std::size_t r, std::size_t c, std::size_t lane) {
  if (!(term.traits & NETLOFT_SYMMETRIC)) return matrix[at(r * dofs + c, lane)];
  const std::size_t row = std::max(r, c), column = std::min(r, c);
  return matrix[at(row * (row + 1) / 2 + column, lane)];
}

/// Collects the errors of elements that are not on a kink.
class Ledger {
 public:
  Ledger() : worst_(kDerivativeLimit) {}
  template <class Where>
  void note(double error, double one_sided_difference, Where&& where) {
    if (error > kDerivativeLimit && one_sided_difference > 0.5 * error) {
      ++left_out_;
      return;
    }
    worst_.note(error, where);
  }
  Finding finding(const char* nothing_noted) const {
    const auto all = static_cast<double>(worst_.count() + left_out_);
    if (static_cast<double>(left_out_) > kLeftOutLimit * all && left_out_ > 1)
      return failed(std::to_string(left_out_) + " of " + number_text(all) + " states lie on kinks");
    Finding f = judged(worst_, nothing_noted);
    if (left_out_) f.detail += "; ignored on kinks: " + std::to_string(left_out_);
    return f;
  }

 private:
  Worst worst_;
  std::size_t left_out_ = 0;
};

}  // namespace

namespace {

/// Compares the force with the slope of the energy along a direction, as given by the best central
/// difference.
class EnergySlope {
 public:
  EnergySlope(Bench& b, const netloft_term& term, const States& s)
      : b_(b), term_(term), s_(s), direction_(b.random_field()), scale_(b.force_scale(term, s)) {
    const Answer here = b.specimen->evaluate(term, s, NETLOFT_WANT_ENERGY | NETLOFT_WANT_FORCE);
    energy_ = here.energy;
    for (std::size_t i = 0; i < here.force.size(); ++i) slope_[i % kLanes] += here.force[i] * direction_[i];
  }
  void judge(Ledger& ledger) {
    Lanes best(kLanes, 1e300);
    for (const double step : kSteps) {
      const Lanes e = errors(step);
      for (std::size_t lane = 0; lane < s_.count; ++lane) best[lane] = std::min(best[lane], e[lane]);
    }
    const Lanes kink = one_sided_differences();
    for (std::size_t lane = 0; lane < s_.count; ++lane)
      ledger.note(best[lane], kink[lane], [&] { return b_.place(term_, s_, lane); });
  }

 private:
  Lanes lengths(double step) const {
    Lanes h(kLanes, 0.0);
    for (std::size_t lane = 0; lane < s_.count; ++lane) h[lane] = step * b_.spacing(s_, lane);
    return h;
  }
  Lanes energy_at(Lanes h, double sign) const {
    for (double& length : h) length *= sign;
    const Answer a = b_.specimen->evaluate(term_, moved(s_, direction_, h), NETLOFT_WANT_ENERGY);
    return a.ok() ? a.energy : Lanes(kLanes, std::nan(""));
  }
  Lanes errors(double step) const {
    const Lanes h = lengths(step), right = energy_at(h, 1), left = energy_at(h, -1);
    Lanes e(kLanes, 1e300);
    for (std::size_t lane = 0; lane < s_.count; ++lane) {
      const double error = ratio((right[lane] - left[lane]) / (2 * h[lane]) - slope_[lane], scale_[lane]);
      if (error < e[lane]) e[lane] = error;
    }
    return e;
  }
  Lanes one_sided_differences() const {
    const Lanes h = lengths(kKinkStep), right = energy_at(h, 1), left = energy_at(h, -1);
    Lanes d(kLanes, 0.0);
    for (std::size_t lane = 0; lane < s_.count; ++lane)
      d[lane] = ratio((right[lane] - 2 * energy_[lane] + left[lane]) / h[lane], scale_[lane]);
    return d;
  }

  Bench& b_;
  const netloft_term& term_;
  const States& s_;
  std::vector<double> direction_;
  Lanes scale_, energy_;
  std::array<double, kLanes> slope_{};
};

}  // namespace

Finding force_is_gradient(Bench& b) {
  Ledger ledger;
  for (const auto& term : b.type.terms) {
    if (!(term.traits & NETLOFT_CONSERVATIVE)) continue;
    for (const auto& s : b.tiles)
      for (int k = 0; k < b.options.directions; ++k) EnergySlope(b, term, s).judge(ledger);
  }
  return ledger.finding("no term is conservative");
}

namespace {

/// The variable of a derivative: its field, the trait of terms that read it, and the factors of the tangent.
struct Variable {
  std::vector<double> States::*field;
  std::uint32_t trait;
  Factors factors;
  double factor;
};

// The factors of the tangent are not 1, so that the check finds a term that ignores them.
const Variable kVariables[] = {
    {&States::x, 0, {0.7, 0, 0}, 0.7},
    {&States::v, NETLOFT_READS_VELOCITY, {0, 1.3, 0}, 1.3},
    {&States::a, NETLOFT_READS_ACCELERATION, {0, 0, 0.9}, 0.9},
};

/// Selects the entries of a column that are compared.
using Rows = std::function<bool(std::size_t row, std::size_t column)>;

/// Compares the tangent of a tile, column by column, with differences of the force.
class ForceSlope {
 public:
  ForceSlope(Bench& b, const netloft_term& term, const States& s, const Variable& variable)
      : b_(b), term_(term), s_(s), variable_(variable) {
    tangent_ = b.specimen->evaluate(term, s, NETLOFT_WANT_TANGENT, variable.factors).matrix;
    force_ = b.specimen->evaluate(term, s, NETLOFT_WANT_FORCE).force;
    scale_ = b.force_scale(term, s);
    for (std::size_t lane = 0; lane < s.count; ++lane) {
      scale_[lane] /= length(lane);
      for (std::size_t e = 0; e * kLanes < tangent_.size(); ++e)
        scale_[lane] = std::max(scale_[lane], std::abs(tangent_[at(e, lane)]));
    }
  }
  void judge(const Rows& rows, Ledger& ledger) const {
    for (std::size_t column = 0; column < b_.dofs(); ++column) judge_column(column, rows, ledger);
  }

 private:
  bool is_position() const { return variable_.trait == 0; }
  double length(std::size_t lane) const { return is_position() ? b_.size(s_, lane) : 1; }
  double step_length(double step, std::size_t lane) const {
    return step * (is_position() ? b_.spacing(s_, lane) : 1);
  }
  std::vector<double> force_at(std::size_t column, double step, double sign) const {
    States to = s_;
    for (std::size_t lane = 0; lane < s_.count; ++lane) {
      const double h = sign * step_length(step, lane);
      (to.*variable_.field)[at(column, lane)] += h;
      for (std::size_t axis = 0; is_position() && column % 3 == 2 && axis < 3; ++axis)
        to.current[at(column - 2 + axis, lane)] += h * s_.current_dz[at(column - 2 + axis, lane)];
      if (const std::size_t node = column / 3; is_position() && 6 * (node + 1) * kLanes <= to.bed.size())
        move_bed(to, node, lane, column % 3 == 0 ? h : 0, column % 3 == 1 ? h : 0);
    }
    const Answer a = b_.specimen->evaluate(term_, to, NETLOFT_WANT_FORCE);
    return a.ok() ? a.force : std::vector<double>(b_.dofs() * kLanes, std::nan(""));
  }
  void judge_column(std::size_t column, const Rows& rows, Ledger& ledger) const {
    Lanes best(kLanes, 1e300), kink(kLanes, 0.0);
    for (const double step : kSteps) {
      const auto right = force_at(column, step, 1), left = force_at(column, step, -1);
      for (std::size_t lane = 0; lane < s_.count; ++lane) {
        const double error = column_error(column, rows, right, left, step_length(step, lane), lane);
        if (error < best[lane]) best[lane] = error;
        if (step == kKinkStep)
          kink[lane] = column_kink(rows, column, right, left, step_length(step, lane), lane);
      }
    }
    for (std::size_t lane = 0; lane < s_.count; ++lane)
      ledger.note(best[lane], kink[lane],
                  [&] { return b_.place(term_, s_, lane) + ", column " + std::to_string(column); });
  }
  double column_error(std::size_t column, const Rows& rows, const std::vector<double>& right,
                      const std::vector<double>& left, double h, std::size_t lane) const {
    double worst = 0;
    for (std::size_t row = 0; row < b_.dofs(); ++row) {
      if (!rows(row, column)) continue;
      const double slope = variable_.factor * (right[at(row, lane)] - left[at(row, lane)]) / (2 * h);
      const double error = slope - packed_or_full(term_, tangent_, b_.dofs(), row, column, lane);
      if (std::isnan(error)) return 1e300;
      worst = std::max(worst, ratio(error, scale_[lane]));
    }
    return worst;
  }
  double column_kink(const Rows& rows, std::size_t column, const std::vector<double>& right,
                     const std::vector<double>& left, double h, std::size_t lane) const {
    double worst = 0;
    for (std::size_t row = 0; row < b_.dofs(); ++row)
      if (rows(row, column))
        worst = std::max(worst,
                         ratio((right[at(row, lane)] - 2 * force_[at(row, lane)] + left[at(row, lane)]) / h,
                               scale_[lane]));
    return worst;
  }

  Bench& b_;
  const netloft_term& term_;
  const States& s_;
  const Variable& variable_;
  std::vector<double> tangent_, force_;
  Lanes scale_;
};

void judge_tangents(Bench& b, const netloft_term& term, const Rows& rows, Ledger& ledger) {
  for (const auto& variable : kVariables) {
    if (variable.trait && !(term.traits & variable.trait)) continue;
    for (const auto& s : b.tiles) ForceSlope(b, term, s, variable).judge(rows, ledger);
  }
}

}  // namespace

/// Checks only the stored triangle of a packed tangent; the check symmetric-where-claimed covers the other
/// triangle.
Finding tangent_is_derivative(Bench& b) {
  Ledger ledger;
  for (const auto& term : b.type.terms) {
    if (term.traits & NETLOFT_CONSTANT) continue;
    const bool packed = term.traits & NETLOFT_SYMMETRIC;
    judge_tangents(
        b, term, [packed](std::size_t r, std::size_t c) { return !packed || r >= c; }, ledger);
  }
  return ledger.finding("all terms are constant");
}

Finding symmetric_where_claimed(Bench& b) {
  Ledger ledger;
  for (const auto& term : b.type.terms)
    if ((term.traits & NETLOFT_SYMMETRIC) && !(term.traits & NETLOFT_CONSTANT))
      judge_tangents(
          b, term, [](std::size_t r, std::size_t c) { return r < c; }, ledger);
  return ledger.finding("no tangent is declared symmetric");
}

Finding constant_where_claimed(Bench& b) {
  Worst worst(1e-12);
  for (const auto& term : b.type.terms) {
    if (!(term.traits & NETLOFT_CONSTANT)) continue;
    for (const auto& s : b.tiles) {
      const Answer here = b.specimen->evaluate(term, s, NETLOFT_WANT_FORCE);
      const Lanes scale = b.force_scale(term, s);
      Lanes step(kLanes, 0.0);
      for (std::size_t lane = 0; lane < s.count; ++lane) step[lane] = 0.3 * b.size(s, lane);
      const Answer there = b.specimen->evaluate(term, moved(s, b.random_field(), step), NETLOFT_WANT_FORCE);
      for (std::size_t i = 0; i < here.force.size(); ++i)
        worst.note(ratio(there.force[i] - here.force[i], scale[i % kLanes]),
                   [&] { return b.place(term, s, i % kLanes) + ": the force moves with the nodes"; });
    }
  }
  return judged(worst, "no term is declared constant");
}

namespace {

/// Work of the force along a straight path, summed over pieces by the midpoint rule, and the sum of the
/// absolute works of the pieces.
struct PathWork {
  Lanes work = Lanes(kLanes, 0.0), effort = Lanes(kLanes, 0.0);
  bool inside = true;  // whether all points are inside the domain
};

PathWork walk(const Bench& b, const netloft_term& term, const States& from,
              const std::vector<double>& direction, const Lanes& length, int pieces) {
  PathWork path;
  for (int k = 0; k < pieces; ++k) {
    Lanes step = length;
    for (double& h : step) h *= (k + 0.5) / pieces;
    const Answer a = b.specimen->evaluate(term, moved(from, direction, step), NETLOFT_WANT_FORCE);
    path.inside = path.inside && a.ok();
    Lanes slope(kLanes, 0.0);
    for (std::size_t i = 0; i < a.force.size(); ++i) slope[i % kLanes] += a.force[i] * direction[i];
    for (std::size_t lane = 0; lane < from.count; ++lane) {
      path.work[lane] += slope[lane] * length[lane] / pieces;
      path.effort[lane] += std::abs(slope[lane]) * length[lane] / pieces;
    }
  }
  return path;
}

/// Compares the work along a path with the change of energy. If they are equal on every path, no closed path
/// gains energy, even if an element changes between slack and taut. Paths are shorter than half the distance
/// of the nodes, so that no element collapses. Returns the error per element, or −1 if the path left the
/// domain.
Lanes energy_not_accounted_for(const Bench& b, const netloft_term& term, const States& from,
                               const std::vector<double>& direction, const Lanes& length, int pieces) {
  const PathWork path = walk(b, term, from, direction, length, pieces);
  const Answer start = b.specimen->evaluate(term, from, NETLOFT_WANT_ENERGY);
  const Answer end = b.specimen->evaluate(term, moved(from, direction, length), NETLOFT_WANT_ENERGY);
  Lanes error(kLanes, -1.0);
  if (!path.inside || !start.ok() || !end.ok()) return error;
  for (std::size_t lane = 0; lane < from.count; ++lane) {
    const double rounding = 1e-12 * (std::abs(start.energy[lane]) + std::abs(end.energy[lane]));
    error[lane] =
        ratio(end.energy[lane] - start.energy[lane] - path.work[lane], path.effort[lane] + rounding);
  }
  return error;
}

constexpr double kWorkLimit = 1e-3;

}  // namespace

Finding no_work_round_a_closed_path(Bench& b) {
  Worst worst(kWorkLimit);
  for (const auto& term : b.type.terms) {
    if (!(term.traits & NETLOFT_CONSERVATIVE)) continue;
    for (const auto& s : b.tiles)
      for (int k = 0; k < b.options.directions; ++k) {
        const std::vector<double> direction = b.random_field();
        Lanes length(kLanes, 0.0), best(kLanes, 1e300);
        for (std::size_t lane = 0; lane < s.count; ++lane) length[lane] = 0.4 * b.spacing(s, lane);
        for (int pieces = 16; pieces <= 262144;
             pieces *= 4) {  // many pieces, because an energy can bend sharply where an element becomes taut
          const Lanes error = energy_not_accounted_for(b, term, s, direction, length, pieces);
          bool done = true;
          for (std::size_t lane = 0; lane < s.count; ++lane) {
            if (error[lane] >= 0 && error[lane] < best[lane]) best[lane] = error[lane];
            done = done && (best[lane] <= kWorkLimit || error[lane] < 0);
          }
          if (done) break;
        }
        for (std::size_t lane = 0; lane < s.count; ++lane)
          if (best[lane] < 1e300) worst.note(best[lane], [&] { return b.place(term, s, lane); });
      }
  }
  return judged(worst, "no term is conservative");
}

}  // namespace netloft::conformance
