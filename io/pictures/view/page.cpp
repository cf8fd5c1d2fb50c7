// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/view/page.hpp"

#include "io/pictures/picture/plan_sketch.hpp"
#include "io/pictures/picture/sheet.hpp"
#include "io/pictures/view/key_figures.hpp"
#include "io/pictures/view/page_parts.hpp"
#include "io/pictures/view/plan_drawing.hpp"
#include "io/pictures/view/report_html.hpp"
#include "io/pictures/view/result_json.hpp"
#include "io/results/diff/varied_key.hpp"
#include "io/results/figures/merged_scene.hpp"

#include <algorithm>
#include <filesystem>

namespace netloft::pictures {

namespace {

std::string head(const std::string& title, const std::string& badge, const std::string& policy) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"" +
         policy + "\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         in_html(title) + "</title>\n<style>" + kPageStyle + "</style>\n</head>\n<body>\n<header><h1>" +
         in_html(title) + "</h1>\n" + badge + "<p id=\"status\" role=\"status\" hidden></p></header>\n";
}

std::string name_of_file(const results::Result& result) {
  return std::filesystem::path(result.path).filename().string();
}

// Width of pictures [pixels]. At this width, the page of any gear is smaller than 2 MB.
constexpr std::size_t kPictureWidth = 800;

/// A warning at the top of a page that the shape is not an equilibrium.
std::string unfinished_html(const results::Result& result) {
  return "<p><strong>" +
         in_html(name_of_file(result) + ": " +
                 (result.outcome.empty() ? "the run has not ended" : result.outcome)) +
         "</strong>, so that this is not the shape in equilibrium. " + in_html(result.sentence) + "</p>\n";
}

std::string picture_html(const results::StoredShape& shape, View view, const std::string& words,
                         Framing framing = Framing::netting) {
  SheetOptions options;
  options.framing = framing;
  options.view = view;
  options.width = kPictureWidth;
  options.with_dimensions = options.is_small = true;
  return "<figure>" + svg_sheet(shape, options) + "<figcaption>" + words + "</figcaption></figure>\n";
}

/// A view from above with boards and sweeps; empty for a gear without boards.
std::string rig_html(const results::StoredShape& shape) {
  const auto is_of_board = [](const auto& figure) { return figure.name.starts_with("pairs/"); };
  return std::ranges::any_of(shape.result.figures, is_of_board)
             ? picture_html(shape, View::top, "From above, with the boards", Framing::boards)
             : "";
}

/// Views from the side, from above and from the front, and the plan, for browsers without scripts and for
/// printing.
std::string pictures_html(const results::StoredShape& shape) {
  std::string html = "<section id=\"pictures\" aria-label=\"Pictures\">\n";
  for (const auto& [view, words] :
       {std::pair{View::side, "From the side"}, {View::top, "From above"}, {View::front, "From the front"}})
    html += picture_html(shape, view, words);
  const std::string drawing = plan_drawing(shape.result);
  const std::string plan = drawing.empty() ? plan_sketch(shape) : drawing;
  if (!plan.empty())
    html += "<figure class=\"plan\">" + plan.substr(plan.find("<svg")) + "<figcaption>The plan" +
            (drawing.empty() && shape.result.is_half() ? ", of the half that was modelled" : "") +
            "</figcaption></figure>\n";
  return html + "</section>\n";
}

/// The title of the gear, or else that of the scene.
std::string heading_of(const results::Result& result) {
  const auto conditions = results::conditions_of(result);
  return !conditions.empty() && conditions.front().name == "gear" ? conditions.front().value : result.title;
}

}  // namespace

std::string view_page(const std::vector<const results::StoredShape*>& shapes, std::size_t most_states) {
  std::vector<const results::Result*> results;
  for (const auto* shape : shapes) results.push_back(&shape->result);
  std::string page =
      head(results::title_of(results), results.size() == 1 ? badge_html(*results.front()) : "", kPagePolicy);
  page += "<main>\n" + key_figures_html(results);
  for (const auto* result : results)
    if (!result->is_answer()) page += unfinished_html(*result);
  page += kPageBody;
  page += pictures_html(*shapes.front());
  if (results.size() == 2) page += diff_html(results::compare_results(*results[0], *results[1]));
  for (const auto* result : results)
    page += "<section aria-label=\"Report\">\n<h2>Report: " + in_html(name_of_file(*result)) + "</h2>\n" +
            badge_html(*result) + summary_html(*result) + materials_html(*result) + details_html(*result) +
            "</section>\n";
  page += "</main>\n<script type=\"application/json\" id=\"data\">" + results_json(shapes, most_states) +
          "</script>\n<script>" + std::string(kPageLibraries) + "</script>\n<script>" +
          viewer_script(kPageStart) + "</script>\n</body>\n</html>\n";
  return page;
}

std::string viewer_script(const std::string& start) {
  return "(() => {\n'use strict';\n" + std::string(kPageClasses) + start + "})();\n";
}

std::string report_page(const results::StoredShape& shape) {
  const results::Result& result = shape.result;
  return head(heading_of(result), badge_html(result), kPageQuietPolicy) + "<main>\n<div class=\"sheet\">\n" +
         summary_html(result) + key_figures_html({&result}) +
         picture_html(shape, View::oblique, "Obliquely from ahead") + deck_html(result) +
         "</div>\n<div class=\"sheet next-page\">\n" + materials_html(result) + rig_html(shape) +
         "</div>\n<div class=\"sheet next-page\">\n" + pictures_html(shape) +
         "</div>\n<div class=\"sheet next-page\">\n<h2>Details</h2>\n" + details_html(result) +
         "</div>\n</main>\n</body>\n</html>\n";
}

}  // namespace netloft::pictures
