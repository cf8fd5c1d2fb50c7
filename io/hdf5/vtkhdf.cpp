// SPDX-License-Identifier: BSD-3-Clause
#include "io/hdf5/vtkhdf.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "io/hdf5/tree.hpp"

namespace netloft::io {
namespace {

constexpr unsigned kGzipLevel = 1;  // level 4 takes a third more time and saves a few per cent
constexpr hsize_t kStepChunk = 64;

[[noreturn]] void reject(const std::string& reason) { throw std::invalid_argument("result mesh: " + reason); }

void require_consistent(const Mesh& mesh) {
  if (mesh.offsets.size() != mesh.n_cells() + 1) reject("offsets must be one more than cells");
  if (mesh.offsets.front() != 0 || !std::is_sorted(mesh.offsets.begin(), mesh.offsets.end()))
    reject("offsets must begin with 0 and never decrease");
  if (static_cast<std::size_t>(mesh.offsets.back()) != mesh.connectivity.size())
    reject("the last offset must be the length of the connectivity");
  const auto is_node = [&](std::int64_t id) {
    return id >= 0 && static_cast<std::size_t>(id) < mesh.n_points;
  };
  if (!std::all_of(mesh.connectivity.begin(), mesh.connectivity.end(), is_node))
    reject("the connectivity names a node that does not exist");
}

void require_usable(const FieldSpec& spec) {
  if (spec.name.empty() || spec.name.find('/') != std::string::npos || spec.name == ".")
    reject("'" + spec.name + "' cannot be the name of a field");
  if (spec.components == 0) reject("field " + spec.name + " has no components");
}

void require_distinct(std::span<const FieldSpec> changing, std::span<const StaticField> fixed) {
  std::vector<std::pair<Location, std::string>> names;
  for (const FieldSpec& spec : changing) names.emplace_back(spec.location, spec.name);
  for (const StaticField& field : fixed) names.emplace_back(field.spec.location, field.spec.name);
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if (twice != names.end()) reject("two fields are called " + twice->second);
}

hid_t file_type(const FieldSpec& spec) { return spec.is_integer ? H5T_STD_I64LE : H5T_IEEE_F64LE; }

const char* group_name(Location location) { return location == Location::kPoint ? "PointData" : "CellData"; }

Handle make_group(hid_t parent, const char* name) {
  return Handle(H5Gcreate2(parent, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
}

/// Arrays of one component have rank 1, as VTK writes them.
int rank_of(std::size_t columns) { return columns == 1 ? 1 : 2; }

Handle make_dataset(hid_t group, const std::string& name, hid_t type, hid_t space, hid_t properties) {
  return Handle(H5Dcreate2(group, name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT), H5Dclose);
}

Handle make_extendable(hid_t group, const std::string& name, hid_t type, std::array<hsize_t, 2> chunk,
                       int rank, bool compressed) {
  const std::array<hsize_t, 2> none = {0, chunk[1]};
  const std::array<hsize_t, 2> most = {H5S_UNLIMITED, chunk[1]};
  const Handle properties = make_dataset_properties();
  check(H5Pset_chunk(properties, rank, chunk.data()));
  if (compressed) check(H5Pset_shuffle(properties));
  if (compressed) check(H5Pset_deflate(properties, kGzipLevel));
  const Handle space(H5Screate_simple(rank, none.data(), most.data()), H5Sclose);
  return make_dataset(group, name, type, space, properties);
}

/// Writes a dataset once, without chunks, so that any reader supports it.
Handle write_fixed(hid_t group, const std::string& name, hid_t type, hid_t memory_type, const void* values,
                   std::array<hsize_t, 2> extents, int rank) {
  const Handle space(H5Screate_simple(rank, extents.data(), nullptr), H5Sclose);
  Handle dataset = make_dataset(group, name, type, space, make_dataset_properties());
  if (extents[0] > 0) check(H5Dwrite(dataset, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
  return dataset;
}

void write_ids(hid_t group, const std::string& name, std::span<const std::int64_t> values,
               std::string_view doc) {
  const Handle dataset =
      write_fixed(group, name, H5T_STD_I64LE, H5T_NATIVE_INT64, values.data(), {values.size(), 1}, 1);
  put_labels(dataset, "1", doc);
}

void write_count(hid_t group, const std::string& name, std::size_t count) {
  const auto value = static_cast<std::int64_t>(count);
  write_ids(group, name, {&value, 1}, "");
}

/// VTK compares the type string exactly and requires a string of fixed length for it.
void put_grid_type(hid_t group) {
  constexpr std::string_view kType = "UnstructuredGrid";
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  check(H5Tset_size(type, kType.size()));
  check(H5Tset_strpad(type, H5T_STR_NULLPAD));
  put_attribute(group, "Type", type, type, kType.data());
}

void put_version(hid_t group) {
  constexpr std::array<std::int64_t, 2> kVersion = {2, 0};
  const hsize_t length = kVersion.size();
  const Handle space(H5Screate_simple(1, &length, nullptr), H5Sclose);
  const Handle attribute(H5Acreate2(group, "Version", H5T_STD_I64LE, space, H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose);
  check(H5Awrite(attribute, H5T_NATIVE_INT64, kVersion.data()));
}

/// Overwrites the attribute in place; deleting and creating it would leave a moment without it.
void put_step_count(hid_t steps, std::size_t count) {
  const auto value = static_cast<std::int64_t>(count);
  const Handle attribute(H5Aopen(steps, "NSteps", H5P_DEFAULT), H5Aclose);
  check(H5Awrite(attribute, H5T_NATIVE_INT64, &value));
}

/// Increases the first extent to at least `rows`; existing data remain.
void grow(hid_t dataset, hsize_t rows) {
  std::array<hsize_t, 2> extents{};
  const Handle space(H5Dget_space(dataset), H5Sclose);
  check(H5Sget_simple_extent_dims(space, extents.data(), nullptr));
  if (extents[0] >= rows) return;
  extents[0] = rows;
  check(H5Dset_extent(dataset, extents.data()));
}

void write_entry(hid_t dataset, std::size_t row, hid_t memory_type, const void* value) {
  grow(dataset, row + 1);
  const std::array<hsize_t, 2> start = {row, 0};
  const std::array<hsize_t, 2> one = {1, 1};
  const Handle space(H5Dget_space(dataset), H5Sclose);
  check(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, one.data(), nullptr));
  const Handle memory(H5Screate_simple(1, one.data(), nullptr), H5Sclose);
  check(H5Dwrite(dataset, memory_type, memory, space, H5P_DEFAULT, value));
}

}  // namespace

VtkHdf::VtkHdf(hid_t file, const Mesh& mesh, std::vector<FieldSpec> changing,
               std::span<const StaticField> fixed)
    : n_points_(mesh.n_points), n_cells_(mesh.n_cells()), changing_(std::move(changing)) {
  require_consistent(mesh);
  for (const FieldSpec& spec : changing_) require_usable(spec);
  for (const StaticField& field : fixed) require_usable(field.spec);
  require_distinct(changing_, fixed);

  root_ = make_group(file, "VTKHDF");
  put_grid_type(root_);
  put_version(root_);
  write_topology(mesh);
  add_slot_array(root_,
                 {"Points", "m", "Node positions, z up, one slot of all nodes per state, newest first",
                  Location::kPoint, 3},
                 n_points_);
  const Handle point_data = make_group(root_, group_name(Location::kPoint));
  const Handle cell_data = make_group(root_, group_name(Location::kCell));
  const auto rows = [&](const FieldSpec& spec) {
    return spec.location == Location::kPoint ? n_points_ : n_cells_;
  };
  const auto group = [&](const FieldSpec& spec) -> hid_t {
    return spec.location == Location::kPoint ? point_data : cell_data;
  };
  for (const FieldSpec& spec : changing_) add_slot_array(group(spec), spec, rows(spec));
  for (const StaticField& field : fixed) add_static_array(group(field.spec), field, rows(field.spec));
  make_steps(fixed);
}

void VtkHdf::write_topology(const Mesh& mesh) {
  write_count(root_, "NumberOfPoints", mesh.n_points);
  write_count(root_, "NumberOfCells", mesh.n_cells());
  write_count(root_, "NumberOfConnectivityIds", mesh.connectivity.size());
  write_ids(root_, "Connectivity", mesh.connectivity, "Nodes of the cells, one cell after the other");
  write_ids(root_, "Offsets", mesh.offsets,
            "Where each cell begins in Connectivity; the last entry is its length");
  const Handle types =
      write_fixed(root_, "Types", H5T_STD_U8LE, H5T_NATIVE_UINT8, mesh.types.data(), {mesh.n_cells(), 1}, 1);
  put_labels(types, "1", "Shape of each cell: 1 vertex, 3 line, 5 triangle");
}

void VtkHdf::add_slot_array(hid_t group, const FieldSpec& spec, std::size_t rows) {
  const std::array<hsize_t, 2> chunk = {std::max<hsize_t>(rows, 1), spec.components};
  arrays_.push_back(
      {spec.name, rows, spec.components,
       make_extendable(group, spec.name, file_type(spec), chunk, rank_of(spec.components), true)});
  put_labels(arrays_.back().dataset, spec.unit, spec.doc);
}

void VtkHdf::add_static_array(hid_t group, const StaticField& field, std::size_t rows) {
  const FieldSpec& spec = field.spec;
  if (field.values.size() != rows * spec.components)
    reject("field " + spec.name + " has " + std::to_string(field.values.size()) + " values instead of " +
           std::to_string(rows * spec.components));
  const Handle dataset = write_fixed(group, spec.name, file_type(spec), H5T_NATIVE_DOUBLE,
                                     field.values.data(), {rows, spec.components}, rank_of(spec.components));
  put_labels(dataset, spec.unit, spec.doc);
}

void VtkHdf::add_step_column(const std::string& path, std::int64_t first, std::int64_t stride,
                             bool by_topology) {
  columns_.push_back(
      {first, stride,
       make_extendable(root_, "Steps/" + path, H5T_STD_I64LE, {kStepChunk, 1}, by_topology ? 2 : 1, false)});
}

/// Every step is the same single part with the same topology; only offsets into points and fields move.
void VtkHdf::make_steps(std::span<const StaticField> fixed) {
  steps_ = make_group(root_, "Steps");
  const std::int64_t none = 0;
  put_attribute(steps_, "NSteps", H5T_STD_I64LE, H5T_NATIVE_INT64, &none);
  times_ = make_extendable(steps_, "Values", H5T_IEEE_F64LE, {kStepChunk, 1}, 1, false);
  put_labels(times_, "s", "Time of each state, or the load step of a static run");
  const auto offsets_of = [](const FieldSpec& spec) {
    return std::string(group_name(spec.location)) + "Offsets/" + spec.name;
  };
  make_group(steps_, "PointDataOffsets");
  make_group(steps_, "CellDataOffsets");
  add_step_column("NumberOfParts", 1, 0, false);
  add_step_column("PartOffsets", 0, 0, false);
  add_step_column("CellOffsets", 0, 0, true);
  add_step_column("ConnectivityIdOffsets", 0, 0, true);
  add_step_column("PointOffsets", 0, static_cast<std::int64_t>(n_points_), false);
  for (std::size_t i = 0; i < changing_.size(); ++i)
    add_step_column(offsets_of(changing_[i]), 0, static_cast<std::int64_t>(arrays_[i + 1].rows), false);
  for (const StaticField& field : fixed) add_step_column(offsets_of(field.spec), 0, 0, false);
}

void VtkHdf::write_state(double time, std::span<const double> points,
                         std::span<const std::span<const double>> fields) {
  require_sizes(points, fields);
  if (n_states_ > 0) {
    for (SlotArray& array : arrays_) array.copy(0, n_states_);
    flush();
    point_step_at(n_states_ - 1, n_states_);  // (1)
    flush();
  }
  write_newest(time, points, fields);
  flush();
  put_step_count(steps_, n_states_ + 1);
  flush();
  ++n_states_;
}

void VtkHdf::require_sizes(std::span<const double> points,
                           std::span<const std::span<const double>> fields) const {
  if (fields.size() != changing_.size())
    reject(std::to_string(fields.size()) + " fields written, " + std::to_string(changing_.size()) +
           " declared");
  for (std::size_t i = 0; i < arrays_.size(); ++i) {
    const std::size_t size = i == 0 ? points.size() : fields[i - 1].size();
    if (size != arrays_[i].size())
      reject("field " + arrays_[i].name + " has " + std::to_string(size) + " values instead of " +
             std::to_string(arrays_[i].size()));
  }
}

void VtkHdf::write_newest(double time, std::span<const double> points,
                          std::span<const std::span<const double>> fields) {
  arrays_[0].write(0, points.data());
  for (std::size_t i = 0; i < fields.size(); ++i) arrays_[i + 1].write(0, fields[i].data());
  write_entry(times_, n_states_, H5T_NATIVE_DOUBLE, &time);
  point_step_at(n_states_, 0);  // (1)
}

void VtkHdf::flush() { check(H5Fflush(root_, H5F_SCOPE_GLOBAL)); }

void VtkHdf::point_step_at(std::size_t step, std::size_t slot) {
  for (StepColumn& column : columns_) column.write(step, slot);
}

void VtkHdf::StepColumn::write(std::size_t step, std::size_t slot) {
  const std::int64_t value = first + stride * static_cast<std::int64_t>(slot);
  write_entry(dataset, step, H5T_NATIVE_INT64, &value);
}

Handle VtkHdf::SlotArray::select(std::size_t slot) const {
  const std::array<hsize_t, 2> start = {slot * rows, 0};
  const std::array<hsize_t, 2> count = {rows, columns};
  Handle space(H5Dget_space(dataset), H5Sclose);
  check(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr));
  return space;
}

void VtkHdf::SlotArray::write(std::size_t slot, const double* values) {
  if (size() == 0) return;
  grow(dataset, (slot + 1) * rows);
  const hsize_t length = size();
  const Handle memory(H5Screate_simple(1, &length, nullptr), H5Sclose);
  check(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, memory, select(slot), H5P_DEFAULT, values));
}

void VtkHdf::SlotArray::copy(std::size_t from, std::size_t to) {
  if (size() == 0) return;
  std::vector<double> values(size());
  const hsize_t length = size();
  const Handle memory(H5Screate_simple(1, &length, nullptr), H5Sclose);
  check(H5Dread(dataset, H5T_NATIVE_DOUBLE, memory, select(from), H5P_DEFAULT, values.data()));
  write(to, values.data());
}

}  // namespace netloft::io
