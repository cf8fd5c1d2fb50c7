// SPDX-License-Identifier: BSD-3-Clause
#include "io/runs/tangent.hpp"

#include "framework/judging/correction.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace netloft::runs {

namespace {

// The correction steps (2) end when a step is smaller than this fraction of the change. Rounding errors have
// about this size: on trawls with 300 nodes, derivatives of figures differ by 1e-9 from differences of
// equilibria (tests/bench/derivatives.md).
constexpr double kNoMore = 1e-9;
// Limit of the correction steps (2). One step is enough unless a member is slack in only one of the scenes.
constexpr int kMostSteps = 5;

/// Positions of a scene at displacements u of its unknowns.
std::vector<double> placed(const Assembler& assembler, const std::vector<double>& u) {
  std::vector<double> x(assembler.start());
  assembler.place(u, x);
  return x;
}

}  // namespace

bool have_same_topology(const PreparedScene& a, const PreparedScene& b) {
  return a.assembler().numbering().dofs() == b.assembler().numbering().dofs() &&
         a.assembler().pattern() == b.assembler().pattern();
}

Tangent::Tangent(PreparedScene& scene, std::vector<double> x)
    : scene_(scene),
      x_(std::move(x)),
      u_(scene.assembler().displacements_to(x_)),
      problem_(scene.assembler(), scene.factorisations(), {}) {}

/// Whether the scene leaves no quantity to the search.
bool Tangent::is_defined() const {
  return !scene_.loaded().analysis.settles && scene_.loaded().scene.settings.empty();
}

/// Evaluates the residual of a scene at the unknowns of x. Returns this residual and the positions in the
/// scene.
std::optional<Tangent::Point> Tangent::evaluate(PreparedScene& scene, const std::vector<double>& x) {
  std::vector<double> there = placed(scene.assembler(), scene.assembler().displacements_to(x));
  auto residual = residual_at(scene, {there, std::vector<double>(there.size())});
  return residual ? std::optional(Point{std::move(there), std::move(*residual)}) : std::nullopt;
}

std::optional<std::vector<double>> Tangent::residual_at(PreparedScene& scene, const ExactPlace& place) {
  std::vector<double> residual(place.x.size());
  ++spent_.residuals;
  if (!scene.assembler().evaluate(place.x,
                                  {.residual = residual.data(), .motion = {.x_low = place.x_low.data()}}))
    return std::nullopt;
  return residual;
}

/// Solves K du = −imbalance, where `imbalance` has a value for every degree of freedom.
bool Tangent::solve(std::vector<double> imbalance, std::vector<double>& du) {
  imbalance.resize(u_.size());
  du.resize(u_.size());
  return has_factor() && solve_for_correction(problem_, imbalance, du);
}

/// Factorises K at the first call. Returns false if that is not possible.
bool Tangent::has_factor() {
  if (factor_ == Factor::none) factor_ = factorise_tangent(problem_, u_) ? Factor::ready : Factor::failed;
  return factor_ == Factor::ready;
}

/// Solves K y = rhs or Kᵀ y = rhs, with one step of iterative refinement.
std::optional<std::vector<double>> Tangent::refined(const std::vector<double>& rhs, bool transposed) {
  if (!has_factor()) return std::nullopt;
  std::vector<double> y(u_.size()), rest = rhs, product(u_.size());
  for (int pass = 0; pass < 2; ++pass) {
    transposed ? problem_.factors().solve_transposed(rest, rest) : problem_.factors().solve(rest, rest);
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += rest[i];
    Matrices& K = problem_.matrices();
    transposed ? K.multiply_transposed(NETLOFT_EXACT, y.data(), product.data())
               : K.multiply(NETLOFT_EXACT, 0, y.data(), product.data());
    for (std::size_t i = 0; i < y.size(); ++i) rest[i] = rhs[i] - product[i];
  }
  const bool is_finite = std::ranges::all_of(y, [](double value) { return std::isfinite(value); });
  return is_finite ? std::optional(std::move(y)) : std::nullopt;
}

std::optional<std::vector<double>> Tangent::solved(const std::vector<double>& b) { return refined(b, false); }

std::optional<std::vector<double>> Tangent::adjoint(const std::vector<double>& w) { return refined(w, true); }

ExactPlace moved(const ExactPlace& from, const std::vector<double>& dx, double times) {
  ExactPlace to = from;
  to.x_low.resize(to.x.size());
  for (std::size_t i = 0; i < to.x.size(); ++i) {
    const double way = times * dx[i];
    to.x[i] = from.x[i] + way;
    to.x_low[i] += (from.x[i] - to.x[i]) + way;  // exact where |way| ≤ |x|
  }
  return to;
}

namespace {

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

std::vector<double> difference(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
  return a;
}

/// The motion of all degrees of freedom at positions x, to first order, when the unknowns move by du. It is
/// not computed as a difference of two positions, because that would lose digits of du.
std::vector<double> motion_of(const Assembler& assembler, const std::vector<double>& x,
                              const std::vector<double>& du) {
  const std::vector<double> none(du.size(), 0.0);
  std::vector<double> motion(x.size()), of_guides(x.size()), unused(x.size());
  assembler.move(0, x, du, none, motion, unused);
  assembler.move(0, x, none, none, of_guides, unused);
  for (std::size_t i = 0; i < motion.size(); ++i) motion[i] -= of_guides[i];
  return motion;
}

}  // namespace

