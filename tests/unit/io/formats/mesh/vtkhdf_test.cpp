// SPDX-License-Identifier: BSD-3-Clause
//
// Reads meshes in VTKHDF: files of other programs, results of this program, and invalid files.
#include "io/formats/hdf5/tree.hpp"
#include "io/formats/mesh/mesh.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace netloft::formats {
namespace {

namespace fs = std::filesystem;
using Reals = std::vector<double>;
using Ints = std::vector<std::int64_t>;
using Change = std::function<void(Tree&)>;

/// Writes two triangles, a rope of two bars and a set, as another program may write them.
void write_grid(Tree& tree, bool has_regions = true) {
  tree.set_attribute("/VTKHDF", "Type", "UnstructuredGrid");
  tree.write_ints("/VTKHDF/NumberOfPoints", Ints{5}, "1");
  tree.write_ints("/VTKHDF/NumberOfCells", Ints{5}, "1");
  tree.write_ints("/VTKHDF/NumberOfConnectivityIds", Ints{12}, "1");
  tree.write_matrix("/VTKHDF/Points", Reals{0, 0, 0, 1, 0, 0, 0.1, 1, -1.0 / 3, 1, 1, -0.5, 2, 0, 1e-9}, 3,
                    "m");
  tree.write_ints("/VTKHDF/Connectivity", Ints{0, 1, 2, 1, 3, 2, 0, 1, 1, 4, 0, 4}, "1");
  tree.write_ints("/VTKHDF/Offsets", Ints{0, 3, 6, 8, 10, 12}, "1");
  tree.write_ints("/VTKHDF/Types", Ints{5, 5, 3, 3, 2}, "1");
  if (!has_regions) return;
  tree.write_ints("/VTKHDF/CellData/region", Ints{0, 0, 1, 1, 2}, "1");
  tree.write_strings("/VTKHDF/FieldData/region_names", std::vector<std::string>{"belly", "line", "tip"});
  Reals corners(30);
  const Reals own{0, 0, 10, 0, 0, 5, 10, 0, 10, 1.0 / 3, 0, 5};
  std::copy(own.begin(), own.end(), corners.begin());
  tree.write_matrix("/VTKHDF/CellData/panel_corners", corners, 6, "1");
  tree.write_matrix("/VTKHDF/CellData/shares", Reals{0, 0, 0, 0, 0, 0.25, 0.25, 1, 0, 0}, 2, "1");
}

/// Writes a file in the tests' folder and reads it.
struct Written {
  explicit Written(const Change& write, const std::string& name = "grid.vtkhdf") {
    // Tests run at the same time in several processes, so file names differ.
    const fs::path path = fs::path(testing::TempDir()) / (std::to_string(getpid()) + name);
    {
      const Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
      Tree tree(file, path.string());
      write(tree);
    }
    mesh = read_vtkhdf(path, diagnostics.add_source(name, ""), diagnostics);
    fs::remove(path);
  }
  std::string said() const { return diagnostics.render(false); }
  Diagnostics diagnostics;
  InputMesh mesh;
};

TEST(VtkHdfMesh, HasTheRegionsOfAnotherProgram) {
  const Written file([](Tree& tree) { write_grid(tree); });
  ASSERT_EQ(file.diagnostics.errors(), 0) << file.said();
  EXPECT_EQ(file.mesh.positions[8], -1.0 / 3);
  const MeshRegion *belly = file.mesh.find("belly"), *line = file.mesh.find("line");
  ASSERT_TRUE(belly && line);
  EXPECT_EQ(belly->kind, RegionKind::triangles);
  EXPECT_EQ(belly->nodes, (std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2}));
  EXPECT_EQ(belly->numbers[9], 1.0 / 3);
  EXPECT_EQ(line->numbers, (Reals{0, 0.25, 0.25, 1}));
  ASSERT_EQ(file.mesh.sets.size(), 1u);
  EXPECT_EQ(file.mesh.sets[0].name, "tip");
  EXPECT_EQ(file.mesh.sets[0].nodes, (std::vector<std::uint32_t>{0, 4}));
}

