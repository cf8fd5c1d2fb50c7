// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/kept_analyses.hpp"

#include <map>
#include <memory>
#include <mutex>
#include <utility>

namespace netloft {
namespace {

constexpr double kLargestKept = 4e6;  // entries of the factor

/// A factorisation with the pattern it knows.
struct Analysed {
  std::unique_ptr<Factorisation> factorisation;
  SparsePattern pattern = {};
};

/// Those that nobody uses.
class Shelf {
 public:
  /// Null if there is none for the pattern.
  std::unique_ptr<Analysed> take(MatrixClass kind, const SparsePattern& pattern) {
    const std::lock_guard lock(mutex_);
    const auto at = kept_.find(kind);
    if (at == kept_.end() || !at->second || !(at->second->pattern == pattern)) return nullptr;
    return std::move(at->second);
  }
  void put(MatrixClass kind, std::unique_ptr<Analysed> analysed) {
    if (analysed->factorisation->factor_entries() > kLargestKept) return;
    const std::lock_guard lock(mutex_);
    kept_[kind].swap(analysed);
  }

 private:
  std::mutex mutex_;
  std::map<MatrixClass, std::unique_ptr<Analysed>> kept_;
};

class LentFactorisation final : public Factorisation {
 public:
  LentFactorisation(std::shared_ptr<Shelf> shelf, MatrixClass kind, std::unique_ptr<Factorisation> fresh)
      : shelf_(std::move(shelf)),
        kind_(kind),
        analysed_(std::make_unique<Analysed>(Analysed{std::move(fresh)})) {}
  ~LentFactorisation() override {
    if (is_analysed_) shelf_->put(kind_, std::move(analysed_));
  }

  std::string description() const override { return inner().description(); }
  void analyse(const SparsePattern& pattern) override {
    if (auto kept = shelf_->take(kind_, pattern)) {
      analysed_ = std::move(kept);
    } else {
      is_analysed_ = false;
      analysed_->pattern = pattern;
      inner().analyse(analysed_->pattern);
    }
    is_analysed_ = true;
  }
  FactorResult factorise(std::span<const double> values) override { return inner().factorise(values); }
  void solve(std::span<const double> rhs, std::span<double> x) override { inner().solve(rhs, x); }
  double factor_entries() const override { return inner().factor_entries(); }
  double factor_flops() const override { return inner().factor_flops(); }

 private:
  Factorisation& inner() const { return *analysed_->factorisation; }

  std::shared_ptr<Shelf> shelf_;
  MatrixClass kind_;
  std::unique_ptr<Analysed> analysed_;
  bool is_analysed_ = false;
};

}  // namespace

MakeFactorisation keep_analyses(MakeFactorisation make) {
  return [make = std::move(make), shelf = std::make_shared<Shelf>()](MatrixClass kind) {
    return std::make_unique<LentFactorisation>(shelf, kind, make(kind));
  };
}

}  // namespace netloft
