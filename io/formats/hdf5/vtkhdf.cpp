// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/hdf5/vtkhdf.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "io/formats/hdf5/transfer.hpp"
#include "io/formats/hdf5/tree.hpp"

namespace netloft::formats {
namespace {

// Largest number of values that one call writes: 1 MB, a small part of the memory of a motion.
constexpr std::size_t kBlock = std::size_t{1} << 17;

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

/// The rank of a dataset; arrays of one component have rank 1, as in files of VTK.
int rank_of(std::size_t columns) { return columns == 1 ? 1 : 2; }

Handle make_dataset(hid_t group, const std::string& name, hid_t type, hid_t space, hid_t properties) {
  return Handle(H5Dcreate2(group, name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT), H5Dclose);
}

/// Creates a contiguous array without compression: compression took ten times as long as everything else and
/// saved a fifth of the space.
Handle make_plain(hid_t group, const std::string& name, hid_t type, std::array<hsize_t, 2> extents,
                  int rank) {
  const Handle properties = make_dataset_properties();
  check(H5Pset_fill_time(properties, H5D_FILL_TIME_NEVER));
  const Handle space(H5Screate_simple(rank, extents.data(), nullptr), H5Sclose);
  return make_dataset(group, name, type, space, properties);
}

/// Writes a dataset in one piece, without chunks, which every reader supports.
Handle write_fixed(hid_t group, const std::string& name, hid_t type, hid_t memory_type, const void* values,
                   std::array<hsize_t, 2> extents, int rank) {
  const Handle space(H5Screate_simple(rank, extents.data(), nullptr), H5Sclose);
  Handle dataset = make_dataset(group, name, type, space, make_dataset_properties());
  const bool is_converted = H5Tget_class(type) != H5Tget_class(memory_type);
  const Handle transfer = is_converted ? make_transfer(dataset, memory_type) : Handle();
  if (extents[0] > 0)
    check(H5Dwrite(dataset, memory_type, H5S_ALL, H5S_ALL, is_converted ? hid_t{transfer} : H5P_DEFAULT,
                   values));
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

/// Writes the type of the grid. VTK compares the type string exactly and requires a fixed length.
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

}  // namespace

VtkHdf::VtkHdf(hid_t file, const Mesh& mesh, std::vector<FieldSpec> changing,
               std::span<const StaticField> fixed, std::size_t states,
               std::span<const std::vector<bool>> stored)
    : n_points_(mesh.n_points),
      n_cells_(mesh.n_cells()),
      states_(states),
      changing_(std::move(changing)),
      stored_(stored.begin(), stored.end()) {
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
                 n_points_, nullptr);
  const Handle point_data = make_group(root_, group_name(Location::kPoint));
  const Handle cell_data = make_group(root_, group_name(Location::kCell));
  const auto rows = [&](const FieldSpec& spec) {
    return spec.location == Location::kPoint ? n_points_ : n_cells_;
  };
  const auto group = [&](const FieldSpec& spec) -> hid_t {
    return spec.location == Location::kPoint ? point_data : cell_data;
  };
  for (std::size_t k = 0; k < changing_.size(); ++k)
    add_slot_array(group(changing_[k]), changing_[k], rows(changing_[k]),
                   stored_.empty() ? nullptr : &stored_.at(k));
  for (const StaticField& field : fixed) add_static_array(group(field.spec), field, rows(field.spec));
  write_steps(fixed);
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

void VtkHdf::add_slot_array(hid_t group, const FieldSpec& spec, std::size_t rows,
                            const std::vector<bool>* stored) {
  std::size_t slots = states_;
  if (stored && states_ > 0)
    slots = 1 + static_cast<std::size_t>(std::count(stored->begin() + 1, stored->end(), true));
  const std::array<hsize_t, 2> extents = {slots * rows, spec.components};
  arrays_.push_back({spec.name, rows, spec.components, stored, slots,
                     make_plain(group, spec.name, file_type(spec), extents, rank_of(spec.components))});
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

/// For each state, the first row of the slot that holds it; slots are explained in vtkhdf.hpp.
std::vector<std::int64_t> VtkHdf::offsets_of(const SlotArray& array) const {
  std::vector<std::int64_t> rows;
  std::size_t own = 0;  // number of states up to this one that have a slot of their own
  for (std::size_t i = 0; i < states_; ++i) {
    own += array.has(i);
    rows.push_back(static_cast<std::int64_t>(array.rows * array.slot_of(own - 1)));
  }
  return rows;
}

void VtkHdf::write_step_column(const std::string& path, std::span<const std::int64_t> values,
                               bool by_topology) {
  write_fixed(steps_, path, H5T_STD_I64LE, H5T_NATIVE_INT64, values.data(), {values.size(), 1},
              by_topology ? 2 : 1);
}

/// Writes the steps. The grid has a single part, whose topology is the same in every step; only the offsets
/// into points and fields change.
void VtkHdf::write_steps(std::span<const StaticField> fixed) {
  steps_ = make_group(root_, "Steps");
  const auto count = static_cast<std::int64_t>(states_);
  put_attribute(steps_, "NSteps", H5T_STD_I64LE, H5T_NATIVE_INT64, &count);
  const std::vector<std::int64_t> zeros(states_, 0), ones(states_, 1);
  const auto name_of = [](const FieldSpec& spec) {
    return std::string(group_name(spec.location)) + "Offsets/" + spec.name;
  };
  make_group(steps_, "PointDataOffsets");
  make_group(steps_, "CellDataOffsets");
  write_step_column("NumberOfParts", ones, false);
  write_step_column("PartOffsets", zeros, false);
  write_step_column("CellOffsets", zeros, true);
  write_step_column("ConnectivityIdOffsets", zeros, true);
  write_step_column("PointOffsets", offsets_of(arrays_[0]), false);
  for (std::size_t i = 0; i < changing_.size(); ++i)
    write_step_column(name_of(changing_[i]), offsets_of(arrays_[i + 1]), false);
  for (const StaticField& field : fixed) write_step_column(name_of(field.spec), zeros, false);
}

void VtkHdf::write_state(double time, std::span<const double> points,
                         std::span<const std::span<const double>> fields) {
  require_sizes(points, fields);
  if (times_.size() == states_) reject("more states than the " + std::to_string(states_) + " announced");
  arrays_[0].add(points);
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (arrays_[i + 1].has(times_.size())) arrays_[i + 1].add(fields[i]);
  times_.push_back(time);
}

void VtkHdf::write_blocks() {
  for (SlotArray& array : arrays_) array.write_block();
}

void VtkHdf::finish() {
  if (times_.size() != states_)
    reject(std::to_string(times_.size()) + " states instead of the " + std::to_string(states_) +
           " announced");
  write_blocks();
  const Handle times =
      write_fixed(steps_, "Values", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, times_.data(), {times_.size(), 1}, 1);
  put_labels(times, "s", "Time of each state, or the load step of a static run");
}

void VtkHdf::require_sizes(std::span<const double> points,
                           std::span<const std::span<const double>> fields) const {
  if (fields.size() != changing_.size())
    reject(std::to_string(fields.size()) + " fields written, " + std::to_string(changing_.size()) +
           " declared");
  for (std::size_t i = 0; i < arrays_.size(); ++i) {
    const std::size_t size = i == 0 ? points.size() : fields[i - 1].size();
    const bool is_left_out = size == 0 && times_.size() < states_ && !arrays_[i].has(times_.size());
    if (size != arrays_[i].size() && !is_left_out)
      reject("field " + arrays_[i].name + " has " + std::to_string(size) + " values instead of " +
             std::to_string(arrays_[i].size()));
  }
}

void VtkHdf::SlotArray::add(std::span<const double> values) {
  if (size() == 0) return;
  const std::size_t slot = slot_of(added++);
  const bool follows = slot == first + block.size() / size();
  if (!follows || block.size() + size() > kBlock) write_block();
  if (block.empty()) first = slot;
  block.insert(block.end(), values.begin(), values.end());
}

void VtkHdf::SlotArray::write_block() {
  if (block.empty()) return;
  const std::array<hsize_t, 2> start = {first * rows, 0};
  const std::array<hsize_t, 2> count = {block.size() / columns, columns};
  const hsize_t length = block.size();
  const Handle space(H5Dget_space(dataset), H5Sclose),
      memory(H5Screate_simple(1, &length, nullptr), H5Sclose);
  check(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr));
  check(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, block.data()));
  block.clear();
}

}  // namespace netloft::formats