/// The motion of all degrees of freedom in a step whose unknowns move by du. Held degrees of freedom move as
/// the two scenes say.
std::vector<double> Tangent::Step::motion(const std::vector<double>& du) const {
  std::vector<double> dx = motion_of(after.assembler(), b.x, du);
  for (std::size_t i = 0; i < dx.size(); ++i) dx[i] += b.x[i] - a.x[i];
  return dx;
}

std::optional<Tangent::Step> Tangent::first_step(PreparedScene& before, PreparedScene& after) {
  if (!is_defined()) return std::nullopt;
  std::optional<Point> a = evaluate(before, x_), b = evaluate(after, x_);
  std::vector<double> du;
  if (!a || !b || !solve(difference(b->residual, a->residual), du)) return std::nullopt;  // (1)
  return Step{after, std::move(*a), std::move(*b), std::move(du)};
}

std::optional<std::vector<double>> Tangent::towards(PreparedScene& near) {
  const std::optional<Step> step = first_step(scene_, near);
  return step ? std::optional(step->motion(step->du)) : std::nullopt;
}

std::optional<std::vector<double>> Tangent::between(PreparedScene& before, PreparedScene& after,
                                                    double theta) {
  const std::optional<Step> step = first_step(before, after);
  if (!step) return std::nullopt;
  std::vector<double> du = step->du, more;
  double last = dot(du, du);
  for (int k = 0; k < kMostSteps; ++k) {
    const std::vector<double> dx = step->motion(du);
    const auto a = residual_at(before, moved({x_, {}}, dx, theta - 1)),
               b = residual_at(after, moved({x_, {}}, dx, theta));
    if (!a || !b || !solve(difference(*b, *a), more)) return std::nullopt;  // (2)
    const double square = dot(more, more);
    if (!(square < last)) break;  // no improvement: members alternate between slack and taut
    last = square;
    for (std::size_t i = 0; i < du.size(); ++i) du[i] += more[i];
    if (square <= kNoMore * kNoMore * dot(du, du)) break;
  }
  return step->motion(du);
}

std::optional<std::vector<double>> Tangent::corrected(PreparedScene& near, const std::vector<double>& y) {
  if (!is_defined()) return std::nullopt;
  std::optional<Point> at = evaluate(near, y);
  std::vector<double> du;
  if (!at || !solve(std::move(at->residual), du)) return std::nullopt;
  const std::vector<double> u = near.assembler().displacements_to(y);
  for (std::size_t i = 0; i < du.size(); ++i) du[i] += u[i];
  return placed(near.assembler(), du);
}

/// Computes dK du of (3) from the tangents of the scene `near` at x and at x + `fraction` dx; nullopt if one
/// of them is not known.
std::optional<std::vector<double>> Tangent::stiffness_change(PreparedScene& near, double fraction,
                                                             const std::vector<double>& dx,
                                                             const std::vector<double>& du) {
  std::vector<double> change(du.size()), here(du.size());
  Assembler& assembler = near.assembler();
  Matrices& matrices = problem_.matrices();
  ++spent_.matrices;
  const auto x = placed(assembler, assembler.displacements_to(moved({x_, {}}, dx, fraction).x));
  // The tangent of `near` takes the place of the convex matrix, which this problem does not use.
  double* const values = matrices.slots(MatrixKind::convex).data();
  if (!assembler.evaluate(x, {.matrix = MatrixKind::exact, .values = values}) ||
      !matrices.multiply(NETLOFT_CONVEX, 0, du.data(), change.data()) ||
      !matrices.multiply(NETLOFT_EXACT, 0, du.data(), here.data()))
    return std::nullopt;
  for (std::size_t i = 0; i < change.size(); ++i) change[i] = (change[i] - here[i]) / fraction;
  return change;
}

std::optional<double> Tangent::growth(PreparedScene& before, PreparedScene& after, double theta,
                                      const std::vector<double>& dx) {
  if (factor_ != Factor::ready) return std::nullopt;
  std::vector<double> du = difference(scene_.assembler().displacements_to(moved({x_, {}}, dx, 1).x), u_),
                      more;
  const double square = dot(du, du);
  if (!(square > 0)) return 0;
  std::optional<std::vector<double>> least;
  for (auto [near, part] : {std::pair(&after, theta), std::pair(&before, theta - 1)}) {
    if (part == 0) continue;
    auto change = stiffness_change(*near, part, dx, du);
    if (!change) return std::nullopt;
    if (!least || dot(*change, *change) < dot(*least, *least)) least = std::move(change);
  }
  if (!solve(std::move(*least), more)) return std::nullopt;
  const double along = dot(du, more) / square, across = dot(more, more) / square - along * along;
  return across < along * along ? along : 0;
}

Statistics Tangent::spent() const {
  Statistics all = spent_;
  all.add(problem_.statistics());
  return all;
}

}  // namespace netloft::runs
