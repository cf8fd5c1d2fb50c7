// SPDX-License-Identifier: BSD-3-Clause
#include "framework/registry/registry.hpp"
#include "tests/folders.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using netloft::Registry;

const std::string kRegistryFolder = netloft::test::build_folder() + "/tests/refused";

template <class Ask>
std::string complaint(Ask&& ask) {
  try {
    ask();
    return "";
  } catch (const netloft::UnknownComponent& unknown) {
    return unknown.what();
  }
}

TEST(Registry, FindsAnElementByTheNameOfItsFile) {
  Registry registry;
  registry.add_folder(kRegistryFolder);
  EXPECT_EQ(registry.element("none/bar").type, "none/bar");
  EXPECT_EQ(registry.element("none/bar").origin->name, "none");
}

TEST(Registry, OpensOnlyWhatIsAskedFor) {
  Registry registry;
  registry.add_folder(kRegistryFolder);
  EXPECT_TRUE(registry.opened().empty());
  registry.element("none/bar");
  registry.element("none/rod");
  EXPECT_EQ(registry.opened().size(), 1u);
}

TEST(Registry, NamesThePathsTriedAndTheNearestName) {
  Registry registry;
  registry.add_folder("/nowhere");
  registry.add_folder(kRegistryFolder);
  const std::string text = complaint([&] { registry.element("nome/bar"); });
  EXPECT_NE(text.find("there is no plugin \"nome\""), std::string::npos) << text;
  EXPECT_NE(text.find("did you mean \"none\"?"), std::string::npos) << text;
  EXPECT_NE(text.find("tried /nowhere/nome.so"), std::string::npos) << text;
  EXPECT_NE(text.find("tried " + std::string(kRegistryFolder) + "/nome.so"), std::string::npos) << text;
}

TEST(Registry, NamesTheNearestElement) {
  Registry registry;
  registry.add_folder(kRegistryFolder);
  const std::string text = complaint([&] { registry.element("none/bat"); });
  EXPECT_NE(text.find("did you mean \"none/bar\"?"), std::string::npos) << text;
}

TEST(Registry, AsksForPluginAndElementInAType) {
  Registry registry;
  for (const char* type : {"bar", "/bar", "none/"})
    EXPECT_NE(complaint([&] { registry.element(type); }).find("plugin/element"), std::string::npos) << type;
}

TEST(Registry, FindsAStrategyByTheNameOfItsPluginAlone) {
  Registry registry;
  registry.add_folder(kRegistryFolder);
  EXPECT_EQ(registry.strategy("none").type, "none/none");
  EXPECT_EQ(registry.strategy("none/second").type, "none/second");
  EXPECT_EQ(registry.strategy("none").origin->name, "none");
}

TEST(Registry, NamesTheNearestStrategy) {
  Registry registry;
  registry.add_folder(kRegistryFolder);
  const std::string text = complaint([&] { registry.strategy("none/secnd"); });
  EXPECT_NE(text.find("has no strategy \"none/secnd\"; did you mean \"none/second\"?"), std::string::npos)
      << text;
}

TEST(Registry, SaysWhatElseItIsThatHasTheName) {
  Registry registry;
  registry.add_folder(kRegistryFolder);
  const std::string text = complaint([&] { registry.solver("none/second"); });
  EXPECT_NE(text.find("\"none/second\" is a strategy, and no solver"), std::string::npos) << text;
}

TEST(Registry, TakesTheFirstOfSeveralFolders) {
  Registry registry;
  registry.add_folder("/nowhere");
  registry.add_folder(kRegistryFolder);
  EXPECT_EQ(registry.plugin("none").origin.file, std::string(kRegistryFolder) + "/none.so");
}

TEST(Registry, ListsWhatIsThereWithoutOpeningIt) {
  Registry registry;
  registry.add_folder(kRegistryFolder);
  const auto names = registry.available();
  EXPECT_TRUE(std::find(names.begin(), names.end(), "flushes_to_zero") != names.end());
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  EXPECT_TRUE(registry.opened().empty());
}

}  // namespace
