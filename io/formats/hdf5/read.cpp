// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/hdf5/read.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "io/formats/hdf5/fold.hpp"
#include "io/formats/hdf5/open.hpp"
#include "io/formats/hdf5/result_file.hpp"
#include "io/formats/hdf5/seal.hpp"
#include "io/formats/hdf5/transfer.hpp"
#include "io/formats/text/printable.hpp"

namespace netloft::formats {
namespace fs = std::filesystem;
namespace {

Handle open_file(const fs::path& path) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) throw FileError("cannot read " + path.string() + ": there is no such file");
  if (fs::is_directory(path, ignored)) throw FileError("cannot read " + path.string() + ": it is a folder");
  if (!fs::is_regular_file(path, ignored))
    throw FileError("cannot read " + path.string() + ": it is a pipe, a device or similar, not a file");
  check_seal(path);
  return open_for_reading(path);
}

std::string parent_of(const std::string& path) {
  const auto slash = path.rfind('/');
  return slash == 0 || slash == std::string::npos ? "/" : path.substr(0, slash);
}

std::vector<std::size_t> extents_of(hid_t dataset) {
  const Handle space(H5Dget_space(dataset), H5Sclose);
  std::vector<hsize_t> extents(static_cast<std::size_t>(check(H5Sget_simple_extent_ndims(space))));
  check(H5Sget_simple_extent_dims(space, extents.data(), nullptr));
  return {extents.begin(), extents.end()};
}

/// The number of entries of a dataset, limited to the largest representable number.
std::size_t product(const std::vector<std::size_t>& extents) {
  std::size_t all = 1;
  for (const std::size_t extent : extents)
    if (__builtin_mul_overflow(all, extent, &all)) return std::numeric_limits<std::size_t>::max();
  return all;
}

// If the extents of a dataset are damaged, a reader must not allocate more memory than the computer has.
// Stored data contain at most one number per byte; deflated data at most 1032 times as many (RFC 1951).
constexpr std::size_t kHarmless = 1 << 20, kMostDeflated = 1100;

void require_stored(hid_t dataset, std::size_t count, const std::filesystem::path& file) {
  std::error_code none;
  const std::size_t in_file = static_cast<std::size_t>(std::filesystem::file_size(file, none));
  const std::size_t stored = std::min<std::size_t>(H5Dget_storage_size(dataset), none ? 0 : in_file);
  if (count > kHarmless && count / kMostDeflated > stored)
    throw FileError("it is damaged: it claims " + std::to_string(count) + " entries in " +
                    std::to_string(stored) + " bytes");
}

bool is_number(hid_t type) {
  const H5T_class_t kind = H5Tget_class(type);
  return kind == H5T_INTEGER || kind == H5T_FLOAT;
}

/// Reads `count` strings of any HDF5 kind; `read(type, buffer)` reads them into memory.
template <class Read>
std::vector<std::string> fetch_strings(const Handle& type, const Handle& space, std::size_t count,
                                       Read&& read) {
  std::vector<std::string> texts;
  if (check(H5Tis_variable_str(type)) > 0) {
    std::vector<char*> pointers(count, nullptr);
    read(type, pointers.data());
    for (const char* pointer : pointers) texts.emplace_back(pointer ? pointer : "");
    check(H5Dvlen_reclaim(type, space, H5P_DEFAULT, pointers.data()));
    return texts;
  }
  const std::size_t width = H5Tget_size(type);
  std::string buffer(width * count, '\0');
  read(type, buffer.data());
  for (std::size_t i = 0; i < count; ++i) texts.emplace_back(buffer.substr(i * width, width).c_str());
  return texts;
}

herr_t append_name(hid_t, const char* name, const H5L_info_t*, void* data) {
  static_cast<std::vector<std::string>*>(data)->emplace_back(name);
  return 0;
}

}  // namespace

Reader::Reader(fs::path path) : path_(std::move(path)) {
  silence_hdf5();
  file_ = is_journal(path_) ? unfold(path_) : open_file(path_);
}

Reader::Reader(fs::path path, Handle file) : path_(std::move(path)), file_(std::move(file)) {}

Reader Reader::of_own(fs::path path) {
  silence_hdf5();
  Handle file = open_for_reading(path);
  return {std::move(path), std::move(file)};
}

void Reader::require_known_format() const {
  if (!has_attribute("/netloft", "schema")) return;
  const double format = real_attribute("/netloft", "schema");
  if (format > kResultFormat)
    throw FileError(path_.string() + " was written by a newer netloft, in format " +
                    std::to_string(static_cast<long>(format)) + "; this program reads format " +
                    std::to_string(kResultFormat));
}

