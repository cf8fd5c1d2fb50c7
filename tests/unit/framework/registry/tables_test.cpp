// SPDX-License-Identifier: BSD-3-Clause
//
// Impossible numbers in the tables of a plugin, as memory corruption may produce them.
#include "framework/registry/descriptors.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <string_view>

namespace netloft {
namespace {

netloft_law law() {
  netloft_law l{};
  l.size = sizeof l, l.kind = NETLOFT_TWINE_LAW, l.name = "law", l.doc = "a law";
  l.evaluate = [](const void*, const netloft_law_tile*) -> int { return NETLOFT_OK; };
  return l;
}

netloft_plugin plugin() {
  netloft_plugin p{};
  p.size = sizeof p, p.abi_major = NETLOFT_ABI_MAJOR, p.abi_minor = NETLOFT_ABI_MINOR;
  p.name = "made";
  return p;
}

/// The laws that the plugin of a test offers. The variable is global because a C function must return it.
netloft_laws offered{};

std::string refusal(const netloft_plugin& p) {
  try {
    read_plugin(&p, "made.so", "made");
    return "";
  } catch (const PluginRefused& refused) {
    return refused.what();
  }
}

/// The message about a plugin with only this law.
std::string refusal(const netloft_law* laws, std::uint32_t count) {
  offered = {sizeof offered, count, laws};
  netloft_plugin p = plugin();
  p.extension = [](const char* id) -> const void* {
    return std::string_view(id) == NETLOFT_EXT_LAWS ? &offered : nullptr;
  };
  return refusal(p);
}

TEST(Tables, OfOneRowAreTaken) {
  const netloft_law one = law();
  EXPECT_EQ(refusal(&one, 1), "");
}

TEST(Tables, LongerThanAnyTableAreRefusedWithoutReadingThem) {
  const netloft_law one = law();
  EXPECT_EQ(refusal(&one, 4000000000u),
            "made.so: has a table of 4000000000 rows; build the plugin again, or look for what wrote over "
            "its tables");
}

TEST(Tables, ThatAreNullAreRefused) {
  EXPECT_NE(refusal(nullptr, 2).find("has a table of 2 rows that is null"), std::string::npos);
}

TEST(Tables, WithRowsTooShortForASizeAreRefused) {
  netloft_law one = law();
  one.size = 0;
  EXPECT_NE(refusal(&one, 2).find("has a table whose rows are 0 bytes long"), std::string::npos);
}

// The size of a row must not end within a pointer. Found by table_fuzzer.
TEST(Tables, WithRowsThatEndWithinAPointerAreRefused) {
  netloft_law one = law();
  one.size = offsetof(netloft_law, parameters) + 4;
  EXPECT_NE(refusal(&one, 1).find("bytes long"), std::string::npos);
}

TEST(Tables, HaveRowsAsLongAsTheFirst) {
  netloft_law two[2] = {law(), law()};
  two[1].name = "second";
  EXPECT_EQ(refusal(two, 2), "");
  two[1].size = sizeof two[1] + 8;
  EXPECT_NE(refusal(two, 2).find("rows are not equally long"), std::string::npos);
}

TEST(Extensions, ThatAPluginNeedsAndTheProgramHasNotAreNamed) {
  const char* const required[] = {NETLOFT_EXT_LAWS, "netloft.ice/1", nullptr};
  netloft_plugin p = plugin();
  p.required = required;
  EXPECT_EQ(refusal(p),
            "made.so: needs the extension \"netloft.ice/1\" of the plugin interface, which this program does "
            "not have; update the program");
}

TEST(Extensions, ThatThrowAreAFault) {
  netloft_plugin p = plugin();
  p.extension = [](const char*) -> const void* { throw 1; };
  EXPECT_NE(refusal(p).find("made: its function `extension` throws"), std::string::npos);
}

/// The message about an element with one term, which has these traits and inputs.
std::string refusal(std::uint32_t traits, const char* const* inputs) {
  netloft_term t{};
  t.size = sizeof t, t.name = "term", t.doc = "a term", t.traits = traits;
  t.evaluate = [](const void*, netloft_tile*) -> int { return NETLOFT_OK; };
  netloft_element e{};
  e.size = sizeof e, e.stencil = NETLOFT_NODE, e.name = "one", e.doc = "an element";
  e.terms = &t, e.term_count = 1, e.inputs = inputs;
  e.create = [](netloft_create*, void**) -> int { return NETLOFT_OK; };
  e.destroy = [](void*) {};
  netloft_plugin p = plugin();
  p.elements = &e, p.element_count = 1;
  return refusal(p);
}

TEST(Inputs, ThatATermReadsAreListedByItsElement) {
  const char* const others[] = {NETLOFT_EXT_GROUND, nullptr};
  const char* const waves[] = {"netloft.ice/1", NETLOFT_EXT_WAVES, nullptr};
  EXPECT_NE(refusal(NETLOFT_READS_WAVES, nullptr).find("which the element does not list"), std::string::npos);
  EXPECT_NE(refusal(NETLOFT_READS_WAVES, others).find("\"netloft.waves/1\""), std::string::npos);
  EXPECT_EQ(refusal(NETLOFT_READS_WAVES, waves), "");
}

TEST(Inputs, KeepTheirPlacesAndAreNullWhereThereAreNone) {
  const double acceleration[3 * NETLOFT_LANES] = {};
  const ExtensionInput listed[] = {ExtensionInput::none, ExtensionInput::waves, ExtensionInput::ground};
  ExtensionInputs inputs;
  inputs.waves.acceleration = acceleration;
  netloft_tile t{};
  inputs.hand_to(t, listed);
  EXPECT_EQ(t.inputs[0], nullptr) << "an identifier that this program does not know";
  EXPECT_EQ(t.inputs[1], &inputs.waves);
  EXPECT_EQ(t.inputs[2], nullptr) << "no bed, no ground that passes";
  inputs.hand_to(t, {});
  EXPECT_EQ(t.inputs, nullptr);
}

}  // namespace
}  // namespace netloft
