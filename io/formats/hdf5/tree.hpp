// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "io/formats/hdf5/handle.hpp"

namespace netloft::formats {

/// Writes named data anywhere in an open HDF5 file: `tree.write_real("/netloft/scalars/drag", 4.2e4, "N",
/// "…")`.
///
/// Paths are absolute; missing groups on the path are created. An existing dataset is replaced. Every dataset
/// has the attributes `unit` (numbers only; "1" if dimensionless) and `doc`, each omitted if empty. Text is
/// UTF-8. Texts with other bytes or with NUL are stored as an array of uint8 with the attribute `content` =
/// "bytes"; Reader::text() reads both forms.
class Tree {
 public:
  Tree(hid_t file, std::string file_name) : file_(file), file_name_(std::move(file_name)) {}

  void write_text(const std::string& path, std::string_view text, std::string_view doc = {});
  void write_real(const std::string& path, double value, std::string_view unit, std::string_view doc = {});
  void write_int(const std::string& path, std::int64_t value, std::string_view unit,
                 std::string_view doc = {});
  void write_reals(const std::string& path, std::span<const double> values, std::string_view unit,
                   std::string_view doc = {});
  void write_ints(const std::string& path, std::span<const std::int64_t> values, std::string_view unit,
                  std::string_view doc = {});
  /// Writes `values` row by row; their number must be a multiple of `columns`.
  void write_matrix(const std::string& path, std::span<const double> values, std::size_t columns,
                    std::string_view unit, std::string_view doc = {});
  void write_strings(const std::string& path, std::span<const std::string> values, std::string_view doc = {});

  /// Sets an attribute of a dataset or a group, which is created if missing; replaces an existing attribute.
  void set_attribute(const std::string& path, const std::string& name, std::string_view value);
  void set_attribute(const std::string& path, const std::string& name, std::integral auto value) {
    set_int_attribute(path, name, static_cast<std::int64_t>(value));
  }
  void set_attribute(const std::string& path, const std::string& name, std::floating_point auto value) {
    set_real_attribute(path, name, static_cast<double>(value));
  }

 private:
  struct Labels {
    std::string_view unit;
    std::string_view doc;
  };

  void set_int_attribute(const std::string& path, const std::string& name, std::int64_t value);
  void set_real_attribute(const std::string& path, const std::string& name, double value);
  /// Creates or replaces a dataset. `data` has the memory type that fits `file_type`: native for numbers,
  /// char* for strings.
  void replace(const std::string& path, hid_t file_type, hid_t memory_type, const Handle& space,
               const void* data, Labels labels);
  template <class Action>
  void write(const std::string& path, Action&& action);
  /// Calls `put_on` with the dataset or group `path`; a missing group is created.
  template <class Put>
  void put(const std::string& path, Put&& put_on);
  hid_t strings();
  hid_t transfer_of(hid_t memory_type, hssize_t values);

  /// The parent group of `path`, created if missing. It stays open, because the next path is often in the
  /// same group, and HDF5 takes as long to follow a path as to create a dataset.
  hid_t group_of(const std::string& path);

  hid_t file_;
  std::string file_name_;
  Handle group_;
  std::string group_path_;
  Handle links_, datasets_, strings_, transfer_;  // properties, and the type of strings; created when needed
};

/// The HDF5 type of all strings that are written: UTF-8 with variable length.
Handle make_string_type();
/// Writes or replaces an attribute on an open object.
void put_attribute(hid_t object, const std::string& name, hid_t file_type, hid_t memory_type,
                   const void* data);
void put_text_attribute(hid_t object, const std::string& name, std::string_view value);
/// Writes the attributes `unit` and `doc`, unless they are empty.
void put_labels(hid_t object, std::string_view unit, std::string_view doc);
/// Creation properties without time stamps, so that equal content gives equal bytes.
Handle make_dataset_properties();

}  // namespace netloft::formats
