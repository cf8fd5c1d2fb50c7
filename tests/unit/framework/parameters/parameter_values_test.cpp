// SPDX-License-Identifier: BSD-3-Clause
#include "framework/parameters/parameter_values.hpp"

#include <netloft/parameters.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using netloft::ParameterBlock;
using netloft::Values;

struct Twine {
  double EA = 0, EA_compression = 0, unbounded = 0;
  std::int64_t strands = 0, material = 0;
  bool knotted = false;
  const char* colour = nullptr;
  const char* maker = nullptr;
};

/// The table of a plugin's author, with one parameter of every kind.
const std::vector<netloft_parameter>& table() {
  static const netloft::ParameterTable<Twine> rows = [] {
    netloft::ParameterTable<Twine> t;
    t.real("EA", &Twine::EA, "N", "axial stiffness", {.lo = 0, .hi = 1e9});
    t.real("EA_compression", &Twine::EA_compression, "N", "stiffness when slack",
           {.lo = 0, .hi = 1e9, .fallback = 1e-4, .fallback_of = "EA"});
    t.real("unbounded", &Twine::unbounded, "m", "anything", {.fallback = 3});
    t.integer("strands", &Twine::strands, "strands in the twine", 1, 16, 3);
    t.choice("material", &Twine::material, "what it is made of", {"nylon", "polyethylene", "dyneema"});
    t.boolean("knotted", &Twine::knotted, "whether meshes are knotted", true);
    t.text("colour", &Twine::colour, "what it looks like", "green");
    t.text("maker", &Twine::maker, "who made it", nullptr);
    return t;
  }();
  return rows.rows();
}

const netloft_parameter& row(const std::string& name) {
  for (const auto& p : table())
    if (name == p.name) return p;
  throw std::out_of_range(name);
}

struct Filled {
  explicit Filled(const Values& values) : block(table(), sizeof(Twine), values, faults) {}
  const Twine& twine() const { return *static_cast<const Twine*>(block.data()); }
  std::vector<std::string> faults;
  ParameterBlock block;
};

Values with(Values more) {
  more.insert({{"EA", 1e4}, {"maker", std::string("us")}});
  return more;
}

/// The message about these values, which must have exactly one error.
std::string fault(const Values& more) {
  const Filled f(with(more));
  EXPECT_EQ(f.faults.size(), 1u);
  return f.faults.empty() ? "" : f.faults.front();
}

TEST(Parameters, TakeTheirDefaultsWhenNothingIsSaid) {
  const Filled f(with({}));
  ASSERT_TRUE(f.faults.empty()) << f.faults.front();
  EXPECT_EQ(f.twine().unbounded, 3);
  EXPECT_EQ(f.twine().strands, 3);
  EXPECT_EQ(f.twine().material, 0);
  EXPECT_TRUE(f.twine().knotted);
  EXPECT_STREQ(f.twine().colour, "green");
}

TEST(Parameters, TakeWhatIsSaid) {
  const Filled f(with({{"EA_compression", 5.0},
                       {"strands", std::int64_t{4}},
                       {"material", std::string("dyneema")},
                       {"knotted", false},
                       {"colour", std::string("orange")}}));
  ASSERT_TRUE(f.faults.empty()) << f.faults.front();
  EXPECT_EQ(f.twine().EA, 1e4);
  EXPECT_EQ(f.twine().EA_compression, 5);
  EXPECT_EQ(f.twine().strands, 4);
  EXPECT_EQ(f.twine().material, 2);
  EXPECT_FALSE(f.twine().knotted);
  EXPECT_STREQ(f.twine().colour, "orange");
  EXPECT_STREQ(f.twine().maker, "us");
}

TEST(Parameters, MayDefaultToAFactorOnAnother) {
  EXPECT_EQ(Filled(with({})).twine().EA_compression, 1e-4 * 1e4);
  EXPECT_EQ(netloft::default_of(row("EA_compression")), "0.0001 x EA");
}

TEST(Parameters, OwnTheirTexts) {
  Values values = with({{"colour", std::string("a colour with a long name, beyond any small buffer")}});
  const Filled f(values);
  values.clear();
  EXPECT_STREQ(f.twine().colour, "a colour with a long name, beyond any small buffer");
}

TEST(Parameters, KeepTheirTextsWhenMoved) {
  Filled f(with({}));
  const ParameterBlock moved = std::move(f.block);
  EXPECT_STREQ(static_cast<const Twine*>(moved.data())->colour, "green");
}

