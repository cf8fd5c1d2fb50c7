// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/mumps.hpp"

#include <dmumps_c.h>

#include <algorithm>
#include <cassert>
#include <mutex>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "solvers/factorisation/finite_values.hpp"
#include "solvers/factorisation/foreseen_memory.hpp"
#include "solvers/factorisation/memory_pool.hpp"

// The only entry point of MUMPS in this build; see cmake/FindMumpsSeq.cmake.
extern "C" void netloft_dmumps_c(DMUMPS_STRUC_C*);

namespace netloft {
namespace {

enum Job { kBegin = -1, kEnd = -2, kAnalyse = 1, kFactorise = 2, kSolve = 3 };

/// An instance of MUMPS. Its parameters have the names and the indices, from one, of the users' guide of
/// MUMPS 5.5, section 6.
class MumpsInstance {
 public:
  explicit MumpsInstance(bool symmetric);
  MumpsInstance(const MumpsInstance&) = delete;
  MumpsInstance& operator=(const MumpsInstance&) = delete;
  ~MumpsInstance() { run(kEnd); }

  DMUMPS_STRUC_C* operator->() { return &id_; }
  MUMPS_INT& icntl(int i) { return id_.icntl[i - 1]; }
  MUMPS_INT infog(int i) const { return id_.infog[i - 1]; }
  double rinfog(int i) const { return id_.rinfog[i - 1]; }

  /// Returns INFOG(1): negative numbers are errors.
  int run(Job job);

 private:
  DMUMPS_STRUC_C id_{};
};

MumpsInstance::MumpsInstance(bool symmetric) {
  id_.sym = symmetric ? 2 : 0;
  id_.par = 1;
  id_.comm_fortran = -987654;  // code for MPI_COMM_WORLD, one process
  if (run(kBegin) < 0) throw std::bad_alloc();
  for (const int stream : {1, 2, 3, 4}) icntl(stream) = 0;  // no output
  icntl(6) = 0;                                             // no permutation by values:
  icntl(7) = 1;                                             // the order is the one that we give,
  icntl(12) = 1;                                            // and is used unchanged
  icntl(13) = 1;                                            // count all negative pivots
  icntl(24) = 1;                                            // name pivots that are zero
}

int MumpsInstance::run(Job job) {
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  id_.job = job;
  netloft_dmumps_c(&id_);
  return id_.infog[0];
}

class MumpsFactorisation final : public Factorisation, public ForeseesMemory {
 public:
  MumpsFactorisation(MatrixClass kind, OrderingMethod method)
      : symmetric_(kind == MatrixClass::symmetric), method_(method) {
    assert(kind != MatrixClass::positive_definite);
  }
  ~MumpsFactorisation() override { forget(); }

  std::string description() const override;
  void analyse(const SparsePattern& pattern) override;
  FactorResult factorise(std::span<const double> values) override;
  void solve(std::span<const double> rhs, std::span<double> x) override;
  void solve_transposed(std::span<const double> rhs, std::span<double> x) override;
  double factor_entries() const override { return entries_; }
  double factor_flops() const override { return flops_; }
  /// The memory that the analysis predicts, INFOG(17) [10⁶ bytes].
  double factor_bytes() const override { return mumps_ ? 1e6 * mumps_->infog(17) : 0; }

 private:
  void forget();
  void analyse_unknowns(const SparsePattern& pattern);
  void list_entries(const SparsePattern& pattern);
  int factorise_with_room();
  FactorResult result_of(int status);

