// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/stability/run.hpp"

namespace netloft::io {

/// How one solver did on all rows.
struct Tally {
  std::string solver;
  std::size_t cases = 0, right = 0, lies = 0;  // right: arrived, or honest where there is nothing to find
  double cpu_seconds = 0;
};
std::vector<Tally> tally(const std::vector<Row>& rows);

/// The matrix of cases and solvers: for a terminal, for a program, and as a page of its own.
struct MatrixTitle {
  std::string folder;
  std::uint64_t draw = 1;
};
std::string row_text(const Row& row);
std::string matrix_text(const MatrixTitle& title, const std::vector<Row>& rows);
std::string matrix_json(const MatrixTitle& title, const std::vector<Row>& rows);
std::string matrix_html(const MatrixTitle& title, const std::vector<Row>& rows);

}  // namespace netloft::io
