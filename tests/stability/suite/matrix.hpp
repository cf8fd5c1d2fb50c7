// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tests/stability/suite/run.hpp"

namespace netloft::hard_cases {

/// The counts of one column, a solver or strategy, over all cases or over those of one kind.
struct Tally {
  std::string solver;
  std::size_t cases = 0;
  std::size_t right = 0, claimed_wrong = 0;  // as defined in judge.hpp
  std::size_t unconfirmed = 0;               // right, but no other solver has found a stable equilibrium
  std::size_t factorisations = 0;
  double cpu_seconds = 0;
};
std::vector<Tally> tally(const std::vector<Row>& rows);

/// The tallies of one kind of case, which is one file of the suite, in the order of the rows.
struct KindTally {
  std::string kind;
  std::vector<Tally> columns;
};
std::vector<KindTally> tally_by_kind(const std::vector<Row>& rows);

/// The title of a matrix of cases and solvers: the folder of the suite, and the seed of its random cases.
struct MatrixTitle {
  std::string folder;
  std::uint64_t seed = 1;
};
std::string row_text(const Row& row);
std::string matrix_text(const MatrixTitle& title, const std::vector<Row>& rows);
std::string matrix_json(const MatrixTitle& title, const std::vector<Row>& rows);
std::string matrix_html(const MatrixTitle& title, const std::vector<Row>& rows);

}  // namespace netloft::hard_cases
