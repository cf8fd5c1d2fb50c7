// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/units/units.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <thread>
#include <vector>

#include "io/formats/units/common_words.hpp"
#include "io/formats/units/known_words.hpp"
#include "io/formats/units/udunits.hpp"

namespace netloft::formats {
namespace {

/// Expects `text` to be read exactly as `value`, which is the decimal number that a person would write.
void expect_reads(const char* text, const char* unit, double value) {
  const Quantity read = to_si(text, unit);
  EXPECT_TRUE(read.ok()) << read.error;
  EXPECT_DOUBLE_EQ(read.value, value) << text;
}

void expect_refused(const char* text, const char* unit, const std::string& error,
                    const std::string& hint = {}) {
  const Quantity read = to_si(text, unit);
  EXPECT_EQ(read.error, error);
  EXPECT_EQ(read.hint, hint);
}

TEST(Units, KeepsNumberAndUnitAsTheyAreWritten) {
  const WrittenQuantity speed = read_as_written(" 2.5 kn");
  EXPECT_TRUE(speed.ok());
  EXPECT_EQ(speed.number, 2.5);
  EXPECT_EQ(speed.unit, "kn");
  EXPECT_EQ(read_as_written("0.2").unit, "");
  EXPECT_EQ(to_si("1 m/s", speed.unit).value, 3600.0 / 1852);
  EXPECT_EQ(read_as_written("3 knn").error, to_si("3 knn", "m/s").error);
  EXPECT_EQ(read_as_written("").error, to_si("", "m").error);
  EXPECT_FALSE(read_as_written("pe-braided-4mm").ok());
}
TEST(Units, ReadsMillimetres) { expect_reads("10 mm", "m", 0.01); }
TEST(Units, ReadsMetresUnchanged) { expect_reads("34 m", "m", 34); }
TEST(Units, ReadsKilonewtons) { expect_reads("2 kN", "N", 2000); }
TEST(Units, ReadsADensity) { expect_reads("1025 kg/m3", "kg/m3", 1025); }
TEST(Units, ReadsASpeed) { expect_reads("1.5 m/s", "m/s", 1.5); }
TEST(Units, ReadsAMomentPerAngle) { expect_reads("0.001 N.m/rad", "N.m/rad", 0.001); }
TEST(Units, ReadsAMomentPerDegree) { expect_reads("1 N.m/deg", "N.m/rad", 180 / std::numbers::pi); }
TEST(Units, ReadsDegrees) { expect_reads("45 deg", "rad", std::numbers::pi / 4); }
TEST(Units, ReadsTheDegreeSign) { expect_reads("180°", "rad", std::numbers::pi); }
TEST(Units, ReadsKilogramsOfForce) { expect_reads("2000 kgf", "N", 19613.3); }
TEST(Units, ReadsMetricTonsOfForce) { expect_reads("2 tonf", "N", 19613.3); }
TEST(Units, ReadsTonnes) { expect_reads("1.2 t", "kg", 1200); }
TEST(Units, ReadsPercent) { expect_reads("5 %", "1", 0.05); }
TEST(Units, ReadsExponents) { expect_reads("1.5e-3 m", "m", 1.5e-3); }
TEST(Units, ReadsANumberThatTouchesItsUnit) { expect_reads("-5N", "N", -5); }
TEST(Units, ReadsALeadingPlus) { expect_reads("+5 N", "N", 5); }
TEST(Units, ReadsAPureNumber) { expect_reads("0.7", "1", 0.7); }
TEST(Units, ReadsInches) { expect_reads("12 in", "m", 0.3048); }
TEST(Units, ReadsFathomsAsSixInternationalFeet) { expect_reads("6 fathom", "m", 10.9728); }
TEST(Units, ReadsFathomsInThePlural) { expect_reads("6 fathoms", "m", 10.9728); }
TEST(Units, ReadsNauticalMiles) { expect_reads("2 nmi", "m", 3704); }
TEST(Units, ReadsPoundsOfMass) { expect_reads("90 lb", "kg", 90 * 0.45359237); }
TEST(Units, ReadsTex) { expect_reads("2500 Rtex", "kg/m", 2.5e-3); }
TEST(Units, ReadsSquareMillimetresWithoutASign) { expect_reads("3 mm2", "m2", 3e-6); }
TEST(Units, ReadsSquareMillimetresWithACaret) { expect_reads("3 mm^2", "m2", 3e-6); }
TEST(Units, ReadsSquareMillimetresWithASuperscript) { expect_reads("3 mm²", "m2", 3e-6); }
TEST(Units, ReadsMicrometres) { expect_reads("40 µm", "m", 4e-5); }
TEST(Units, ReadsNegativePowers) { expect_reads("1025 kg m-3", "kg/m3", 1025); }
TEST(Units, ReadsAnInverse) { expect_reads("4 1/mm", "1/m", 4000); }
TEST(Units, ReadsParentheses) { expect_reads("3 kN/(m.s)", "N/m/s", 3000); }
TEST(Units, WorksProductsOffFromTheLeft) { expect_reads("3 kg/m.s", "kg.s/m", 3); }
TEST(Units, ReadsADoubleStarAsAPower) { expect_reads("3 cm**2", "m2", 3e-4); }
TEST(Units, RefusesAPowerWithoutItsDigit) { EXPECT_FALSE(to_si("3 m^", "m").ok()); }
TEST(Units, RefusesAnOpenParenthesis) { EXPECT_FALSE(to_si("3 (m", "m").ok()); }
TEST(Units, ReadsCelsiusWithItsOffset) { expect_reads("20 degC", "K", 293.15); }
TEST(Units, ReadsFahrenheitWithItsOffset) { expect_reads("68 degF", "K", 293.15); }
TEST(Units, ReadsRevolutionsAsAnAngle) { expect_reads("60 rpm", "rad/s", 2 * std::numbers::pi); }

class Knots : public testing::TestWithParam<const char*> {};
TEST_P(Knots, AreNauticalMilesPerHour) { expect_reads(GetParam(), "m/s", 3 * 1852.0 / 3600); }
INSTANTIATE_TEST_SUITE_P(AllSpellings, Knots, testing::Values("3 kn", "3 kt", "3 kts", "3 knot", "3 knots"));

TEST(Units, ReadEveryMillimetreAsItsDecimalInMetres) {
  for (int i = 1; i <= 1000; ++i)
    EXPECT_EQ(to_si(std::to_string(i) + " mm", "m").value, std::stod(std::to_string(i) + "e-3")) << i;
}

TEST(Units, SayWhatIsThereAndWhatIsWanted) {
  expect_refused("10 kg", "m", "\"10 kg\" is a mass (kg); a length (m) is expected");
}
TEST(Units, TellHowToWriteAWeight) {
  expect_refused("10 kg", "N", "\"10 kg\" is a mass (kg); a force (N) is expected",
                 "the weight of a mass is written with kgf, tonf or lbf");
}
TEST(Units, TellAKnotFromAKilonewton) {
  expect_refused("2 kn", "N", "\"2 kn\" is a speed (m/s); a force (N) is expected",
                 "kn is the knot; the kilonewton is kN");
}
TEST(Units, DoNotTakeAKilonewtonForAKnot) {
  expect_refused("2 kN", "m/s", "\"2 kN\" is a force (N); a speed (m/s) is expected",
                 "kN is the kilonewton; the knot is kn");
}
TEST(Units, DoNotTakeAnAngleForAPureNumber) {
  expect_refused("45 deg", "1", "\"45 deg\" is an angle (rad); a pure number (1) is expected");
}
TEST(Units, DoNotTakeAMomentForAMomentPerAngle) {
  expect_refused("1 N.m", "N.m/rad", "\"1 N.m\" is a moment (N.m); a moment per angle (N.m/rad) is expected");
}
TEST(Units, AskForTheUnitOfABareText) {
  expect_refused("10", "m", "\"10\" is a pure number (1); a length (m) is expected",
                 "add a unit, or omit the quotes for an SI number");
}
TEST(Units, SpellADimensionWithoutAName) {
  expect_refused("1 kg.m/K", "m", "\"1 kg.m/K\" is a quantity (K-1.kg.m); a length (m) is expected");
}
TEST(Units, NameTheNearestKnownUnit) {
  expect_refused("10 kgs", "kg", "unit \"kgs\" in \"10 kgs\" is not known", "did you mean \"kg\"?");
}
TEST(Units, PointAtTheUnknownWordInAProduct) {
  expect_refused("10 kg/metr3", "kg/m3", "unit \"metr\" in \"10 kg/metr3\" is not known",
                 "did you mean \"metre\"?");
}
TEST(Units, KeepSilentWhenNothingIsNear) {
  expect_refused("10 bananas", "kg", "unit \"bananas\" in \"10 bananas\" is not known");
}
struct Meant {
  const char *written, *si_unit, *unit;
};
class MeantUnits : public testing::TestWithParam<Meant> {};
TEST_P(MeantUnits, AreProposedInTheDimensionThatIsWanted) {
  const auto& [written, si_unit, unit] = GetParam();
  EXPECT_EQ(to_si(written, si_unit).hint, std::string("did you mean \"") + unit + "\"?");
}
INSTANTIATE_TEST_SUITE_P(Slips, MeantUnits,
                         testing::Values(Meant{"0.9 mps", "m/s", "m/s"}, Meant{"3 kmh", "m/s", "km/h"},
                                         Meant{"3 kph", "m/s", "km/h"}, Meant{"3 fps", "m/s", "ft/s"},
                                         Meant{"3 knt", "m/s", "kn"}, Meant{"3 KTS", "m/s", "kt"},
                                         Meant{"3 KN", "m/s", "kn"}, Meant{"3 KN", "N", "kN"},
                                         Meant{"5 Nm", "N.m", "N.m"}, Meant{"80 MM", "m", "mm"},
                                         Meant{"2 Kg", "kg", "kg"}));
TEST(Units, RefuseTheMileOfManyMeanings) {
  for (const char* mile : {"2 mile", "2 miles", "2 mi"})
    EXPECT_EQ(to_si(mile, "m").hint, "write nmi (1852 m) or km");
  expect_reads("2 nautical_miles", "m", 3704);
}
TEST(Units, TellAMetrePerSecondFromAnInverseMillisecond) {
  EXPECT_EQ(to_si("3 ms-1", "m/s").hint, "ms is the millisecond; write m/s or m s-1");
}
TEST(Units, RefuseTheTonOfManyMeanings) {
  expect_refused("3 ton", "kg", "unit \"ton\" in \"3 ton\" has more than one meaning",
                 "write t (1000 kg), short_ton or long_ton");
}
TEST(Units, RefuseTheNanometreThatIsMeantAsAMile) {
  EXPECT_FALSE(to_si("3 nm", "m").ok());
  EXPECT_EQ(to_si("3 NM", "m").hint, to_si("3 nm", "m").hint);
}
TEST(Units, RefuseADecimalComma) {
  expect_refused("1,5 m", "m", "\"1,5 m\" has a decimal comma", "write a decimal point");
}
TEST(Units, RefuseAUnitWithoutANumber) {
  expect_refused("mm", "m", "\"mm\" does not begin with a number", "write it as \"10 mm\"");
  expect_refused("kN", "N", "\"kN\" does not begin with a number", "write it as \"10 N\"");
  expect_refused("much", "1", "\"much\" does not begin with a number", "write a number, such as 10");
}
TEST(Units, RefuseASecondNumber) {
  EXPECT_EQ(to_si("10 5 m", "m").error, "\"5 m\" in \"10 5 m\" cannot be read as a unit");
}
TEST(Units, RefuseBrokenSyntax) {
  expect_refused("10 m//s", "m/s", "\"m//s\" in \"10 m//s\" cannot be read as a unit",
                 "write products and powers as \"kg/m3\", \"N.m/rad\", \"m^2\"");
}
TEST(Units, RefuseAnEmptyText) { EXPECT_FALSE(to_si("  ", "m").ok()); }
TEST(Units, RefuseWhatIsNotFinite) {
  EXPECT_FALSE(to_si("nan m", "m").ok());
  EXPECT_FALSE(to_si("-inf m", "m").ok());
}
TEST(Units, RefuseWhatIsTooLargeForANumber) {
  EXPECT_FALSE(to_si("1e999 m", "m").ok());
  EXPECT_FALSE(to_si("1e307 km", "m").ok());
}
TEST(Units, RefuseDates) { EXPECT_FALSE(to_si("3 days since 2020-01-01", "s").ok()); }
TEST(Units, RefuseLogarithms) { EXPECT_FALSE(to_si("3 lg(re 1 mW)", "W").ok()); }
TEST(Units, RefuseBytesThatAreNoText) { EXPECT_FALSE(to_si(std::string_view("3 m\0\xff", 5), "m").ok()); }
TEST(Units, RefuseAnEndlessText) { EXPECT_FALSE(to_si(std::string(1 << 20, '('), "m").ok()); }
TEST(Units, SurviveTheDeepestNestingThatIsLetThrough) {
  EXPECT_FALSE(to_si("1 " + std::string(190, '('), "m").ok());
}

TEST(Units, SayWhichDatabaseIsMissing) {
  const UnitSystem none("/nowhere/udunits2.xml");
  EXPECT_EQ(none.trouble(), "the unit database /nowhere/udunits2.xml of UDUNITS-2 cannot be opened");
}
TEST(Units, KnowNothingWithoutADatabase) {
  const UnitSystem none("/nowhere/udunits2.xml");
  EXPECT_FALSE(none.parse("m"));
}
TEST(Units, AreTheSameByWordsKnownAndByTheDatabase) {
  const UnitSystem database;
  for (const char* word : kCommonWords) {
    const auto unit = database.parse(word);
    ASSERT_TRUE(unit && known_words().contains(word)) << word;
    const Unit& known = known_words().at(word);
    EXPECT_EQ(known.dimension, unit->dimension) << word;
    EXPECT_EQ(known.scale, unit->scale) << word;
    EXPECT_EQ(known.offset, unit->offset) << word;
  }
}
TEST(Units, MayBeReadFromSeveralThreads) {
  std::vector<std::thread> threads;
  std::vector<double> sums(4, 0);
  for (double& sum : sums)
    threads.emplace_back([&sum] {
      for (int i = 0; i < 200; ++i) sum += to_si("10 mm", "m").value;
    });
  for (std::thread& thread : threads) thread.join();
  for (const double sum : sums) EXPECT_NEAR(sum, 2.0, 1e-12);
}

TEST(Units, NameADimensionWithItsArticle) { EXPECT_EQ(dimension_name("N/m"), "a stiffness"); }
TEST(Units, CallAnUnnamedDimensionAValue) { EXPECT_EQ(dimension_name("kg.m/K"), "a value"); }

TEST(Format, WritesTheShortestDecimal) { EXPECT_EQ(format(0.1, "m"), "0.1 m"); }
TEST(Format, WritesExponentsAsPeopleDo) {
  EXPECT_EQ(format(1e9), "1e9");
  EXPECT_EQ(format(1e-5), "1e-5");
  EXPECT_EQ(format(1.5e100), "1.5e100");
}
TEST(Format, LeavesThePureNumberBare) { EXPECT_EQ(format(2, "1"), "2"); }

}  // namespace
}  // namespace netloft::formats
