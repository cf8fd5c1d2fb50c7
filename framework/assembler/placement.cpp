// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/placement.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cassert>
#include <utility>

namespace netloft {

namespace {

/// Turns a body so that its points come as close as possible to given positions, by the iteration of Gauss
/// and Newton with central differences.
class TurnedBody {
 public:
  /// `x` are the positions of all dofs; those of the body's rotation and of carried nodes change.
  TurnedBody(const Bodies& bodies, const Numbering& numbering, std::size_t body, std::size_t scene_nodes,
             std::span<const double> positions, std::vector<double>& x)
      : bodies_(bodies), arm_(bodies.arm(body)), x_(x) {
    const auto [origin, rotation] = bodies.pairs()[body];
    for (int axis = 0; axis < 3; ++axis) turn_[axis] = numbering.dof(rotation, axis).at();
    for (std::uint32_t node = 0; node < scene_nodes; ++node)
      for (int axis = 0; axis < 3; ++axis) {
        const std::size_t at = numbering.dof(node, axis).at();
        const double where = positions[3 * std::size_t{node} + static_cast<std::size_t>(axis)];
        if (node == origin) x_[at] = where;
        if (node != origin && bodies.carrier(node) == origin) points_.push_back({at, where});
      }
  }

  /// Returns false, and leaves the rotation as it is, if the points do not determine it.
  bool fit() {
    constexpr int kMostSteps = 20;
    constexpr double kNoMore = 1e-13;  // last step, as a fraction of the arm
    constexpr double kOnALine = 1e-6;  // ratio of pivots below which points are on one line
    const Eigen::Vector3d start{x_[turn_[0]], x_[turn_[1]], x_[turn_[2]]};
    Eigen::Vector3d q = start;
    const double before = off(q).norm();
    for (int k = 0; k < kMostSteps; ++k) {
      Eigen::ColPivHouseholderQR<Eigen::MatrixXd> J(slopes(q));
      J.setThreshold(kOnALine);
      if (J.rank() < 3) break;
      const Eigen::Vector3d step = J.solve(off(q));
      q -= step;
      if (step.norm() <= kNoMore * arm_) break;
    }
    const bool is_nearer = off(q).norm() < before;
    if (!is_nearer) off(start);
    return is_nearer;
  }

 private:
  struct Coordinate {
    std::size_t at;
    double where;
  };

  Eigen::VectorXd off(const Eigen::Vector3d& q) {
    for (int axis = 0; axis < 3; ++axis) x_[turn_[axis]] = q[axis];
    bodies_.place(x_);
    Eigen::VectorXd distances(static_cast<Eigen::Index>(points_.size()));
    for (std::size_t i = 0; i < points_.size(); ++i)
      distances[static_cast<Eigen::Index>(i)] = x_[points_[i].at] - points_[i].where;
    return distances;
  }

  Eigen::MatrixXd slopes(const Eigen::Vector3d& q) {
    const double h = 1e-5 * arm_;  // error of the differences 1e-10, and of rounding 1e-11
    Eigen::MatrixXd J(static_cast<Eigen::Index>(points_.size()), 3);
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(axis);
      J.col(axis) = (off(q + step) - off(q - step)) / (2 * h);
    }
    return J;
  }

  const Bodies& bodies_;
  double arm_;
  std::vector<double>& x_;
  std::size_t turn_[3];
  std::vector<Coordinate> points_;
};

}  // namespace

Placement::Placement(const Scene& scene, const Scene& nodes, const NodeBlocks& blocks, bool symmetric)
    : scene_nodes_(scene.node_count()),
      numbering_(nodes),
      axes_(scene.frames),
      frames_(nodes, numbering_, blocks, symmetric),
      bodies_(nodes, numbering_, blocks, symmetric),
      guides_(scene.guides),
      start_(numbering_.dofs()) {
  for (std::uint32_t n = 0; n < nodes.node_count(); ++n)
    for (int axis = 0; axis < 3; ++axis)
      start_[numbering_.dof(n, axis).at()] =
          nodes.positions[3 * std::size_t{n} + static_cast<std::size_t>(axis)];
  bodies_.place(start_);
}

