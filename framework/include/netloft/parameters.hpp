// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/plugin.h>

#include <deque>
#include <initializer_list>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace netloft {

/// The meaning of a real parameter for strategies that make a scene easier.
enum class Role : std::uint32_t {
  plain = 0,
  stiffness = NETLOFT_STIFFNESS,      // elastic forces grow in proportion to it
  compression = NETLOFT_COMPRESSION,  // stiffness of slack twines and ropes
  damping = NETLOFT_DAMPING,          // tension per strain rate
};

/// Range and default of a real parameter. Without a default the user must give a value.
struct Real {
  double lo = -std::numeric_limits<double>::infinity();
  double hi = std::numeric_limits<double>::infinity();
  double fallback = std::numeric_limits<double>::quiet_NaN();
  const char* fallback_of = nullptr;  // name of an earlier parameter: `fallback` is a factor on it
  Role role = Role::plain;
};

/// The parameter table of one element or solver: binds names in a scene to members of the struct P. Name,
/// unit, range, default and description are given here and nowhere else.
template <class P>
class ParameterTable {
 public:
  void real(const char* name, double P::*member, const char* unit, const char* doc, Real range) {
    auto& p = add(NETLOFT_REAL, name, offset(member), unit, doc);
    p.lo = range.lo, p.hi = range.hi, p.fallback_of = range.fallback_of;
    p.flags |= static_cast<std::uint32_t>(range.role);
    set_fallback(p, range.fallback, range.fallback != range.fallback);
  }
  void integer(const char* name, std::int64_t P::*member, const char* doc, std::int64_t lo, std::int64_t hi,
               std::int64_t fallback) {
    auto& p = add(NETLOFT_INTEGER, name, offset(member), "1", doc);
    p.lo = static_cast<double>(lo), p.hi = static_cast<double>(hi);
    set_fallback(p, static_cast<double>(fallback), false);
  }
  void boolean(const char* name, bool P::*member, const char* doc, bool fallback) {
    set_fallback(add(NETLOFT_BOOLEAN, name, offset(member), "1", doc), fallback ? 1 : 0, false);
  }
  /// One of several words; the member is its index in the list. The first word is the default.
  void choice(const char* name, std::int64_t P::*member, const char* doc,
              std::initializer_list<const char*> words) {
    auto& p = add(NETLOFT_CHOICE, name, offset(member), "1", doc);
    auto& list = choices_.emplace_back(words);
    list.push_back(nullptr);
    p.choices = list.data();
    p.hi = static_cast<double>(words.size() - 1);
  }
  void text(const char* name, const char* P::*member, const char* doc, const char* fallback) {
    auto& p = add(NETLOFT_TEXT, name, offset(member), "1", doc);
    p.fallback_text = fallback;
    if (!fallback) p.flags |= NETLOFT_REQUIRED;
  }

  /// A sampled curve with named columns, the first increasing; empty if not given.
  void table(const char* name, netloft_table P::*member, const char* doc,
             std::initializer_list<std::pair<const char*, const char*>> columns, bool required = false) {
    auto& p = add(NETLOFT_TABLE, name, offset(member), "1", doc);
    auto& names = choices_.emplace_back();
    auto& units = choices_.emplace_back();
    for (const auto& [column, unit] : columns) names.push_back(column), units.push_back(unit);
    names.push_back(nullptr), units.push_back(nullptr);
    p.columns = names.data(), p.column_units = units.data();
    if (required) p.flags |= NETLOFT_REQUIRED;
  }

  const std::vector<netloft_parameter>& rows() const { return rows_; }

 private:
  template <class M>
  static std::uint32_t offset(M P::*member) {
    static const P object{};
    return static_cast<std::uint32_t>(reinterpret_cast<const char*>(&(object.*member)) -
                                      reinterpret_cast<const char*>(&object));
  }
  netloft_parameter& add(std::uint32_t kind, const char* name, std::uint32_t offset, const char* unit,
                         const char* doc) {
    netloft_parameter p{};
    p.size = sizeof p, p.kind = kind, p.name = name, p.unit = unit, p.doc = doc, p.offset = offset;
    return rows_.emplace_back(p);
  }
  static void set_fallback(netloft_parameter& p, double fallback, bool required) {
    p.fallback = required ? 0 : fallback;
    if (required) p.flags |= NETLOFT_REQUIRED;
  }

  std::vector<netloft_parameter> rows_;
  std::deque<std::vector<const char*>> choices_;
};

}  // namespace netloft
