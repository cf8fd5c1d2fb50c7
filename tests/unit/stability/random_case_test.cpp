// SPDX-License-Identifier: BSD-3-Clause
#include "tests/stability/suite/random_case.hpp"

#include "tests/unit/io/formats/toml/scratch.hpp"

namespace netloft::hard_cases {

using namespace formats;
using namespace scenes;

namespace {

using formats::test::Input;

constexpr const char* kVary =
    "across = { whole = [30, 33] }\n"
    "bar = { from = -1, to = 2 }\n"
    "EA = { from = 1e3, to = 1e6, log = true }\n"
    "type = { one_of = [\"priour/triangle\", \"lumped/net\"] }\n";

RandomTexts random_with(std::uint64_t number) {
  Input input(kVary);
  scenes::Dice dice("panel", number);
  RandomTexts random = random_texts(input.reader, dice);
  EXPECT_EQ(input.error(), "");
  return random;
}

// The first outputs of SplitMix64 for the seed 1234567, as published with the generator by S. Vigna.
TEST(Dice, IsSplitMix64) {
  scenes::Dice dice(1234567);
  EXPECT_EQ(dice.next(), 6457827717110365317u);
  EXPECT_EQ(dice.next(), 3203168211198807973u);
  EXPECT_EQ(dice.next(), 9817491932198370423u);
}

TEST(RandomCase, KeepsToItsRanges) {
  std::size_t lumped = 0;
  double least = 1e9, most = 0;
  for (std::uint64_t n = 0; n < 200; ++n) {
    const RandomTexts d = random_with(n);
    EXPECT_TRUE(d.at("across") >= "30" && d.at("across") <= "33");
    EXPECT_TRUE(std::stod(d.at("bar")) >= -1 && std::stod(d.at("bar")) <= 2);
    least = std::min(least, std::stod(d.at("EA"))), most = std::max(most, std::stod(d.at("EA")));
    lumped += d.at("type") == "lumped/net";
  }
  EXPECT_TRUE(least >= 1e3 && most <= 1e6);
  EXPECT_LT(least, 1.3e3);  // of 200, uniform in the logarithm
  EXPECT_GT(most, 0.77e6);
  EXPECT_TRUE(lumped > 50 && lumped < 150);
}

TEST(RandomCase, IsTheSameForTheSameNumberAndAnotherForAnother) {
  EXPECT_EQ(random_with(3), random_with(3));
  EXPECT_NE(random_with(3), random_with(4));
}

TEST(RandomCase, FillsNamesInAndTakesTheLongerOneFirst) {
  Input input("set = [\"a=$wide\", \"b=[$wide_aft,$wide]\"]\nstart = [{ noise = \"$wide m\" }]");
  formats::Value value = input.document.root();
  fill_in(value, {{"wide", "1.5"}, {"wide_aft", "2.5"}});
  formats::TableReader reader(value, input.diagnostics);
  EXPECT_EQ(reader.texts("set", {}), (std::vector<std::string>{"a=1.5", "b=[2.5,1.5]"}));
  EXPECT_EQ(reader.tables("start")[0].real("noise", {.unit = "m"}), 1.5);
}

}  // namespace
}  // namespace netloft::hard_cases