/// For every degree of freedom that a guide moves, calls visit(index among all dofs, axis, motion of the
/// guide at `time`).
template <class Visit>
void Placement::visit_guided(double time, const Visit& visit) const {
  for (const Guide& guide : guides_) {
    const Course::Moment moment = guide.course.at(time);
    for (std::size_t i = 0; i < guide.nodes.size(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (guide.axes[i] & (1 << axis))
          visit(numbering_.dof(guide.nodes[i], static_cast<int>(axis)).at(), axis, moment);
  }
}

void Placement::place(std::span<const double> u, std::span<double> x, double time) const {
  assert(is_over_unknowns(u) && is_over_dofs(x));
  for (std::size_t i = 0; i < u.size(); ++i) x[i] = start_[i] + u[i];
  frames_.place(start_, u, x);
  visit_guided(
      time, [&](std::size_t i, std::size_t axis, const Course::Moment& m) { x[i] = start_[i] + m.d[axis]; });
  bodies_.place(x);
}

void Placement::place_from(std::span<const double> base, std::span<const double> u, std::span<double> x,
                           std::span<double> x_low) const {
  assert(is_over_dofs(base) && is_over_unknowns(u) && is_over_dofs(x) && is_over_dofs(x_low));
  assert(!has_bodies() && "low-order parts of positions are not kept for nodes on a body");
  std::copy(u.begin(), u.end(), x_low.begin());
  std::fill(x_low.begin() + static_cast<std::ptrdiff_t>(u.size()), x_low.end(), 0.0);
  frames_.turn_back(u, x_low);
  // The exact sum of two numbers, as the rounded sum and its error (Knuth 1969).
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double way = x_low[i];
    x[i] = base[i] + way;
    const double moved = x[i] - base[i];
    x_low[i] = (base[i] - (x[i] - moved)) + (way - moved);
  }
}

void Placement::move(double time, std::span<const double> x, std::span<const double> v,
                     std::span<const double> a, std::span<double> all_v, std::span<double> all_a) const {
  assert(is_over_dofs(x) && is_over_dofs(all_v) && is_over_dofs(all_a));
  assert(is_over_unknowns(v) && is_over_unknowns(a));
  for (const auto& [from, to] : {std::pair{v, all_v}, std::pair{a, all_a}}) {
    std::copy(from.begin(), from.end(), to.begin());
    std::fill(to.begin() + static_cast<std::ptrdiff_t>(from.size()), to.end(), 0.0);
    frames_.turn_back(from, to);
  }
  visit_guided(time, [&](std::size_t i, std::size_t axis, const Course::Moment& m) {
    all_v[i] = m.v[axis];
    all_a[i] = m.a[axis];
  });
  bodies_.move(x, all_v, all_a);
}

std::array<double, 3> Placement::node_position(std::uint32_t node, std::span<const double> x) const {
  assert(is_over_dofs(x));
  std::array<double, 3> place{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    place[axis] = x[numbering_.dof(node, static_cast<int>(axis)).at()];
  return place;
}

std::array<double, 3> Placement::rotation(std::size_t body, std::span<const double> x) const {
  assert(body < bodies_.pairs().size());
  auto turn = node_position(bodies_.pairs()[body][1], x);
  for (double& component : turn) component /= bodies_.arm(body);
  return turn;
}

void Placement::take_rotations(const Placement& from, std::span<const double> x, std::span<double> u) const {
  for (std::size_t b = 0; b < bodies_.pairs().size(); ++b) {
    const auto turn = from.rotation(b, x);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto at = numbering_.dof(bodies_.pairs()[b][1], static_cast<int>(axis)).at();
      if (at < u.size()) u[at] = bodies_.arm(b) * turn[axis] - start_[at];
    }
  }
}

std::vector<double> Placement::node_positions(std::span<const double> x) const {
  std::vector<double> all;
  all.reserve(3 * scene_nodes_);
  for (std::uint32_t node = 0; node < scene_nodes_; ++node) {
    const auto place = node_position(node, x);
    all.insert(all.end(), place.begin(), place.end());
  }
  return all;
}

namespace {

/// Displacements of the unknowns of nodes that have these positions. Unknowns that are no coordinates of a
/// node with a position do not move.
std::vector<double> displacements_of_nodes(const Numbering& numbering,
                                           const std::map<std::uint32_t, std::array<double, 9>>& axes,
                                           std::span<const double> start, std::span<const double> positions) {
  std::vector<double> u(static_cast<std::size_t>(numbering.unknowns()));
  for (std::size_t i = 0; i < u.size(); ++i) {
    const std::uint32_t node = numbering.node(Dof(i));
    if (3 * std::size_t{node} >= positions.size()) continue;
    const auto own = static_cast<std::size_t>(numbering.axis(Dof(i)));
    const auto frame = axes.find(node);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto at = numbering.dof(node, static_cast<int>(axis)).at();
      const double way = positions[3 * std::size_t{node} + axis] - start[at];
      u[i] += frame == axes.end() ? (axis == own ? way : 0.0) : frame->second[3 * axis + own] * way;
    }
  }
  return u;
}

}  // namespace

