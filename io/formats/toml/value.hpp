// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "io/formats/toml/diagnostics.hpp"

namespace netloft::formats {

struct Member;
struct Value;

struct Table {
  std::vector<Member> members;  // members in the order of the file
  const Member* find(std::string_view key) const;
  Member* find(std::string_view key);
  bool operator==(const Table&) const;
};

struct Array {
  std::vector<Value> items;
  bool from_headers = false;  // written as [[hold]], not as hold = [...]
  bool operator==(const Array&) const;
};

struct Date {
  std::string text;
  bool operator==(const Date&) const = default;
};

enum class Kind { table, array, text, integer, real, boolean, date };

/// A value of a file with its place. It does not depend on the parser that read it.
struct Value {
  Place place;
  std::variant<Table, Array, std::string, std::int64_t, double, bool, Date> data;  // types as in Kind

  Kind kind() const { return static_cast<Kind>(data.index()); }
  template <class T>
  const T* as() const {
    return std::get_if<T>(&data);
  }
  template <class T>
  T* as() {
    return std::get_if<T>(&data);
  }
  /// Whether place and data are equal. Numbers are compared bit by bit: 0 differs from -0.
  bool operator==(const Value&) const;
};

struct Member {
  std::string key;
  Place place;  // place of the key
  Value value;
  bool operator==(const Member&) const = default;
};

inline const Member* Table::find(std::string_view key) const {
  for (const Member& member : members)
    if (member.key == key) return &member;
  return nullptr;
}

inline Member* Table::find(std::string_view key) {
  return const_cast<Member*>(static_cast<const Table*>(this)->find(key));
}

/// Adds `by` to the file index of every place in a value and in the values that it contains.
void shift_files(Value& value, int by);

/// A key as written in a dotted path: bare, or quoted if necessary.
std::string spell_key(std::string_view key);

/// Joins "parts.net" and "cells" to "parts.net.cells".
std::string join_path(std::string_view path, std::string_view key);

}  // namespace netloft::formats
