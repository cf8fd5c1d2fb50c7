// SPDX-License-Identifier: BSD-3-Clause
//
// Reads files of VTKHDF (Kitware, "VTKHDF file format"): unstructured grids of one piece at their last time,
// and results of Netloft, which are such files with additional data of parts.
#include "framework/registry/element_outputs.hpp"
#include "io/formats/hdf5/read.hpp"
#include "io/formats/mesh/vtk_cells.hpp"
#include "io/formats/units/in_quotes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace netloft::formats {

namespace {

const std::string kGridGroup = "/VTKHDF";

/// Reads one file; the member functions are steps in their order. Errors of HDF5 are thrown as FileError.
class VtkHdfMesh {
 public:
  VtkHdfMesh(const std::filesystem::path& path, int file, Diagnostics& diagnostics)
      : reader_(path), place_{file, 0, 0}, diagnostics_(diagnostics), builder_(diagnostics) {}

  InputMesh read() {
    require_grid();
    is_transient_ = reader_.has(kGridGroup + "/Steps");
    states_ = is_transient_ ? reader_.times().size() : 1;
    if (states_ == 0) throw FileError("it has no state");
    for (const double x : points()) builder_.add_coordinate(in_range(x), place_);
    read_cells();
    read_arrays();
    if (!reader_.has(kGridGroup + "/CellData/region") && reader_.has("/netloft/parts/name")) take_parts();
    if (builder_.errors() == 0) add_vtk_cells(cells_, place_, builder_);
    return builder_.finish(place_);
  }

 private:
  void require_grid() {
    if (!reader_.is_group(kGridGroup)) throw FileError("it has no group VTKHDF: it is not a file of VTKHDF");
    const std::string type =
        reader_.has_attribute(kGridGroup, "Type") ? reader_.text_attribute(kGridGroup, "Type") : "";
    if (type != "UnstructuredGrid")
      throw FileError("its data set is " + in_quotes(type) + "; only an UnstructuredGrid can be read");
    for (const char* count : {"/NumberOfPoints", "/NumberOfCells"})
      if (const auto pieces = reader_.integers(kGridGroup + count);
          !reader_.has(kGridGroup + "/Steps") && pieces.size() != 1)
        throw FileError("it is in " + std::to_string(pieces.size()) +
                        " pieces; only a file with a single piece can be read");
  }

  /// The points of the last state; array() returns an array on cells, also of the last state.
  std::vector<double> points() const {
    return is_transient_ ? reader_.points(states_ - 1) : reader_.reals(kGridGroup + "/Points");
  }
  std::vector<double> array(const std::string& name) const {
    return is_transient_ ? reader_.field(Location::kCell, name, states_ - 1)
                         : reader_.reals(kGridGroup + "/CellData/" + name);
  }

  double in_range(double x) {
    if (std::abs(x) <= kFarthest) return x;
    if (builder_.goes_on())
      builder_.error(place_, kGridGroup + "/Points: " + spell_number(x) + " is no number below a million");
    return 0;
  }

  /// Reads the cells. If a grid changes its cells from state to state, those of the first state are used.
  void read_cells() {
    const auto counts = reader_.integers(kGridGroup + "/NumberOfPoints");
    const auto connectivity = reader_.integers(kGridGroup + "/Connectivity"),
               offsets = reader_.integers(kGridGroup + "/Offsets"),
               types = reader_.integers(kGridGroup + "/Types");
    const auto known = std::min<std::int64_t>(counts.empty() ? 0 : counts[0],
                                              static_cast<std::int64_t>(points().size() / 3));
    if (types.size() > kMostElements || connectivity.size() > 8 * kMostElements)
      throw FileError("it has more than " + std::to_string(kMostElements) + " cells");
    if (offsets.size() != types.size() + 1)
      throw FileError("it has " + std::to_string(types.size()) + " cells and " +
                      std::to_string(offsets.size()) + " offsets, but needs one offset more than cells");
    for (std::size_t c = 0; c < types.size(); ++c) {
      const auto from = offsets[c], to = offsets[c + 1];
      if (from < 0 || to < from || to > static_cast<std::int64_t>(connectivity.size()))
        throw FileError("the offsets of cell " + std::to_string(c) + " are outside /VTKHDF/Connectivity");
      auto& nodes = cells_.nodes.emplace_back();
      for (auto k = from; k < to; ++k) {
        const auto node = connectivity[static_cast<std::size_t>(k)];
        if (node < 0 || node >= known)
          throw FileError("cell " + std::to_string(c) + " refers to node " + std::to_string(node) +
                          ", and there are " + std::to_string(known));
        nodes.push_back(static_cast<std::uint32_t>(node));
      }
      cells_.types.push_back(static_cast<int>(types[c]));
    }
    cells_.places.assign(types.size(), place_);
  }