  bool symmetric_;
  OrderingMethod method_;
  MemoryPool pool_;
  std::unique_ptr<MumpsInstance> mumps_;  // nullptr for a matrix without unknowns
  const SparsePattern* pattern_ = nullptr;
  std::vector<MUMPS_INT> row_, column_;  // rows and columns of the entries, counted from one
  std::vector<double> value_;            // values in the order of the entries
  bool has_factor_ = false;
  std::string ordering_;
  double entries_ = 0, flops_ = 0;
};

void MumpsFactorisation::forget() {
  const MemoryPoolScope pool(pool_);
  mumps_.reset();
  pool_.clear();
  pattern_ = nullptr;
  has_factor_ = false;
  ordering_.clear();
  entries_ = flops_ = 0;
}

std::string MumpsFactorisation::description() const {
  const std::string text = std::string(symmetric_ ? "MUMPS LDLT " : "MUMPS LU ") + MUMPS_VERSION;
  return ordering_.empty() ? text : text + ", " + ordering_ + " on the node graph";
}

void MumpsFactorisation::analyse(const SparsePattern& pattern) {
  assert(pattern.symmetric == symmetric_);
  forget();
  if (pattern.size > 0) analyse_unknowns(pattern);
  pattern_ = &pattern;
}

void MumpsFactorisation::analyse_unknowns(const SparsePattern& pattern) {
  const NodeOrdering ordering = order_nodes(pattern, method_);
  std::vector<MUMPS_INT> position(ordering.unknown.size());
  for (std::size_t k = 0; k < position.size(); ++k)
    position[static_cast<std::size_t>(ordering.unknown[k])] = static_cast<MUMPS_INT>(k) + 1;
  list_entries(pattern);

  const MemoryPoolScope pool(pool_);
  mumps_ = std::make_unique<MumpsInstance>(symmetric_);
  MumpsInstance& mumps = *mumps_;
  mumps->n = pattern.size;
  mumps->nnz = static_cast<MUMPS_INT8>(pattern.entries());
  mumps->irn = row_.data();
  mumps->jcn = column_.data();
  mumps->a = value_.data();
  mumps->perm_in = position.data();
  if (const int status = mumps.run(kAnalyse); status < 0) {
    throw std::runtime_error("cannot analyse a matrix of " + std::to_string(pattern.size) +
                             " unknowns: MUMPS status " + std::to_string(status));
  }
  mumps->perm_in = nullptr;
  ordering_ = ordering.method;
}

void MumpsFactorisation::list_entries(const SparsePattern& pattern) {
  value_.resize(pattern.entries());
  row_.resize(pattern.entries());
  column_.resize(pattern.entries());
  std::transform(pattern.row.begin(), pattern.row.end(), row_.begin(), [](auto row) { return row + 1; });
  for (std::int32_t column = 0; column < pattern.size; ++column)
    std::fill(column_.begin() + pattern.column_start[column],
              column_.begin() + pattern.column_start[column + 1], column + 1);
}

FactorResult MumpsFactorisation::factorise(std::span<const double> values) {
  assert(pattern_ != nullptr && values.size() == pattern_->value_slots());
  has_factor_ = false;
  if (pattern_->size > 0) {
    if (const std::int32_t column = find_column_not_finite(*pattern_, values); column >= 0) {
      return {FactorStatus::failed, column};
    }
    for (std::size_t e = 0; e < value_.size(); ++e) value_[e] = values[pattern_->slot_of(e)];
    const MemoryPoolScope pool(pool_);
    if (const FactorResult result = result_of(factorise_with_room()); result.status != FactorStatus::ok) {
      return result;
    }
  }
  has_factor_ = true;
  return {FactorStatus::ok, -1, !symmetric_ ? -1 : mumps_ ? mumps_->infog(12) : 0};
}

/// Computes (1) or (2) of mumps.hpp. Delayed pivots need more memory than the analysis of the pattern
/// predicts, and it is unknown how much. Therefore the memory is doubled until it is enough.
int MumpsFactorisation::factorise_with_room() {
  constexpr int kNoRoomForIntegers = -8, kNoRoomForReals = -9;
  constexpr int kMostRoom = 10000;  // memory in addition to the prediction [percent]
  for (;;) {
    const int status = mumps_->run(kFactorise);
    MUMPS_INT& room = mumps_->icntl(14);
    if ((status != kNoRoomForIntegers && status != kNoRoomForReals) || room > kMostRoom) return status;
    room *= 2;
  }
}

FactorResult MumpsFactorisation::result_of(int status) {
  constexpr int kSingular = -10;
  MumpsInstance& mumps = *mumps_;
  if (status == kSingular) return {FactorStatus::singular};
  if (status < 0) {
    constexpr int kNoMemory[] = {-7, -8, -9, -13, -19};
    return {std::ranges::count(kNoMemory, status) ? FactorStatus::out_of_memory : FactorStatus::failed};
  }
  const int zero_pivots = mumps.infog(28);
  if (zero_pivots > 0) return {FactorStatus::singular, mumps->pivnul_list[0] - 1};
  const int entries = mumps.infog(29);
  entries_ = entries < 0 ? -1e6 * entries : entries;
  flops_ = mumps.rinfog(3);
  return {};
}

void MumpsFactorisation::solve(std::span<const double> rhs, std::span<double> x) {
  assert(has_factor_);
  if (!mumps_) return;
  assert(rhs.size() == static_cast<std::size_t>(pattern_->size) && x.size() == rhs.size());
  const MemoryPoolScope pool(pool_);
  if (x.data() != rhs.data()) std::copy(rhs.begin(), rhs.end(), x.begin());
  MumpsInstance& mumps = *mumps_;
  mumps->rhs = x.data();
  if (mumps.run(kSolve) < 0) throw std::bad_alloc();
}

void MumpsFactorisation::solve_transposed(std::span<const double> rhs, std::span<double> x) {
  if (!mumps_) return;
  constexpr MUMPS_INT kPlain = 1, kTransposed = 2;
  mumps_->icntl(9) = kTransposed;
  solve(rhs, x);
  mumps_->icntl(9) = kPlain;
}

}  // namespace

bool has_mumps() { return true; }

std::unique_ptr<Factorisation> make_mumps_factorisation(MatrixClass kind, OrderingMethod method) {
  return std::make_unique<MumpsFactorisation>(kind, method);
}

}  // namespace netloft
