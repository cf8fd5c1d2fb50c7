// SPDX-License-Identifier: BSD-3-Clause
#include "io/stability/matrix.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace netloft::io {

namespace {

constexpr std::size_t kCellWidth = 27;

std::string cell_text(const Cell& cell) {
  if (cell.verdict.where == Where::unfit) return "-";
  const std::string mark = is_right(cell.verdict.where) ? "" : is_lie(cell.verdict.where) ? "!! " : "! ";
  return fmt::format("{}{} {}/{}/{:.2g}", mark, name_of(cell.verdict.where), cell.iterations,
                     cell.factorisations, cell.cpu_seconds);
}

std::string label(const Row& row) {
  return row.about->name + (row.about->drawn ? " *" : "") +
         (row.about->expected == Expected::none ? " (none)" : "");
}

std::string header(const Row& row, std::size_t width) {
  std::string line = fmt::format("{:<{}} {:>8}", row.size, width, "unknowns");
  for (const auto& cell : row.cells) line += fmt::format("  {:<{}}", cell.solver, kCellWidth);
  return line + "\n";
}

}  // namespace

std::vector<Tally> tally(const std::vector<Row>& rows) {
  std::vector<Tally> all;
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      if (all.size() <= i) all.push_back({row.cells[i].solver, 0, 0, 0, 0});
      if (row.cells[i].verdict.where == Where::unfit) continue;
      ++all[i].cases;
      all[i].right += is_right(row.cells[i].verdict.where);
      all[i].lies += is_lie(row.cells[i].verdict.where);
      all[i].cpu_seconds += row.cells[i].cpu_seconds;
    }
  return all;
}

std::string row_text(const Row& row) {
  std::string line = row.size + " " + label(row) + ":";
  for (const auto& cell : row.cells) {
    line += "  " + cell.solver + " " + cell_text(cell);
    if (cell.verdict.where == Where::not_run) line += " (" + cell.reason + ")";
  }
  return line;
}

std::string matrix_text(const MatrixTitle& title, const std::vector<Row>& rows) {
  std::string text = fmt::format("{}, draw {}; * drawn; where / iterations / factorisations / CPU seconds\n",
                                 title.folder, title.draw);
  std::size_t width = 6;
  for (const auto& row : rows) width = std::max(width, label(row).size());
  std::string size;
  for (const auto& row : rows) {
    if (row.size != size) text += "\n" + header(row, width), size = row.size;
    std::size_t unknowns = 0;
    for (const auto& cell : row.cells) unknowns = std::max(unknowns, cell.unknowns);
    text += fmt::format("{:<{}} {:>8}", label(row), width, unknowns);
    for (const auto& cell : row.cells) text += fmt::format("  {:<{}}", cell_text(cell), kCellWidth);
    if (row.shapes > 1) text += fmt::format("  {} stable shapes", row.shapes);
    text += "\n";
  }
  text += "\n";
  for (const auto& t : tally(rows))
    text += fmt::format("{:<24} right {} of {}, success claimed where there was none {}, {:.1f} s CPU\n",
                        t.solver, t.right, t.cases, t.lies, t.cpu_seconds);
  return text;
}

}  // namespace netloft::io