  void read_arrays() {
    for (const auto& [name, components] : {std::pair<const char*, std::size_t>{"region", 1},
                                           {"panel_corners", 6},
                                           {"shares", 2},
                                           {"twines", 2}}) {
      const std::string path = kGridGroup + "/CellData/" + name;
      if (!reader_.has(path)) continue;
      const auto shape = reader_.shape(path);
      if ((shape.size() < 2 ? 1 : shape[1]) != components ||
          array(name).size() != components * cells_.types.size())
        throw FileError(path + " must have " + std::to_string(components) + " numbers for each of " +
                        std::to_string(cells_.types.size()) + " cells");
      cells_.arrays[name] = {components, array(name)};
    }
    if (reader_.has(kGridGroup + "/FieldData/region_names"))
      cells_.names = reader_.names(kGridGroup + "/FieldData/region_names");
  }

  /// Makes regions from the parts of a result of Netloft. It leaves out netting without panel coordinates,
  /// bars of several twines, and bars that belong to no rope. The fractions of a rope at the ends of its bars
  /// follow from their unstretched lengths.
  void take_parts() {
    const std::size_t count = cells_.types.size();
    cells_.names = reader_.names("/netloft/parts/name");
    cells_.arrays["region"] = {1, field("part", -1)};
    const auto strain = field(output::kStrain.name, std::nan("")),
               twines = field(output::kTwineArea.name, std::nan(""));
    std::vector<bool> is_kept(count, true);
    for (std::size_t c = 0; c < count; ++c) {
      const double* corners = cells_.numbers("panel_corners", 6, c);
      if (cells_.types[c] == vtk::kTriangle)
        is_kept[c] = corners &&
                     std::all_of(corners, corners + 6, [](double x) { return std::isfinite(x); }) &&
                     !has_twins(cells_.nodes[c]);
      if (cells_.types[c] == vtk::kLine) is_kept[c] = std::isfinite(strain[c]) && !std::isfinite(twines[c]);
    }
    share_out(strain, is_kept);
    leave_out(is_kept);
  }

  std::vector<double> field(const std::string& name, double otherwise) const {
    auto values = reader_.has(kGridGroup + "/CellData/" + name) ? array(name) : std::vector<double>();
    values.resize(cells_.types.size(), otherwise);
    return values;
  }

  static bool has_twins(const std::vector<std::uint32_t>& nodes) {
    return std::set<std::uint32_t>(nodes.begin(), nodes.end()).size() != nodes.size();
  }

  void share_out(const std::vector<double>& strain, const std::vector<bool>& is_kept) {
    const auto at = points();
    std::map<double, std::vector<std::size_t>> ropes;
    for (std::size_t c = 0; c < strain.size(); ++c)
      if (cells_.types[c] == vtk::kLine && is_kept[c] && cells_.nodes[c].size() == 2)
        ropes[*cells_.numbers("region", 1, c)].push_back(c);
    auto& shares = cells_.arrays["shares"] = {2, std::vector<double>(2 * strain.size())};
    for (const auto& [part, bars] : ropes) {
      std::vector<double> ends{0};
      for (const auto c : bars) {
        const double *x = &at[3 * std::size_t{cells_.nodes[c][0]}],
                     *y = &at[3 * std::size_t{cells_.nodes[c][1]}];
        ends.push_back(ends.back() + std::hypot(y[0] - x[0], y[1] - x[1], y[2] - x[2]) / (1 + strain[c]));
      }
      for (std::size_t i = 0; i < bars.size(); ++i)
        for (const std::size_t end : {0u, 1u}) shares.values[2 * bars[i] + end] = ends[i + end] / ends.back();
    }
  }

  void leave_out(const std::vector<bool>& is_kept) {
    std::map<std::string, int> left_out;
    VtkCells kept;
    kept.names = cells_.names;
    for (auto& [name, values] : cells_.arrays) kept.arrays[name].components = values.components;
    for (std::size_t c = 0; c < is_kept.size(); ++c) {
      if (!is_kept[c]) {
        ++left_out[cells_.region_of(c, "a part")];
        continue;
      }
      kept.nodes.push_back(cells_.nodes[c]);
      kept.types.push_back(cells_.types[c]);
      for (auto& [name, array] : kept.arrays) {
        const auto& from = cells_.arrays[name].values;
        const auto first = from.begin() + static_cast<std::ptrdiff_t>(array.components * c);
        array.values.insert(array.values.end(), first, first + static_cast<std::ptrdiff_t>(array.components));
      }
    }
    kept.places.assign(kept.types.size(), place_);
    cells_ = std::move(kept);
    for (const auto& [part, count] : left_out)
      diagnostics_.warning(
          place_,
          in_quotes(part) + ": " + std::to_string(count) +
              " elements that are neither bars of a rope nor triangles with places on a panel are left out");
  }

  Reader reader_;
  Place place_;
  Diagnostics& diagnostics_;
  MeshBuilder builder_;
  bool is_transient_ = false;
  std::size_t states_ = 1;
  VtkCells cells_;
};

}  // namespace

bool is_hdf5(std::string_view bytes) { return bytes.starts_with("\x89HDF\r\n\x1a\n"); }

InputMesh read_vtkhdf(const std::filesystem::path& path, int file, Diagnostics& diagnostics) {
  try {
    return VtkHdfMesh(path, file, diagnostics).read();
  } catch (const FileError& e) {
    diagnostics.error({file, 0, 0}, e.what());
    return {};
  }
}

}  // namespace netloft::formats
