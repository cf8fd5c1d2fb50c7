// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/view/key_figures.hpp"

#include "io/pictures/view/report_html.hpp"
#include "io/results/figures/figure_names.hpp"
#include "io/results/figures/key_figures.hpp"
#include "io/results/text/measured.hpp"
#include "io/results/text/result_text.hpp"

#include <cmath>

namespace netloft::pictures {

namespace {

std::string name_of(const results::NamedScalar& figure) {
  const std::string name = results::principal_name(figure.name);
  return name.empty() ? results::spoken(figure.name) : name;
}

std::string box_html(const results::NamedScalar& figure, const results::NamedScalar* after) {
  std::string text = card_text(figure);
  if (after) text += " → " + card_text(*after);
  return "<div><dt>" + in_html(name_of(figure)) + "</dt><dd title=\"" + in_html(figure.doc) +
         "\"><span data-figure=\"" + in_html(figure.name) + "\">" + in_html(text) + "</span></dd></div>\n";
}

}  // namespace

std::string card_text(const results::NamedScalar& figure) {
  const bool in_kilo = figure.unit == "N" && std::abs(figure.value) >= 1000;
  const double factor = in_kilo ? 1e-3 : 1;
  const std::string unit = in_kilo ? "kN" : results::unit_text(figure.unit);
  return results::measured(factor * figure.value, factor * results::total_error(figure), "{:.3g}") +
         (unit.empty() ? "" : " " + unit);
}

std::string badge_html(const results::Result& result) {
  return std::string("<span class=\"badge") + (result.is_answer() ? " answer" : "") + "\">" +
         in_html(results::ending_text(result)) + "</span>\n";
}

std::string key_figures_html(const std::vector<const results::Result*>& results) {
  std::string html;
  for (const auto* key : results::key_figures(*results.front())) {
    const auto* after = results.size() == 2 ? results[1] : nullptr;
    const results::NamedScalar* same = after ? results::find_scalar(after->figures, key->name) : nullptr;
    if (after && !same) same = results::find_scalar(after->scalars, key->name);
    html += box_html(*key, same);
  }
  if (html.empty()) return html;
  return "<dl id=\"keys\">\n" + html + "</dl>\n<p class=\"errors\">" +
         in_html(results::short_errors_text(*results.front())) + ".</p>\n";
}

}  // namespace netloft::pictures
