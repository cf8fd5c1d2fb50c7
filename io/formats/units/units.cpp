// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/units/units.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "framework/parameters/nearest.hpp"
#include "io/formats/units/common_words.hpp"
#include "io/formats/units/expression.hpp"
#include "io/formats/units/in_quotes.hpp"
#include "io/formats/units/udunits.hpp"

namespace netloft::formats {
namespace {

constexpr std::size_t kLongestText = 200;

bool is_decimal_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_space(char c) { return c == ' ' || c == '\t'; }

Quantity refuse(std::string error, std::string hint = {}) { return {0, std::move(error), std::move(hint)}; }

std::string_view trim(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

/// Replaces typographic signs by their ASCII spelling in UDUNITS, which receives only ASCII.
std::string in_ascii(std::string_view text) {
  constexpr std::pair<std::string_view, std::string_view> kSigns[] = {
      {"°C", "degC"}, {"°", "deg"}, {"µ", "u"}, {"μ", "u"}, {"²", "2"},     {"³", "3"},
      {"·", "."},     {"⋅", "."},   {"−", "-"}, {"×", "."}, {"\u00a0", " "}};
  std::string result(text);
  for (const auto& [sign, ascii] : kSigns)
    for (std::size_t at = 0; (at = result.find(sign, at)) != std::string::npos; at += ascii.size())
      result.replace(at, sign.size(), ascii);
  return result;
}

struct Written {
  double number = 0;
  std::string unit;
};

/// Splits `text` into a number and the unit after it. Returns an error if the text does not begin with a
/// finite number.
Quantity split(std::string_view text, const std::string& example, Written& out) {
  std::string_view rest = text;
  if (rest.starts_with('+') && !rest.starts_with("+-")) rest.remove_prefix(1);
  const auto [end, code] = std::from_chars(rest.data(), rest.data() + rest.size(), out.number);
  if (code == std::errc::result_out_of_range)
    return refuse(in_quotes(text) + " exceeds the range of floating-point numbers");
  if (code != std::errc()) return refuse(in_quotes(text) + " does not begin with a number", example);
  if (!std::isfinite(out.number)) return refuse(in_quotes(text) + " is not a finite number");
  out.unit = trim(rest.substr(static_cast<std::size_t>(end - rest.data())));
  const bool comma = out.unit.size() > 1 && out.unit[0] == ',' && is_decimal_digit(out.unit[1]);
  if (comma) return refuse(in_quotes(text) + " has a decimal comma", "write a decimal point");
  return {};
}

/// The hint for a word that has another meaning at sea than in UDUNITS; empty for other words.
std::string ambiguity(const std::string& word) {
  std::string lower(word.size(), ' ');
  std::transform(word.begin(), word.end(), lower.begin(), detail::lower);
  if (lower == "ton" || lower == "tons") return "write t (1000 kg), short_ton or long_ton";
  if (lower == "ton_force" || lower == "tons_force" || lower == "force_ton") return "write tonf (1000 kgf)";
  if (word == "nm" || word == "NM") return "write nmi for nautical miles, mm or m for short lengths";
  if (lower == "mile" || lower == "miles" || lower == "mi") return "write nmi (1852 m) or km";
  if (word == "fm") return "write fathom, or m for a length in metres";
  return {};
}

std::vector<std::string> words_of(const std::string& unit) {
  std::vector<std::string> words;
  bool inside = false;
  for (const char c : unit) {
    const bool letter = is_letter(c) || c == '%';
    if (letter && !inside) words.emplace_back();
    if (letter) words.back() += c;
    inside = letter;
  }
  return words;
}

const std::vector<std::string>& common_units() {
  static const std::vector<std::string> units = [] {
    std::vector<std::string> all{"N.m", "ft/s", "m/s", "km/h"};
    all.insert(all.end(), std::begin(kCommonWords), std::end(kCommonWords));
    return all;
  }();
  return units;
}

std::string named(const Dimension& dimension, std::string_view unit) {
  return describe(dimension).name + " (" + std::string(unit) + ')';
}

/// Multiplies a number by the scale of a unit. If this scale is the inverse of an integer, as for mm, the
/// number is divided by the integer, which rounds once. A multiplication by 0.001 would round twice: for 144
/// of the integers from 1 to 1000, among them 35 in "35 mm", the result would be wrong.
double times(double number, double scale) {
  const double inverse = std::round(1 / scale);
  const bool divides = std::abs(scale) < 1 && std::abs(inverse * scale - 1) < 4e-16 && inverse <= 1e15;
  return divides ? number / inverse : number * scale;
}

/// A product of units in the shared system, and the name of its dimension with its article.
struct KnownUnit {
  ParsedUnit parsed;
  std::string name;
};

/// The unit that a text names. Scenes read few units many times, so the results are stored.
const KnownUnit& unit_of(std::string_view text) {
  constexpr std::size_t kMostKept = 1000;
  thread_local std::map<std::string, KnownUnit, std::less<>> kept;
  if (const auto known = kept.find(text); known != kept.end()) return known->second;
  if (kept.size() == kMostKept) kept.clear();
  KnownUnit unit{parse_unit(UnitSystem::shared(), text), "a value"};
  if (unit.parsed.unit) unit.name = describe(unit.parsed.unit->dimension).name;
  return kept.emplace(text, std::move(unit)).first->second;
}

const KnownUnit& wanted_unit(std::string_view si_unit) { return unit_of(si_unit == "1" ? "" : si_unit); }

/// Passed as the wanted unit if a text may have any unit.
constexpr std::string_view kAnyUnit = "?";

/// `si_unit` and the common units with its dimension; all common units for kAnyUnit.
std::vector<std::string> units_like(std::string_view si_unit) {
  std::vector<std::string> like = common_units();
  const std::optional<Unit> wanted = wanted_unit(si_unit).parsed.unit;
  if (!wanted) return like;
  std::erase_if(like, [&](const std::string& unit) {
    const std::optional<Unit>& parsed = unit_of(unit).parsed.unit;
    return !parsed || parsed->dimension != wanted->dimension;
  });
  like.emplace_back(si_unit);
  return like;
}

/// A hint with the candidate that `unit` most likely means. If no candidate is similar, a p between two
/// letters is read as "per": "kph" as "km/h". Empty if this does not help either.
std::string proposal(std::string unit, const std::vector<std::string>& candidates) {
  auto near = nearest(unit, candidates);
  const auto per = unit.find('p', 1);
  if (!near && per != std::string::npos && per + 1 < unit.size())
    near = nearest(unit.replace(per, 1, "/"), candidates);
  return near ? "did you mean " + in_quotes(*near) + "?" : "";
}

/// Refuses a quantity because `word`, a part of its unit, is not known; an empty word means that the unit
/// cannot be divided into words. If the word is the whole unit, the hint proposes units of the wanted
/// dimension. If it is a factor in a product, the hint proposes any units.
Quantity refuse_unknown(std::string_view text, const std::string& unit, std::string word,
                        std::string_view si_unit) {
  if (word.empty())
    return refuse(in_quotes(unit) + " in " + in_quotes(text) + " cannot be read as a unit",
                  "write products and powers as \"kg/m3\", \"N.m/rad\", \"m^2\"");
  return refuse("unit " + in_quotes(word) + " in " + in_quotes(text) + " is not known",
                proposal(word, word == unit ? units_like(si_unit) : common_units()));
}

/// The cure for common mistakes; empty if none fits.
std::string cure(const std::string& unit, const Dimension& got, const Dimension& wanted,
                 std::string_view si_unit) {
  const std::string is = describe(got).name, should = describe(wanted).name;
  if (is == "a mass" && should == "a force") return "the weight of a mass is written with kgf, tonf or lbf";
  if (is == "a force" && should == "a mass") return "kgf, tonf and lbf are forces; kg, t and lb are masses";
  if (is == "a speed" && unit == "kn") return "kn is the knot; the kilonewton is kN";
  if (should == "a speed" && unit == "kN") return "kN is the kilonewton; the knot is kn";
  if (should == "a speed" && unit == "ms-1") return "ms is the millisecond; write m/s or m s-1";
  if (is == "a pure number" && unit.empty()) return "add a unit, or omit the quotes for an SI number";
  // UDUNITS takes kph for a kilophot and knt for a kilonit. No quantity of a scene has such a dimension.
  return is == "a quantity" ? proposal(unit, units_like(si_unit)) : "";
}

/// A hint that shows how to write a quantity with this unit.
std::string example_of(std::string_view si_unit) {
  if (si_unit == "1") return "write a number, such as 10";
  const bool is_length = si_unit == "m" || si_unit == kAnyUnit;
  return "write it as \"10 " + std::string(is_length ? "mm" : si_unit) + "\"";
}

/// Splits a text into a number and a known unit; returns an error if that fails.
Quantity take_apart(const UnitSystem& units, std::string_view text, std::string_view si_unit,
                    Written& written, Unit& unit) {
  if (Quantity bad = split(in_ascii(trim(text)), example_of(si_unit), written); !bad.ok()) return bad;
  for (const std::string& word : words_of(written.unit))
    if (std::string hint = ambiguity(word); !hint.empty())
      return refuse("unit " + in_quotes(word) + " in " + in_quotes(text) + " has more than one meaning",
                    hint);
  const auto& [parsed, unknown] = unit_of(written.unit).parsed;
  if (!parsed && !units.trouble().empty()) return refuse(units.trouble());
  if (!parsed) return refuse_unknown(text, written.unit, unknown, si_unit);
  unit = *parsed;
  return {};
}

Quantity read_checked(const UnitSystem& units, std::string_view text, std::string_view si_unit) {
  Written written;
  Unit unit;
  if (Quantity bad = take_apart(units, text, si_unit, written, unit); !bad.ok()) return bad;
  const auto wanted = wanted_unit(si_unit).parsed.unit;
  if (!wanted && !units.trouble().empty()) return refuse(units.trouble());
  if (!wanted) return refuse("the requested unit " + in_quotes(si_unit) + " is not known to UDUNITS-2");
  if (unit.dimension != wanted->dimension)
    return refuse(in_quotes(text) + " is " + named(unit.dimension, describe(unit.dimension).unit) + "; " +
                      named(wanted->dimension, si_unit) + " is expected",
                  cure(written.unit, unit.dimension, wanted->dimension, si_unit));
  const double value = times(written.number + unit.offset, unit.scale) / wanted->scale - wanted->offset;
  if (!std::isfinite(value)) return refuse(in_quotes(text) + " exceeds the range of floating-point numbers");
  return {value, {}, {}};
}

Quantity refuse_length(std::string_view text) {
  if (text.size() > kLongestText)
    return refuse("a text of " + std::to_string(text.size()) + " characters is not a number with a unit");
  if (trim(text).empty()) return refuse("an empty text is not a number with a unit", "write it as \"10 mm\"");
  return {};
}

}  // namespace

Quantity to_si(std::string_view text, std::string_view si_unit) {
  if (Quantity bad = refuse_length(text); !bad.ok()) return bad;
  return read_checked(UnitSystem::shared(), text, si_unit);
}

WrittenQuantity read_as_written(std::string_view text) {
  Written written;
  Unit unit;
  Quantity read = refuse_length(text);
  if (read.ok()) read = take_apart(UnitSystem::shared(), text, kAnyUnit, written, unit);
  return {written.number, std::move(written.unit), std::move(read.error), std::move(read.hint)};
}

std::string dimension_name(std::string_view unit) {
  const std::string& name = wanted_unit(unit).name;
  return name == "a quantity" ? "a value" : name;
}

std::string format(double value) {
  std::array<char, 32> buffer;
  const auto [end, code] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  std::string text(buffer.data(), end);
  // 1e+09 and 1e-05 are written as 1e9 and 1e-5.
  if (const std::size_t e = text.find('e'); e != std::string::npos) {
    if (text[e + 1] == '+') text.erase(e + 1, 1);
    const std::size_t digits = text[e + 1] == '-' ? e + 2 : e + 1;
    if (text[digits] == '0' && digits + 1 < text.size()) text.erase(digits, 1);
  }
  return text;
}

std::string format(double value, std::string_view unit) {
  return unit.empty() || unit == "1" ? format(value) : format(value) + ' ' + std::string(unit);
}

}  // namespace netloft::formats
