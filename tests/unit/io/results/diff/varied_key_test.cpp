// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/diff/varied_key.hpp"

#include <gtest/gtest.h>

namespace netloft::results {
namespace {

Result result_of(const std::string& scene, const std::vector<std::string>& command = {}) {
  Result result;
  result.title = "net";
  result.origins.files = {{"folder/net.toml", "", scene}};
  result.origins.command = command;
  return result;
}

VariedKey varied_among(const std::vector<Result>& results) {
  std::vector<const Result*> pointers;
  for (const auto& result : results) pointers.push_back(&result);
  return find_varied_key(pointers);
}

TEST(VariedKey, IsTheOptionOfTheCommandLinesThatDiffers) {
  const std::string scene = "[gear]\nnodes = 500\n";
  const VariedKey varied = varied_among(
      {result_of(scene, {"netloft", "run", "a.toml", "--set", "gear.nodes=500", "--set", "tow.speed=2 kn"}),
       result_of(scene, {"netloft", "run", "a.toml", "--set=tow.speed=3 kn", "--set", "gear.nodes=500"})});
  EXPECT_EQ(varied.path, "tow.speed");
  EXPECT_EQ(varied.values, (std::vector<std::string>{"2 kn", "3 kn"}));
}

TEST(VariedKey, IsTheNumberThatDiffersWhereverItIsWritten) {
  const std::string scene = "title = \"one\"  # speed = 9\n[[hold]]\nat = [1, 2]\n[tow]\nspeed = ";
  const VariedKey varied =
      varied_among({result_of(scene + "\"2.5 kn\"\n"), result_of(scene + "\"4 kn\" # fast\n"),
                    result_of(scene + "9\n", {"--set", "tow.speed=1 kn"})});
  EXPECT_EQ(varied.path, "tow.speed");
  EXPECT_EQ(varied.values, (std::vector<std::string>{"2.5 kn", "4 kn", "1 kn"}));
  EXPECT_EQ(varied.numbers, (std::vector<double>{2.5, 4, 1}));
  EXPECT_EQ(varied.unit, "kn");
}

TEST(VariedKey, IsNothingWhereTwoResultsHaveTheSameOrNoNumber) {
  EXPECT_EQ(varied_among({result_of("a.b = 1"), result_of("a.b = 2"), result_of("a.b = 2")}).path, "");
  EXPECT_EQ(varied_among({result_of("a.b = \"x\""), result_of("a.b = \"y\"")}).path, "");
  EXPECT_EQ(varied_among({result_of("a.b = 1")}).path, "");
  EXPECT_EQ(varied_among({}).path, "");
}

TEST(VariedKey, SurvivesWhatIsNoScene) {
  EXPECT_EQ(varied_among({result_of("=\n[\n"), result_of("a = 1", {"--set="})}).path, "");
  EXPECT_EQ(varied_among({Result{}, Result{}}).path, "");
}

TEST(VariedKey, NamesResultsOfOneTitle) {
  Result slow = result_of("a.b = \"2 kn\""), fast = result_of("a.b = \"3 kn\"");
  EXPECT_EQ(title_of({&slow, &fast}), "net: a.b 2 kn, 3 kn");
  fast.origins.files = slow.origins.files;
  slow.path = "results/slow.hdf";
  fast.path = "fast.hdf";
  EXPECT_EQ(title_of({&slow, &fast}), "net: slow.hdf, fast.hdf");
  fast.title = "another";
  EXPECT_EQ(title_of({&slow, &fast}), "net, another");
  EXPECT_EQ(title_of({&slow}), "net");
}

}  // namespace
}  // namespace netloft::results
