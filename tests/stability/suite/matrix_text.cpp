// SPDX-License-Identifier: BSD-3-Clause
#include "tests/stability/suite/matrix.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace netloft::hard_cases {

namespace {

constexpr std::size_t kCellWidth = 27;

std::string cell_text(const Cell& cell) {
  if (cell.verdict.where == Where::unfit) return "-";
  const std::string mark = is_right(cell.verdict.where)           ? ""
                           : is_claimed_wrong(cell.verdict.where) ? "!! "
                                                                  : "! ";
  return fmt::format("{}{} {}/{}/{:.2g}", mark, name_of(cell.verdict.where), cell.iterations,
                     cell.factorisations, cell.cpu_seconds);
}

std::string label(const Row& row) {
  return row.about->name + (row.about->is_random ? " *" : "") +
         (row.about->expected == Expected::none ? " (none)" : "");
}

std::string header(const Row& row, std::size_t width) {
  std::string line = fmt::format("{:<{}} {:>8}", row.size, width, "unknowns");
  for (const auto& cell : row.cells) line += fmt::format("  {:<{}}", cell.solver, kCellWidth);
  return line + "\n";
}

std::string kind_of(const Row& row) { return row.about->name.substr(0, row.about->name.find('/')); }

void count(const Cell& cell, Tally& t) {
  const Where where = cell.verdict.where;
  if (where == Where::unfit) return;
  ++t.cases;
  t.right += is_right(where), t.claimed_wrong += is_claimed_wrong(where);
  t.unconfirmed += !cell.confirmed;
  t.factorisations += static_cast<std::size_t>(cell.factorisations);
  t.cpu_seconds += cell.cpu_seconds;
}

void count(const Row& row, std::vector<Tally>& columns) {
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    if (columns.size() <= i) columns.push_back({.solver = row.cells[i].solver});
    count(row.cells[i], columns[i]);
  }
}

std::string tally_text(const std::vector<Row>& rows) {
  std::string text;
  for (const auto& t : tally(rows))
    text += fmt::format("{:<24} right {} of {}{}, claimed wrong {}, {} factorisations, {:.1f} s CPU\n",
                        t.solver, t.right, t.cases,
                        t.unconfirmed ? fmt::format(" ({} that no other solver found)", t.unconfirmed) : "",
                        t.claimed_wrong, t.factorisations, t.cpu_seconds);
  return text;
}

/// Counts of right answers and wrong claims of each kind: "9/10", "9/10 !!1".
std::string kinds_text(const std::vector<Row>& rows) {
  const auto kinds = tally_by_kind(rows);
  if (kinds.size() < 2) return "";
  std::string text = fmt::format("\n{:<24}", "right, !! claimed wrong");
  for (const auto& t : kinds[0].columns) text += fmt::format("  {:<{}}", t.solver, kCellWidth);
  for (const auto& kind : kinds) {
    text += fmt::format("\n{:<24}", kind.kind);
    for (const auto& t : kind.columns)
      text += fmt::format("  {:<{}}",
                          fmt::format("{}/{}", t.right, t.cases) +
                              (t.claimed_wrong ? fmt::format(" !!{}", t.claimed_wrong) : ""),
                          kCellWidth);
  }
  return text + "\n";
}

}  // namespace

std::vector<Tally> tally(const std::vector<Row>& rows) {
  std::vector<Tally> all;
  for (const auto& row : rows) count(row, all);
  return all;
}

std::vector<KindTally> tally_by_kind(const std::vector<Row>& rows) {
  std::vector<KindTally> all;
  for (const auto& row : rows) {
    const std::string kind = kind_of(row);
    auto at = std::find_if(all.begin(), all.end(), [&](const auto& k) { return k.kind == kind; });
    if (at == all.end()) at = all.insert(at, {kind, {}});
    count(row, at->columns);
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
  std::string text = fmt::format("{}, seed {}; * random; where / iterations / factorisations / CPU seconds\n",
                                 title.folder, title.seed);
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
  return text + kinds_text(rows) + "\n" + tally_text(rows);
}

}  // namespace netloft::hard_cases
