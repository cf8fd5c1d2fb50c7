// SPDX-License-Identifier: BSD-3-Clause
#include "framework/problem/growth.hpp"

#include "framework/assembler/pattern.hpp"

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>

namespace netloft {

namespace {

// σ of (4): the least, the most, from one to the next; and by how much another is tried where it is an
// eigenvalue. Growth is seen from two decades off: slower than 1e-5/s, tenfold in three days, nothing is.
constexpr double kLeastSigma = 1e-3, kMostSigma = 1e9, kStep = 100, kAside = 1.3;
// Steps of Arnoldi's, and how many there may be if these do not tell.
constexpr int kSteps = 24, kMostSteps = 48;
// How far beyond the unit circle a Ritz value is looked at: with σ ten times off |s|, the band (6) ends at a
// fifth of what it is at its best, 0.002.
constexpr double kBeyond = 1e-3;
// By (5) and (7).
constexpr double kKnown = 0.1, kRoundingOfK = 10 * std::numeric_limits<double>::epsilon();
// Powers before growth is measured, and over which it is measured.
constexpr int kPowers = 40, kMeasured = 20;
// Growth that still falls by this from one measure to the next may be passing: so often it is measured again.
constexpr double kFalls = 1e-3;
constexpr int kMeasures = 16;
// What is equal but for rounding, of the largest entry.
constexpr double kRounding = 1e-9;
// τ of (2) [s]
constexpr double kFollows = 1e-3;
// Of the metric in the norm (8), for what nothing else keeps; what is left of a vector that is orthogonal
// already, at least, when it is made so again.
constexpr double kLittle = 1e-6, kRemains = 0.5;
constexpr int kMatrices = 5;

using Vector = Eigen::VectorXd;
using Complex = std::complex<double>;
using Sparse = Eigen::SparseMatrix<double>;

/// Calls visit(row, column, value) for every entry, those above the diagonal of a symmetric one included.
template <class Visit>
void for_entries(const SparsePattern& p, std::span<const double> values, Visit&& visit) {
  for (std::int32_t c = 0; c < p.size; ++c)
    for (auto k = static_cast<std::size_t>(p.column_start[static_cast<std::size_t>(c)]);
         k < static_cast<std::size_t>(p.column_start[static_cast<std::size_t>(c) + 1]); ++k) {
      const std::int32_t r = p.row[k];
      visit(r, c, values[p.slot_of(k)]);
      if (p.symmetric && r != c) visit(c, r, values[p.slot_of(k)]);
    }
}

/// Without the zeros of the pattern.
Sparse make_sparse(const SparsePattern& p, std::span<const double> values) {
  std::vector<Eigen::Triplet<double>> entries;
  for_entries(p, values, [&](std::int32_t r, std::int32_t c, double value) {
    if (value != 0) entries.emplace_back(r, c, value);
  });
  Sparse A(p.size, p.size);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

/// A vector with a share in every direction, the same on every machine: fractions of multiples of the golden
/// ratio.
Vector scattered(Eigen::Index size) {
  constexpr double kGolden = 0.61803398874989485;
  Vector v(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const double multiple = kGolden * static_cast<double>(i + 1);
    v[i] = 2 * (multiple - std::floor(multiple)) - 1;
  }
  return v;
}

bool is_symmetric(const Sparse& A) {
  const Sparse apart = A - Sparse(A.transpose());
  double largest = 0, most = 0;
  for (Eigen::Index k = 0; k < A.nonZeros(); ++k) largest = std::max(largest, std::abs(A.valuePtr()[k]));
  for (Eigen::Index k = 0; k < apart.nonZeros(); ++k) most = std::max(most, std::abs(apart.valuePtr()[k]));
  return most <= kRounding * largest;
}

/// Whether ½ (A + Aᵀ) has positive eigenvalues only. The pattern of A is symmetric.
bool is_symmetric_part_positive(const SparsePattern& p, std::span<const double> A,
                                const MakeFactorisation& make, Statistics& cost) {
  SparsePattern lower;
  lower.size = p.size, lower.node = p.node, lower.column_start = {0};
  std::vector<double> values;
  for (std::int32_t c = 0; c < p.size; ++c) {
    const auto end = static_cast<std::size_t>(p.column_start[static_cast<std::size_t>(c) + 1]);
    for (auto k = static_cast<std::size_t>(p.column_start[static_cast<std::size_t>(c)]); k < end; ++k) {
      const std::int32_t r = p.row[k];
      if (r < c) continue;
      lower.row.push_back(r);
      values.push_back(p.symmetric ? A[p.slot_of(k)] : 0.5 * (A[p.slot_of(k)] + A[find_slot(p, c, r)]));
    }
    lower.column_start.push_back(static_cast<std::int32_t>(lower.row.size()));
  }
  const auto factorisation = make(MatrixClass::positive_definite);
  factorisation->analyse(lower);
  ++cost.factorisations;
  return factorisation->factorise(values).status == FactorStatus::ok;
}

std::span<double> span_of(Vector& v) { return {v.data(), static_cast<std::size_t>(v.size())}; }

/// A of (4), on vectors (y, v) whose length is that of (8).
class Cayley {
 public:
  Cayley(const SparsePattern& p, const LinearMotion& m, Factorisation& factor, Statistics& cost)
      : motion_(m),
        K_(make_sparse(p, m.K)),
        C_(make_sparse(p, m.C)),
        M_(make_sparse(p, m.M)),
        convex_(make_sparse(p, m.convex)),
        factor_(factor),
        cost_(cost),
        rhs_(p.size),
        d_(p.size) {}

  /// False: K + σC + σ²M has no factor.
  bool set(double sigma) {
    sigma_ = sigma;
    std::vector<double> sum(motion_.K.size());
    for (std::size_t i = 0; i < sum.size(); ++i)
      sum[i] = motion_.K[i] + sigma * (motion_.C[i] + sigma * motion_.M[i]);
    N_ = convex_ + sigma * sigma * M_;
    ++cost_.factorisations;
    return factor_.factorise(sum).status == FactorStatus::ok;
  }
  Eigen::Index unknowns() const { return K_.rows(); }
  /// Of the space that the norm (8) sees: what has no mass has no velocity there.
  Eigen::Index dimension() const {
    const Eigen::VectorXd masses = M_.cwiseAbs() * Eigen::VectorXd::Ones(unknowns());
    return unknowns() + (masses.array() > 0).count();
  }
  Vector operator*(const Vector& z) {
    const auto y = z.head(unknowns()), v = z.tail(unknowns());
    rhs_ = 2 * (sigma_ * (M_ * v) - K_ * y);
    factor_.solve(span_of(rhs_), span_of(d_));
    ++cost_.solves;
    Vector to(z.size());
    to << y + d_, sigma_ * d_ - v;
    return to;
  }
  /// B z of the inner product zᵀ B z.
  Vector weighed(const Vector& z) const {
    Vector to(z.size());
    to << N_ * z.head(unknowns()), M_ * z.tail(unknowns());
    return to;
  }
  bool is_damped() const { return motion_.is_damped; }
  /// s of an eigenvalue μ.
  Complex rate(Complex mu) const { return sigma_ * (mu - 1.0) / (mu + 1.0); }
  Vector start() const { return scattered(2 * unknowns()); }

  /// By (7): whether a change of K as small as it is known would undo what grows by s along y.
  bool is_in_doubt(Complex s, const Eigen::VectorXcd& y, double doubt) const {
    const Eigen::VectorXd size = y.cwiseAbs();
    const Eigen::VectorXd noise = kRoundingOfK * (K_.cwiseAbs() * size) + doubt * size;
    return (s * (C_ * y) + s * s * (M_ * y)).norm() <= noise.norm();
  }

 private:
  const LinearMotion& motion_;
  Sparse K_, C_, M_, convex_, N_;
  Factorisation& factor_;
  Statistics& cost_;
  double sigma_ = 0;
  Vector rhs_, d_;
};

/// An eigenvalue of A with a vector, as a Krylov space has them.
struct RitzPair {
  Complex theta;
  double residual = std::numeric_limits<double>::infinity();  // ρ of (5)
  double condition = 1;                                       // 1/χ
  Eigen::VectorXcd vector = {};

  double beyond() const { return std::abs(theta) - 1; }
  bool is_known() const { return residual * condition <= kKnown * beyond(); }
};

/// An orthonormal basis Q of z, Az, A²z, … in the inner product (8), with A Q = Q H on it.
class Arnoldi {
 public:
  Arnoldi(Cayley& A, const Vector& z) : A_(A), Q_(z), BQ_(A.weighed(z)) {
    const double length = std::sqrt(Q_.col(0).dot(BQ_.col(0)));
    Q_ /= length, BQ_ /= length;
  }

  void extend(int steps) {
    Q_.conservativeResize(Eigen::NoChange, steps + 1), BQ_.conservativeResize(Eigen::NoChange, steps + 1);
    const Eigen::Index before = H_.cols();
    H_.conservativeResizeLike(Eigen::MatrixXd::Zero(steps + 1, steps));
    for (Eigen::Index k = before; k < steps && !is_exhausted_; ++k) step(k);
  }

  /// Of those beyond the circle that are known one that diverges, else the outermost; if there is none, the
  /// outermost of all. Without a number: A has none.
  RitzPair outermost() const {
    const Eigen::MatrixXd H = H_.topLeftCorner(size_, size_);
    if (!H.allFinite()) return {.theta = std::nan("")};
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(H);
    if (solver.info() != Eigen::Success) return {.theta = std::nan("")};
    const Eigen::MatrixXcd right = solver.eigenvectors(), left = right.inverse();
    RitzPair best{.theta = 0};
    Eigen::Index place = 0;
    for (Eigen::Index i = 0; i < size_; ++i) {
      const double rho = std::abs(H_(size_, size_ - 1) * right(size_ - 1, i));
      // Of unit right eigenvectors, the rows of the inverse are as long as χ is short.
      const RitzPair pair{solver.eigenvalues()[i], rho, left.row(i).norm()};
      if (is_better(pair, best)) best = pair, place = i;
    }
    best.vector = Q_.leftCols(size_) * right.col(place);
    return best;
  }

 private:
  /// Orthogonalised twice, which is enough: what gets shorter by that once more was rounding (B. N. Parlett,
  /// The Symmetric Eigenvalue Problem, 1998, section 6.9), and the space holds all of Az.
  void step(Eigen::Index k) {
    Vector next = A_ * Vector(Q_.col(k)), weighed;
    double rest = 0, before = 0;
    for (int i = 0; i < 2; ++i) {
      const Vector along = BQ_.leftCols(k + 1).transpose() * next;
      H_.col(k).head(k + 1) += along;
      next -= Q_.leftCols(k + 1) * along;
      weighed = A_.weighed(next);
      before = std::exchange(rest, std::sqrt(std::max(0.0, next.dot(weighed))));
    }
    size_ = k + 1;
    is_exhausted_ = !(rest > kRemains * before) || size_ == A_.dimension();
    H_(k + 1, k) = is_exhausted_ ? 0 : rest;
    if (!is_exhausted_) Q_.col(k + 1) = next / rest, BQ_.col(k + 1) = weighed / rest;
  }

  bool is_better(const RitzPair& a, const RitzPair& b) const {
    return std::pair(rank(a), std::abs(a.theta)) > std::pair(rank(b), std::abs(b.theta));
  }
  int rank(const RitzPair& pair) const {
    if (pair.beyond() <= kBeyond || !pair.is_known()) return 0;
    const Complex s = A_.rate(pair.theta);
    return std::abs(s.imag()) > s.real() ? 1 : 2;
  }

  Cayley& A_;
  Eigen::MatrixXd Q_, BQ_, H_ = Eigen::MatrixXd::Zero(1, 0);
  Eigen::Index size_ = 0;
  bool is_exhausted_ = false;
};

/// A vector under powers of A, kept at length 1.
class Powers {
 public:
  Powers(Cayley& A) : A_(A), z_(A.start()) {}

  /// Growth per power, averaged over so many.
  double grow(int powers) {
    double logarithm = 0;
    for (int k = 0; k < powers; ++k) {
      z_ = A_ * z_;
      const double length = std::sqrt(z_.dot(A_.weighed(z_)));
      if (!std::isfinite(length)) return std::numeric_limits<double>::infinity();
      if (length == 0) return 0;
      logarithm += std::log(length);
      z_ /= length;
    }
    return std::exp(logarithm / powers);
  }

  GrowthVerdict judge() {
    grow(kPowers);
    double growth = grow(kMeasured);
    for (int measure = 1; growth > kGrows && measure < kMeasures; ++measure) {
      const double before = std::exchange(growth, grow(kMeasured));
      if (growth > (1 - kFalls) * before) return GrowthVerdict::grows;
    }
    return growth > kGrows ? GrowthVerdict::marginal : GrowthVerdict::none;
  }
  const Vector& vector() const { return z_; }

 private:
  Cayley& A_;
  Vector z_;
};

/// The largest entry of y has no imaginary part then.
void take_mode(const Eigen::VectorXcd& y, Growth& g) {
  Eigen::Index largest = 0;
  y.cwiseAbs2().maxCoeff(&largest);
  const Eigen::VectorXcd turned = y / y[largest];
  const double length = turned.real().norm();
  const Vector now = turned.real() / length, later = turned.imag() / length;
  g.mode.assign(now.begin(), now.end());
  if (g.frequency > 0) g.mode_later.assign(later.begin(), later.end());
}

Growth growth_of(const RitzPair& pair, const Cayley& A, double doubt) {
  const Complex s = A.rate(pair.theta);
  const Eigen::VectorXcd y = pair.vector.head(A.unknowns()).normalized();
  if (!(s.real() > 0)) return {.verdict = GrowthVerdict::marginal};  // powers saw it grow
  Growth g{.verdict = GrowthVerdict::grows};
  const double c = std::min(1.0, s.real() / std::abs(s));
  g.per_power = std::sqrt((1 + c) / (1 - c));  // (6)
  g.rate = s.real(), g.frequency = std::abs(s.imag());
  take_mode(y, g);
  const bool is_for_damping_to_tell = !A.is_damped() && g.swings();
  if (g.per_power <= kGrows || is_for_damping_to_tell || A.is_in_doubt(s, y, doubt))
    g.verdict = GrowthVerdict::marginal, g.per_power = std::min(g.per_power, kGrows);
  return g;
}

/// Where the largest Ritz value is not known.
Growth growth_by_powers(Cayley& A, double doubt) {
  Powers powers(A);
  const GrowthVerdict verdict = powers.judge();
  if (verdict != GrowthVerdict::grows) return {.verdict = verdict};
  Arnoldi arnoldi(A, powers.vector());
  arnoldi.extend(kSteps);
  return growth_of(arnoldi.outermost(), A, doubt);
}

/// With the residual that A itself leaves: rounding keeps that of the recurrence, which is as small, from
/// holding.
RitzPair checked(Cayley& A, RitzPair pair) {
  const Vector real = pair.vector.real(), imaginary = pair.vector.imag();
  Eigen::VectorXcd rest = -pair.theta * pair.vector;
  rest.real() += A * real, rest.imag() += A * imaginary;
  const auto square = [&](const Vector& z) { return z.dot(A.weighed(z)); };
  const double ratio = (square(rest.real()) + square(rest.imag())) / (square(real) + square(imaginary));
  pair.residual = ratio >= 0 ? std::max(pair.residual, std::sqrt(ratio)) : RitzPair{}.residual;
  return pair;
}

/// For the σ that A has.
Growth growth_by(Cayley& A, double doubt) {
  Arnoldi arnoldi(A, A.start());
  for (const int steps : {kSteps, kMostSteps}) {
    arnoldi.extend(steps);
    const RitzPair pair = arnoldi.outermost();
    if (std::isnan(pair.beyond())) return {.verdict = GrowthVerdict::unknown};
    if (pair.beyond() <= kBeyond) return {};
    if (pair.is_known() && checked(A, pair).is_known()) return growth_of(pair, A, doubt);
  }
  return growth_by_powers(A, doubt);
}

/// The largest entry of each column.
Vector largest_by_column(const SparsePattern& p, std::span<const double> A) {
  Vector largest = Vector::Zero(p.size);
  for_entries(p, A, [&](std::int32_t, std::int32_t c, double value) {
    if (std::isfinite(value)) largest[c] = std::max(largest[c], std::abs(value));
  });
  return largest;
}

/// The greatest σ: so that none is ten times slower than the fastest that an unknown makes by itself.
double largest_sigma(const SparsePattern& p, const LinearMotion& m) {
  const Vector K = largest_by_column(p, m.K), C = largest_by_column(p, m.C);
  double fastest = kLeastSigma;
  for (std::int32_t c = 0; c < p.size; ++c) {
    const double mass = m.M[find_slot(p, c, c)];
    const double rate = mass > 0 ? std::max(std::sqrt(K[c] / mass), C[c] / mass) : C[c] > 0 ? K[c] / C[c] : 0;
    fastest = std::max(fastest, rate);
  }
  double sigma = kLeastSigma;
  while (sigma * std::sqrt(kStep) < fastest && sigma < kMostSigma) sigma *= kStep;
  return sigma;
}

/// By (9).
bool is_stable_by_energy(const SparsePattern& p, const LinearMotion& m, const MakeFactorisation& make,
                         Statistics& cost) {
  const auto is_positive = [&](std::span<const double> A) {
    std::vector<double> sum(p.value_slots());
    double largest = 0, largest_of_convex = 0;
    for (std::size_t i = 0; i < sum.size(); ++i)
      largest = std::max(largest, std::abs(A[i])),
      largest_of_convex = std::max(largest_of_convex, std::abs(m.convex[i]));
    if (largest == 0) return true;
    for (std::size_t i = 0; i < sum.size(); ++i)
      sum[i] = A[i] + kRounding * largest / largest_of_convex * m.convex[i];
    return is_symmetric_part_positive(p, sum, make, cost);
  };
  return is_symmetric(make_sparse(p, m.K)) && is_symmetric(make_sparse(p, m.M)) && is_positive(m.M) &&
         is_positive(m.C) && is_symmetric_part_positive(p, m.K, make, cost);
}

/// (2)
void let_follow(const SparsePattern& p, std::span<const double> metric, LinearMotion& m) {
  std::vector<bool> follows(static_cast<std::size_t>(p.size), true);
  const auto each = [&](auto&& visit) {
    for (std::int32_t c = 0; c < p.size; ++c)
      for (auto k = static_cast<std::size_t>(p.column_start[static_cast<std::size_t>(c)]);
           k < static_cast<std::size_t>(p.column_start[static_cast<std::size_t>(c) + 1]); ++k)
        visit(static_cast<std::size_t>(p.row[k]), static_cast<std::size_t>(c), p.slot_of(k));
  };
  each([&](std::size_t r, std::size_t c, std::size_t at) {
    if (m.M[at] != 0 || m.C[at] != 0) follows[r] = follows[c] = false;
  });
  each([&](std::size_t r, std::size_t c, std::size_t at) {
    if (follows[r] && follows[c]) m.C[at] += kFollows * metric[at];
  });
}

/// The matrices of (1) and (8) at x. False: see the assembler's fault.
bool linearise(Assembler& assembler, std::span<const double> x, std::span<const double> x_low,
               LinearMotion& m) {
  const double* low = x_low.empty() ? nullptr : x_low.data();
  const std::size_t slots = assembler.value_slots();  // more than the pattern has
  std::vector<double> metric(slots);
  for (auto* A : {&m.K, &m.C, &m.M, &m.convex}) A->assign(slots, 0.0);
  const auto evaluate = [&](std::vector<double>& A, MatrixKind kind, double cu, double cv, double ca) {
    const Kinematics motion{.cu = cu, .cv = cv, .ca = ca, .x_low = low};
    return assembler.evaluate(x, {.matrix = kind, .values = A.data(), .motion = motion});
  };
  if (!evaluate(m.K, MatrixKind::exact, 1, 0, 0) || !evaluate(m.C, MatrixKind::exact, 0, 1, 0) ||
      !evaluate(m.M, MatrixKind::exact, 0, 0, 1) || !evaluate(m.convex, MatrixKind::convex, 1, 0, 0) ||
      !evaluate(metric, MatrixKind::metric, 1, 0, 0))
    return false;
  m.is_damped = std::any_of(m.C.begin(), m.C.end(), [](double c) { return c != 0; });
  let_follow(assembler.pattern(), metric, m);
  for (std::size_t i = 0; i < slots; ++i) m.convex[i] += kLittle * metric[i];
  for (auto* A : {&m.K, &m.C, &m.M, &m.convex}) A->resize(assembler.pattern().value_slots());
  return true;
}

}  // namespace

Growth find_growth(const SparsePattern& pattern, const LinearMotion& motion, const MakeFactorisation& make,
                   double doubt) {
  Growth most;
  Statistics cost;
  if (is_stable_by_energy(pattern, motion, make, cost)) return {.cost = cost};
  const auto factorisation = make(pattern.symmetric ? MatrixClass::symmetric : MatrixClass::unsymmetric);
  factorisation->analyse(pattern);
  Cayley A(pattern, motion, *factorisation, cost);
  const auto is_decided = [&] {
    return most.verdict == GrowthVerdict::unknown || (most.grows() && !most.swings());
  };
  // What swings does not hide what diverges more slowly.
  for (double sigma = largest_sigma(pattern, motion); sigma > kLeastSigma / 2 && !is_decided();
       sigma /= kStep) {
    Growth growth{.verdict = GrowthVerdict::unknown};
    if (A.set(sigma) || A.set(kAside * sigma)) growth = growth_by(A, doubt);
    const bool diverges = growth.grows() && !growth.swings();
    if (growth.verdict > most.verdict || diverges) most = std::move(growth);
  }
  most.cost = cost;
  return most;
}

Growth find_growth(Assembler& assembler, std::span<const double> x, const MakeFactorisation& make,
                   std::span<const double> x_low, double doubt) {
  LinearMotion m;
  if (!linearise(assembler, x, x_low, m)) return {.verdict = GrowthVerdict::unknown};
  Growth growth = find_growth(assembler.pattern(), m, make, doubt);
  growth.cost.matrices += kMatrices;
  return growth;
}

}  // namespace netloft