bool Reader::has(const std::string& path) const {
  silence_hdf5();
  const hid_t id = H5Oopen(file_, path.c_str(), H5P_DEFAULT);
  if (id >= 0) H5Oclose(id);
  return id >= 0;
}

bool Reader::is_group(const std::string& path) const {
  return has(path) && H5Iget_type(object(path)) == H5I_GROUP;
}

std::vector<std::string> Reader::list(const std::string& group) const {
  const Handle id = object(group);
  if (H5Iget_type(id) != H5I_GROUP) throw FileError(at(group) + " is a dataset, not a group");
  std::vector<std::string> names;
  with_context("cannot read " + at(group),
               [&] { check(H5Literate(id, H5_INDEX_NAME, H5_ITER_INC, nullptr, append_name, &names)); });
  return names;
}

std::string Reader::describe_neighbours(const std::string& path) const {
  std::string group = parent_of(path);
  while (!has(group)) group = parent_of(group);
  const Handle id = object(group);
  if (H5Iget_type(id) != H5I_GROUP) return "";
  std::string names;
  for (const std::string& name : list(group)) names += (names.empty() ? "" : ", ") + name;
  return "; " + group + " holds " + (names.empty() ? "nothing" : names);
}

Handle Reader::object(const std::string& path) const {
  silence_hdf5();
  if (!has(path)) throw FileError(path_.string() + " has no " + path + describe_neighbours(path));
  return Handle(H5Oopen(file_, path.c_str(), H5P_DEFAULT), H5Oclose);
}

Handle Reader::dataset(const std::string& path) const {
  Handle id = object(path);
  if (H5Iget_type(id) != H5I_DATASET) throw FileError(at(path) + " is a group, not a dataset");
  return id;
}

bool Reader::holds_reals(const std::string& path) const {
  return H5Tget_class(Handle(H5Dget_type(dataset(path)), H5Tclose)) == H5T_FLOAT;
}

std::vector<std::size_t> Reader::shape(const std::string& path) const { return extents_of(dataset(path)); }

std::uint64_t Reader::place(const std::string& path) const {
  const haddr_t place = H5Dget_offset(dataset(path));
  if (place == HADDR_UNDEF) throw FileError(at(path) + " does not lie in one piece");
  return place;
}

template <class Number>
std::vector<Number> Reader::numbers(const std::string& path, hid_t memory_type) const {
  const Handle data = dataset(path);
  if (!is_number(Handle(H5Dget_type(data), H5Tclose))) throw FileError(at(path) + " does not hold numbers");
  const std::size_t count = product(extents_of(data));
  with_context("cannot read " + at(path), [&] { require_stored(data, count, path_); });
  std::vector<Number> values(count);
  if (values.empty()) return values;
  with_context("cannot read " + at(path),
               [&] { check(H5Dread(data, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data())); });
  return values;
}

std::vector<double> Reader::reals(const std::string& path) const {
  return numbers<double>(path, H5T_NATIVE_DOUBLE);
}

std::vector<std::int64_t> Reader::integers(const std::string& path) const {
  if (H5Tget_class(Handle(H5Dget_type(dataset(path)), H5Tclose)) == H5T_FLOAT)
    throw FileError(at(path) + " holds reals, not integers");
  return numbers<std::int64_t>(path, H5T_NATIVE_INT64);
}

double Reader::real(const std::string& path) const {
  const std::vector<double> values = reals(path);
  if (values.size() != 1)
    throw FileError(at(path) + " holds " + std::to_string(values.size()) + " numbers, not one");
  return values.front();
}

std::int64_t Reader::integer(const std::string& path) const {
  const std::vector<std::int64_t> values = integers(path);
  if (values.size() != 1)
    throw FileError(at(path) + " holds " + std::to_string(values.size()) + " numbers, not one");
  return values.front();
}

std::vector<std::string> Reader::strings(const std::string& path) const {
  const Handle data = dataset(path);
  const Handle type(H5Dget_type(data), H5Tclose);
  if (H5Tget_class(type) != H5T_STRING) throw FileError(at(path) + " does not hold text");
  const std::size_t count = product(extents_of(data));
  if (count == 0) return {};
  with_context("cannot read " + at(path), [&] { require_stored(data, count, path_); });
  return with_context("cannot read " + at(path), [&] {
    return fetch_strings(
        type, Handle(H5Dget_space(data), H5Sclose), count, [&](hid_t memory_type, void* buffer) {
          check(H5Dread(data, memory_type, H5S_ALL, H5S_ALL, make_transfer(data, memory_type), buffer));
        });
  });
}

std::vector<std::string> Reader::names(const std::string& path) const {
  std::vector<std::string> names = strings(path);
  for (const std::string& name : names)
    if (has_control_characters(name))
      throw FileError("cannot read " + path_.string() + ": " + path +
                      " has a name with control characters, " + printable_in_line(name) +
                      ", and no result has such names");
  return names;
}

