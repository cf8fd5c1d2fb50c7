// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/assembler/pattern.hpp"
#include "framework/balance/factorisation.hpp"
#include "framework/balance/statistics.hpp"

namespace netloft {

/// Values, in one pattern, of the matrices of (1) and (8) of growth.hpp, whose numbers are meant here.
struct LinearMotion {
  std::vector<double> K, C, M;  // [N/m], [N s/m], [kg]
  std::vector<double> convex;   // symmetric positive definite, about what K is [N/m]
  std::vector<double> K_error;  // what K changes by from here to where the equilibrium is; empty: not known
  bool is_damped = true;        // some element damps
};

/// A place next to an equilibrium, over all dofs.
struct RestPlace {
  std::span<const double> x;
  std::span<const double> x_low = {};  // what x rounds off; empty: not known
  std::span<const double> after = {};  // x after the Newton step that is left; empty: not known
  std::span<const double> after_low = {};
  double fraction = 1;  // of that step, at most as far as one place reaches
};

/// The matrices there. False: see the assembler's fault.
bool linearise(Assembler& assembler, const RestPlace& place, LinearMotion& motion);

/// That `linearise` evaluates at most: those of a motion, the linear stiffness, and K where the equilibrium
/// is.
inline constexpr int kMatricesOfMotion = 6;

/// What a matrix that is assembled from many elements may round off, of its largest entry.
inline constexpr double kRoundingOfMatrix = 1e-9;

/// By (9), whose factorisations are counted in `cost`.
bool is_stable_by_energy(const SparsePattern& pattern, const LinearMotion& motion,
                         const MakeFactorisation& make, Statistics& cost);

/// The largest |s| of (6c) with Re s/|s| of at least `fraction`, by every unknown alone [1/s]; zero: nothing
/// can grow so.
double fastest_growth(const SparsePattern& pattern, const LinearMotion& motion, double fraction);

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

}  // namespace netloft
