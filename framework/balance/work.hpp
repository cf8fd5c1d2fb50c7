// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/balance/factorisation.hpp"
#include "framework/balance/statistics.hpp"

#include <algorithm>

namespace netloft {

class Assembler;

/// What each operation of a solve costs, in operations of a factorisation: known before anything is solved,
/// the same on every machine and for every run. The unit in which budgets are told is one Newton iteration of
/// the scene as it is written,
///   unit = factorisation + solution + matrix + residual of that scene                       (1)
///   work = Σ count × cost / unit                                                            (2)
struct WorkModel {
  double factorisation = 1, solution = 0, matrix = 0, residual = 0;  // [floating-point operations]
  double unit = 1;                                                   // (1), of the scene as it is written

  double of_iteration() const { return factorisation + solution + matrix + residual; }
  /// (2). Factorisations that end early count in full: they did most of the work. An energy costs what a
  /// residual does, and nothing beside one.
  double of(const Statistics& statistics) const {
    const int evaluations = std::max(statistics.residuals, statistics.energies);
    return (statistics.factorisations * factorisation + statistics.solves * solution +
            statistics.matrices * matrix + evaluations * residual) /
           unit;
  }
};

/// The model of a scene, by the factorisation of its tangent: F operations and N entries of the factor, known
/// when the pattern is analysed; and by the size of its elements, S = Σ elements × active terms × (degrees of
/// freedom)².
///   factorisation = F + (a or b) N                                                          (3)
///   solution = a N,   residual = c S,   matrix = d S                                        (4)
/// The four constants are times in operations of a large factorisation, which makes 20 of them in a
/// nanosecond: a solution has 4 N, but waits for memory, and so does b, of Cholesky's factor (CHOLMOD), where
/// a is that of LU (multifrontal). tests/bench/work_model.cpp prints both sides. On panels in still water and
/// in a current and on a trawl, of 216 to 100 000 unknowns, an iteration took 0.6 to 1.4 times the seconds
/// that the model has for it, a factorisation 0.7 to 1.6, a solution 0.3 to 4.5, a matrix 0.5 to 3.2 and a
/// residual 0.5 to 2.2 times.
///
/// `unit` is that of the scene itself (1). Where F is not known before the first factorisation, F and N are
/// those of nested dissection of a square grid of n nodes, with the unknowns of three axes each: 31/4 n log₂
/// n and 829/84 n^(3/2) for a symmetric matrix of numbers, twice as many for an unsymmetric one (A. George,
/// Nested dissection of a regular finite element mesh, SIAM J. Numer. Anal. 10, 1973). A `make` that keeps
/// analyses hands this one to the solver.
WorkModel make_work_model(const Assembler& assembler, const MakeFactorisation& make);

}  // namespace netloft