TEST(Parameters, AreReadBackAsNumbers) {
  const Filled f(with({{"material", std::string("polyethylene")}}));
  EXPECT_EQ(f.block.number(row("EA")), 1e4);
  EXPECT_EQ(f.block.number(row("strands")), 3);
  EXPECT_EQ(f.block.number(row("material")), 1);
  EXPECT_EQ(f.block.number(row("knotted")), 1);
}

TEST(Parameters, AreMissedWhenRequired) {
  const Filled f({});
  ASSERT_EQ(f.faults.size(), 2u);
  EXPECT_EQ(f.faults[0], "EA is missing: axial stiffness, [0, 1e+09] N");
  EXPECT_EQ(f.faults[1], "maker is missing: who made it, a text");
}

TEST(Parameters, NameValueRangeUnitAndMeaningWhenOutOfRange) {
  EXPECT_EQ(fault({{"EA_compression", -5.0}}),
            "EA_compression = -5 N is outside [0, 1e+09] N (stiffness when slack)");
  EXPECT_EQ(fault({{"strands", std::int64_t{17}}}), "strands = 17 is outside [1, 16] (strands in the twine)");
}

TEST(Parameters, IncludeBothEndsOfTheirRange) {
  for (const double end : {0.0, 1e9})
    EXPECT_TRUE(Filled(with({{"EA_compression", end}})).faults.empty()) << end;
}

TEST(Parameters, RefuseWhatIsNotFiniteEvenWithoutARange) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  for (const double wrong : {inf, -inf, std::nan("")})
    EXPECT_NE(fault({{"unbounded", wrong}}).find("unbounded = "), std::string::npos);
}

TEST(Parameters, RefuseAnotherKindOfValue) {
  EXPECT_EQ(fault({{"strands", 3.5}}), "strands must be a whole number (strands in the twine)");
  EXPECT_EQ(fault({{"knotted", std::int64_t{1}}}),
            "knotted must be true or false (whether meshes are knotted)");
  EXPECT_EQ(fault({{"colour", 1.0}}), "colour must be a text (what it looks like)");
  EXPECT_EQ(fault({{"EA_compression", std::string("much")}}),
            "EA_compression must be a number (stiffness when slack)");
}

TEST(Parameters, ListTheWordsOfAChoiceAndTheNearestOne) {
  EXPECT_EQ(fault({{"material", std::string("dynema")}}),
            "material = \"dynema\" is not one of nylon, polyethylene, dyneema; did you mean \"dyneema\"?");
  EXPECT_EQ(fault({{"material", std::string("steel")}}),
            "material = \"steel\" is not one of nylon, polyethylene, dyneema");
}

TEST(Parameters, NameTheNearestOfAnUnknownName) {
  EXPECT_EQ(fault({{"EA_compresion", 1.0}}),
            "unknown parameter \"EA_compresion\"; did you mean \"EA_compression\"?");
  EXPECT_EQ(fault({{"temperature", 1.0}}), "unknown parameter \"temperature\"");
}

TEST(Parameters, TellAllFaultsAtOnce) {
  const Filled f({{"EA", -1.0}, {"material", std::string("wood")}, {"tempo", 1.0}});
  EXPECT_EQ(f.faults.size(), 4u);  // the faults are in EA, material, the missing maker, and tempo
}

TEST(Parameters, SayWhatIsAllowedAndWhatTheDefaultIs) {
  EXPECT_EQ(netloft::allowed(row("knotted")), "true or false");
  EXPECT_EQ(netloft::allowed(row("material")), "one of nylon, polyethylene, dyneema");
  EXPECT_EQ(netloft::default_of(row("EA")), "required");
  EXPECT_EQ(netloft::default_of(row("material")), "nylon");
  EXPECT_EQ(netloft::default_of(row("knotted")), "true");
  EXPECT_EQ(netloft::default_of(row("strands")), "3");
  EXPECT_EQ(netloft::default_of(row("colour")), "green");
}

// A struct may have members that its author did not register, for instance if several elements use one
// struct.
TEST(Parameters, AreZeroWhereNothingIsRegistered) {
  constexpr std::size_t kBytes = 96;
  { const std::vector<char> used_before(kBytes, 'x'); }  // memory that the heap is likely to return next
  std::vector<std::string> faults;
  const ParameterBlock block({}, kBytes, {}, faults);
  const auto* bytes = static_cast<const char*>(block.data());
  EXPECT_TRUE(std::all_of(bytes, bytes + kBytes, [](char c) { return c == 0; }));
}

}  // namespace
