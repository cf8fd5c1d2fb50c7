// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/compare/division.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace netloft::studies {
namespace {

std::string refusal(const std::function<void()>& act) {
  try {
    act();
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "accepted";
}

bool contains(const std::string& text, const std::string& piece) {
  return text.find(piece) != std::string::npos;
}

/// A scene whose parts have these cells, and whose file contains `text`.
scenes::LoadedScene scene_of(const std::vector<std::pair<std::string, std::vector<int>>>& parts,
                             const std::string& text = "") {
  scenes::LoadedScene loaded;
  for (const auto& [name, cells] : parts) {
    loaded.parts.emplace_back();
    loaded.parts.back().name = name, loaded.parts.back().cells = cells;
  }
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto path =
      std::filesystem::temp_directory_path() / (std::string("netloft-") + test->name() + ".toml");
  std::ofstream(path) << text;
  loaded.files.push_back({path.string(), text, ""});
  return loaded;
}

const std::vector<std::pair<std::string, std::vector<int>>> kGear{
    {"rope", {16}}, {"net", {32, 16}}, {"float", {}}};

TEST(CellList, IsReadInAnyOrder) {
  const CellList list = read_cell_list("32,8,16");
  EXPECT_EQ(list.cells, (std::vector<std::int64_t>{8, 16, 32}));
  EXPECT_EQ(list.part, "");
  EXPECT_EQ(read_cell_list("parts.net=4,8").part, "net");
  EXPECT_EQ(read_cell_list("net=4,8").part, "net");
}

TEST(CellList, RefusesWhatIsNoListOfCells) {
  for (const char* word : {"", ",", "8", "8,8", "8,x", "8,1.5", "0,8", "-4,8", "8,16,", "8;16",
                           "net=", "1e2,4", "8,99999999999999999999"})
    EXPECT_TRUE(contains(refusal([&] { read_cell_list(word); }), "--cells")) << word;
}

std::vector<std::string> texts_of(const MeshLevel& level) {
  std::vector<std::string> texts;
  for (const formats::Change& change : level.changes) texts.push_back(change.text);
  return texts;
}

TEST(Division, ScalesAllPartsWithTheLeadingPanel) {
  const auto levels = mesh_levels(scene_of(kGear), read_cell_list("8,64"));
  ASSERT_EQ(levels.size(), 2u);
  EXPECT_EQ(texts_of(levels[0]), (std::vector<std::string>{"parts.rope.cells=4", "parts.net.cells=[8, 4]"}));
  EXPECT_EQ(texts_of(levels[1]),
            (std::vector<std::string>{"parts.rope.cells=32", "parts.net.cells=[64, 32]"}));
}

TEST(Division, ChangesOnePartAlone) {
  const auto levels = mesh_levels(scene_of(kGear), read_cell_list("rope=8,64"));
  EXPECT_EQ(texts_of(levels[0]), (std::vector<std::string>{"parts.rope.cells=8"}));
}

TEST(Division, RefusesPartsOfCells) {
  const std::string why = refusal([] { mesh_levels(scene_of(kGear), read_cell_list("1,32")); });
  EXPECT_TRUE(contains(why, "\"rope\" has 16 cells")) << why;
}

TEST(Division, RefusesPartsThatAreNotDivided) {
  const std::string why = refusal([] { mesh_levels(scene_of(kGear), read_cell_list("float=8,64")); });
  EXPECT_TRUE(contains(why, "divided are rope, net")) << why;
}

TEST(Division, RefusesASceneOfPointsAlone) {
  const std::string why = refusal([] { levels_around(scene_of({{"float", {}}})); });
  EXPECT_TRUE(contains(why, "nothing in this scene is divided")) << why;
}

TEST(Division, RefusesNodesThatAreOthersOnAnotherMesh) {
  const std::string text = "[[hold]]\non = \"net.node-17\"\n";
  const std::string why = refusal([&] { levels_around(scene_of(kGear, text)); });
  EXPECT_TRUE(contains(why, ".toml:2:6: \"net.node-17\"")) << why;
  EXPECT_EQ(refusal([&] { mesh_levels(scene_of(kGear, text), read_cell_list("rope=8,32")); }), "accepted");
}

TEST(Division, PrefersMeshesThatCostLittle) {
  const auto cells = [](const std::vector<std::pair<std::string, std::vector<int>>>& parts) {
    std::vector<std::int64_t> all;
    for (const auto& level : levels_around(scene_of(parts))) all.push_back(level.cells);
    return all;
  };
  EXPECT_EQ(cells({{"net", {32, 16}}}), (std::vector<std::int64_t>{8, 16}));
  EXPECT_EQ(cells({{"net", {6, 8}}}), (std::vector<std::int64_t>{3, 12}));
  EXPECT_EQ(cells({{"net", {4, 4}}}), (std::vector<std::int64_t>{2, 8}));
  EXPECT_EQ(cells({{"net", {32, 32}}, {"rope", {5}}}), (std::vector<std::int64_t>{64}));
}

}  // namespace
}  // namespace netloft::studies
