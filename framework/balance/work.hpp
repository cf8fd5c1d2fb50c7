// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/factorisation.hpp"
#include "framework/balance/statistics.hpp"

#include <algorithm>

namespace netloft {

class Assembler;

/// Cost of each operation of a solve, in floating-point operations of a factorisation. The cost is known
/// before the first solution, and is the same on every machine and in every run. Budgets are given in units
/// of one Newton iteration of the original scene:
///   unit = factorisation + solution + matrix + residual of that scene                       (1)
///   work = Σ count × cost / unit                                                            (2)
struct WorkModel {
  double factorisation = 1, solution = 0, matrix = 0, residual = 0;  // [floating-point operations]
  double unit = 1;  // cost of one iteration of the original scene, (1)

  double of_iteration() const { return factorisation + solution + matrix + residual; }
  /// The work of the counted operations by (2). A factorisation that ended early counts in full, because most
  /// of its work was done. Evaluating an energy costs as much as a residual, or nothing if the residual is
  /// evaluated at the same point.
  double of(const Statistics& statistics) const {
    const int evaluations = std::max(statistics.residuals, statistics.energies);
    return (statistics.factorisations * factorisation + statistics.solves * solution +
            statistics.matrices * matrix + evaluations * residual) /
           unit;
  }
};

/// The cost model of a scene. F is the number of operations of the factorisation of the tangent and N the
/// number of entries in the factor, both known from the analysis of the pattern. S = Σ elements × active
/// terms × (degrees of freedom)² measures the elements.
///   factorisation = F + a N                                                                 (3)
///   solution = a N,   residual = c S,   matrix = d S                                        (4)
/// The constants a, c and d are times, expressed in operations of a large factorisation, which performs 20
/// operations per nanosecond. A solution has 4 N operations but waits for memory. The second term of (3) is
/// the time for which a factorisation waits for memory. tests/bench/work_model.cpp prints the times of this
/// model and the measured ones: for panels and a trawl of 216 to 100 000 unknowns, they agree to a factor of
/// 1.7 for iterations and factorisations, and to a factor of 4.5 for the other operations, of which there are
/// few.
///
/// In the returned model, `unit` is (1) for this scene. If the factorisation does not report F before its
/// first use, F and N are estimated for nested dissection of a square grid of n nodes with three unknowns
/// each. With one unknown per node, Cholesky's factor has 31/4 n log₂ n entries and takes 829/84 n^(3/2)
/// multiplications, and L U twice as many (A. George, Nested dissection of a regular finite element mesh,
/// SIAM J. Numer. Anal. 10, 1973); three unknowns per node take 9 times as many entries and 27 times as many
/// multiplications. If `make` caches analyses of patterns, the solver reuses the analysis made here.
WorkModel make_work_model(const Assembler& assembler, const MakeFactorisation& make);

}  // namespace netloft
