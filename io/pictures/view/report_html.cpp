// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/view/report_html.hpp"

#include "io/formats/svg/svg.hpp"
#include "io/results/diff/report_diff.hpp"
#include "io/results/figures/figure_names.hpp"
#include "io/results/figures/merged_scene.hpp"
#include "io/results/text/result_tables.hpp"
#include "io/results/text/result_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

namespace netloft::pictures {

namespace {

/// Formats five significant digits, or all digits before the point of a larger number.
std::string number(double value) {
  if (!std::isfinite(value)) return "–";
  return std::abs(value) >= 1e5 && std::abs(value) < 1e9 ? fmt::format("{:.0f}", value)
                                                         : fmt::format("{:.5g}", value);
}

std::string number(double value, const char* format) {
  return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "–";
}

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

/// A table that is written row by row. It escapes all texts, so that callers pass them unescaped.
class HtmlTable {
 public:
  explicit HtmlTable(const std::vector<std::string>& columns) : html_("<table>\n<tr>") {
    for (const auto& column : columns) html_ += "<th scope=\"col\">" + in_html(column) + "</th>";
    html_ += "</tr>\n";
  }
  HtmlTable& row() {
    html_ += html_.ends_with("</tr>\n") ? "<tr>" : "";
    return *this;
  }
  HtmlTable& text(const std::string& text) {
    constexpr std::size_t kName = 60;  // most letters of a name; longer texts may break anywhere
    html_ += (text.size() > kName ? "<td class=\"long\">" : "<td>") + in_html(text) + "</td>";
    return *this;
  }
  HtmlTable& value(const std::string& text) {
    html_ += "<td class=\"number\">" + in_html(text) + "</td>";
    return *this;
  }
  /// A load as a bar with the percentage `share`; `of` is the name of the item that bears the load.
  HtmlTable& share(double share, const std::string& of) {
    if (!std::isfinite(share)) return value("–");
    const std::string percent = number(100 * share, "{:.0f}");
    html_ +=
        "<td class=\"number\"><meter min=\"0\" max=\"100\" low=\"50\" high=\"100\" optimum=\"0\" value=\"" +
        percent + "\" aria-label=\"load on " + in_html(of) + " in per cent of its breaking load\"></meter> " +
        percent + " %</td>";
    return *this;
  }
  void end() {
    html_ += "</tr>\n";
    ++rows_;
  }
  std::string finish() const { return rows_ ? html_ + "</table>\n" : ""; }

