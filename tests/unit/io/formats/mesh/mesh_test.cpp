// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/mesh/mesh.hpp"

#include <gtest/gtest.h>

namespace netloft::formats {
namespace {

const std::string kMesh =
    "netloft mesh 1\n"        // 1
    "[nodes]\n"               // 2
    "0 0 0\n"                 // 3
    "1 0 0\n"                 // 4
    "0 1 -0.5\n"              // 5
    "[triangles belly]\n"     // 6
    "0 1 2  0 0 10 0 10 5\n"  // 7
    "[bars line]\n"           // 8
    "0 1  0 0.25\n"           // 9
    "[twines wing]\n"         // 10
    "1 2  5 3\n"              // 11
    "[set tip]\n"             // 12
    "0 2\n"                   // 13
    "[end]\n";

struct ReadMesh {
  explicit ReadMesh(const std::string& text)
      : file(diagnostics.add_source("gear.mesh", text)), mesh(read_mesh(text, file, diagnostics)) {}
  Diagnostics diagnostics;
  int file;
  InputMesh mesh;
};

TEST(Mesh, IsReadWithItsRegionsAndSets) {
  const ReadMesh read(kMesh);
  ASSERT_EQ(read.diagnostics.errors(), 0) << read.diagnostics.render(false);
  EXPECT_EQ(read.mesh.node_count(), 3u);
  EXPECT_EQ(read.mesh.positions[8], -0.5);
  ASSERT_NE(read.mesh.find("belly"), nullptr);
  EXPECT_EQ(read.mesh.find("belly")->numbers, (std::vector<double>{0, 0, 10, 0, 10, 5}));
  EXPECT_EQ(read.mesh.find("line")->kind, RegionKind::bars);
  EXPECT_EQ(read.mesh.find("wing")->numbers, (std::vector<double>{5, 3}));
  EXPECT_EQ(read.mesh.sets.at(0).nodes, (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(read.mesh.find("tip"), nullptr);
}

TEST(Mesh, IsTheSameWhenWrittenAndReadAgain) {
  const InputMesh first = ReadMesh(kMesh).mesh;
  const std::string text = mesh_text(first, "a source\nof two lines");
  const ReadMesh again(text);
  ASSERT_EQ(again.diagnostics.errors(), 0) << again.diagnostics.render(false);
  EXPECT_EQ(again.mesh.positions, first.positions);
  for (const auto& region : first.regions) {
    ASSERT_NE(again.mesh.find(region.name), nullptr);
    EXPECT_EQ(again.mesh.find(region.name)->nodes, region.nodes);
    EXPECT_EQ(again.mesh.find(region.name)->numbers, region.numbers);
  }
  EXPECT_EQ(again.mesh.sets.at(0).nodes, first.sets.at(0).nodes);
}

struct WrongFile {
  const char *name, *old, *fresh, *where, *says;
};

class WrongMesh : public testing::TestWithParam<WrongFile> {};

TEST_P(WrongMesh, IsAnsweredWithItsPlace) {
  std::string text = kMesh;
  const auto at = text.find(GetParam().old);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, std::string(GetParam().old).size(), GetParam().fresh);
  const ReadMesh read(text);
  ASSERT_EQ(read.diagnostics.errors(), 1) << read.diagnostics.render(false);
  const Diagnostic error = read.diagnostics.sorted().at(0);
  EXPECT_EQ(read.diagnostics.where(error.place), std::string("gear.mesh:") + GetParam().where);
  EXPECT_NE(error.message.find(GetParam().says), std::string::npos) << error.message;
}

INSTANTIATE_TEST_SUITE_P(
    Each, WrongMesh,
    testing::Values(WrongFile{"NoMesh", "netloft mesh 1", "hello", "1:1", "this file is no mesh"},
                    WrongFile{"Newer", "mesh 1", "mesh 2", "1:14", "is of version 2"},
                    WrongFile{"CutOff", "[end]\n", "", "13:1", "cut off"},
                    WrongFile{"UnknownSection", "[bars line]", "[beams line]", "8:1", "no section \"beams\""},
                    WrongFile{"RegionWithoutName", "[bars line]", "[bars]", "8:1", "without a name"},
                    WrongFile{"NoBracket", "[bars line]", "[bars line", "8:1", "in brackets"},
                    WrongFile{"NameTwice", "[bars line]", "[bars belly]", "8:7", "already"},
                    WrongFile{"NodeOfTwoNumbers", "1 0 0\n", "1 0\n", "4:1", "2 numbers are given here"},
                    WrongFile{"NoNumber", "0 1 -0.5", "0 one -0.5", "5:3", "\"one\" is no number"},
                    WrongFile{"NaN", "0 1 -0.5", "0 nan -0.5", "5:3", "\"nan\" is no number"},
                    WrongFile{"FarAway", "0 1 -0.5", "0 1e9 -0.5", "5:3", "beyond a million"},
                    WrongFile{"NoSuchNode", "0 1 2  0 0", "0 1 3  0 0", "7:1", "there is no node 3"},
                    WrongFile{"NegativeNode", "0 1 2  0 0", "0 1 -2  0 0", "7:5", "is no number of a node"},
                    WrongFile{"NodeTwice", "0 1 2  0 0", "0 1 1  0 0", "7:1", "appears twice"},
                    WrongFile{"NoNetting", "10 0 10 5", "10 0 20 0", "7:8", "on one line in meshes"},
                    WrongFile{"SharesBackwards", "0 0.25", "0.25 0.25", "9:6", "shares of a rope must grow"},
                    WrongFile{"NoTwines", "5 3", "5 0", "11:6", "above zero"},
                    WrongFile{"SetOfNoNode", "0 2\n", "0 7\n", "13:3", "there is no node 7"}),
    [](const auto& wrong) { return wrong.param.name; });

}  // namespace
}  // namespace netloft::formats