/// The file has two states of the points; the last one must be read.
TEST(VtkHdfMesh, IsThatOfTheLastState) {
  const Written file([](Tree& tree) {
    write_grid(tree);
    Reals points(30, 7);
    for (std::size_t i = 15; i < 30; ++i) points[i] = static_cast<double>(i);
    tree.write_matrix("/VTKHDF/Points", points, 3, "m");
    tree.set_attribute("/VTKHDF/Steps", "NSteps", 2);
    tree.write_reals("/VTKHDF/Steps/Values", Reals{0, 1}, "s");
    tree.write_ints("/VTKHDF/Steps/PointOffsets", Ints{0, 5}, "1");
    for (const char* array : {"region", "panel_corners", "shares"})
      tree.write_ints(std::string("/VTKHDF/Steps/CellDataOffsets/") + array, Ints{0, 0}, "1");
  });
  ASSERT_EQ(file.diagnostics.errors(), 0) << file.said();
  EXPECT_EQ(file.mesh.positions[0], 15);
  EXPECT_EQ(file.mesh.positions.size(), 15u);
}

/// The bars are 1 m long, the second is stretched to 2 m, and one triangle has no place on a panel.
TEST(VtkHdfMesh, HasThePartsOfAResult) {
  const Written file([](Tree& tree) {
    write_grid(tree, false);
    Reals corners(30, NAN);
    std::fill_n(corners.begin(), 6, 0.5), corners[0] = 3, corners[3] = 2;
    tree.write_matrix("/VTKHDF/CellData/panel_corners", corners, 6, "1");
    tree.write_ints("/VTKHDF/CellData/part", Ints{0, 0, 1, 1, 2}, "1");
    tree.write_reals("/VTKHDF/CellData/strain", Reals{NAN, NAN, 0, 1, NAN}, "1");
    tree.write_strings("/netloft/parts/name", std::vector<std::string>{"net", "rope", "float"});
  });
  ASSERT_EQ(file.diagnostics.errors(), 0) << file.said();
  const MeshRegion *net = file.mesh.find("net"), *rope = file.mesh.find("rope");
  ASSERT_TRUE(net && rope);
  EXPECT_EQ(net->size(), 1u);
  EXPECT_EQ(rope->numbers[0], 0);
  EXPECT_DOUBLE_EQ(rope->numbers[1], 1 / 1.5);
  EXPECT_EQ(rope->numbers[3], 1);
  EXPECT_EQ(file.mesh.sets.at(0).name, "float");
  EXPECT_NE(file.said().find("\"net\": 1 elements that are neither bars of a rope nor triangles"),
            std::string::npos)
      << file.said();
}

struct Broken {
  const char* name;
  Change change;
  const char* says;
};

class BrokenGrid : public testing::TestWithParam<Broken> {};

TEST_P(BrokenGrid, IsSaid) {
  const Written file([&](Tree& tree) { write_grid(tree), GetParam().change(tree); });
  EXPECT_GE(file.diagnostics.errors(), 1);
  EXPECT_NE(file.said().find(GetParam().says), std::string::npos) << file.said();
}

