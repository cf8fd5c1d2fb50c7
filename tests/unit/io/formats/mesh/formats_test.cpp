// SPDX-License-Identifier: BSD-3-Clause
//
// Writes meshes as OBJ and VTK and reads them again; reports of errors name their places.
#include "io/formats/mesh/mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace netloft::formats {
namespace {

InputMesh sample() {
  InputMesh mesh;
  mesh.positions = {0, 0, 0, 1, 0, 0, 0.1, 1, -1.0 / 3, 1, 1, -0.5, 2, 0, 1e-9};
  mesh.regions = {
      {RegionKind::triangles, "belly", {0, 1, 2, 1, 3, 2}, {0, 0, 10, 0, 0, 5, 10, 0, 10, 1.0 / 3, 0, 5}},
      {RegionKind::bars, "line", {0, 1, 1, 4}, {0, 0.25, 0.25, 1}},
      {RegionKind::twines, "wing", {3, 4}, {5, 3}}};
  mesh.sets = {{"tip", {0, 2}}, {"end", {4}}};
  return mesh;
}

struct Read {
  explicit Read(const std::string& text)
      : mesh(read_any_mesh(text, diagnostics.add_source("gear.x", text), diagnostics)) {}
  std::string said() const { return diagnostics.render(false); }
  Diagnostics diagnostics;
  InputMesh mesh;
};

void expect_same(const InputMesh& mesh, const InputMesh& as) {
  EXPECT_EQ(mesh.positions, as.positions);
  ASSERT_EQ(mesh.regions.size(), as.regions.size());
  for (const auto& region : as.regions) {
    const auto* found = mesh.find(region.name);
    ASSERT_NE(found, nullptr) << region.name;
    EXPECT_EQ(found->kind, region.kind);
    EXPECT_EQ(found->nodes, region.nodes);
    EXPECT_EQ(found->numbers, region.numbers);
  }
  ASSERT_EQ(mesh.sets.size(), as.sets.size());
  for (std::size_t i = 0; i < as.sets.size(); ++i) {
    EXPECT_EQ(mesh.sets[i].name, as.sets[i].name);
    EXPECT_EQ(mesh.sets[i].nodes, as.sets[i].nodes);
  }
}

TEST(Vtk, IsTheSameWhenWrittenAndReadAgain) {
  const Read again(vtk_text(sample(), "a source\nof two lines"));
  ASSERT_EQ(again.diagnostics.errors(), 0) << again.said();
  expect_same(again.mesh, sample());
}

TEST(Obj, IsTheSameWhenWrittenAndReadAgainButForBarsOfTwines) {
  InputMesh mesh = sample();
  const Read again(obj_text(mesh, "a source"));
  ASSERT_EQ(again.diagnostics.errors(), 0) << again.said();
  mesh.regions.pop_back();
  expect_same(again.mesh, mesh);
}

TEST(Obj, OfAnotherProgramIsRead) {
  const Read read(
      "# a program\nmtllib net.mtl\no Net.001\nv 0 0 0\nv 4 0 0\nv 4 -2 0\nv 0 -2 0\nv 8 0 0\n"
      "vt 0 0\nvt 20 0\nvt 20 -10\nvt 0 -10\nvn 0 0 1\nusemtl white\ns off\nf 1/1/1 2/2/1 3/3/1 -2/-1/1\n"
      "l 1 2 5\ng corners\np 1 -1\n");
  ASSERT_EQ(read.diagnostics.errors(), 0) << read.said();
  const auto* net = read.mesh.find("Net-001");
  ASSERT_NE(net, nullptr);
  EXPECT_EQ(net->nodes, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(net->numbers, (std::vector<double>{0, 0, 20, 0, 20, -10, 0, 0, 20, -10, 0, -10}));
  const auto* rope = read.mesh.find("Net-001-bars");
  ASSERT_NE(rope, nullptr);
  EXPECT_EQ(rope->numbers,
            (std::vector<double>{0, 0.5, 0.5, 1}));  // fractions of the rope, by the distances of the nodes
  EXPECT_EQ(read.mesh.sets.at(0).nodes, (std::vector<std::uint32_t>{0, 4}));
}

TEST(Vtk, OfVersionFiveIsRead) {
  const Read read(
      "# vtk DataFile Version 5.1\nvtk output\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n"
      "0 0 0 1 0 0\n0 1 0 1 1 0\n\nCELLS 4 7\nOFFSETS vtktypeint64\n0 3 5 7\nCONNECTIVITY vtktypeint64\n0 1 "
      "2\n1 3\n0 2\n"
      "CELL_TYPES 3\n5\n3\n3\n\nCELL_DATA 3\nFIELD FieldData 2\npanel_corners 6 3 double\n0 0 2 0 0 2\n"
      "nan nan nan nan nan nan nan nan nan nan nan nan\nMETADATA\nINFORMATION 0\n\nregion 1 3 "
      "vtktypeint64\n0 4 4\n");
  ASSERT_EQ(read.diagnostics.errors(), 0) << read.said();
  ASSERT_NE(read.mesh.find("region-0"), nullptr);
  ASSERT_NE(read.mesh.find("region-4"), nullptr);
  EXPECT_EQ(read.mesh.find("region-4")->numbers, (std::vector<double>{0, 0.5, 0.5, 1}));
}

TEST(AnyMesh, IsNoPictureInSinglePrecision) {
  for (const char* text : {"glTF\2", "{\"asset\": {}}"})
    EXPECT_NE(Read(text).said().find("export .vtk or .obj"), std::string::npos) << text;
}

struct Wrong {
  const char *old, *fresh, *says;
};

void expect_answers(const std::string& good, const std::vector<Wrong>& wrong) {
  for (const auto& w : wrong) {
    std::string text = good;
    const auto at = text.find(w.old);
    ASSERT_NE(at, std::string::npos) << w.old;
    const Read read(text.replace(at, std::string(w.old).size(), w.fresh));
    EXPECT_GE(read.diagnostics.errors(), 1) << w.fresh;
    EXPECT_NE(read.said().find(w.says), std::string::npos) << w.fresh << "\n" << read.said();
    for (const auto& d : read.diagnostics.sorted()) EXPECT_GT(d.place.line, 0) << d.message;
  }
}

TEST(Obj, AnswersWhatIsWrongWithItsPlace) {
  const std::string good =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 2 0\nvt 0 2\ng net\nf 1/1 2/2 3/3\ng rope\nl 1 2\nl 2 3\n";
  ASSERT_EQ(Read(good).diagnostics.errors(), 0) << Read(good).said();
  expect_answers(good,
                 {{"v 1 0 0", "v 1 0", "gear.x:2:1: error: a vertex is v x y z"},
                  {"v 1 0 0", "v 1 nan 0", "gear.x:2:5: error: \"nan\" is no number"},
                  {"v 1 0 0", "v 1 1e7 0", "is beyond a million"},
                  {"vt 2 0", "vt", "a texture coordinate is vt U V"},
                  {"f 1/1 2/2 3/3", "f 1/1 2/2", "a face has three corners or more"},
                  {"f 1/1 2/2 3/3", "f 1/1 2/2 4/3", "gear.x:8:11: error: there is no vertex \"4\""},
                  {"f 1/1 2/2 3/3", "f 1/1 2/2 0/3", "there is no vertex \"0\""},
                  {"f 1/1 2/2 3/3", "f 1/1 2/2 -9/3", "there is no vertex \"-9\""},
                  {"f 1/1 2/2 3/3", "f 1/1 2/2 3/9", "there is no texture coordinate \"9\""},
                  {"f 1/1 2/2 3/3", "f 1 2 3", "the corner has no coordinates on its panel"},
                  {"f 1/1 2/2 3/3", "f 1/1 1/2 3/3", "a node appears twice"},
                  {"f 1/1 2/2 3/3", "f 1/1 2/2 3/1", "the corners lie on one line in meshes"},
                  {"l 2 3", "l 2/1 3/2", "some bars of this rope state their share"},
                  {"l 2 3", "l 2", "a line has two corners or more"},
                  {"v 0 0 0", "solid net", "this file is no mesh that can be read"},
                  {"l 1 2", "l 1 99999999999999999999", "there is no vertex \"99999999999999999999\""}});
  EXPECT_NE(Read("").said().find("the mesh has no nodes"), std::string::npos);
}

TEST(Vtk, AnswersWhatIsWrongWithItsPlace) {
  const std::string good = vtk_text(sample(), "");
  expect_answers(good, {{"ASCII", "BINARY", "gear.x:3:1: error: only VTK files in ASCII are read"},
                        {"UNSTRUCTURED_GRID", "POLYDATA", "the data set is \"POLYDATA\""},
                        {"POINTS 5", "POINTS 4000000000", "the number of points is \"4000000000\""},
                        {"POINTS 5", "POINTS -1", "the number of points is \"-1\""},
                        {"POINTS 5", "POINTS 4", "is not read in a VTK file"},
                        {"POINTS 5", "POINTS 6", "is no number"},
                        {"3 0 1 2", "3 0 1 9", "there is no node \"9\""},
                        {"3 0 1 2", "3 0 1 1", "a node appears twice"},
                        {"3 0 1 2", "9999 0 1 2", "the number of nodes of a cell is \"9999\""},
                        {"CELL_TYPES 7\n5", "CELL_TYPES 7\n10", "cells of type 10 with 3 nodes are not read"},
                        {"CELL_TYPES 7", "CELL_TYPES 9000000", "the number of cells is"},
                        {"CELL_TYPES 7", "CELL_KINDS 7", "\"CELL_KINDS\" is not read"},
                        {"panel_corners", "corners", "triangles need the array panel_corners"},
                        {"0 0 10 0 0 5", "0 0 10 0 20 0", "the corners lie on one line in meshes"},
                        {"0 0.25", "0.5 0.25", "shares of a rope must grow from 0"}});
  for (std::size_t end = 0; end + 30 < good.size(); end += 13) {
    const Read cut(good.substr(0, end));
    EXPECT_TRUE(cut.diagnostics.errors() > 0 || !cut.mesh.positions.empty()) << end;
  }
}

}  // namespace
}  // namespace netloft::formats
