// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/distributed.hpp"

#include <cassert>
#include <string>
#include <utility>

#include "solvers/factorisation/foreseen_memory.hpp"
#include "solvers/factorisation/mumps.hpp"

namespace netloft {
namespace {

/// A negative pivot, which MUMPS counts, or none: as CHOLMOD would answer. (1)
class DefiniteByMumps final : public Factorisation, public ForeseesMemory {
 public:
  explicit DefiniteByMumps(Ranks& ranks)
      : mumps_(make_mumps_factorisation_on(ranks, MatrixClass::positive_definite)) {}
  std::string description() const override { return mumps_->description(); }
  void analyse(const SparsePattern& pattern) override { mumps_->analyse(pattern); }
  FactorResult factorise(std::span<const double> values) override {
    const FactorResult result = mumps_->factorise(values);
    if (result.status == FactorStatus::singular) return {FactorStatus::not_positive_definite, result.column};
    if (result.negative_pivots > 0) return {FactorStatus::not_positive_definite};
    return result;
  }
  void solve(std::span<const double> rhs, std::span<double> x) override { mumps_->solve(rhs, x); }
  double factor_entries() const override { return mumps_->factor_entries(); }
  double factor_flops() const override { return mumps_->factor_flops(); }
  double factor_bytes() const override { return factor_bytes_of(*mumps_); }

 private:
  std::unique_ptr<Factorisation> mumps_;
};

class DistributedFactorisation final : public Factorisation, public ForeseesMemory {
 public:
  DistributedFactorisation(MatrixClass kind, const RankUse& use, MakeFactorisation make_local,
                           MakeFactorisation make_on_ranks)
      : kind_(kind),
        use_(use),
        make_local_(std::move(make_local)),
        make_on_ranks_(std::move(make_on_ranks)),
        inner_(make_local_(kind)) {
    assert(use_.ranks != nullptr);
  }

  std::string description() const override {
    if (is_analysed_) return inner_->description();
    return inner_->description() + "; from " + std::to_string(use_.from) + " unknowns on " +
           std::to_string(use_.ranks->size()) + " ranks";
  }
  void analyse(const SparsePattern& pattern) override;
  FactorResult factorise(std::span<const double> values) override { return inner_->factorise(values); }
  void solve(std::span<const double> rhs, std::span<double> x) override { inner_->solve(rhs, x); }
  double factor_entries() const override { return inner_->factor_entries(); }
  double factor_flops() const override { return inner_->factor_flops(); }
  double factor_bytes() const override { return factor_bytes_of(*inner_); }

 private:
  MatrixClass kind_;
  RankUse use_;
  MakeFactorisation make_local_, make_on_ranks_;
  std::unique_ptr<Factorisation> inner_;
  bool is_distributed_ = false, is_analysed_ = false;
};

void DistributedFactorisation::analyse(const SparsePattern& pattern) {
  if (const bool wanted = pattern.size >= use_.from; wanted != is_distributed_) {
    inner_ = wanted ? make_on_ranks_(kind_) : make_local_(kind_);
    is_distributed_ = wanted;
  }
  inner_->analyse(pattern);
  is_analysed_ = true;
}

}  // namespace

std::unique_ptr<Factorisation> make_distributed_factorisation(MatrixClass kind, const RankUse& use,
                                                              MakeFactorisation make_local,
                                                              MakeFactorisation make_on_ranks) {
  return std::make_unique<DistributedFactorisation>(kind, use, std::move(make_local),
                                                    std::move(make_on_ranks));
}

MakeFactorisation make_mumps_on(Ranks& ranks) {
  return [&ranks](MatrixClass kind) -> std::unique_ptr<Factorisation> {
    if (kind == MatrixClass::positive_definite) return std::make_unique<DefiniteByMumps>(ranks);
    return make_mumps_factorisation_on(ranks, kind);
  };
}

MakeFactorisation make_fronts_on(Ranks& ranks, int threads, MakeSpare make_spare,
                                 MakeFactorisation make_local) {
  return [&ranks, threads, make_spare, make_local](MatrixClass kind) {
    if (kind == MatrixClass::symmetric) return make_local(kind);
    return kind == MatrixClass::unsymmetric
               ? make_multifrontal_factorisation(make_spare, OrderingMethod::best, threads, &ranks)
               : make_definite_multifrontal_factorisation(OrderingMethod::best, threads, &ranks);
  };
}

}  // namespace netloft