std::vector<double> Placement::displacements(std::span<const double> positions) const {
  std::vector<double> u = displacements_of_nodes(numbering_, axes_, start_, positions), x = start_;
  for (std::size_t b = 0; b < bodies_.pairs().size(); ++b) {
    std::array<std::size_t, 3> turn{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      turn[axis] = numbering_.dof(bodies_.pairs()[b][1], static_cast<int>(axis)).at();
    if (std::ranges::any_of(turn, [&](std::size_t at) { return at >= u.size(); })) continue;
    if (TurnedBody(bodies_, numbering_, b, scene_nodes_, positions, x).fit())
      for (const std::size_t at : turn) u[at] = x[at] - start_[at];
  }
  return u;
}

std::vector<double> Placement::displacements_to(std::span<const double> x) const {
  assert(is_over_dofs(x));
  std::vector<double> u = displacements_of_nodes(numbering_, axes_, start_, node_positions(x));
  for (std::size_t i = 0; i < u.size(); ++i)
    if (numbering_.node(Dof(i)) >= scene_nodes_) u[i] = x[i] - start_[i];
  return u;
}

bool Placement::shorten_rotations(std::span<double> u, std::span<double> v, std::span<double> a) const {
  return bodies_.shorten(start_, u, v, a);
}

std::array<double, 3> Placement::reaction(std::uint32_t node, std::span<const double> residual,
                                          std::uint8_t axes) const {
  return part_of(node, residual, true, axes);
}
std::array<double, 3> Placement::unbalanced(std::uint32_t node, std::span<const double> residual) const {
  return part_of(node, residual, false, kAllAxes);
}

std::array<double, 3> Placement::part_of(std::uint32_t node, std::span<const double> residual, bool held,
                                         std::uint8_t axes) const {
  assert(is_over_dofs(residual));
  const auto frame = axes_.find(node);
  std::array<double, 3> force{};
  for (std::size_t own = 0; own < 3; ++own) {
    const Dof place = numbering_.dof(node, static_cast<int>(own));
    if (numbering_.is_unknown(place) == held || !(axes & (1 << own))) continue;
    const double f = residual[place.at()];
    for (std::size_t axis = 0; axis < 3; ++axis)
      force[axis] += frame == axes_.end() ? (axis == own ? f : 0.0) : frame->second[3 * axis + own] * f;
  }
  return force;
}

}  // namespace netloft
