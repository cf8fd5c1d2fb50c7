// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/view/plan_drawing.hpp"

#include <gtest/gtest.h>

namespace netloft::pictures {
namespace {

const std::string kPlan = "include = [\"codend.toml\"]\n[gear]\ntitle = \"A <b>cod-end</b>\"\n";
const std::string kCodend =
    "[panels.codend]\nmesh = \"50 mm\"\ntwine = \"pe-3mm\"\nround = 120\ndepth = 80\nopen = [\"fore\", "
    "\"aft\"]\n";
const std::string kTwines =
    "source = \"test\"\nuncertainty = \"none\"\n[twine.pe-3mm]\ndoc = \"twine\"\ndiameter = \"3 mm\"\nEA = "
    "\"10 kN\"\n"
    "mass = \"4 g/m\"\nmaterial_density = \"960 kg/m3\"\nbreaking_load = \"1 kN\"\n";

results::Result result_of(const std::string& codend, const std::string& twines) {
  results::Result result;
  result.origins.files = {{"scenes/tow.toml", "", kPlan},
                          {"scenes/codend.toml", "", codend},
                          {"/usr/share/catalogue/twines.toml", "", twines},
                          {"scenes/bars.mesh", "", "no TOML"}};
  return result;
}

std::string without(std::string text, const std::string& line) {
  return text.replace(text.find(line), line.size(), "");
}

TEST(PlanDrawing, IsMadeOfTheTextsOfAResult) {
  const std::string svg = plan_drawing(result_of(kCodend, kTwines));
  EXPECT_NE(svg.find("<svg"), std::string::npos) << svg;
  EXPECT_NE(svg.find("pe-3mm"), std::string::npos);
  EXPECT_NE(svg.find("A &lt;b&gt;cod-end"), std::string::npos) << svg.substr(0, 400);
  EXPECT_EQ(svg.find("<b>"), std::string::npos);
}

TEST(PlanDrawing, IsEmptyWithoutAPlanThatCanBeSewn) {
  EXPECT_EQ(plan_drawing({}), "");
  EXPECT_EQ(plan_drawing(result_of(kCodend, "")), "");  // no such twine
  EXPECT_EQ(plan_drawing(result_of(without(kCodend, "mesh = \"50 mm\"\n"), kTwines)), "");
  results::Result incomplete = result_of(kCodend, kTwines);
  incomplete.origins.files.erase(incomplete.origins.files.begin() + 1);
  EXPECT_EQ(plan_drawing(incomplete), "");
}

}  // namespace
}  // namespace netloft::pictures
