// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/scene_source.hpp"

#include "io/formats/units/units.hpp"
#include "tests/folders.hpp"
#include "tests/unit/io/scenes/reading/scene_bytes.hpp"
#include "tests/verification/solving.hpp"

#include <gtest/gtest.h>

#include <random>

namespace netloft::scenes {
namespace {

using Changes = std::vector<formats::Change>;

/// The data of an instance, and the messages about it.
struct Instance {
  std::string bytes, messages;
  bool refused = false;
  bool operator==(const Instance&) const = default;
};

Instance instance_of(const SceneSource& source, const Changes& changes) {
  Instance one;
  formats::Diagnostics diagnostics;
  const LoadedScene loaded =
      source.instance(changes, netloft::test::shipped_plugins(), diagnostics, one.refused);
  if (diagnostics.errors() == 0) one.bytes = SceneBytes(loaded).bytes();
  one.messages = diagnostics.render(false);
  return one;
}

/// Collects "path=value" for all numbers of a document, each with a slightly changed value.
class OtherNumbers {
 public:
  explicit OtherNumbers(const std::filesystem::path& file) {
    formats::Diagnostics diagnostics;
    const auto document = formats::Document::load(file, {}, diagnostics);
    visit("", document.root());
  }
  std::vector<std::string> all;

 private:
  void visit(const std::string& path, const formats::Value& value) {
    if (const auto* table = value.as<formats::Table>())
      for (const auto& member : table->members) visit(formats::join_path(path, member.key), member.value);
    if (const auto* array = value.as<formats::Array>())
      for (std::size_t i = 0; i < array->items.size(); ++i)
        visit(path + "[" + std::to_string(i) + "]", array->items[i]);
    if (const auto* whole = value.as<std::int64_t>()) add(path, std::to_string(*whole + 1));
    if (const auto* real = value.as<double>()) add(path, formats::format(1.015625 * *real + 0.001));
    if (const auto* text = value.as<std::string>())
      if (const auto written = formats::read_as_written(*text); written.ok() && !written.unit.empty())
        add(path, formats::format(1.015625 * written.number, written.unit));
  }
  void add(const std::string& path, const std::string& value) { all.push_back(path + "=" + value); }
};

std::vector<std::string> library_scenes() {
  const std::filesystem::path folder = netloft::test::source_folder() + "/gear-library/scenes";
  std::vector<std::string> scenes;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".toml")
      scenes.push_back(std::filesystem::relative(entry.path(), folder).string());
  std::ranges::sort(scenes);
  return scenes;
}

std::string path_of(const std::string& scene) {
  return netloft::test::source_folder() + "/gear-library/scenes/" + scene;
}

class LibraryScene : public testing::TestWithParam<std::string> {};

// The seed is fixed, so that a failure can be repeated.
TEST_P(LibraryScene, IsInstantiatedAsItIsReadAnew) {
  constexpr std::size_t kDraws = 6;
  const std::string file = path_of(GetParam());
  const SceneSource source(file);
  const auto numbers = OtherNumbers(file).all;
  ASSERT_FALSE(numbers.empty());
  std::mt19937 draw(20260101);
  Changes before;
  for (std::size_t i = 0; i < kDraws; ++i) {
    const Changes changes = formats::read_changes({numbers.at(draw() % numbers.size())});
    const Instance fresh = instance_of(SceneSource(file), changes);
    EXPECT_EQ(instance_of(source, changes), fresh) << changes[0].text;
    instance_of(source, before);
    EXPECT_EQ(instance_of(source, changes), fresh) << "after another instance, " << changes[0].text;
    before = changes;
  }
}

INSTANTIATE_TEST_SUITE_P(Any, LibraryScene, testing::ValuesIn(library_scenes()), [](const auto& one) {
  std::string name = one.param;
  std::erase_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
  return name;
});

// Each change concerns an input of one of the stored results.
TEST(SceneSource, KeepsNoResultWhoseInputHasChanged) {
  const std::string file = path_of("83-112-at-sea-66m.toml");
  const SceneSource source(file);
  const std::vector<std::string> all{"gear.nodes=300",
                                     "gear.nodes=301",
                                     "ship.speed=2.9 kn",
                                     "ship.warp.length=241 m",
                                     "bed.depth=67 m",
                                     "panels.top-wing.mesh=0.11",
                                     "panels.top-wing.twine={ EA = 1000, diameter = 0.003, density = 1100 }",
                                     "panels.top-wing.angle=3",
                                     "panels.top-wing.no-such-key=1",
                                     "ropes.footrope.rope={ part = \"6x19-fc-16mm\", EA = \"9 MN\" }",
                                     "elements.ropes.no-such-key=1",
                                     "elements.netting.drag=no/law",
                                     "elements.contact.seabed.stiffness=11 kN/m2",
                                     "gear.finer={ headrope = 2 }",
                                     "catalogue=[\"no-such-folder\"]",
                                     "gear.nodes=-1",
                                     "no.such.key=1"};
  for (const std::string& one : all)
    for (const std::string& other : {one, all[0], one}) {
      const Changes changes = formats::read_changes({"gear.nodes=300", other});
      EXPECT_EQ(instance_of(source, changes), instance_of(SceneSource(file), changes)) << other;
    }
}

TEST(SceneSource, PointsToTheChangeThatIsWrong) {
  formats::Diagnostics diagnostics;
  bool refused = false;
  SceneSource(path_of("two-panel.toml"))
      .instance({formats::make_change({"analysis", "tolerance"}, {{}, -1.0})},
                netloft::test::shipped_plugins(), diagnostics, refused);
  ASSERT_EQ(diagnostics.errors(), 1);
  EXPECT_TRUE(
      diagnostics.render(false).starts_with("--set analysis.tolerance: error: analysis.tolerance = -1"))
      << diagnostics.render(false);
}

}  // namespace
}  // namespace netloft::scenes
