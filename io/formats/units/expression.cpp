// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/units/expression.hpp"

#include <cmath>

namespace netloft::formats {
namespace {

constexpr int kDeepestParenthesis = 16;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_word(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '%'; }

Unit raised(Unit unit, int power) {
  for (auto& [base, exponent] : unit.dimension) exponent *= power;
  unit.scale = std::pow(unit.scale, power);
  return unit;
}

/// Multiplies two units. In a product, a degree Celsius is a temperature difference, so that W/(m2.degC) has
/// no offset.
Unit product(Unit a, const Unit& b) {
  for (const auto& [base, exponent] : b.dimension) a.dimension[base] += exponent;
  std::erase_if(a.dimension, [](const auto& entry) { return entry.second == 0; });
  return {std::move(a.dimension), a.scale * b.scale, 0};
}

class ExpressionReader {
 public:
  ExpressionReader(const UnitSystem& system, std::string_view text) : system_(system), rest_(text) {}

  ParsedUnit read() {
    std::optional<Unit> unit = read_product(0);
    if (!rest_.empty()) unit.reset();
    return {std::move(unit), std::move(unknown_)};
  }

 private:
  std::optional<Unit> read_product(int depth) {
    std::optional<Unit> unit = Unit{};
    bool first = true;
    if (rest_.starts_with("1/") || rest_.starts_with("1 /")) rest_.remove_prefix(1);
    for (skip_spaces(); unit && !rest_.empty() && rest_.front() != ')'; skip_spaces()) {
      const bool inverse = take('/');
      if (!inverse && !first && !take('.')) take('*');
      skip_spaces();
      const std::optional<Unit> factor = read_factor(depth);
      if (!factor) return std::nullopt;
      unit = first && !inverse ? *factor : product(*unit, raised(*factor, inverse ? -1 : 1));
      first = false;
    }
    return unit;
  }

  std::optional<Unit> read_factor(int depth) {
    const bool nested = take('(');
    std::optional<Unit> unit;
    if (!nested) unit = read_word();
    if (nested && depth < kDeepestParenthesis) unit = read_product(depth + 1);
    if (nested && !take(')')) return std::nullopt;
    return unit ? read_power(*unit) : std::nullopt;
  }

  std::optional<Unit> read_word() {
    std::size_t length = 0;
    while (length < rest_.size() && is_word(rest_[length])) ++length;
    if (length == 0) return std::nullopt;
    const std::string word(rest_.substr(0, length));
    rest_.remove_prefix(length);
    std::optional<Unit> unit = system_.parse(word);
    if (!unit) unknown_ = word;
    return unit;
  }

  std::optional<Unit> read_power(const Unit& unit) {
    const bool marked = take('^') || (rest_.starts_with("**") && take('*') && take('*'));
    const bool negative = take('-');
    const bool is_signed = negative || take('+');
    if (rest_.empty() || !is_digit(rest_.front()))
      return marked || is_signed ? std::nullopt : std::optional(unit);
    const int power = rest_.front() - '0';
    rest_.remove_prefix(1);
    if (power == 0 || (!rest_.empty() && is_digit(rest_.front()))) return std::nullopt;
    return power == 1 && !negative ? unit : product(raised(unit, negative ? -power : power), {});
  }

  bool take(char c) {
    if (!rest_.starts_with(c)) return false;
    rest_.remove_prefix(1);
    return true;
  }

  void skip_spaces() {
    while (take(' ') || take('\t')) continue;
  }

  const UnitSystem& system_;
  std::string_view rest_;
  std::string unknown_;
};

}  // namespace

ParsedUnit parse_unit(const UnitSystem& system, std::string_view text) {
  return ExpressionReader(system, text).read();
}

}  // namespace netloft::formats
