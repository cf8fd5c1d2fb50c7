// SPDX-License-Identifier: BSD-3-Clause
#include "io/dynamics/xdmf.hpp"

#include "io/files/whole_file.hpp"
#include "io/hdf5/read.hpp"

#include <fmt/format.h>

#include <sstream>

namespace netloft::io {

namespace {

/// An array of all states: every state has its own rows, beginning at offsets[state].
struct SteppedArray {
  std::string name, center;
  std::uint64_t place;  // of the array in the file [bytes]
  std::size_t rows, columns;
  std::vector<std::int64_t> offsets;
};

/// The rows of a state as plain numbers in the file. Selections of rows by HDF5 are no way: XDMF 3 counts
/// their beginning along the other dimension than XDMF 2.
std::string item(const std::string& file, const SteppedArray& array, std::size_t step) {
  const auto first = static_cast<std::size_t>(array.offsets.at(step)) * array.columns;
  return fmt::format(
      "<DataItem Format=\"Binary\" NumberType=\"Float\" Precision=\"8\" Endian=\"Little\" Seek=\"{}\" "
      "Dimensions=\"{}{}\">{}</DataItem>",
      array.place + 8 * first, array.rows, array.columns == 1 ? "" : fmt::format(" {}", array.columns), file);
}

SteppedArray array_at(const Reader& reader, const std::string& path, const std::string& offsets_path,
                      std::size_t rows) {
  const auto shape = reader.shape(path);
  return {{}, {}, reader.place(path), rows, shape.size() == 1 ? 1 : shape[1], reader.integers(offsets_path)};
}

/// Fields that change: the first state lies behind the newest one. Those that do not change lie at 0.
std::vector<SteppedArray> changing_fields(const Reader& reader) {
  std::vector<SteppedArray> arrays;
  for (const auto& [group, center] : {std::pair{"PointData", "Node"}, {"CellData", "Cell"}})
    for (const auto& name : reader.list(std::string("/VTKHDF/") + group)) {
      const std::string offsets = std::string("/VTKHDF/Steps/") + group + "Offsets/" + name;
      const auto rows = reader.integers(offsets).at(0);
      if (rows == 0) continue;
      arrays.push_back(array_at(reader, std::string("/VTKHDF/") + group + "/" + name, offsets,
                                static_cast<std::size_t>(rows)));
      arrays.back().name = name, arrays.back().center = center;
    }
  return arrays;
}

/// Cells in XDMF's order: type, number of nodes if the type does not imply it, nodes.
std::string topology(const Reader& reader) {
  const auto nodes = reader.integers("/VTKHDF/Connectivity"), offsets = reader.integers("/VTKHDF/Offsets");
  std::string mixed;
  std::size_t length = 0;
  for (std::size_t c = 0; c + 1 < offsets.size(); ++c) {
    const auto first = static_cast<std::size_t>(offsets[c]), last = static_cast<std::size_t>(offsets[c + 1]);
    const bool is_triangle = last - first == 3;
    mixed += is_triangle ? "4" : fmt::format("{0} {0}", last - first);  // polyvertex is 1, polyline 2
    for (std::size_t k = first; k < last; ++k) mixed += fmt::format(" {}", nodes[k]);
    mixed += '\n';
    length += (is_triangle ? 1 : 2) + last - first;
  }
  return fmt::format(
      "<Topology TopologyType=\"Mixed\" NumberOfElements=\"{}\">\n<DataItem Format=\"XML\" "
      "NumberType=\"Int\" "
      "Dimensions=\"{}\">\n{}</DataItem></Topology>\n",
      offsets.size() - 1, length, mixed);
}

std::string fields(const std::vector<SteppedArray>& arrays, std::size_t step, const std::string& file) {
  std::string text;
  for (const auto& array : arrays)
    text +=
        fmt::format("<Attribute Name=\"{}\" Center=\"{}\" AttributeType=\"{}\">{}</Attribute>\n", array.name,
                    array.center, array.columns == 1 ? "Scalar" : "Vector", item(file, array, step));
  return text;
}

}  // namespace

void write_xdmf(const std::filesystem::path& result) {
  const Reader reader(result);
  const auto times = reader.times();
  if (times.size() < 2) return;
  const std::string file = result.filename().string();
  std::ostringstream out;
  out << "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\"><Domain>\n"
      << "<Grid Name=\"series\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  const std::string shared = topology(reader);
  const auto arrays = changing_fields(reader);
  const SteppedArray points = array_at(reader, "/VTKHDF/Points", "/VTKHDF/Steps/PointOffsets",
                                       static_cast<std::size_t>(reader.integer("/VTKHDF/NumberOfPoints")));
  for (std::size_t i = 0; i < times.size(); ++i)
    out << fmt::format("<Grid Name=\"step {}\"><Time Value=\"{:.17g}\"/>\n", i, times[i]) << shared
        << "<Geometry GeometryType=\"XYZ\">" << item(file, points, i) << "</Geometry>\n"
        << fields(arrays, i, file) << "</Grid>\n";
  out << "</Grid></Domain></Xdmf>\n";
  write_whole(std::filesystem::path(result).replace_extension(".xdmf"), out.str());
}

}  // namespace netloft::io
