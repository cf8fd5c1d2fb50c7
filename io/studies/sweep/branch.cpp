// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/branch.hpp"
#include "io/runs/equilibrium.hpp"
#include "io/runs/tangent.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace netloft::studies {

namespace {

using Values = std::vector<VariableValue>;

// A change is a jump if more than this fraction of it remains after all halvings of the step. On a smooth
// branch, 2^-5 of the change remains; at a jump, all of it remains.
constexpr double kLeftOfAJump = 0.25;
// An equilibrium is on another branch if its distance exceeds the extrapolated change by this factor.
constexpr double kElsewhere = 4;

bool has_converged(const Solution& s) { return s.status == SolveStatus::converged; }

/// The ratio of the step from `last` to `next` to the step from `before` to `last`; nullopt if the two steps
/// change different variables, or more than one variable.
std::optional<double> way_on(const Values& before, const Values& last, const Values& next) {
  std::optional<double> ratio;
  for (std::size_t v = 0; v < next.size(); ++v) {
    const auto &a = before[v], &b = last[v], &c = next[v];
    if (a.text == b.text && b.text == c.text) continue;
    if (ratio || !a.number || !b.number || !c.number || *a.number == *b.number) return std::nullopt;
    ratio = (*c.number - *b.number) / (*b.number - *a.number);
  }
  return ratio;
}

/// Whether there are points between `a` and `b`: all values in which they differ must be numbers.
bool can_be_halved(const Values& a, const Values& b) {
  for (std::size_t v = 0; v < a.size(); ++v)
    if (a[v].text != b[v].text && !(a[v].number && b[v].number)) return false;
  return true;
}

struct Move {
  double distance = 0;  // [m]
  std::uint32_t node = 0;
};

/// The largest distance between the positions of a node in two states of one scene, and the node.
Move largest_move(const runs::PreparedScene& scene, const std::vector<double>& from_x,
                  const std::vector<double>& to_x) {
  const auto from = scene.assembler().node_positions(from_x), to = scene.assembler().node_positions(to_x);
  Move largest;
  for (std::uint32_t n = 0; 3 * std::size_t{n} < from.size(); ++n) {
    const double *p = &from[3 * std::size_t{n}], *q = &to[3 * std::size_t{n}];
    const double distance = std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
    if (distance > largest.distance) largest = {distance, n};
  }
  return largest;
}

Move largest_move(const Solved& a, const Solved& b) {
  return largest_move(*b.scene, a.solution.x, b.solution.x);
}

std::string name_of(const Solved& solved, const Move& move) {
  return solved.scene->assembler().node_name(solved.scene->loaded().scene, move.node);
}

/// Largest extent of the initial positions of a scene along an axis [m].
double extent_of(const Scene& scene) {
  double size = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = scene.positions[axis], high = low;
    for (std::size_t d = axis; d < scene.positions.size(); d += 3) {
      low = std::min(low, scene.positions[d]);
      high = std::max(high, scene.positions[d]);
    }
    size = std::max(size, high - low);
  }
  return size;
}

}  // namespace

Reached Branch::reach(std::shared_ptr<runs::PreparedScene> scene, const Values& values) {
  Reached reached;
  Solved solved{std::move(scene), {}, values};
  spent_ = {};
  Way way;
  if (!trail_.empty() && runs::have_same_topology(*trail_.back().scene, *solved.scene)) {
    way = known_places(values);
    const std::size_t known = way.size();
    reached.was_continued = walk(solved.scene, values, way);
    for (std::size_t p = known; p < way.size(); ++p)
      if (may_have_jumped(way, p)) look_for_jump(way[p - 1].solved, way[p].solved, reached.events);
  }
  if (reached.was_continued) {
    solved = way.back().solved;
  } else {
    solved.solution = runs::find_equilibrium(*solved.scene, watch_);
    spent_.add(solved.solution.cost);
    if (!way.empty() && has_converged(solved.solution)) look_for_fold(way, solved, reached.events);
  }
  reached.solution = solved.solution;
  reached.solution.cost = spent_;
  has_converged(solved.solution) ? trail_.push_back(std::move(solved)) : trail_.clear();
  if (trail_.size() > 2) trail_.erase(trail_.begin());
  return reached;
}

/// Returns the points from which the next one is predicted: the last two if the next one is on a line with
/// them, else the last one and a point before it on the tangent. Instead of the tangent, one could reuse the
/// movement along the same variable in the previous row of points, but this predicts worse: on the trawl
/// 83-112 at sea with 300 nodes and 16 samples, points took 4.9 factorisations on average instead of 4.2 to
/// 4.6.
Branch::Way Branch::known_places(const Values& values) {
  if (trail_.size() == 2)
    if (const auto ratio = way_on(trail_[0].values, trail_[1].values, values); ratio && *ratio != 0)
      if (runs::have_same_topology(*trail_[0].scene, *trail_[1].scene))
        return {{-1 / *ratio, trail_[0]}, {0, trail_[1]}};
  return tangent_way(trail_.back(), values);
}

/// Returns two places: a point on the tangent, a little before `from` on the way to `to`, and `from` itself.
/// Returns only `from` if there is no tangent.
Branch::Way Branch::tangent_way(const Solved& from, const Values& to) {
  Way way{{0, from}};
  if (!can_be_halved(from.values, to)) return way;
  Values values;
  const auto near = open_between(from, to, options_.little, values);
  if (!near || !runs::have_same_topology(*from.scene, *near)) return way;
  runs::Tangent at(*from.scene, from.solution.x);
  const auto tangent = at.towards(*near);
  spent_.statistics.add(at.spent());
  if (!tangent) return way;
  Solved before{from.scene, {}, from.values};
  before.solution.x = from.solution.x;
  for (std::size_t i = 0; i < tangent->size(); ++i) before.solution.x[i] -= (*tangent)[i];
  way.insert(way.begin(), {-options_.little, std::move(before)});
  return way;
}

