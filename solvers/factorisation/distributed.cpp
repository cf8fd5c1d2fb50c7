// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/distributed.hpp"

#include <cassert>
#include <string>
#include <utility>

#include "solvers/factorisation/foreseen_memory.hpp"
#include "solvers/factorisation/mumps.hpp"

namespace netloft {
namespace {

class DistributedFactorisation final : public Factorisation, public ForeseesMemory {
 public:
  DistributedFactorisation(MatrixClass kind, const RankUse& use, MakeFactorisation make_local)
      : kind_(kind), use_(use), make_local_(std::move(make_local)), inner_(make_local_(kind)) {
    assert(use_.ranks != nullptr);
  }

  std::string description() const override {
    if (is_analysed_) return inner_->description();
    return inner_->description() + "; from " + std::to_string(use_.from) + " unknowns on MUMPS on " +
           std::to_string(use_.ranks->size()) + " ranks";
  }
  void analyse(const SparsePattern& pattern) override;
  FactorResult factorise(std::span<const double> values) override {
    const FactorResult result = inner_->factorise(values);
    return is_distributed_ && kind_ == MatrixClass::positive_definite ? judged(result) : result;
  }
  void solve(std::span<const double> rhs, std::span<double> x) override { inner_->solve(rhs, x); }
  double factor_entries() const override { return inner_->factor_entries(); }
  double factor_flops() const override { return inner_->factor_flops(); }
  double factor_bytes() const override { return factor_bytes_of(*inner_); }

 private:
  static FactorResult judged(const FactorResult& result);

  MatrixClass kind_;
  RankUse use_;
  MakeFactorisation make_local_;
  std::unique_ptr<Factorisation> inner_;
  bool is_distributed_ = false, is_analysed_ = false;
};

void DistributedFactorisation::analyse(const SparsePattern& pattern) {
  if (const bool wanted = pattern.size >= use_.from; wanted != is_distributed_) {
    inner_ = wanted ? make_mumps_factorisation_on(*use_.ranks, kind_) : make_local_(kind_);
    is_distributed_ = wanted;
  }
  inner_->analyse(pattern);
  is_analysed_ = true;
}

/// (1), as CHOLMOD would answer.
FactorResult DistributedFactorisation::judged(const FactorResult& result) {
  if (result.status == FactorStatus::singular) return {FactorStatus::not_positive_definite, result.column};
  if (result.negative_pivots > 0) return {FactorStatus::not_positive_definite};
  return result;
}

}  // namespace

std::unique_ptr<Factorisation> make_distributed_factorisation(MatrixClass kind, const RankUse& use,
                                                              MakeFactorisation make_local) {
  return std::make_unique<DistributedFactorisation>(kind, use, std::move(make_local));
}

}  // namespace netloft
