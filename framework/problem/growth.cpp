// SPDX-License-Identifier: BSD-3-Clause
#include "framework/problem/growth.hpp"

#include "framework/assembler/pattern.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numeric>
#include <utility>

namespace netloft {

namespace {

// σ of (3): the least, the most, from one to the next; and by how much another is tried where −σ is an
// eigenvalue.
constexpr double kLeastSigma = 1e-10, kMostSigma = 1e16, kStep = 100, kAside = 1.3;
// Steps of Arnoldi's, and how many there may be if these do not tell.
constexpr int kSteps = 24, kMostSteps = 48;
// How far beyond the unit circle a Ritz value is looked at: with σ ten times off |λ|, the band (5) ends at a
// fifth of what it is at its best, 0.002.
constexpr double kBeyond = 1e-3;
// By (4) and (6).
constexpr double kKnown = 0.1, kRoundingOfK = 10 * std::numeric_limits<double>::epsilon();
// Powers before growth is measured, and over which it is measured.
constexpr int kPowers = 40, kMeasured = 20;
// Growth that still falls by this from one measure to the next may be passing: so often it is measured again.
constexpr double kFalls = 1e-3;
constexpr int kMeasures = 16;
// ε of (2), by which flow damps where it does not; what is equal but for rounding, of the largest entry.
constexpr double kLittle = 0.01, kRounding = 1e-9;

/// y = A x, of a matrix that may be stored as its lower triangle.
void multiply(const SparsePattern& p, std::span<const double> values, std::span<const double> x,
              std::vector<double>& y) {
  y.assign(x.size(), 0.0);
  for (std::size_t c = 0; c < x.size(); ++c)
    for (auto k = static_cast<std::size_t>(p.column_start[c]);
         k < static_cast<std::size_t>(p.column_start[c + 1]); ++k) {
      const auto r = static_cast<std::size_t>(p.row[k]);
      y[r] += values[p.slot_of(k)] * x[c];
      if (p.symmetric && r != c) y[c] += values[p.slot_of(k)] * x[r];
    }
}

double dot(std::span<const double> v, std::span<const double> w) {
  return std::inner_product(v.begin(), v.end(), w.begin(), 0.0);
}

double norm(std::span<const double> v) { return std::sqrt(dot(v, v)); }

/// A vector with a share in every direction, the same on every machine: fractions of multiples of the golden
/// ratio.
std::vector<double> scattered(std::size_t size) {
  constexpr double kGolden = 0.61803398874989485;
  std::vector<double> v(size);
  for (std::size_t i = 0; i < size; ++i) {
    const double multiple = kGolden * static_cast<double>(i + 1);
    v[i] = 2 * (multiple - std::floor(multiple)) - 1;
  }
  return v;
}

/// Calls visit(row, column, place of the value) for every entry.
template <class Visit>
void for_entries(const SparsePattern& p, Visit&& visit) {
  for (std::int32_t c = 0; c < p.size; ++c)
    for (auto k = static_cast<std::size_t>(p.column_start[static_cast<std::size_t>(c)]);
         k < static_cast<std::size_t>(p.column_start[static_cast<std::size_t>(c) + 1]); ++k)
      visit(p.row[k], c, p.slot_of(k));
}

double trace(const SparsePattern& p, std::span<const double> A) {
  double sum = 0;
  for_entries(p, [&](std::int32_t r, std::int32_t c, std::size_t at) { sum += r == c ? A[at] : 0; });
  return sum;
}

bool is_symmetric(const SparsePattern& p, std::span<const double> A) {
  if (p.symmetric) return true;
  double largest = 0, apart = 0;
  for_entries(p, [&](std::int32_t r, std::int32_t c, std::size_t at) {
    largest = std::max(largest, std::abs(A[at]));
    if (r > c) apart = std::max(apart, std::abs(A[at] - A[find_slot(p, c, r)]));
  });
  return apart <= kRounding * largest;
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

using Vector = Eigen::VectorXd;
using Complex = std::complex<double>;

std::span<const double> span_of(const Vector& v) { return {v.data(), static_cast<std::size_t>(v.size())}; }

/// A of (3).
class Cayley {
 public:
  Cayley(const SparsePattern& p, std::span<const double> K, std::span<const double> M, Factorisation& plus,
         Statistics& cost)
      : p_(p), K_(K), M_(M), plus_(plus), cost_(cost), minus_(K.size()) {}

  /// False: K + σM has no factor.
  bool set(double sigma) {
    sigma_ = sigma;
    std::vector<double> sum(K_.size());
    for (std::size_t i = 0; i < K_.size(); ++i)
      sum[i] = K_[i] + sigma * M_[i], minus_[i] = sigma * M_[i] - K_[i];
    ++cost_.factorisations;
    return plus_.factorise(sum).status == FactorStatus::ok;
  }
  Vector operator*(const Vector& v) {
    Vector to(v.size());
    multiply(p_, minus_, span_of(v), z_);
    plus_.solve(z_, {to.data(), z_.size()});
    ++cost_.solves;
    return to;
  }
  /// λ of an eigenvalue μ.
  Complex lambda(Complex mu) const { return sigma_ * (1.0 - mu) / (1.0 + mu); }
  Vector start() const {
    const std::vector<double> v = scattered(static_cast<std::size_t>(p_.size));
    return Eigen::Map<const Vector>(v.data(), p_.size).normalized();
  }

 private:
  const SparsePattern& p_;
  std::span<const double> K_, M_;
  Factorisation& plus_;
  Statistics& cost_;
  double sigma_ = 0;
  std::vector<double> minus_, z_;
};

/// An eigenvalue of A with a vector, as a Krylov space has them.
struct RitzPair {
  Complex theta;
  double error = std::numeric_limits<double>::infinity();  // left side of (4)
  Eigen::VectorXcd vector = {};

  double beyond() const { return std::abs(theta) - 1; }
  bool is_known() const { return error <= kKnown * beyond(); }
};

/// An orthonormal basis of v, Av, A²v, … with A = Q H Qᵀ on it.
class Arnoldi {
 public:
  Arnoldi(Cayley& A, const Vector& v) : A_(A), Q_(v), H_(Eigen::MatrixXd::Zero(1, 0)) {}

  void extend(int steps) {
    Q_.conservativeResize(Eigen::NoChange, steps + 1);
    const Eigen::Index before = H_.cols();
    H_.conservativeResizeLike(Eigen::MatrixXd::Zero(steps + 1, steps));
    for (Eigen::Index k = before; k < steps && !is_exhausted_; ++k) step(k);
  }

  /// The outermost beyond the circle that is known, else the outermost.
  RitzPair outermost() const {
    const Eigen::MatrixXd H = H_.topLeftCorner(size_, size_);
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(H);
    const Eigen::MatrixXcd right = solver.eigenvectors(), left = right.inverse();
    const double rounding = std::numeric_limits<double>::epsilon() * H.norm();
    RitzPair best{.theta = 0};
    Eigen::Index place = 0;
    for (Eigen::Index i = 0; i < size_; ++i) {
      const double rho = std::abs(H_(size_, size_ - 1) * right(size_ - 1, i));
      // Of unit right eigenvectors, the rows of the inverse are as long as s is short.
      const double error = (rho + rounding) * left.row(i).norm();
      const RitzPair pair{solver.eigenvalues()[i], std::isfinite(error) ? error : RitzPair{}.error};
      if (is_better(pair, best)) best = pair, place = i;
    }
    best.vector = Q_.leftCols(size_) * right.col(place);
    return best;
  }

 private:
  /// Orthogonalised twice, which is enough.
  void step(Eigen::Index k) {
    Vector next = A_ * Vector(Q_.col(k));
    const double length = next.norm();
    for (int i = 0; i < 2; ++i) {
      const Vector along = Q_.leftCols(k + 1).transpose() * next;
      H_.col(k).head(k + 1) += along;
      next -= Q_.leftCols(k + 1) * along;
    }
    const double rest = next.norm();
    size_ = k + 1;
    is_exhausted_ = !(rest > 16 * std::numeric_limits<double>::epsilon() * length) || size_ == Q_.rows();
    H_(k + 1, k) = is_exhausted_ ? 0 : rest;
    if (!is_exhausted_) Q_.col(k + 1) = next / rest;
  }

  static bool is_better(const RitzPair& a, const RitzPair& b) {
    if (a.is_known() != b.is_known()) return a.is_known();
    return std::abs(a.theta) > std::abs(b.theta);
  }

  Cayley& A_;
  Eigen::MatrixXd Q_, H_;
  Eigen::Index size_ = 0;
  bool is_exhausted_ = false;
};

/// A vector under powers of A, kept at length 1.
class Powers {
 public:
  Powers(Cayley& A) : A_(A), y_(A.start()) {}

  /// Growth per power, averaged over so many.
  double grow(int powers) {
    double logarithm = 0;
    for (int k = 0; k < powers; ++k) {
      y_ = A_ * y_;
      const double length = y_.norm();
      if (!std::isfinite(length)) return std::numeric_limits<double>::infinity();
      if (length == 0) return 0;
      logarithm += std::log(length);
      y_ /= length;
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
  const Vector& vector() const { return y_; }

 private:
  Cayley& A_;
  Vector y_;
};

/// Of length 1, the largest entry of v having no imaginary part.
std::vector<double> real_mode(const Eigen::VectorXcd& v) {
  Eigen::Index largest = 0;
  v.cwiseAbs2().maxCoeff(&largest);
  const Vector mode = (v / v[largest]).real().normalized();
  return {mode.begin(), mode.end()};
}

/// By (6).
bool is_in_doubt(Complex lambda, const std::vector<double>& v, const SparsePattern& p,
                 std::span<const double> K, std::span<const double> M, double doubt) {
  std::vector<double> Mv, noise(v.size()), all_K(K.begin(), K.end()), all_v(v);
  for (double& k : all_K) k = std::abs(k);
  for (double& vi : all_v) vi = std::abs(vi);
  multiply(p, M, v, Mv);
  multiply(p, all_K, all_v, noise);
  for (std::size_t i = 0; i < v.size(); ++i) noise[i] = kRoundingOfK * noise[i] + doubt * all_v[i];
  return std::abs(lambda) * norm(Mv) <= norm(noise);
}

Growth growth_of(const RitzPair& pair, const Cayley& A) {
  const Complex lambda = A.lambda(pair.theta);
  Growth g{.verdict = GrowthVerdict::grows, .mode = real_mode(pair.vector)};
  const double c = std::min(1.0, -lambda.real() / std::abs(lambda));
  g.per_power = std::sqrt((1 + c) / (1 - c));  // (5)
  g.rate = -lambda.real(), g.frequency = std::abs(lambda.imag());
  return g;
}

/// Where the largest Ritz value is not known.
Growth growth_by_powers(Cayley& A) {
  Powers powers(A);
  const GrowthVerdict verdict = powers.judge();
  if (verdict != GrowthVerdict::grows) return {.verdict = verdict};
  Arnoldi arnoldi(A, powers.vector());
  arnoldi.extend(kSteps);
  return growth_of(arnoldi.outermost(), A);
}

/// For the σ that A has.
Growth growth_by(Cayley& A) {
  Arnoldi arnoldi(A, A.start());
  for (const int steps : {kSteps, kMostSteps}) {
    arnoldi.extend(steps);
    const RitzPair pair = arnoldi.outermost();
    if (pair.beyond() <= kBeyond) return {};
    if (pair.is_known()) return growth_of(pair, A);
  }
  return growth_by_powers(A);
}

/// A power of ten that no entry of the diagonal of K is above, over that of M, but for rounding; from 1 to
/// kMostSigma. A member in compression that is next to nothing long pushes aside much more stiffly than its
/// linear stiffness.
double largest_sigma(const SparsePattern& p, std::span<const double> K, std::span<const double> M) {
  double largest = 1;
  for_entries(p, [&](std::int32_t r, std::int32_t c, std::size_t at) {
    if (r == c && M[at] > 0 && std::isfinite(K[at])) largest = std::max(largest, std::abs(K[at]) / M[at]);
  });
  return std::min(kMostSigma, std::pow(10, std::ceil(std::log10(largest) - kRounding)));
}

/// Adds to a block of a matrix what makes its symmetric part positive semidefinite.
void make_block_positive(const SparsePattern& p, const std::vector<std::int32_t>& unknowns,
                         std::span<double> A) {
  if (unknowns.empty()) return;
  const auto n = static_cast<Eigen::Index>(unknowns.size());
  const auto slot = [&](Eigen::Index r, Eigen::Index c) {
    const std::int32_t i = unknowns[static_cast<std::size_t>(r)], j = unknowns[static_cast<std::size_t>(c)];
    return p.symmetric ? find_slot(p, std::max(i, j), std::min(i, j)) : find_slot(p, i, j);
  };
  Eigen::MatrixXd block(n, n);
  for (Eigen::Index r = 0; r < n; ++r)
    for (Eigen::Index c = 0; c < n; ++c) block(r, c) = A[slot(r, c)];
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> of(0.5 * (block + block.transpose()));
  if (!(of.eigenvalues()[0] < 0)) return;
  const Eigen::VectorXd lacking = (-of.eigenvalues()).cwiseMax(0.0);
  const Eigen::MatrixXd more = of.eigenvectors() * lacking.asDiagonal() * of.eigenvectors().transpose();
  for (Eigen::Index r = 0; r < n; ++r)
    for (Eigen::Index c = p.symmetric ? r : 0; c < n; ++c) A[slot(r, c)] += more(r, c);
}

/// Leaves of C what damps.
void leave_what_damps(const Assembler& assembler, std::span<double> C) {
  const Numbering& numbering = assembler.numbering();
  std::vector<std::vector<std::int32_t>> blocks(numbering.dofs() / 3);
  std::vector<std::size_t> block_of(blocks.size());
  std::iota(block_of.begin(), block_of.end(), std::size_t{0});
  for (const auto& body : assembler.body_nodes()) block_of[body[1]] = body[0];
  for (std::int32_t i = 0; i < numbering.unknowns(); ++i) blocks[block_of[numbering.node(i)]].push_back(i);
  for (const auto& block : blocks) make_block_positive(assembler.pattern(), block, C);
}

/// Makes the linear stiffness M the matrix of (2). 1/τ; zero where the trace of C is not positive.
double add_damping(const SparsePattern& p, std::span<const double> C, std::span<double> M) {
  if (!(trace(p, C) > 0)) return 0;
  const double share = trace(p, M) / (kLittle * trace(p, C));
  for (std::size_t i = 0; i < p.value_slots(); ++i) M[i] += share * C[i];
  return share;
}

}  // namespace

Growth find_growth(Assembler& assembler, std::span<const double> x, const MakeFactorisation& make,
                   std::span<const double> x_low, double doubt) {
  const double* low = x_low.empty() ? nullptr : x_low.data();
  // An assembler has more values than its pattern.
  std::vector<double> K(assembler.value_slots()), C = K, M = K;
  if (!assembler.evaluate(x, {.matrix = MatrixKind::exact, .values = K.data(), .motion = {.x_low = low}}) ||
      !assembler.evaluate(
          x, {.matrix = MatrixKind::exact, .values = C.data(), .motion = {.cu = 0, .cv = 1, .x_low = low}}) ||
      !assembler.evaluate(x, {.matrix = MatrixKind::metric, .values = M.data()}))
    return {.verdict = GrowthVerdict::unknown};
  const SparsePattern& pattern = assembler.pattern();
  const std::size_t entries = pattern.value_slots();
  leave_what_damps(assembler, C);
  const double per_second = add_damping(pattern, C, M);
  Growth growth = find_growth(pattern, std::span(K).first(entries), std::span(M).first(entries), make, doubt);
  growth.rate *= per_second, growth.frequency *= per_second;
  growth.cost.matrices += 3;
  return growth;
}

Growth find_growth(const SparsePattern& pattern, std::span<const double> K, std::span<const double> M,
                   const MakeFactorisation& make, double doubt) {
  Growth most;
  Statistics cost;
  if (is_symmetric(pattern, M) && is_symmetric_part_positive(pattern, M, make, cost) &&
      is_symmetric_part_positive(pattern, K, make, cost))
    return {.cost = cost};  // (7)
  const auto factorisation = make(pattern.symmetric ? MatrixClass::symmetric : MatrixClass::unsymmetric);
  factorisation->analyse(pattern);
  Cayley A(pattern, K, M, *factorisation, cost);
  for (double sigma = largest_sigma(pattern, K, M); sigma > kLeastSigma / 2 && !most.grows();
       sigma /= kStep) {
    if (!A.set(sigma) && !A.set(kAside * sigma)) {
      most = {.verdict = GrowthVerdict::unknown};
      break;
    }
    Growth growth = growth_by(A);
    if (growth.grows() && (growth.per_power <= kGrows ||
                           is_in_doubt({growth.rate, growth.frequency}, growth.mode, pattern, K, M, doubt)))
      growth.verdict = GrowthVerdict::marginal, growth.per_power = std::min(growth.per_power, kGrows);
    if (growth.verdict > most.verdict) most = std::move(growth);
  }
  most.cost = cost;
  return most;
}

}  // namespace netloft
