// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/plugin.h>

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace netloft {

/// A sampled curve: rows of equal length, the first column increasing.
using Samples = std::vector<std::vector<double>>;

/// The value of a parameter given by a user. Its type depends on the kind of the parameter: real (in SI
/// units), integer, boolean, text (also for choices), or samples.
using Value = std::variant<double, std::int64_t, bool, std::string, Samples>;
using Values = std::map<std::string, Value>;

/// Returns a sentence that describes what is wrong with a value; nullopt if it is valid.
std::optional<std::string> fault_of(const netloft_parameter& parameter, const Value& value);

/// The allowed values in words: "[0, 1e+09] N", "one of classic, robust", "true or false".
std::string allowed(const netloft_parameter& parameter);

/// The default in words: "required", "1e-4 x twine.EA", "classic".
std::string default_of(const netloft_parameter& parameter);

/// Size of a value in a parameter struct, by kind; zero for an unknown kind.
std::size_t bytes_of(std::uint32_t kind);

/// Bytes of a parameter struct from `begin` up to `end`.
struct ByteRange {
  std::size_t begin, end;
};

/// The ranges of bytes of a parameter struct that no row of its table declares, including padding.
std::vector<ByteRange> undeclared(std::span<const netloft_parameter> table, std::size_t bytes);

/// The parameter struct that a plugin reads, filled with values and defaults. The block owns copies of texts
/// and tables.
class ParameterBlock {
 public:
  /// Errors (missing, unknown, out of range) are appended to `faults`; a block with errors must not be used.
  ParameterBlock(std::span<const netloft_parameter> table, std::size_t bytes, const Values& values,
                 std::vector<std::string>& faults);
  ParameterBlock(ParameterBlock&&) = default;
  ParameterBlock& operator=(ParameterBlock&&) = default;

  const void* data() const { return bytes_.get(); }
  /// Overwrites bytes that no row of the table declares, to find out whether the plugin reads them.
  void spoil(const ByteRange& range);
  /// Sets bytes that no row declares to zero again.
  void clear(const ByteRange& range);
  /// The value of a real, integer, choice or boolean parameter as stored.
  double number(const netloft_parameter& parameter) const;
  /// The numbers of a table parameter as stored, row by row. They may be changed between calls of the plugin.
  std::span<double> table(const netloft_parameter& parameter) const;

 private:
  void store(const netloft_parameter& parameter, const Value& value);
  Value fallback(std::span<const netloft_parameter> table, const netloft_parameter& parameter) const;

  std::unique_ptr<std::byte[]> bytes_;
  std::vector<std::unique_ptr<std::string>> texts_;
  std::vector<std::unique_ptr<std::vector<double>>> tables_;
};

}  // namespace netloft
