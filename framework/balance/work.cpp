// SPDX-License-Identifier: BSD-3-Clause
#include "framework/balance/work.hpp"

#include "framework/assembler/assembler.hpp"

#include <cmath>

namespace netloft {

namespace {

// The constants a, c and d of (3) and (4) in work.hpp, measured with tests/bench/work_model.cpp.
constexpr double kPerEntry = 20, kPerResidual = 4, kPerMatrix = 12;

struct FactorSize {
  double flops = 0, entries = 0;
};

FactorSize estimate_factor(const SparsePattern& pattern) {
  const double nodes = std::max(2.0, pattern.size / 3.0);
  return {2 * 27 * 2 * 829.0 / 84 * std::pow(nodes, 1.5), 2 * 9 * 31.0 / 4 * nodes * std::log2(nodes)};
}

FactorSize analyse_factor(const SparsePattern& pattern, const MakeFactorisation& make) {
  const auto factorisation =
      make(pattern.symmetric ? MatrixClass::positive_definite : MatrixClass::unsymmetric);
  factorisation->analyse(pattern);
  const FactorSize size{factorisation->factor_flops(), factorisation->factor_entries()};
  return size.flops > 0 ? size : estimate_factor(pattern);
}

/// The measure S of the elements in (4) of work.hpp, Σ elements × terms × (degrees of freedom)².
double size_of_elements(const Assembler& assembler) {
  double sum = 0;
  for (const auto& family : assembler.families()) {
    const double dofs = family->type().dofs();
    sum += static_cast<double>(family->size() * family->active_terms().size()) * dofs * dofs;
  }
  return sum;
}

}  // namespace

WorkModel make_work_model(const Assembler& assembler, const MakeFactorisation& make) {
  if (assembler.pattern().size == 0) return {};
  const FactorSize factor = analyse_factor(assembler.pattern(), make);
  const double elements = size_of_elements(assembler);
  WorkModel model;
  model.factorisation = factor.flops + kPerEntry * factor.entries;  // (3)
  model.solution = kPerEntry * factor.entries;                      // (4)
  model.residual = kPerResidual * elements;
  model.matrix = kPerMatrix * elements;
  model.unit = model.of_iteration();
  return model;
}

}  // namespace netloft
