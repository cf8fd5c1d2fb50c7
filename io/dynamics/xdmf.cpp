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
  std::string name, path, center;
  std::vector<std::size_t> shape;
  std::vector<std::int64_t> offsets;
  std::size_t rows;
};

std::string in_words(const std::vector<std::size_t>& numbers) {
  std::string text;
  for (const std::size_t n : numbers) text += (text.empty() ? "" : " ") + std::to_string(n);
  return text;
}

/// The rows of a state: where they begin in the array, their stride, how many they are.
std::string item(const std::string& file, const SteppedArray& array, std::size_t step) {
  std::vector<std::size_t> first(array.shape.size(), 0), stride(array.shape.size(), 1), count = array.shape;
  first[0] = static_cast<std::size_t>(array.offsets.at(step)), count[0] = array.rows;
  return fmt::format(
      "<DataItem ItemType=\"HyperSlab\" Dimensions=\"{0}\"><DataItem Format=\"XML\" NumberType=\"Int\" "
      "Dimensions=\"3 {1}\">{2} {3} {0}</DataItem><DataItem Format=\"HDF\" NumberType=\"Float\" "
      "Precision=\"8\" Dimensions=\"{4}\">{5}:{6}</DataItem></DataItem>",
      in_words(count), count.size(), in_words(first), in_words(stride), in_words(array.shape), file,
      array.path);
}

/// Fields that change: the first state lies behind the newest one. Those that do not change lie at 0.
std::vector<SteppedArray> changing_fields(const Reader& reader) {
  std::vector<SteppedArray> arrays;
  for (const auto& [group, center] : {std::pair{"PointData", "Node"}, {"CellData", "Cell"}})
    for (const auto& name : reader.list(std::string("/VTKHDF/") + group)) {
      const std::string path = std::string("/VTKHDF/") + group + "/" + name;
      const auto offsets = reader.integers(std::string("/VTKHDF/Steps/") + group + "Offsets/" + name);
      if (offsets.empty() || offsets[0] == 0) continue;
      const auto rows = static_cast<std::size_t>(offsets[0]);
      arrays.push_back({name, path, center, reader.shape(path), offsets, rows});
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
                    array.center, array.shape.size() == 1 ? "Scalar" : "Vector", item(file, array, step));
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
  const SteppedArray points{"",
                            "/VTKHDF/Points",
                            "",
                            reader.shape("/VTKHDF/Points"),
                            reader.integers("/VTKHDF/Steps/PointOffsets"),
                            static_cast<std::size_t>(reader.integer("/VTKHDF/NumberOfPoints"))};
  for (std::size_t i = 0; i < times.size(); ++i)
    out << fmt::format("<Grid Name=\"step {}\"><Time Value=\"{:.17g}\"/>\n", i, times[i]) << shared
        << "<Geometry GeometryType=\"XYZ\">" << item(file, points, i) << "</Geometry>\n"
        << fields(arrays, i, file) << "</Grid>\n";
  out << "</Grid></Domain></Xdmf>\n";
  write_whole(std::filesystem::path(result).replace_extension(".xdmf"), out.str());
}

}  // namespace netloft::io
