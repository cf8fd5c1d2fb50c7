// SPDX-License-Identifier: BSD-3-Clause
#include "tests/stability/suite/matrix.hpp"

#include <fmt/format.h>

namespace netloft::hard_cases {

namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --page: #fff; --ink: #1b1f24; --faint: #66707c; --line: #d5dae0;
  --right: #d3efd8; --honest: #dbe7fb; --off: #fdecc8; --failed: #f6d5d0; --claimed-wrong: #c62828; --claimed-wrong-ink: #fff; }
@media (prefers-color-scheme: dark) { :root { --page: #14181d; --ink: #e4e8ec; --faint: #98a2ad; --line: #333b44;
  --right: #1d4a2a; --honest: #1f3a63; --off: #5a4512; --failed: #5c2620; --claimed-wrong: #ff5c4d; --claimed-wrong-ink: #14181d; } }
body { background: var(--page); color: var(--ink); font: 15px/1.45 system-ui, sans-serif; margin: 2rem; }
h1 { font-size: 1.4rem; } h2 { font-size: 1.1rem; margin-top: 2rem; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; } th, td { border: 1px solid var(--line); padding: .25rem .6rem; text-align: left; }
th { font-weight: 600; } td.number { text-align: right; } th, td { white-space: nowrap; } small { color: var(--faint); } td small { color: inherit; opacity: .75; }
.right { background: var(--right); } .honest { background: var(--honest); } .off { background: var(--off); }
.unfit { color: var(--faint); } .failed { background: var(--failed); } .claimed-wrong { background: var(--claimed-wrong); color: var(--claimed-wrong-ink); font-weight: 600; }
)";

const char* colour_of(Where where) {
  if (is_claimed_wrong(where)) return "claimed-wrong";
  if (where == Where::unfit) return "unfit";
  if (is_honest(where)) return "honest";
  if (is_answer(where)) return "right";
  const bool is_off = where == Where::near || where == Where::higher || where == Where::unstable ||
                      where == Where::unproven || where == Where::late;
  return is_off ? "off" : "failed";
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

std::string cell_html(const Cell& c) {
  return fmt::format("<td class=\"{}\" title=\"{}\">{}<br><small>{} / {} / {:.2g} s</small></td>",
                     colour_of(c.verdict.where), escaped(c.reason), name_of(c.verdict.where), c.iterations,
                     c.factorisations, c.cpu_seconds);
}

std::string row_html(const Row& row) {
  std::size_t unknowns = 0;
  for (const auto& cell : row.cells) unknowns = std::max(unknowns, cell.unknowns);
  std::string html = fmt::format(
      "<tr><th scope=\"row\" title=\"{}\">{}{}</th><td>{}</td><td class=\"number\">{}</td>",
      escaped(row.about->about), escaped(row.about->name),
      row.about->is_random ? " <small>random</small>" : "", name_of(row.about->expected), unknowns);
  for (const auto& cell : row.cells) html += cell_html(cell);
  return html + fmt::format("<td class=\"number\">{}</td></tr>\n", row.shapes);
}

std::string table_html(const std::string& size, const std::vector<Row>& rows) {
  std::string html, head;
  for (const auto& row : rows) {
    if (row.size != size) continue;
    if (head.empty())
      for (const auto& cell : row.cells) head += "<th scope=\"col\">" + escaped(cell.solver) + "</th>";
    html += row_html(row);
  }
  if (html.empty()) return "";
  return "<h2>" + size +
         "</h2>\n<div class=\"wide\"><table>\n<tr><th>case</th><th>expected</th><th>unknowns</th>" + head +
         "<th title=\"found by the solvers of this row\">stable shapes</th></tr>\n" + html +
         "</table></div>\n";
}

std::string tally_html(const std::vector<Row>& rows) {
  std::string html =
      "<div class=\"wide\"><table>\n<tr><th>solver</th><th>cases</th><th>right</th>"
      "<th>claimed wrong</th><th>right, found by no other solver</th><th>factorisations</th>"
      "<th>CPU seconds</th></tr>\n";
  for (const auto& t : tally(rows))
    html += fmt::format(
        "<tr><th scope=\"row\">{}</th><td class=\"number\">{}</td><td class=\"number\">{}</td>"
        "<td class=\"number\">{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td>"
        "<td class=\"number\">{:.1f}</td></tr>\n",
        escaped(t.solver), t.cases, t.right, t.claimed_wrong, t.unconfirmed, t.factorisations, t.cpu_seconds);
  return html + "</table></div>\n";
}

std::string kind_cell_html(const Tally& t) {
  return fmt::format("<td class=\"{}\">{} of {}{}</td>",
                     t.claimed_wrong      ? "claimed-wrong"
                     : t.right == t.cases ? "right"
                                          : "off",
                     t.right, t.cases,
                     t.claimed_wrong ? fmt::format(", {} claimed wrong", t.claimed_wrong) : "");
}

std::string kinds_html(const std::vector<Row>& rows) {
  const auto kinds = tally_by_kind(rows);
  if (kinds.empty()) return "";
  std::string html = "<h2>right, by kind</h2>\n<div class=\"wide\"><table>\n<tr><th>kind</th>";
  for (const auto& t : kinds[0].columns) html += "<th scope=\"col\">" + escaped(t.solver) + "</th>";
  for (const auto& kind : kinds) {
    html += "</tr>\n<tr><th scope=\"row\">" + escaped(kind.kind) + "</th>";
    for (const auto& t : kind.columns) html += kind_cell_html(t);
  }
  return html + "</tr>\n</table></div>\n";
}

constexpr const char* kLegend =
    "<p>Each cell: where the solver ended, then iterations / factorisations / CPU seconds; the reason it "
    "gave "
    "stands behind the cell. <span class=\"right\">reference, lower, another</span>: at the best answer "
    "known, "
    "at one of less energy, at a stable one elsewhere. <span class=\"honest\">honest, flutters, "
    "unsettled</span>: there is no equilibrium; or the gear swings about one, or moves on without end, and "
    "no "
    "solver of this run found one where it rests; and the solver says so. <span class=\"off\">near, higher, "
    "unstable, unproven, late</span>: at the only answer, but not within 1e-8 of the size; at a stable shape "
    "of "
    "more energy; at an unstable one, saying so; in balance, but whether it is stable could not be found "
    "out; "
    "there is no equilibrium, but only the end of its budget ended it. <span class=\"failed\">failed</span>: "
    "says that it has not converged. <span class=\"claimed-wrong\">wrong, lied</span>: claims success at "
    "another than the only answer or at an unstable one; where there is none. unfit: the solver needs an "
    "energy, "
    "which drag, friction and pressure do not have.</p>\n";

}  // namespace

std::string matrix_html(const MatrixTitle& title, const std::vector<Row>& rows) {
  std::string html =
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width\"><title>Netloft: stability</title><style>";
  html += kStyle;
  html +=
      fmt::format("</style></head><body>\n<h1>Stability of solvers on hard cases</h1>\n<p>{}, seed {}</p>\n",
                  escaped(title.folder), title.seed);
  html += tally_html(rows) + kinds_html(rows) + kLegend;
  for (const auto& size : kSizes) html += table_html(size, rows);
  return html + "</body></html>\n";
}

}  // namespace netloft::hard_cases
