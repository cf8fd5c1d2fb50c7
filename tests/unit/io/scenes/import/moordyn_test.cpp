// SPDX-License-Identifier: BSD-3-Clause
//
// Moorings of MoorDyn in both versions of its input file.
#include "io/scenes/import/moordyn.hpp"
#include "tests/unit/io/scenes/import/samples.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace netloft::scenes {
namespace {

using femnet::changed;

const std::string kMooring = R"(--------------------- MoorDyn Input File ------------------------------------
a mooring with a float on the way
---------------------- LINE TYPES -----------------------------------
TypeName   Diam    Mass/m     EA     BA/-zeta    EI         Cd     Ca     CdAx    CaAx
(name)     (m)     (kg/m)     (N)    (N-s/-)     (N-m^2)    (-)    (-)    (-)     (-)
chain      0.1     150        1e8    -1          0          2.3    1      1.0     0.5
---------------------- BODIES ---------------------------------------
ID   Attachment  X0  Y0  Z0  r0 p0 y0  Mass CG* I* Volume CdA* Ca*
(#)  (-) (m) (m) (m) (deg) (deg) (deg) (kg) (m) (kg-m^2) (m^3) (m^2) (-)
1    Coupled     10  0   -5  0  0  0   1e3  0   1  1      0    0
---------------------- POINTS ---------------------------------------
ID   Attachment  X       Y     Z      Mass   Volume  CdA    Ca
(#)   (word/ID) (m)     (m)   (m)    (kg)   (m^3)   (m^2)  (-)
1     Fixed     -300     0     -100   0      0       0      0
2     Free      -100     0     -60    200    3       1.5    0
3     Body1      -2      0     1      0      0       0      0
4     Coupled    50      0     -4     0      0       0      0
---------------------- LINES ----------------------------------------
ID   LineType   AttachA  AttachB  UnstrLen  NumSegs  LineOutputs
(#)   (name)     (ID)     (ID)      (m)       (-)      (-)
1     chain      1        2        250        20       p   ! the lower one
2     chain      2        3        130        10       -
3     chain      2        4        170        4        -
---------------------- OPTIONS -----------------------------------------
0.002     dtM       time step
2e6       kbot      bottom stiffness (Pa/m)
100       WtrDpth   depth
1000      WtrDnsty  density
9.8       g
---------------------- OUTPUTS -----------------------------------------
FAIRTEN1
END
------------------------- need this line -------------------------------------
)";

const std::string kOldMooring = R"(MoorDyn v1 sample input file
----------------------- LINE DICTIONARY ------------------------------------------
LineType  Diam      MassDen   EA        BA/-zeta   Can   Cat   Cdn    Cdt
(-)       (m)       (kg/m)    (N)       (Pa-s/-)   (-)   (-)   (-)    (-)
nylon     0.124     13.76     2515288.0  -0.8      1.0   0.0   1.6    0.05
----------------------- NODE PROPERTIES ------------------------------------------
Node      Type      X        Y         Z        M        V        FX       FY      FZ     CdA   CA
(-)       (-)      (m)      (m)       (m)      (kg)     (m^3)    (N)      (N)     (N)   (m^2)  (-)
1         Vessel     0.0     0      -10.00       0        0        0        0       0       0     0
2         Fixed    267.0     0      -70.00       0        0        0        0       0       0     0
3         Connect  100.0     0      -30.00       7        0        0        5       0       0     0
-------------------------- LINE PROPERTIES -----------------------------------------
Line     LineType  UnstrLen  NumSegs   NodeAnch  NodeFair  Flags/Outputs
(-)      (-)       (m)         (-)       (-)       (-)      (-)
1        nylon     180.0        5         2         3        p
2        nylon     110.0        5         3         1        p
-------------------------- SOLVER OPTIONS-------------------------------------------
0.001    dtM          - time step
)";

struct ReadMooring {
  explicit ReadMooring(const std::string& text)
      : mooring(read_moordyn(text, diagnostics.add_source("lines.txt", text), diagnostics)) {}
  std::string said() const { return diagnostics.render(false); }
  formats::Diagnostics diagnostics;
  MooringFile mooring;
};

TEST(MoorDyn, IsReadAsPointsAndLines) {
  const ReadMooring read(kMooring);
  ASSERT_EQ(read.diagnostics.errors(), 0) << read.said();
  const BarTable& table = read.mooring.table;
  EXPECT_EQ(table.nodes.size(), 4u + 19 + 9 + 3);
  EXPECT_EQ(table.nodes[0].hold, "xyz");
  EXPECT_EQ(table.nodes[1].hold, "");
  EXPECT_EQ(table.nodes[1].mass, 200);
  EXPECT_EQ(table.nodes[1].volume, 3);
  EXPECT_EQ(table.nodes[1].drag_area, 1.5);
  EXPECT_EQ(table.nodes[2].at, (std::array<double, 3>{8, 0, -4}));  // at the position on the body
  ASSERT_EQ(table.ropes.size(), 3u);
  const TableRope& line = table.ropes[0];
  EXPECT_EQ(line.bars.size(), 20u);
  EXPECT_DOUBLE_EQ(line.bars[3].length, 12.5);
  EXPECT_DOUBLE_EQ(line.density, 150 / (std::numbers::pi * 0.01 / 4));
  EXPECT_DOUBLE_EQ(*line.tangential, std::numbers::pi);
  EXPECT_DOUBLE_EQ(line.bed, 2e6 * 0.1);
  EXPECT_EQ(table.depth, 100);
  EXPECT_EQ(table.density, 1000);
  EXPECT_EQ(table.gravity, 9.8);
  for (const auto& n : table.nodes) EXPECT_GE(n.at[2], -100);
  ASSERT_EQ(read.mooring.findings.size(), 3u);  // further findings: the time step, and a tension at a free
                                                // point
  EXPECT_NE(read.mooring.findings[0].text.find("point-4 is held"), std::string::npos);
  EXPECT_FALSE(read.mooring.findings[0].is_left_out);
}

TEST(MoorDyn, IsReadInItsFirstVersion) {
  const ReadMooring read(kOldMooring);
  ASSERT_EQ(read.diagnostics.errors(), 0) << read.said();
  const BarTable& table = read.mooring.table;
  ASSERT_EQ(table.ropes.size(), 2u);
  EXPECT_EQ(table.ropes[0].normal, 1.6);
  EXPECT_DOUBLE_EQ(*table.ropes[0].tangential, 0.05 * std::numbers::pi);
  EXPECT_EQ(table.ropes[0].EI, 0);
  EXPECT_EQ(table.ropes[0].bars.front().nodes[0], 1u);
  EXPECT_DOUBLE_EQ(table.ropes[0].bars[0].length, 36);
  EXPECT_EQ(table.ropes[0].bed, 0);  // there is no bed without a depth
  EXPECT_EQ(table.nodes[2].mass, 7);
  EXPECT_EQ(table.nodes[2].force[1], 5);
}

TEST(MoorDyn, BecomesPartsOnABed) {
  const auto made = scene_of(ReadMooring(kMooring).mooring.table, {}, "gear.mesh");
  const auto holds = [&](const std::string& words) { return made.scene.find(words) != std::string::npos; };
  EXPECT_TRUE(
      holds("on = [\"line-1\", \"line-2\", \"line-3\"]\nseabed = { depth = 100, stiffness = 2e+05, softness "
            "= 0 }"))
      << made.scene;
  EXPECT_TRUE(holds("float = { mass = 200, volume = 3, area = 1.5, drag_coefficient = 1 }"));
  EXPECT_TRUE(holds("density = 1000\ngravity = 9.8\n"));
}

TEST(MoorDyn, SaysWhatItLeavesOut) {
  const ReadMooring read(changed(
      changed(kMooring, "9.8       g\n", "1  Currents\nbed.txt SeafloorFile\n"),
      "---------------------- POINTS",
      "---- RODS ----\nID RodType\n(#) (name)\n1 Can Body1 0 0 2 0 0 15 8 p\n---------------------- POINTS"));
  ASSERT_EQ(read.diagnostics.errors(), 0) << read.said();
  int left_out = 0;
  for (const auto& f : read.mooring.findings) left_out += f.is_left_out;
  EXPECT_EQ(left_out, 5);  // including the time step and the tension at a free point
}

/// The left-out features, as "line: text".
std::vector<std::string> left_out_of(const std::string& text) {
  const ReadMooring read(text);
  EXPECT_EQ(read.diagnostics.errors(), 0) << read.said();
  std::vector<std::string> texts;
  for (const auto& f : read.mooring.findings)
    if (f.is_left_out) texts.push_back(std::to_string(f.place.line) + ": " + f.text);
  return texts;
}

TEST(MoorDyn, ListsEveryOptionThatIsNotUsedWithItsLineAndItsMeaning) {
  const auto texts =
      left_out_of(changed(kMooring, "9.8       g\n", "9.8 g\n0.7 FrictionCoefficient\n0 WaveKin\n5 Kbto\n"));
  ASSERT_EQ(texts.size(), 4u);
  EXPECT_EQ(texts[0], "25: the option dtM = 0.002: it controls how MoorDyn computes");
  EXPECT_TRUE(texts[1].starts_with("30: the option FrictionCoefficient = 0.7: friction of the bed"))
      << texts[1];
  EXPECT_EQ(texts[2], "32: the option Kbto = 5: it is not known here, and may be misspelt");
}

TEST(MoorDyn, LeavesOutTheLiftByVorticesOfALineType) {
  EXPECT_EQ(left_out_of(changed(kMooring, "1.0     0.5\n", "1.0     0.5   0.8 0.08 0.18\n")).front(),
            "6: line type \"chain\": lift by vortices, Cl = 0.8");
  EXPECT_EQ(left_out_of(changed(kMooring, "1.0     0.5\n", "1.0     0.5   0\n")).size(),
            left_out_of(kMooring).size());
}

TEST(MoorDyn, SkipsTheNumbersOfRowsOfItsFirstVersion) {
  std::string text = changed(kOldMooring, "LineType  Diam", "1 NTypes - number of LineTypes\nLineType  Diam");
  text = changed(text, "Node      Type", "3        NConnects - number of connections\nNode      Type");
  text = changed(text, "Line     LineType", "2    NLines\nLine     LineType");
  const BarTable counted = ReadMooring(text).mooring.table, plain = ReadMooring(kOldMooring).mooring.table;
  EXPECT_EQ(left_out_of(text).size(), 1u);
  EXPECT_EQ(counted.nodes.size(), plain.nodes.size());
  ASSERT_EQ(counted.ropes.size(), 2u);
  EXPECT_EQ(counted.ropes[1].bars[0].length, plain.ropes[1].bars[0].length);
}

TEST(MoorDyn, HasTensionsAtHeldEndsAsResults) {
  const ReadMooring read(changed(kMooring, "FAIRTEN1\n", "\"FairTen2\"\nLINE1TENA FAIRTEN1\nPOINT2PX\n"));
  const auto& results = read.mooring.table.results;
  ASSERT_EQ(results.size(), 3u);
  EXPECT_EQ(results[0].name, "AnchTen1");
  EXPECT_EQ(results[0].of, "line-1.start");
  EXPECT_EQ(results[1].name, "FairTen2");
  EXPECT_EQ(results[2].of, "line-3.end");
  const auto texts =
      left_out_of(changed(kMooring, "FAIRTEN1\n", "\"FairTen2\" LINE1TENA FAIRTEN1\nPOINT2PX\n"));
  ASSERT_EQ(texts.size(), 3u);  // with the time step
  EXPECT_TRUE(texts[1].starts_with("32: the output \"POINT2PX\"")) << texts[1];
  EXPECT_TRUE(texts[2].starts_with("31: the output \"FAIRTEN1\": the line does not end there")) << texts[2];
  const auto made = scene_of(read.mooring.table, {}, "gear.mesh");
  EXPECT_NE(made.scene.find("[results]\nAnchTen1 = { of = \"line-1.start\", take = \"reaction\" }\n"),
            std::string::npos)
      << made.scene;
}

TEST(MoorDyn, LaysEveryNodeOnOneBedWhereLinesOfTwoTypesMeet) {
  std::string text =
      changed(kMooring, "---------------------- BODIES",
              "rope       0.2     20         1e7    -1          0          1.2    1      1.0     "
              "0.5\n---------------------- BODIES");
  text = changed(text, "2     chain", "2     rope ");
  const auto made = scene_of(ReadMooring(text).mooring.table, {}, "gear.mesh");
  std::vector<int> beds(made.mesh.node_count());
  for (const auto& set : made.mesh.sets)
    if (set.name.starts_with("on-bed-"))
      for (const auto node : set.nodes) ++beds[node];
  for (std::size_t n = 0; n < beds.size(); ++n) EXPECT_EQ(beds[n], 1) << n;
  // At point 2, bars of 12.5 m and 42.5 m of chain meet a bar of 13 m of rope.
  const double at_joint = 2e6 * (0.1 * (12.5 + 42.5) + 0.2 * 13) / (12.5 + 42.5 + 13);
  for (const std::string& k :
       {std::string("2e+05"), fmt::format("{}", at_joint).substr(0, 8), std::string("4e+05")})
    EXPECT_NE(made.scene.find("stiffness = " + k), std::string::npos) << k << made.scene;
}

TEST(MoorDyn, AsksWhetherAFileWithoutAnEndIsWhole) {
  const std::string cut = kMooring.substr(0, kMooring.find("9.8       g"));
  const ReadMooring read(cut);
  ASSERT_EQ(read.diagnostics.errors(), 0) << read.said();
  ASSERT_EQ(read.mooring.findings.size(), 3u);  // further findings: point 4 is coupled, and the time step
  EXPECT_NE(read.mooring.findings.back().text.find("is it whole?"), std::string::npos);
}

TEST(MoorDyn, AnswersWhatIsWrongWithItsPlace) {
  const struct {
    const char *old, *fresh, *says;
  } wrong[] = {
      {"chain      0.1", "chain      -0.1",
       "lines.txt:6:12: error: the diameter of the line = -0.1 is outside"},
      {"150        1e8", "150        ea.txt", "EA = \"ea.txt\": stiffness that is no single number"},
      {"150        1e8", "x          1e8", "the mass of a metre of the line = \"x\" is no number"},
      {"1     chain      1        2", "1     rope       1        2", "there is no line type \"rope\""},
      {"1     chain      1        2", "1     chain      1        9", "there is no point \"9\""},
      {"1     chain      1        2", "1     chain      1        1", "begins and ends at the same point"},
      {"1     chain      1        2", "1     chain      R1A      2", "lines that end at rods"},
      {"2     chain      2        3", "1     chain      2        3",
       "there is a line with this number already"},
      {"250        20", "250        0", "the number of segments = 0 is outside"},
      {"250        20", "250        2.5", "the number of segments is not whole"},
      {"250        20", "250        1000000000", "the number of segments = 1e+09 is outside"},
      {"250        20       p", "250", "5 words are given here, and 6 are needed"},
      {"2     Free ", "1     Free ", "there is a point \"1\" already"},
      {"1     Fixed ", "1     Nailed", "the attachment \"Nailed\" is not known"},
      {"1    Coupled     10", "1    Free        10", "bodies that move, such as \"Body1\""},
      {"-5  0  0  0 ", "-5  0  9  0 ", "bodies with a rotation, such as \"Body1\""},
      {"-100     0     -60 ", "-100     nan   -60 ", "a coordinate of the point = \"nan\" is no number"},
      {"200    3       1.5    0", "200    3", "words are given here, and 9 are needed"},
      {"- LINES -", "- LIES -", "there are no lines"},
      {"100       WtrDpth", "-7        WtrDpth", "the depth of the water = -7 is outside"}};
  for (const auto& w : wrong) {
    const ReadMooring read(changed(kMooring, w.old, w.fresh));
    EXPECT_GE(read.diagnostics.errors(), 1) << w.fresh;
    EXPECT_NE(read.said().find(w.says), std::string::npos) << w.fresh << "\n" << read.said();
    for (const auto& d : read.diagnostics.sorted()) EXPECT_GT(d.place.line, 0) << d.message;
  }
}

TEST(MoorDyn, IsAnsweredWhereverItIsCutOff) {
  for (std::size_t end = 0; end < kMooring.find("- OPTIONS"); end += 11) {
    const ReadMooring read(kMooring.substr(0, end));
    EXPECT_TRUE(read.diagnostics.errors() > 0 || !read.mooring.table.ropes.empty()) << end;
  }
}

}  // namespace
}  // namespace netloft::scenes
