// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/problem/books.hpp"

namespace netloft {

/// What each operation of a solve costs, in operations of a factorisation: known before anything is solved,
/// the same on every machine and for every run. The unit in which budgets are told is one Newton iteration of
/// the scene as it is written,
///   unit = factorisation + solution + matrix + residual of that scene                       (1)
///   work = Σ count × cost / unit                                                            (2)
struct WorkModel {
  double factorisation = 1, solution = 0, matrix = 0, residual = 0;  // [floating-point operations]
  double unit = 1;                                                   // (1), of the scene as it is written

  double of_iteration() const { return factorisation + solution + matrix + residual; }
  /// (2). Factorisations that end early count in full: they did most of the work.
  double of(const Books& books) const {
    return (books.factorisations * factorisation + books.solves * solution + books.matrices * matrix +
            books.residuals * residual) /
           unit;
  }
};

}  // namespace netloft
