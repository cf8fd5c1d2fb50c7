// SPDX-License-Identifier: BSD-3-Clause
#include "io/runs/tangent.hpp"

#include "framework/judging/correction.hpp"

#include <utility>

namespace netloft::runs {

bool have_same_topology(const PreparedScene& a, const PreparedScene& b) {
  return a.assembler().numbering().dofs() == b.assembler().numbering().dofs() &&
         a.assembler().pattern() == b.assembler().pattern();
}

Tangent::Tangent(PreparedScene& scene, std::vector<double> x)
    : scene_(scene),
      x_(std::move(x)),
      u_(scene.assembler().displacements_to(x_)),
      problem_(scene.assembler(), scene.factorisations(), {}) {}

/// Whether all quantities of the scene are known.
bool Tangent::is_defined() const {
  return !scene_.loaded().analysis.settles && scene_.loaded().scene.settings.empty();
}

/// The residual of a scene where its unknowns have the values of x, and its positions there.
std::optional<Tangent::Point> Tangent::evaluate(PreparedScene& scene, const std::vector<double>& x) {
  StaticProblem problem(scene.assembler(), scene.factorisations(), {});
  Point point;
  double energy = 0;
  const bool is_known =
      problem.recompute(scene.assembler().displacements_to(x), point.x, point.residual, energy);
  spent_.add(problem.statistics());
  return is_known ? std::optional(std::move(point)) : std::nullopt;
}

/// Solves (1), and once more for what rounding has left of it.
bool Tangent::solve(std::vector<double> imbalance, std::vector<double>& du) {
  const std::size_t size = u_.size();
  imbalance.resize(size);
  du.resize(size);
  if (factor_ == Factor::failed) return false;
  const bool is_solved = factor_ == Factor::none ? find_correction(problem_, u_, imbalance, du)
                                                 : solve_for_correction(problem_, imbalance, du);
  factor_ = is_solved ? Factor::ready : Factor::failed;
  std::vector<double> rest(size), more(size);
  netloft_problem& p = problem_.interface();
  if (!is_solved || p.multiply(p.host, NETLOFT_EXACT, 0, du.data(), rest.data()) != NETLOFT_OK)
    return is_solved;
  for (std::size_t i = 0; i < size; ++i) rest[i] += imbalance[i];
  if (solve_for_correction(problem_, rest, more))
    for (std::size_t i = 0; i < size; ++i) du[i] += more[i];
  return true;
}

namespace {

/// Positions of a scene where its unknowns have the values of x, plus du.
std::vector<double> moved(const Assembler& assembler, const std::vector<double>& x,
                          const std::vector<double>& du) {
  const auto start = assembler.start();
  std::vector<double> v = assembler.displacements_to(x), there(start.begin(), start.end());
  for (std::size_t i = 0; i < v.size(); ++i) v[i] += du[i];
  assembler.place(v, there);
  return there;
}

}  // namespace

std::optional<std::vector<double>> Tangent::between(PreparedScene& before, PreparedScene& after) {
  if (!is_defined()) return std::nullopt;
  const std::optional<Point> a = evaluate(before, x_), b = evaluate(after, x_);
  if (!a || !b) return std::nullopt;
  std::vector<double> change(b->residual), du;
  for (std::size_t i = 0; i < change.size(); ++i) change[i] -= a->residual[i];
  if (!solve(std::move(change), du)) return std::nullopt;
  std::vector<double> dx = moved(after.assembler(), x_, du);
  for (std::size_t i = 0; i < dx.size(); ++i) dx[i] -= a->x[i];
  return dx;
}

std::optional<std::vector<double>> Tangent::corrected(PreparedScene& near, const std::vector<double>& y) {
  if (!is_defined()) return std::nullopt;
  std::optional<Point> at = evaluate(near, y);
  std::vector<double> du;
  if (!at || !solve(std::move(at->residual), du)) return std::nullopt;
  return moved(near.assembler(), y, du);
}

Statistics Tangent::spent() const {
  Statistics all = spent_;
  all.add(problem_.statistics());
  return all;
}

}  // namespace netloft::runs