 private:
  std::string html_;
  int rows_ = 0;
};

std::string heading(const char* text) { return "<h2>" + std::string(text) + "</h2>\n"; }
std::string paragraph(const std::string& text) { return "<p>" + in_html(text) + "</p>\n"; }
std::string folded(const std::string& title, const std::string& text) {
  return "<details><summary>" + in_html(title) + "</summary>\n<pre tabindex=\"0\">" + in_html(text) +
         "</pre></details>\n";
}

/// The gear, its source, and the conditions under which the figures hold.
std::string conditions_html(const results::Result& result) {
  HtmlTable table({"", ""});
  for (const auto& one : results::conditions_of(result)) table.row().text(one.name).text(one.value).end();
  return table.finish();
}

std::string head_html(const results::Result& result) {
  std::string html = result.is_answer() ? "" : paragraph(result.sentence);
  for (const auto& sentence : result.diagnostics) html += paragraph(sentence + ".");
  for (const auto& note : result.notes) html += paragraph("Note: " + note + ".");
  if (result.is_half()) html += paragraph(std::string("Of the gear ") + results::kOfHalf + ".");
  return html;
}

std::string figures_html(const results::Result& result) {
  HtmlTable table({"quantity", "value", "", "meaning"});
  for (const auto& s : result.scalars)
    table.row()
        .text(results::spoken(s.name))
        .value(results::measured(s, "{:.10g}"))
        .text(results::unit_text(s.unit))
        .text(s.doc)
        .end();
  for (const auto& figure : results::principal_figures(result.figures))
    table.row().text(figure.name).value(figure.value).text(figure.unit).text(figure.doc).end();
  const std::string rows = table.finish();
  if (rows.empty()) return "";
  return heading("Figures") + rows + paragraph(results::errors_text(result) + ".");
}

/// The tables of a report as HTML; the report as text has the same tables.
std::string tables_html(const std::vector<results::FigureTable>& tables) {
  std::string html;
  for (const auto& one : tables) {
    std::vector<std::string> titles = one.headings;
    titles.insert(titles.begin(), "");
    HtmlTable table(titles);
    for (const auto& row : one.rows) {
      table.row().text(row.name);
      for (const auto& cell : row.cells) table.value(cell == "-" ? "–" : cell);
      table.end();
    }
    std::string title = one.title == "bodies" ? "boards and other bodies" : one.title;
    title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
    html += heading(in_html(title).c_str()) + table.finish();
    if (!one.note.empty()) html += paragraph(one.note + ".");
  }
  return html;
}

std::string materials_table(const results::Result& result) {
  HtmlTable table({"", "part", "number", "diameter [mm]", "each [m]", "together [m]", "area [m²]",
                   "mass [kg]", "largest load [N]", "breaking load [N]", "used"});
  for (const auto& m : result.materials) {
    table.row().text(m.item.name).text(m.item.part_name).value(number(m.item.number, "{:g}"));
    for (const double value :
         {1e3 * m.item.diameter, m.item.length, m.length, m.area, m.mass, m.load, m.item.breaking_load})
      table.value(number(value, std::abs(value) < 1000 ? "{:.4g}" : "{:.0f}"));
    table.share(m.utilisation(), m.item.name).end();
  }
  const std::string rows = table.finish();
  if (rows.empty()) return "";
  return heading("Materials, and loads against breaking loads") + rows;
}

std::string convergence_html(const results::Result& result) {
  HtmlTable table({"step", "residual [N]", "largest load [N]", "factorisations", "note"});
  for (std::size_t i = 0; i < result.iterations.size(); ++i) {
    const results::Iteration& at = result.iterations[i];
    table.row()
        .text(std::to_string(i))
        .value(number(at.residual, "{:.3e}"))
        .value(number(at.load, "{:.4g}"))
        .value(std::to_string(at.factorisations))
        .text(at.note)
        .end();
  }
  const std::string rows = table.finish();
  if (rows.empty()) return "";
  return "<details><summary>Convergence of the solve</summary>\n" + paragraph(result.sentence) + rows +
         "</details>\n";
}

/// A path as written. An absolute path has a meaning only on one machine, and is reduced to the file and its
/// folder.
std::string shown_path(const std::string& path) {
  const std::filesystem::path full = path;
  return full.is_absolute() ? (full.parent_path().filename() / full.filename()).string() : path;
}

std::string origins_html(const results::Result& result) {
  const results::Origins& o = result.origins;
  std::string command;
  for (const auto& word : o.command) command += (command.empty() ? "" : " ") + word;
  HtmlTable table({"", ""});
  const std::pair<const char*, std::string> rows[] = {
      {"file", file_name(result.path)}, {"netloft", o.version},   {"command", command},
      {"started", o.started},           {"finished", o.finished}, {"machine", o.machine},
      {"compiler", o.compiler}};
  for (const auto& [name, text] : rows)
    if (!text.empty()) table.row().text(name).text(text).end();
  std::string html = heading("Where it comes from") + table.finish();
  for (const auto& file : o.files) html += folded(shown_path(file.path), file.text);
  return html + (o.plan.empty() ? "" : folded("What was evaluated, and why", o.plan));
}

/// All numbers that changed, with the names that they have in the files.
std::string numbers_html(const std::vector<results::NumberDifference>& numbers) {
  HtmlTable table({"quantity", "before", "after", "difference", "", "error", ""});
  for (const auto& d : numbers) {
    if (!d.is_changed()) continue;
    table.row().text(d.name).value(number(d.before)).value(number(d.after));
    table.value(number(d.difference(), "{:+.4g}")).value(number(d.percent(), "{:+.3g} %"));
    table.value(std::isfinite(d.error()) ? number(d.error(), "{:.1e}") : "±?");
    table.text(results::unit_text(d.unit)).end();
  }
  return table.finish();
}

}  // namespace

std::string in_html(const std::string& text) { return formats::escape_markup(text); }

std::string summary_html(const results::Result& result) {
  std::string html = conditions_html(result) + head_html(result);
  for (const auto& warning : result.warnings)
    html += "<p class=\"warning\">Warning: " + in_html(warning) + ".</p>\n";
  return html;
}

std::string materials_html(const results::Result& result) {
  const auto netting = results::netting_table(result.netting);
  return (netting.rows.empty() ? "" : tables_html({netting})) + materials_table(result);
}

std::string deck_html(const results::Result& result) {
  auto tables = results::report_tables(result);
  std::erase_if(tables, [](const results::FigureTable& table) { return !table.is_for_deck; });
  return tables_html(tables);
}

std::string details_html(const results::Result& result) {
  return figures_html(result) + tables_html(results::report_tables(result)) + convergence_html(result) +
         origins_html(result);
}

std::string diff_html(const results::ResultDiff& diff) {
  std::string html = heading("What changed");
  html += paragraph("From " + file_name(diff.before.path) + " to " + file_name(diff.after.path) + ":");
  html += "<ul>\n";
  for (const auto& change : results::input_changes(diff)) html += "<li>" + in_html(change) + "</li>\n";
  html += "</ul>\n";
  HtmlTable figures({"figure", "before", "after", "change", "", ""});
  for (const std::size_t i : diff.figures) {
    const auto change = results::figure_change(diff.numbers[i]);
    figures.row().text(change.name).value(change.before).value(change.after);
    figures.value(change.difference).value(change.percent);
    figures.text(change.exceeds ? "*" : "").end();
  }
  html += figures.finish() + paragraph(results::errors_line(diff) + ".");
  return html + "<details><summary>All numbers that changed</summary>\n" + numbers_html(diff.numbers) +
         "</details>\n";
}

}  // namespace netloft::pictures