std::string Reader::text(const std::string& path) const {
  if (has_attribute(path, "content") && text_attribute(path, "content") == "bytes") {
    const std::vector<std::int64_t> bytes = integers(path);
    std::string text(bytes.size(), '\0');
    std::transform(bytes.begin(), bytes.end(), text.begin(),
                   [](std::int64_t byte) { return static_cast<char>(byte); });
    return text;
  }
  const std::vector<std::string> texts = strings(path);
  if (texts.size() != 1)
    throw FileError(at(path) + " holds " + std::to_string(texts.size()) + " texts, not one");
  return texts.front();
}

bool Reader::has_attribute(const std::string& path, const std::string& name) const {
  return check(H5Aexists(object(path), name.c_str())) > 0;
}

std::string Reader::text_attribute(const std::string& path, const std::string& name) const {
  return with_context("cannot read the attribute " + name + " of " + at(path), [&] {
    const Handle attribute(H5Aopen(object(path), name.c_str(), H5P_DEFAULT), H5Aclose);
    const Handle type(H5Aget_type(attribute), H5Tclose);
    if (H5Tget_class(type) != H5T_STRING) throw FileError("it is not text");
    const Handle space(H5Aget_space(attribute), H5Sclose);
    if (check(H5Sget_simple_extent_npoints(space)) != 1) throw FileError("it is not one text");
    return fetch_strings(
               type, space, 1,
               [&](hid_t memory_type, void* buffer) { check(H5Aread(attribute, memory_type, buffer)); })
        .front();
  });
}

double Reader::real_attribute(const std::string& path, const std::string& name) const {
  return with_context("cannot read the attribute " + name + " of " + at(path), [&] {
    const Handle attribute(H5Aopen(object(path), name.c_str(), H5P_DEFAULT), H5Aclose);
    const Handle space(H5Aget_space(attribute), H5Sclose);
    if (!is_number(Handle(H5Aget_type(attribute), H5Tclose)) ||
        check(H5Sget_simple_extent_npoints(space)) != 1)
      throw FileError("it is not one number");
    double value = 0;
    check(H5Aread(attribute, H5T_NATIVE_DOUBLE, &value));
    return value;
  });
}

std::vector<double> Reader::times() const {
  std::vector<double> values = reals("/VTKHDF/Steps/Values");
  values.resize(std::min(values.size(), static_cast<std::size_t>(real_attribute("/VTKHDF/Steps", "NSteps"))));
  return values;
}

std::vector<double> Reader::points(std::size_t step) const {
  return slot("/VTKHDF/Points", "/VTKHDF/Steps/PointOffsets", "/VTKHDF/NumberOfPoints", step);
}

std::vector<double> Reader::field(Location location, const std::string& name, std::size_t step) const {
  const bool on_points = location == Location::kPoint;
  const std::string data = on_points ? "PointData" : "CellData";
  return slot("/VTKHDF/" + data + "/" + name, "/VTKHDF/Steps/" + data + "Offsets/" + name,
              on_points ? "/VTKHDF/NumberOfPoints" : "/VTKHDF/NumberOfCells", step);
}

std::vector<double> Reader::slot(const std::string& path, const std::string& offsets,
                                 const std::string& count, std::size_t step) const {
  const Handle data = dataset(path);
  const std::size_t n_states = times().size();
  if (step >= n_states)
    throw FileError(path_.string() + " has " + std::to_string(n_states) + " states, and no state " +
                    std::to_string(step) + ", counted from 0");
  std::vector<std::size_t> extents = extents_of(data);
  extents.resize(2, 1);
  const std::vector<std::int64_t> starts = integers(offsets);
  if (starts.size() <= step || starts[step] < 0)
    throw FileError(path_.string() + " is damaged: " + offsets + " has no place for state " +
                    std::to_string(step));
  const std::array<hsize_t, 2> start = {static_cast<hsize_t>(starts[step]), 0};
  const std::array<hsize_t, 2> size = {static_cast<hsize_t>(integer(count)), extents[1]};
  with_context("cannot read " + at(path), [&] {
    if (size[0] > extents[0]) throw FileError("it is damaged: it has fewer rows than " + count);
    require_stored(data, product(extents), path_);
  });
  std::vector<double> values(size[0] * size[1]);
  if (values.empty()) return values;
  with_context("cannot read " + at(path), [&] {
    const Handle space(H5Dget_space(data), H5Sclose);
    check(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr));
    const hsize_t length = values.size();
    const Handle memory(H5Screate_simple(1, &length, nullptr), H5Sclose);
    check(H5Dread(data, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, values.data()));
  });
  return values;
}

}  // namespace netloft::formats
