// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/hdf5/read.hpp"
#include "io/formats/hdf5/tree.hpp"
#include "io/results/file/groups.hpp"

#include <cmath>
#include <concepts>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace netloft::results {

// The writer and the reader for layout.hpp, which lists every member of a Result once, with its place below
// /netloft. Each member function of the writer has a counterpart in the reader.

/// Writes the members of a Result to its file; leaves out empty lists.
class RecordWriter {
 public:
  explicit RecordWriter(formats::Tree& tree) : tree_(tree) {}

  template <std::integral Number>
  void number(const std::string& at, Number value, const std::string& unit, const char* doc) {
    tree_.write_int(kRoot + at, static_cast<std::int64_t>(value), unit, doc);
  }
  void number(const std::string& at, double value, const std::string& unit, const char* doc) {
    tree_.write_real(kRoot + at, value, unit, doc);
  }
  /// Writes a number unless it is unknown (NaN).
  void known(const std::string& at, double value, const std::string& unit, const char* doc) {
    if (std::isfinite(value)) number(at, value, unit, doc);
  }
  void text(const std::string& at, const std::string& value, const char* doc = "") {
    tree_.write_text(kRoot + at, value, doc);
  }
  void texts(const std::string& at, const std::vector<std::string>& values, const char* doc = "") {
    if (!values.empty()) tree_.write_strings(kRoot + at, values, doc);
  }
  template <class Value>
  void attribute(const std::string& group, const char* name, const Value& value) {
    if constexpr (std::is_arithmetic_v<Value>)
      tree_.set_attribute(kRoot + group, name, value);
    else
      tree_.set_attribute(kRoot + group, name, std::string_view(value));
  }
  /// Writes one member of all rows of a table as one dataset.
  template <class Row, class Member>
  void column(const std::string& at, const std::vector<Row>& rows, Member member, const char* unit,
              const char* doc = "") {
    using Value = std::remove_cvref_t<std::invoke_result_t<Member, const Row&>>;
    if (rows.empty()) return;
    if constexpr (std::is_same_v<Value, std::string>)
      tree_.write_strings(kRoot + at, gathered<std::string>(rows, member), doc);
    else if constexpr (std::is_integral_v<Value>)
      tree_.write_ints(kRoot + at, gathered<std::int64_t>(rows, member), unit, doc);
    else
      tree_.write_reals(kRoot + at, gathered<double>(rows, member), unit, doc);
  }
  /// Writes a column of names.
  template <class Row, class Member>
  void names(const std::string& at, const std::vector<Row>& rows, Member member, const char* doc = "") {
    column(at, rows, member, "", doc);
  }
  /// Writes an optional part of the result if it exists. The reader recognises the part by the dataset, group
  /// or attribute `at`.
  template <class Part, class Visit>
  void sometimes(const std::string&, const std::optional<Part>& part, const Visit& visit) {
    if (part) visit(*part);
  }
  bool is_there(const std::string&, const bool& known) const { return known; }

 private:
  template <class Value, class Row, class Member>
  static std::vector<Value> gathered(const std::vector<Row>& rows, Member member) {
    std::vector<Value> values;
    for (const Row& row : rows) values.push_back(std::invoke(member, row));
    return values;
  }

  formats::Tree& tree_;
};

/// Reads a Result. A member that is missing in the file keeps its value.
class RecordReader {
 public:
  RecordReader(const formats::Reader& reader, std::string file) : reader_(reader), file_(std::move(file)) {}

  template <class Number>
  void number(const std::string& at, Number& value, const std::string&, const char*) const {
    if (!has_data(at)) return;
    if constexpr (std::is_integral_v<Number>)
      value = static_cast<Number>(reader_.integer(kRoot + at));
    else
      value = reader_.real(kRoot + at);
  }
  void known(const std::string& at, double& value, const std::string& unit, const char* doc) const {
    number(at, value, unit, doc);
  }
  void text(const std::string& at, std::string& value, const char* = "") const {
    if (has_data(at)) value = reader_.text(kRoot + at);
  }
  void texts(const std::string& at, std::vector<std::string>& values, const char* = "") const {
    if (has_data(at)) values = reader_.strings(kRoot + at);
  }
  template <class Value>
  void attribute(const std::string& group, const char* name, Value& value) const {
    if (!reader_.has(kRoot + group) || !reader_.has_attribute(kRoot + group, name)) return;
    if constexpr (std::is_arithmetic_v<Value>)
      value = static_cast<Value>(reader_.real_attribute(kRoot + group, name));
    else
      value = reader_.text_attribute(kRoot + group, name);
  }
  template <class Row, class Member>
  void column(const std::string& at, std::vector<Row>& rows, Member member, const char*,
              const char* = "") const {
    using Value = std::remove_cvref_t<std::invoke_result_t<Member, Row&>>;
    if (!has_data(at)) return;
    if constexpr (std::is_same_v<Value, std::string>)
      spread(at, reader_.strings(kRoot + at), rows, member);
    else if constexpr (std::is_integral_v<Value>)
      spread(at, reader_.integers(kRoot + at), rows, member);
    else
      spread(at, reader_.reals(kRoot + at), rows, member);
  }
  template <class Row, class Member>
  void names(const std::string& at, std::vector<Row>& rows, Member member, const char* = "") const {
    if (has_data(at)) spread(at, reader_.names(kRoot + at), rows, member);
  }
  template <class Part, class Visit>
  void sometimes(const std::string& at, std::optional<Part>& part, const Visit& visit) const {
    const auto mark = at.find('@');
    const std::string group = kRoot + at.substr(0, mark);
    if (reader_.has(group) &&
        (mark == std::string::npos || reader_.has_attribute(group, at.substr(mark + 1))))
      visit(part.emplace());
  }
  bool is_there(const std::string& at, bool& known) const { return known = reader_.has(kRoot + at); }

 private:
  bool has_data(const std::string& at) const {
    return reader_.has(kRoot + at) && !reader_.is_group(kRoot + at);
  }
  template <class Value, class Row, class Member>
  void spread(const std::string& at, const std::vector<Value>& values, std::vector<Row>& rows,
              Member member) const {
    if (rows.empty()) rows.resize(values.size());
    if (rows.size() != values.size())
      throw formats::FileError(file_ + " is damaged: the table of " + kRoot + at + " is cut off");
    for (std::size_t i = 0; i < rows.size(); ++i) {
      auto& member_of_row = std::invoke(member, rows[i]);
      member_of_row = static_cast<std::remove_reference_t<decltype(member_of_row)>>(values[i]);
    }
  }

  const formats::Reader& reader_;
  std::string file_;
};

}  // namespace netloft::results
