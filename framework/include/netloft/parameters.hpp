// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/plugin.h>

#include <algorithm>
#include <cstring>
#include <deque>
#include <initializer_list>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace netloft {

/// The effect of a real parameter. Strategies use it to find parameters whose change makes a scene easier to
/// solve.
enum class Role : std::uint32_t {
  plain = 0,
  stiffness = NETLOFT_STIFFNESS,      // elastic forces are proportional to the parameter
  compression = NETLOFT_COMPRESSION,  // stiffness of slack twines and ropes
  damping = NETLOFT_DAMPING,          // tension per strain rate
};

/// Range and default of a real parameter. If there is no default, users must give a value.
struct Real {
  double lo = -std::numeric_limits<double>::infinity();
  double hi = std::numeric_limits<double>::infinity();
  double fallback = std::numeric_limits<double>::quiet_NaN();
  // If this is the name of an earlier parameter of the table, the default is the value of that parameter
  // times `fallback`.
  const char* fallback_of = nullptr;
  Role role = Role::plain;
};

/// The parameter table of one component (element, law, solver …): binds names in a scene to members of the
/// struct P. Name, unit, range, default and description are given here and nowhere else.
template <class P>
class ParameterTable {
 public:
  void real(const char* name, double P::*member, const char* unit, const char* doc, Real range) {
    auto& p = add(NETLOFT_REAL, name, offset(member), unit, doc);
    p.lo = range.lo;
    p.hi = range.hi;
    p.fallback_of = range.fallback_of;
    p.flags |= static_cast<std::uint32_t>(range.role);
    set_fallback(p, range.fallback, range.fallback != range.fallback);
  }
  void integer(const char* name, std::int64_t P::*member, const char* doc, std::int64_t lo, std::int64_t hi,
               std::int64_t fallback) {
    auto& p = add(NETLOFT_INTEGER, name, offset(member), "1", doc);
    p.lo = static_cast<double>(lo);
    p.hi = static_cast<double>(hi);
    set_fallback(p, static_cast<double>(fallback), false);
  }
  void boolean(const char* name, bool P::*member, const char* doc, bool fallback) {
    set_fallback(add(NETLOFT_BOOLEAN, name, offset(member), "1", doc), fallback ? 1 : 0, false);
  }
  /// A parameter whose value is one of several words; the member is the index of the word. The first word is
  /// the default.
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

  /// A parameter that is a sampled curve with named columns; the first column increases. Empty if not given.
  void table(const char* name, netloft_table P::*member, const char* doc,
             std::initializer_list<std::pair<const char*, const char*>> columns, bool required = false) {
    auto& p = add(NETLOFT_TABLE, name, offset(member), "1", doc);
    auto& names = choices_.emplace_back();
    auto& units = choices_.emplace_back();
    for (const auto& [column, unit] : columns) {
      names.push_back(column);
      units.push_back(unit);
    }
    names.push_back(nullptr);
    units.push_back(nullptr);
    p.columns = names.data();
    p.column_units = units.data();
    if (required) p.flags |= NETLOFT_REQUIRED;
  }
  /// A parameter that is a table of samples on a grid of two arguments, the first two columns; empty if not
  /// given.
  void grid(const char* name, netloft_table P::*member, const char* doc,
            std::initializer_list<std::pair<const char*, const char*>> columns, bool required = false) {
    table(name, member, doc, columns, required);
    rows_.back().arguments = 2;
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
    p.size = sizeof p;
    p.kind = kind;
    p.name = name;
    p.unit = unit;
    p.doc = doc;
    p.offset = offset;
    return rows_.emplace_back(p);
  }
  static void set_fallback(netloft_parameter& p, double fallback, bool required) {
    p.fallback = required ? 0 : fallback;
    if (required) p.flags |= NETLOFT_REQUIRED;
  }

  std::vector<netloft_parameter> rows_;
  std::deque<std::vector<const char*>> choices_;
};

namespace detail {

/// Bytes of a parameter struct that a row of its table declares.
struct DeclaredBytes {
  std::uint32_t offset, count;
  bool operator==(const DeclaredBytes&) const = default;
};

inline std::uint32_t bytes_of_kind(std::uint32_t kind) {
  return kind == NETLOFT_BOOLEAN ? sizeof(bool) : kind == NETLOFT_TABLE ? sizeof(netloft_table) : 8;
}

/// The parameters of component C as its functions receive them: members that the table declares have the
/// host's values, all others the defaults of the struct. (The host knows only the members in the table and
/// leaves the others zero. Several plugins may share a struct, and each may declare only some of its
/// members.)
template <class C>
class OwnParameters {
 public:
  using Parameters = typename C::Parameters;
  static_assert(std::is_trivially_copyable_v<Parameters>, "Parameters must be plain numbers");

  /// Stores which members are declared. Must be called with the complete table before components are created.
  static void declare(const std::vector<netloft_parameter>& rows) {
    std::vector<DeclaredBytes> declared;
    for (const auto& row : rows) declared.push_back({row.offset, bytes_of_kind(row.kind)});
    std::sort(declared.begin(), declared.end(), [](auto& a, auto& b) { return a.offset < b.offset; });
    if (is_known_ && declared != declared_)
      throw std::logic_error("one struct is described by two tables with different parameters");
    declared_ = std::move(declared);
    is_known_ = true;
  }
  /// Returns the parameters. A struct that no table describes is returned unchanged, because the author's own
  /// code has filled it.
  static Parameters from(const void* host) {
    if (!is_known_) return *static_cast<const Parameters*>(host);
    Parameters own{};
    for (const auto& d : declared_)
      std::memcpy(reinterpret_cast<char*>(&own) + d.offset, static_cast<const char*>(host) + d.offset,
                  d.count);
    return own;
  }

 private:
  static inline std::vector<DeclaredBytes> declared_;
  static inline bool is_known_ = false;
};

}  // namespace detail

}  // namespace netloft
