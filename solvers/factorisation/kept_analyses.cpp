// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/kept_analyses.hpp"

#include <array>
#include <memory>
#include <mutex>
#include <utility>

#include "solvers/factorisation/foreseen_memory.hpp"

namespace netloft {
namespace {

constexpr double kLargestKept = 4e6;  // most entries of a factor that is kept

/// A factorisation with the pattern that it has analysed.
struct Analysed {
  std::unique_ptr<Factorisation> factorisation;
  SparsePattern pattern = {};
  bool has_factor = false;

  /// A factorisation is kept if its factor is not large, or if it has only been analysed, which needs little
  /// memory.
  bool is_worth_keeping() const { return !has_factor || factorisation->factor_entries() <= kLargestKept; }
};

/// Factorisations that are kept for reuse and not used at present.
class Shelf {
 public:
  /// Returns the factorisation of this class for the pattern, or nullptr if there is none.
  std::unique_ptr<Analysed> take(MatrixClass kind, const SparsePattern& pattern) {
    const std::lock_guard lock(mutex_);
    std::unique_ptr<Analysed>& kept = kept_[static_cast<std::size_t>(kind)];
    if (!kept || !(kept->pattern == pattern)) return nullptr;
    return std::move(kept);
  }
  void put(MatrixClass kind, std::unique_ptr<Analysed> analysed) {
    if (!analysed->is_worth_keeping()) return;
    const std::lock_guard lock(mutex_);
    kept_[static_cast<std::size_t>(kind)].swap(analysed);
  }

 private:
  std::mutex mutex_;
  std::array<std::unique_ptr<Analysed>, 3> kept_;  // one factorisation for each class of matrices
};

class LentFactorisation final : public Factorisation, public ForeseesMemory {
 public:
  LentFactorisation(std::shared_ptr<Shelf> shelf, MatrixClass kind, std::unique_ptr<Factorisation> fresh)
      : shelf_(std::move(shelf)),
        kind_(kind),
        analysed_(std::make_unique<Analysed>(Analysed{std::move(fresh)})) {}
  ~LentFactorisation() override {
    if (is_analysed_ && !has_failed_) shelf_->put(kind_, std::move(analysed_));
  }

  std::string description() const override { return inner().description(); }
  void analyse(const SparsePattern& pattern) override {
    if (auto kept = shelf_->take(kind_, pattern)) {
      analysed_ = std::move(kept);
    } else {
      is_analysed_ = analysed_->has_factor = false;
      analysed_->pattern = pattern;
      inner().analyse(analysed_->pattern);
    }
    is_analysed_ = true;
    has_failed_ = false;
  }
  /// A factorisation that has failed is not kept, because its memory may have grown or be unknown.
  FactorResult factorise(std::span<const double> values) override {
    analysed_->has_factor = true;
    const FactorResult result = inner().factorise(values);
    has_failed_ = result.status != FactorStatus::ok && result.status != FactorStatus::not_positive_definite;
    return result;
  }
  void solve(std::span<const double> rhs, std::span<double> x) override { inner().solve(rhs, x); }
  void solve_transposed(std::span<const double> rhs, std::span<double> x) override {
    inner().solve_transposed(rhs, x);
  }
  double factor_entries() const override { return inner().factor_entries(); }
  double factor_flops() const override { return inner().factor_flops(); }
  double factor_bytes() const override { return factor_bytes_of(inner()); }

 private:
  Factorisation& inner() const { return *analysed_->factorisation; }

  std::shared_ptr<Shelf> shelf_;
  MatrixClass kind_;
  std::unique_ptr<Analysed> analysed_;
  bool is_analysed_ = false, has_failed_ = false;
};

}  // namespace

MakeFactorisation keep_analyses(MakeFactorisation make) {
  return [make = std::move(make), shelf = std::make_shared<Shelf>()](MatrixClass kind) {
    return std::make_unique<LentFactorisation>(shelf, kind, make(kind));
  };
}

}  // namespace netloft
