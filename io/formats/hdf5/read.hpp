// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "io/formats/hdf5/handle.hpp"
#include "io/formats/hdf5/vtkhdf.hpp"

namespace netloft::formats {

/// Reads a finished result, or the outputs of a motion that is running or was killed. Every error is a
/// FileError that names file and path.
class Reader {
 public:
  explicit Reader(std::filesystem::path path);
  /// Opens a finished result that this program has just written; does not compare checksums.
  static Reader of_own(std::filesystem::path path);

  /// Throws FileError if /netloft has a newer format than this program supports; older formats can be read,
  /// except for data that they lack.
  void require_known_format() const;

  bool has(const std::string& path) const;
  /// Whether a group exists at the path.
  bool is_group(const std::string& path) const;
  std::vector<std::string> list(const std::string& group) const;
  /// The extents of a dataset along its dimensions; an empty list for a scalar.
  std::vector<std::size_t> shape(const std::string& path) const;
  bool holds_reals(const std::string& path) const;

  /// Offset of the numbers of a dataset in the file [bytes]. Throws FileError if the dataset is not
  /// contiguous.
  std::uint64_t place(const std::string& path) const;

  /// All numbers of a dataset, row by row; a scalar gives one number.
  std::vector<double> reals(const std::string& path) const;
  std::vector<std::int64_t> integers(const std::string& path) const;
  double real(const std::string& path) const;
  std::int64_t integer(const std::string& path) const;

  std::string text(const std::string& path) const;
  std::vector<std::string> strings(const std::string& path) const;
  /// Reads names. Throws FileError if a name has control characters, because names are printed and written
  /// into lines of files.
  std::vector<std::string> names(const std::string& path) const;

  bool has_attribute(const std::string& path, const std::string& name) const;
  std::string text_attribute(const std::string& path, const std::string& name) const;
  double real_attribute(const std::string& path, const std::string& name) const;

  /// The times of the stored states in ascending order.
  std::vector<double> times() const;
  /// The points, 3n [m], of the stored state with index `step` in times(); field() returns a field of this
  /// state.
  std::vector<double> points(std::size_t step) const;
  std::vector<double> field(Location location, const std::string& name, std::size_t step) const;

 private:
  Reader(std::filesystem::path path, Handle file);
  Handle dataset(const std::string& path) const;
  Handle object(const std::string& path) const;
  std::string describe_neighbours(const std::string& path) const;
  template <class Number>
  std::vector<Number> numbers(const std::string& path, hid_t memory_type) const;
  std::vector<double> slot(const std::string& path, const std::string& offsets, const std::string& count,
                           std::size_t step) const;
  std::string at(const std::string& path) const { return path + " in " + path_.string(); }

  std::filesystem::path path_;
  Handle file_;
};

}  // namespace netloft::formats