const Broken kBroken[] = {
    {"OtherKind", [](Tree& t) { t.set_attribute("/VTKHDF", "Type", "PolyData"); },
     "its data set is \"PolyData\"; only an UnstructuredGrid can be read"},
    {"Pieces",
     [](Tree& t) {
       t.write_ints("/VTKHDF/NumberOfPoints", Ints{2, 3}, "1");
     },
     "it is in 2 pieces"},
    {"FewOffsets",
     [](Tree& t) {
       t.write_ints("/VTKHDF/Offsets", Ints{0, 3, 6}, "1");
     },
     "it has 5 cells and 3 offsets"},
    {"OffsetsThatFall",
     [](Tree& t) {
       t.write_ints("/VTKHDF/Offsets", Ints{0, 3, 2, 8, 10, 12}, "1");
     },
     "the offsets of cell 1 are outside"},
    {"OffsetsBeyond",
     [](Tree& t) {
       t.write_ints("/VTKHDF/Offsets", Ints{0, 3, 6, 8, 10, 99}, "1");
     },
     "the offsets of cell 4 are outside"},
    {"NegativeOffset",
     [](Tree& t) {
       t.write_ints("/VTKHDF/Offsets", Ints{-3, 3, 6, 8, 10, 12}, "1");
     },
     "the offsets of cell 0 are outside"},
    {"NoSuchNode",
     [](Tree& t) {
       t.write_ints("/VTKHDF/Connectivity", Ints{0, 1, 2, 1, 3, 22, 0, 1, 1, 4, 0, 4}, "1");
     },
     "cell 1 refers to node 22, and there are 5"},
    {"NegativeNode",
     [](Tree& t) {
       t.write_ints("/VTKHDF/Connectivity", Ints{0, 1, 2, 1, 3, -1, 0, 1, 1, 4, 0, 4}, "1");
     },
     "cell 1 refers to node -1"},
    {"TwoEqualNodes",
     [](Tree& t) {
       t.write_ints("/VTKHDF/Connectivity", Ints{0, 1, 1, 1, 3, 2, 0, 1, 1, 4, 0, 4}, "1");
     },
     "grid.vtkhdf: error"},
    {"NotANumber",
     [](Tree& t) {
       t.write_matrix("/VTKHDF/Points", Reals{0, 0, NAN, 1, 0, 0, 0, 1, 0, 1, 1, 0, 2, 0, 0}, 3, "m");
     },
     "/VTKHDF/Points: nan is no number below a million"},
    {"FewPoints",
     [](Tree& t) {
       t.write_matrix("/VTKHDF/Points", Reals{0, 0, 0, 1, 0, 0}, 3, "m");
     },
     "cell 0 refers to node 2, and there are 2"},
    {"Tetrahedra",
     [](Tree& t) {
       t.write_ints("/VTKHDF/Types", Ints{10, 5, 3, 3, 2}, "1");
     },
     "cells of type 10 with 3 nodes are not read"},
    {"FarCorner",
     [](Tree& t) {
       Reals corners(30);
       std::copy_n(Reals{0, 0, 10, 0, -1e9, 5, 10, 0, 10, 1.0 / 3, 0, 5}.begin(), 12, corners.begin());
       t.write_matrix("/VTKHDF/CellData/panel_corners", corners, 6, "1");
     },
     "a number of the element is not finite or is above a million"},
    {"FewCorners", [](Tree& t) { t.write_matrix("/VTKHDF/CellData/panel_corners", Reals(12), 6, "1"); },
     "/VTKHDF/CellData/panel_corners must have 6 numbers for each of 5 cells"},
    {"CornersInARow", [](Tree& t) { t.write_reals("/VTKHDF/CellData/panel_corners", Reals(30), "1"); },
     "must have 6 numbers"},
    {"SharesThatFall",
     [](Tree& t) {
       t.write_matrix("/VTKHDF/CellData/shares", Reals{0, 0, 0, 0, 0.5, 0.25, 0.25, 1, 0, 0}, 2, "1");
     },
     "grid.vtkhdf: error"},
    {"TextForNumbers",
     [](Tree& t) {
       t.write_strings("/VTKHDF/Types", std::vector<std::string>{"5", "5", "3", "3", "2"});
     },
     "/VTKHDF/Types"},
    {"NoState",
     [](Tree& t) {
       t.set_attribute("/VTKHDF/Steps", "NSteps", 0);
       t.write_reals("/VTKHDF/Steps/Values", Reals{0}, "s");
     },
     "it has no state"},
    {"NoOffsetsOfStates",
     [](Tree& t) {
       t.set_attribute("/VTKHDF/Steps", "NSteps", 1);
       t.write_reals("/VTKHDF/Steps/Values", Reals{0}, "s");
     },
     "PointOffsets"}};

INSTANTIATE_TEST_SUITE_P(Each, BrokenGrid, testing::ValuesIn(kBroken),
                         [](const auto& i) { return i.param.name; });

TEST(VtkHdfMesh, NeedsItsGroupAndItsFile) {
  const Written bare([](Tree& tree) { tree.write_ints("/Mesh/Points", Ints{1}, "1"); });
  EXPECT_NE(bare.said().find("it has no group VTKHDF"), std::string::npos) << bare.said();
  Diagnostics diagnostics;
  read_vtkhdf("no-such-file.vtkhdf", diagnostics.add_source("no-such-file.vtkhdf", ""), diagnostics);
  EXPECT_EQ(diagnostics.errors(), 1);
}

}  // namespace
}  // namespace netloft::formats
