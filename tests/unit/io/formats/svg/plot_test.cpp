// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/svg/plot.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "io/formats/svg/svg.hpp"

namespace netloft::formats {
namespace {

LinePlot example_plot() {
  return {"a panel",
          "error [m]",
          "CPU time [s]",
          {{"one", {{1e-2, 0.1}, {1e-4, 0.2}, {1e-8, 0.4}}}, {"two", {{1e-1, 1}, {1e-3, 10}}}},
          {{0.05, "32 cells"}, {0.2, "8 cells"}}};
}

std::size_t count(const std::string& text, const std::string& piece) {
  std::size_t n = 0;
  for (auto at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1)) ++n;
  return n;
}

/// The points of the n-th line of the plot.
std::vector<std::pair<double, double>> points_of_line(const std::string& svg, int n) {
  const std::regex line("<polyline points=\"([^\"]*)\"");
  auto at = std::sregex_iterator(svg.begin(), svg.end(), line);
  std::advance(at, n);
  const std::string list = (*at)[1];
  const std::regex point("([-0-9.]+),([-0-9.]+)");
  std::vector<std::pair<double, double>> points;
  for (auto p = std::sregex_iterator(list.begin(), list.end(), point); p != std::sregex_iterator(); ++p)
    points.emplace_back(std::stod((*p)[1]), std::stod((*p)[2]));
  return points;
}

TEST(Plot, DrawsALinePerSeriesAndAMarkerPerPoint) {
  const std::string svg = draw_svg(example_plot());
  EXPECT_EQ(count(svg, "<polyline"), 2u);
  EXPECT_EQ(count(svg, "<circle"), 3u + 1u);  // three points, and one marker in the legend
  EXPECT_EQ(count(svg, "stroke-dasharray"), 2u);
}

TEST(Plot, IsTrueToScale) {
  const auto line = points_of_line(draw_svg(example_plot()), 0);
  ASSERT_EQ(line.size(), 3u);
  // x covers two decades, then four; y doubles in both steps.
  EXPECT_NEAR((line[1].first - line[2].first) / (line[0].first - line[1].first), 2, 1e-3);
  EXPECT_NEAR((line[1].second - line[2].second) / (line[0].second - line[1].second), 1, 2e-3);
  EXPECT_LT(line[2].second, line[0].second);  // y runs downwards in SVG
}

TEST(Plot, ShadesBandsBehindTheirLines) {
  LinePlot plot{"",
                "x",
                "y",
                {{"one", {{0, 1}, {1, 3}, {2, 2}}, {{0, 0, 2}, {1, 2, 4}, {2, 1, 3}}}},
                {},
                AxisScale::linear,
                AxisScale::linear};
  const std::string svg = draw_svg(plot);
  EXPECT_EQ(count(svg, "fill-opacity"), 1u);
  EXPECT_LT(svg.find("fill-opacity"), svg.find("<polyline"));
  const auto line = points_of_line(svg, 0);
  EXPECT_NEAR(line[1].first - line[0].first, line[2].first - line[1].first, 0.02);
  EXPECT_NEAR(line[0].second - line[1].second, 2 * (line[2].second - line[1].second), 0.02);
  plot.series[0].is_line = false;
  EXPECT_EQ(count(draw_svg(plot), "<polyline"), 0u);
}

TEST(Plot, PutsSeveralOnAPage) {
  const std::string page = draw_html("all", {example_plot(), example_plot(), example_plot()});
  EXPECT_EQ(count(page, "<svg"), 3u);
  EXPECT_NE(page.find("<h1>all</h1>"), std::string::npos);
}

TEST(Plot, NamesEverything) {
  const std::string svg = draw_svg(example_plot());
  for (const char* text : {"a panel", "error [m]", "CPU time [s]", ">one<", ">two<", "32 cells", "8 cells"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
}

TEST(Plot, GivesEverySeriesAColourAndAMarkerOfItsOwn) {
  LinePlot plot = example_plot();
  plot.series.clear(), plot.marks.clear();
  for (int i = 0; i < 7; ++i) plot.series.push_back({"s", {{1, 1.0 + i}, {10, 2.0 + i}}});
  const std::string svg = draw_svg(plot);
  std::vector<std::string> colours;
  const std::regex line("<polyline [^>]*stroke=\"(#[0-9a-f]+)\"");
  for (auto m = std::sregex_iterator(svg.begin(), svg.end(), line); m != std::sregex_iterator(); ++m)
    colours.push_back((*m)[1]);
  std::sort(colours.begin(), colours.end());
  EXPECT_EQ(colours.size(), 7u);
  EXPECT_EQ(std::unique(colours.begin(), colours.end()), colours.end());
}

TEST(Plot, LeavesOutWhatHasNoPlace) {
  LinePlot plot = example_plot();
  plot.series[0].points.push_back({0, 1});
  plot.series[0].points.push_back({1e-3, std::nan("")});
  plot.marks.push_back({0, "none"});
  EXPECT_EQ(draw_svg(plot), draw_svg(example_plot()));
}

TEST(Plot, HasAPictureOfNothing) {
  const std::string svg = draw_svg({});
  EXPECT_EQ(count(svg, "<svg"), 1u);
  EXPECT_EQ(count(svg, "nan"), 0u);
  EXPECT_EQ(count(svg, "inf"), 0u);
}

TEST(Plot, KeepsMarkupOfNamesHarmless) {
  LinePlot plot = example_plot();
  plot.title = "a < b & \"c\"\x01";
  for (const std::string& text : {draw_svg(plot), draw_html(plot)}) {
    EXPECT_NE(text.find("a &lt; b &amp; &quot;c&quot; "), std::string::npos);
    EXPECT_EQ(text.find('\x01'), std::string::npos);
  }
}

TEST(Plot, MakesAPageThatNeedsNoOtherFile) {
  const std::string page = draw_html(example_plot());
  EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
  EXPECT_EQ(count(page, "<svg"), 1u);
  for (const char* link : {"src=", "href=", "@import", "url("}) EXPECT_EQ(count(page, link), 0u) << link;
}

TEST(Plot, WritesTicksOfOneAxisInOneManner) {
  LinePlot plot;
  plot.series = {{"s", {{1e-6, 0.03}, {1, 0.4}}}};  // many decades of x, little more than one of y
  const std::string svg = draw_svg(plot);
  for (const char* label : {">0.05<", ">0.1<", ">0.2<", ">\u22124<"})
    EXPECT_NE(svg.find(label), std::string::npos) << label;
  EXPECT_EQ(svg.find(">\u22121<"), std::string::npos);
}

TEST(Plot, ExplainsHollowMarkersWhereThereAreSome) {
  LinePlot plot;
  plot.hollow = "half of them";
  plot.series = {{"s", {{1, 1}, {2, 2}}}};
  EXPECT_EQ(count(draw_svg(plot), "half of them"), 0u);
  const std::size_t white = count(draw_svg(plot), "fill=\"#ffffff\"");
  plot.series.front().points.back().is_hollow = true;
  EXPECT_EQ(count(draw_svg(plot), "half of them"), 1u);
  EXPECT_EQ(count(draw_svg(plot), "fill=\"#ffffff\""), white + 2);  // this marker, and the one in the legend
}

TEST(SvgPicture, GivesZeroNoSign) {
  SvgPicture picture;
  picture.number({0, 0}, -0.0, false, 10, Anchor::end);
  EXPECT_NE(picture.finish(10, 10).find(">0</text>"), std::string::npos);
}

TEST(SvgPicture, WritesPowersOfTenAsSuch) {
  SvgPicture picture;
  picture.number({0, 0}, 1e-3, true, 10, Anchor::end);
  picture.number({0, 0}, 0.2, false, 10, Anchor::end);
  const std::string svg = picture.finish(10, 10);
  EXPECT_NE(svg.find(">\u22123</tspan>"), std::string::npos) << svg;
  EXPECT_NE(svg.find(">0.2</text>"), std::string::npos) << svg;
}

}  // namespace
}  // namespace netloft::formats
