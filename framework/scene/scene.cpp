// SPDX-License-Identifier: BSD-3-Clause
#include "framework/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace netloft {

namespace {

/// Sets of nodes that are connected by elements (union-find with path halving).
class Pieces {
 public:
  explicit Pieces(std::size_t nodes) : parent_(nodes) { std::iota(parent_.begin(), parent_.end(), 0u); }
  std::uint32_t find(std::uint32_t node) {
    while (parent_[node] != node) node = parent_[node] = parent_[parent_[node]];
    return node;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    const auto one = find(a), other = find(b);
    parent_[std::max(one, other)] = std::min(one, other);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

Pieces find_pieces(const Scene& scene, const std::vector<int>& nodes_per_element) {
  Pieces pieces(scene.node_count());
  for (std::size_t p = 0; p < scene.parts.size(); ++p) {
    const auto& nodes = scene.parts[p].nodes;
    const auto width = static_cast<std::size_t>(nodes_per_element[p]);
    for (std::size_t i = 0; i < nodes.size(); i += width)
      for (std::size_t k = i + 1; k < i + width; ++k) pieces.join(nodes[k], nodes[i]);
  }
  for (const auto& body : scene.bodies)
    for (const auto& point : body.points) pieces.join(point.node, body.origin);
  return pieces;
}

/// The axes of the world along which a held node cannot move, as bits.
std::uint8_t world_axes(const Scene& scene, std::uint32_t node) {
  if (!scene.carried.empty() && scene.carried[node]) return 0;
  const auto frame = scene.frames.find(node);
  if (frame == scene.frames.end()) return scene.held[node];
  std::uint8_t axes = 0;
  for (std::size_t own = 0; own < 3; ++own)
    for (std::size_t axis = 0; axis < 3; ++axis)
      if ((scene.held[node] & (1 << own)) && std::abs(frame->second[3 * axis + own]) > 1e-6)
        axes = static_cast<std::uint8_t>(axes | (1 << axis));
  return axes;
}

std::string axes_text(std::uint8_t axes) {
  std::string text;
  for (int axis = 0; axis < 3; ++axis)
    if (axes & (1 << axis)) text += (text.empty() ? "" : ", ") + std::string(1, "xyz"[axis]);
  return text;
}

}  // namespace

namespace {

/// The position of t between two neighbouring samples: the index of the first sample, and the fraction of the
/// interval between them.
struct SampleInterval {
  std::size_t first;
  double fraction;
};

/// Finds t among samples with increasing t; beyond the ends it is at the nearest sample.
template <class Samples>
SampleInterval find_interval(const Samples& samples, double t) {
  std::size_t after = 0;
  while (after < samples.size() && samples[after].t < t) ++after;
  if (after == 0 || after == samples.size()) return {after ? after - 1 : 0, 0};
  return {after - 1, (t - samples[after - 1].t) / (samples[after].t - samples[after - 1].t)};
}

double factor_at(const std::vector<Current::Factor>& factors, double t) {
  const auto [i, fraction] = find_interval(factors, t);
  return fraction == 0 ? factors[i].value
                       : factors[i].value + fraction * (factors[i + 1].value - factors[i].value);
}

std::array<double, 3> drift_at(const std::vector<Current::Drift>& drifts, double t) {
  const auto [i, fraction] = find_interval(drifts, t);
  std::array<double, 3> velocity = drifts[i].velocity;
  for (std::size_t k = 0; k < 3 && fraction != 0; ++k)
    velocity[k] += fraction * (drifts[i + 1].velocity[k] - velocity[k]);
  return velocity;
}

void profile_at(const std::vector<Current::Sample>& samples, double z, std::array<double, 3>& velocity,
                std::array<double, 3>& dz) {
  std::size_t above = 0;
  while (above < samples.size() && samples[above].z < z) ++above;
  if (above == 0 || above == samples.size()) return void(velocity = samples[above ? above - 1 : 0].velocity);
  const Current::Sample &a = samples[above - 1], &b = samples[above];
  for (std::size_t i = 0; i < 3; ++i) {
    dz[i] = (b.velocity[i] - a.velocity[i]) / (b.z - a.z);
    velocity[i] = a.velocity[i] + dz[i] * (z - a.z);
  }
}

bool is_something(const std::array<double, 3>& velocity) {
  return velocity[0] != 0 || velocity[1] != 0 || velocity[2] != 0;
}

}  // namespace

bool Current::flows() const {
  const auto flows = [](const auto& sample) { return is_something(sample.velocity); };
  return is_something(tow) || std::any_of(samples.begin(), samples.end(), flows) ||
         std::any_of(drifts.begin(), drifts.end(), flows);
}

void Current::at(double z, std::array<double, 3>& velocity, std::array<double, 3>& dz, double t) const {
  velocity = dz = {};
  if (!samples.empty()) profile_at(samples, z, velocity, dz);
  if (!factors.empty())
    for (const double factor = factor_at(factors, t); auto* part : {&velocity, &dz})
      for (double& v : *part) v *= factor;
  if (!drifts.empty())
    for (const auto drift = drift_at(drifts, t); const std::size_t i : {0u, 1u, 2u}) velocity[i] += drift[i];
  for (const std::size_t i : {0u, 1u, 2u}) velocity[i] += tow[i];
}

bool Current::is_uniform() const {
  return std::all_of(samples.begin(), samples.end(),
                     [&](const Sample& s) { return s.velocity == samples.front().velocity; });
}

std::array<double, 3> Current::carried(double t) const {
  std::array<double, 3> way{};
  const auto add = [&](const std::array<double, 3>& velocity, double time) {
    for (const std::size_t i : {0u, 1u, 2u}) way[i] += velocity[i] * time;
  };
  add(tow, t);
  const bool moves_as_one = !samples.empty() && is_uniform();
  std::vector<double> times;  // times at which the rate of the velocity jumps
  for (const Drift& drift : drifts) times.push_back(drift.t);
  for (const Factor& factor : factors)
    if (moves_as_one) times.push_back(factor.t);
  std::sort(times.begin(), times.end());
  const double sign = t < 0 ? -1 : 1, begin = std::min(t, 0.0), end = std::max(t, 0.0);
  double from = begin;  // until the next kink, velocities are linear, and the trapezoidal rule is exact
  const auto straight = [&](double to) {
    for (const double at : {from, to}) {
      const double time = 0.5 * sign * (to - from);
      if (!drifts.empty()) add(drift_at(drifts, at), time);
      if (moves_as_one) add(samples.front().velocity, factors.empty() ? time : time * factor_at(factors, at));
    }
    from = to;
  };
  for (const double kink : times)
    if (kink > begin && kink < end) straight(kink);
  straight(end);
  return way;
}

std::array<double, 6> SeaBed::at(double x, double y) const {
  using T = Dual<2>;
  const T relieved = relief.at(T::variable(x, 0), T::variable(y, 1));
  return {-depth + slope_x * x + slope_y * y + relieved.value,
          slope_x + relieved.gradient[0],
          slope_y + relieved.gradient[1],
          relieved.hessian[0],
          relieved.hessian[1],
          relieved.hessian[2]};
}

std::vector<double> Scene::corners_in_time() const {
  std::vector<double> times;
  for (const auto& guide : guides)
    for (const auto& knot : guide.course.knots) times.push_back(knot.t);
  for (const auto& factor : current.factors) times.push_back(factor.t);
  for (const auto& drift : current.drifts) times.push_back(drift.t);
  std::sort(times.begin(), times.end());
  return times;
}

double RigidBody::arm() const {
  double longest = 0;
  for (const auto& point : points)
    longest = std::max(longest, std::hypot(point.r[0], point.r[1], point.r[2]));
  return longest > 0 ? longest : 1;
}

std::optional<std::size_t> Scene::body_at(std::uint32_t origin) const {
  // Bodies are usually in the order of their nodes, so that bisection finds them. Joined parts may change the
  // order; all bodies are searched if bisection fails.
  std::size_t first = 0, last = bodies.size();
  while (last - first > 1) {
    const std::size_t middle = first + (last - first) / 2;
    (bodies[middle].origin > origin ? last : first) = middle;
  }
  if (first < last && bodies[first].origin == origin) return first;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (bodies[b].origin == origin) return b;
  return {};
}

void Scene::add_body(RigidBody body) {
  carried.resize(node_count(), false);
  for (const auto& point : body.points) {
    carried[point.node] = true;
    held[point.node] = kAllAxes;
  }
  bodies.push_back(std::move(body));
}

std::vector<SceneFault> find_loose_parts(const Scene& scene, const std::vector<int>& nodes_per_element) {
  Pieces pieces = find_pieces(scene, nodes_per_element);
  std::vector<std::uint8_t> held(scene.node_count(), 0);
  for (std::uint32_t n = 0; n < scene.node_count(); ++n) held[pieces.find(n)] |= world_axes(scene, n);

  std::vector<SceneFault> faults;
  std::set<std::uint32_t> reported;
  for (std::uint32_t n = 0; n < scene.node_count(); ++n) {
    const std::uint32_t piece = pieces.find(n);
    if (held[piece] == kAllAxes || !reported.insert(piece).second) continue;
    const auto free = static_cast<std::uint8_t>(kAllAxes & ~held[piece]);
    const std::string& part = scene.parts[scene.labels[n].part].name;
    faults.push_back({part, scene.node_name(n) + " is connected to nothing that is held" +
                                (free == kAllAxes ? "" : " along " + axes_text(free)) +
                                ": it would drift away; add a [[hold]] on \"" + part +
                                "\" or on what it is joined to"});
  }
  return faults;
}

}  // namespace netloft