/// Steps from the last point to the next, by the whole step or by halves of it. Returns false if the branch
/// ends between the two points.
bool Branch::walk(const std::shared_ptr<runs::PreparedScene>& scene, const Values& values, Way& way) {
  const Solved start = way.back().solved;
  const double shortest = std::ldexp(1.0, -options_.halvings);
  for (double length = 1; length >= shortest;) {
    const double at = std::min(1.0, way.back().at + length);
    Solved next{scene, {}, values};
    if (at < 1) next.scene = open_between(start, values, at, next.values);
    if (!next.scene || !runs::have_same_topology(*start.scene, *next.scene)) return false;
    next.solution = step(*next.scene, way, at);
    if (has_converged(next.solution)) {
      way.push_back({at, std::move(next)});
      if (at == 1) return true;
      length *= 2;
    } else {
      if (next.solution.status == SolveStatus::interrupted || !can_be_halved(start.values, values))
        return false;
      length /= 2;
    }
  }
  return false;
}

/// Extrapolates positions to `at`, linearly from the last two places. If there is only one place, returns its
/// positions. On the trawl 83-112 at sea with 300 nodes, a parabola through three places predicted worse,
/// because slack twines and the bed make kinks.
std::vector<double> Branch::led_on(const Way& way, double at) {
  const Place& last = way.back();
  std::vector<double> x = last.solved.solution.x;
  if (way.size() < 2) return x;
  const Place& before = way[way.size() - 2];
  const double t = (at - last.at) / (last.at - before.at);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += t * (x[i] - before.solved.solution.x[i]);
  return x;
}

Solution Branch::step(runs::PreparedScene& scene, const Way& way, double at) {
  Solution solution = runs::continue_equilibrium(scene, scene.assembler().displacements_to(led_on(way, at)),
                                                 options_.iterations, watch_);
  spent_.add(solution.cost);
  return solution;
}

bool Branch::may_have_jumped(const Way& way, std::size_t place) const {
  const Solution& found = way[place].solved.solution;
  const runs::PreparedScene& scene = *way[place].solved.scene;
  if (place < 2) return found.cost.statistics.iterations > options_.few_iterations;
  const auto led = led_on({way[place - 2], way[place - 1]}, way[place].at);
  const double off = largest_move(scene, led, found.x).distance;
  return is_noticed(off, scene) && off > largest_move(scene, way[place - 1].solved.solution.x, led).distance;
}

bool Branch::is_noticed(double distance, const runs::PreparedScene& of) const {
  return distance > options_.noticed * extent_of(of.loaded().scene);
}

/// Opens the scene at the fraction t of the step from `from` to the next point, and sets `values` to the
/// values of the variables there.
std::shared_ptr<runs::PreparedScene> Branch::open_between(const Solved& from, const Values& to, double t,
                                                          Values& values) const {
  values = from.values;
  for (std::size_t v = 0; v < to.size(); ++v)
    if (from.values[v].text != to[v].text)
      values[v] = variables_[v].value_of((1 - t) * *from.values[v].number + t * *to[v].number);
  return open_(values);
}

void Branch::look_for_jump(Solved from, Solved to, std::vector<std::string>& events) {
  if (!can_be_halved(from.values, to.values)) return;
  const double whole = largest_move(from, to).distance;
  for (int k = 0; k < options_.halvings; ++k) {
    Solved middle;
    middle.scene = open_between(from, to.values, 0.5, middle.values);
    if (!middle.scene || !runs::have_same_topology(*from.scene, *middle.scene)) return;
    middle.solution = step(*middle.scene, tangent_way(from, to.values), 0.5);
    if (!has_converged(middle.solution)) break;
    const bool is_behind = largest_move(from, middle).distance < largest_move(middle, to).distance;
    (is_behind ? from : to) = std::move(middle);
  }
  const Move left = largest_move(from, to);
  if (left.distance > kLeftOfAJump * whole)
    events.push_back(fmt::format("jump between {} and {}: {} moves by {:.3g} m",
                                 spell(from.values, to.values), spell(to.values, from.values),
                                 name_of(to, left), left.distance));
}

void Branch::look_for_fold(const Way& way, const Solved& anew, std::vector<std::string>& events) const {
  const Place& end = way.back();
  const Move move = largest_move(end.solved, anew);
  double expected = 0;
  if (way.size() > 1)
    expected =
        largest_move(way.front().solved, end.solved).distance / (end.at - way.front().at) * (1 - end.at);
  if (!is_noticed(move.distance, *anew.scene) || (way.size() > 1 && move.distance <= kElsewhere * expected))
    return;
  events.push_back(fmt::format(
      "fold beyond {}: the equilibrium that was followed ends there, and in the next one {} is {:.3g} m away",
      spell(end.solved.values, anew.values), name_of(anew, move), move.distance));
}

/// Lists the values that differ from `other`, such as "speed 3.125 kn".
std::string Branch::spell(const Values& values, const Values& other) const {
  std::string text;
  for (std::size_t v = 0; v < values.size(); ++v)
    if (values[v].text != other[v].text)
      text += (text.empty() ? "" : ", ") + variables_[v].name + " " + values[v].text;
  return text;
}

}  // namespace netloft::studies
