// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/hdf5/tree.hpp"

#include <algorithm>
#include <vector>

#include "io/formats/hdf5/transfer.hpp"
#include "io/formats/text/utf8.hpp"

namespace netloft::formats {
namespace {

Handle make_space(std::initializer_list<hsize_t> extents) {
  if (extents.size() == 0) return Handle(H5Screate(H5S_SCALAR), H5Sclose);
  return Handle(H5Screate_simple(static_cast<int>(extents.size()), extents.begin(), nullptr), H5Sclose);
}

/// Properties of links with names in UTF-8.
Handle make_link_properties() {
  Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  check(H5Pset_char_encoding(links, H5T_CSET_UTF8));
  return links;
}

bool has(hid_t group, const std::string& name) {
  return check(H5Lexists(group, name.c_str(), H5P_DEFAULT)) > 0;
}

Handle open_group(hid_t parent, const std::string& name, hid_t links) {
  if (has(parent, name)) return Handle(H5Gopen2(parent, name.c_str(), H5P_DEFAULT), H5Gclose);
  return Handle(H5Gcreate2(parent, name.c_str(), links, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
}

/// The part of the path after the last slash.
std::string name_in(const std::string& path) { return path.substr(path.rfind('/') + 1); }

bool is_utf8_without_nul(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = sequence_length(text);
    if (length == 0 || text.front() == '\0') return false;
    text.remove_prefix(length);
  }
  return true;
}

void remove_dataset(hid_t group, const std::string& path) {
  const std::string name = name_in(path);
  const Handle object(H5Oopen(group, name.c_str(), H5P_DEFAULT), H5Oclose);
  if (H5Iget_type(object) != H5I_DATASET)
    throw std::invalid_argument(path + " is a group and cannot become a dataset");
  check(H5Ldelete(group, name.c_str(), H5P_DEFAULT));
}

void require_c_string(const std::string& text) {
  if (text.find('\0') != std::string::npos)
    throw std::invalid_argument("a text in an array or an attribute cannot hold a NUL byte: " + text);
}

}  // namespace

Handle make_string_type() {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  check(H5Tset_size(type, H5T_VARIABLE));
  check(H5Tset_cset(type, H5T_CSET_UTF8));
  return type;
}

Handle make_dataset_properties() {
  Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  check(H5Pset_obj_track_times(properties, false));
  return properties;
}

void put_attribute(hid_t object, const std::string& name, hid_t file_type, hid_t memory_type,
                   const void* data) {
  if (check(H5Aexists(object, name.c_str())) > 0) check(H5Adelete(object, name.c_str()));
  const Handle space = make_space({});
  const Handle attribute(H5Acreate2(object, name.c_str(), file_type, space, H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose);
  check(H5Awrite(attribute, memory_type, data));
}

void put_text_attribute(hid_t object, const std::string& name, std::string_view value) {
  const std::string text(value);
  require_c_string(text);
  const char* const pointer = text.c_str();
  const Handle type = make_string_type();
  put_attribute(object, name, type, type, &pointer);
}

void put_labels(hid_t object, std::string_view unit, std::string_view doc) {
  if (!unit.empty()) put_text_attribute(object, "unit", unit);
  if (!doc.empty()) put_text_attribute(object, "doc", doc);
}

template <class Action>
void Tree::write(const std::string& path, Action&& action) {
  silence_hdf5();
  if (path.empty() || path.front() != '/' || (path.size() > 1 && path.back() == '/'))
    throw std::invalid_argument("'" + path + "' is no absolute path in a result file, such as /netloft/plan");
  with_context("cannot write " + path + " in " + file_name_, action);
}

hid_t Tree::group_of(const std::string& path) {
  if (links_ < 0) links_ = make_link_properties();
  const std::string wanted = path.substr(0, path.rfind('/'));
  const bool is_known = group_ >= 0 && (wanted == group_path_ || wanted.starts_with(group_path_ + "/"));
  if (!is_known) {
    group_ = Handle(H5Gopen2(file_, "/", H5P_DEFAULT), H5Gclose);
    group_path_.clear();
  }
  while (group_path_.size() < wanted.size()) {
    const std::size_t begin = group_path_.size() + 1, end = std::min(wanted.find('/', begin), wanted.size());
    group_ = open_group(group_, wanted.substr(begin, end - begin), links_);
    group_path_ = wanted.substr(0, end);
  }
  return group_;
}

void Tree::replace(const std::string& path, hid_t file_type, hid_t memory_type, const Handle& space,
                   const void* data, Labels labels) {
  if (datasets_ < 0) datasets_ = make_dataset_properties();
  const hid_t group = group_of(path);
  const std::string name = name_in(path);
  if (has(group, name)) remove_dataset(group, path);
  const Handle dataset(H5Dcreate2(group, name.c_str(), file_type, space, links_, datasets_, H5P_DEFAULT),
                       H5Dclose);
  if (const hssize_t values = check(H5Sget_simple_extent_npoints(space)); values > 0)
    check(H5Dwrite(dataset, memory_type, H5S_ALL, H5S_ALL, transfer_of(memory_type, values), data));
  put_labels(dataset, labels.unit, labels.doc);
}

/// Transfer properties for a memory type. Only strings need a conversion, because numbers have the same form
/// in the file and in memory.
hid_t Tree::transfer_of(hid_t memory_type, hssize_t values) {
  if (memory_type != strings_) return H5P_DEFAULT;
  if (transfer_ < 0) transfer_ = Handle(H5Pcreate(H5P_DATASET_XFER), H5Pclose);
  want_buffer(transfer_, values, kStringInFile);
  return transfer_;
}

hid_t Tree::strings() {
  if (strings_ < 0) strings_ = make_string_type();
  return strings_;
}

void Tree::write_text(const std::string& path, std::string_view text, std::string_view doc) {
  write(path, [&] {
    const std::string copy(text);
    const char* const pointer = copy.c_str();
    if (is_utf8_without_nul(text)) {
      replace(path, strings(), strings(), make_space({}), &pointer, {{}, doc});
    } else {
      replace(path, H5T_STD_U8LE, H5T_NATIVE_UINT8, make_space({text.size()}), pointer, {{}, doc});
      set_attribute(path, "content", std::string_view("bytes"));
    }
  });
}

void Tree::write_real(const std::string& path, double value, std::string_view unit, std::string_view doc) {
  write(path, [&] { replace(path, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, make_space({}), &value, {unit, doc}); });
}

void Tree::write_int(const std::string& path, std::int64_t value, std::string_view unit,
                     std::string_view doc) {
  write(path, [&] { replace(path, H5T_STD_I64LE, H5T_NATIVE_INT64, make_space({}), &value, {unit, doc}); });
}

void Tree::write_reals(const std::string& path, std::span<const double> values, std::string_view unit,
                       std::string_view doc) {
  write(path, [&] {
    replace(path, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, make_space({values.size()}), values.data(), {unit, doc});
  });
}

void Tree::write_ints(const std::string& path, std::span<const std::int64_t> values, std::string_view unit,
                      std::string_view doc) {
  write(path, [&] {
    replace(path, H5T_STD_I64LE, H5T_NATIVE_INT64, make_space({values.size()}), values.data(), {unit, doc});
  });
}

void Tree::write_matrix(const std::string& path, std::span<const double> values, std::size_t columns,
                        std::string_view unit, std::string_view doc) {
  if (columns == 0 || values.size() % columns != 0)
    throw std::invalid_argument(path + ": " + std::to_string(values.size()) + " values do not fill rows of " +
                                std::to_string(columns));
  write(path, [&] {
    replace(path, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, make_space({values.size() / columns, columns}),
            values.data(), {unit, doc});
  });
}

void Tree::write_strings(const std::string& path, std::span<const std::string> values, std::string_view doc) {
  std::vector<const char*> pointers;
  for (const std::string& value : values) {
    require_c_string(value);
    pointers.push_back(value.c_str());
  }
  write(path, [&] {
    replace(path, strings(), strings(), make_space({values.size()}), pointers.data(), {{}, doc});
  });
}

template <class Put>
void Tree::put(const std::string& path, Put&& put_on) {
  write(path, [&] {
    const hid_t group = group_of(path);
    const std::string name = path == "/" ? "." : name_in(path);
    if (path != "/" && !has(group, name)) open_group(group, name, links_);
    put_on(Handle(H5Oopen(group, name.c_str(), H5P_DEFAULT), H5Oclose));
  });
}

void Tree::set_attribute(const std::string& path, const std::string& name, std::string_view value) {
  put(path, [&](hid_t object) { put_text_attribute(object, name, value); });
}

void Tree::set_int_attribute(const std::string& path, const std::string& name, std::int64_t value) {
  put(path, [&](hid_t object) { put_attribute(object, name, H5T_STD_I64LE, H5T_NATIVE_INT64, &value); });
}

void Tree::set_real_attribute(const std::string& path, const std::string& name, double value) {
  put(path, [&](hid_t object) { put_attribute(object, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, &value); });
}

}  // namespace netloft::formats
