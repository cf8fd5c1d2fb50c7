// SPDX-License-Identifier: BSD-3-Clause
#include "io/dynamics/xdmf.hpp"

#include "io/files/whole_file.hpp"
#include "io/hdf5/read.hpp"
#include "io/hdf5/step_views.hpp"

#include <fmt/format.h>

#include <sstream>

namespace netloft::io {

namespace {

std::string item(const std::string& file, const std::string& path, const std::vector<std::size_t>& shape) {
  std::string extents;
  for (const std::size_t n : shape) extents += (extents.empty() ? "" : " ") + std::to_string(n);
  return fmt::format(
      "<DataItem Format=\"HDF\" NumberType=\"Float\" Precision=\"8\" Dimensions=\"{}\">{}:{}</DataItem>",
      extents, file, path);
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

std::string fields(const Reader& reader, const std::string& group, const char* center, std::size_t step,
                   const std::string& file) {
  std::string text;
  const std::string at = step_group(step) + group;
  if (!reader.has(at)) return text;
  for (const auto& name : reader.list(at)) {
    const auto shape = reader.shape(at + "/" + name);
    text += fmt::format("<Attribute Name=\"{}\" Center=\"{}\" AttributeType=\"{}\">{}</Attribute>\n", name,
                        center, shape.size() == 1 ? "Scalar" : "Vector", item(file, at + "/" + name, shape));
  }
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
  for (std::size_t i = 0; i < times.size(); ++i) {
    const std::string points = step_group(i) + "Points";
    out << fmt::format("<Grid Name=\"step {}\"><Time Value=\"{:.17g}\"/>\n", i, times[i]) << shared
        << "<Geometry GeometryType=\"XYZ\">" << item(file, points, reader.shape(points)) << "</Geometry>\n"
        << fields(reader, "PointData", "Node", i, file) << fields(reader, "CellData", "Cell", i, file)
        << "</Grid>\n";
  }
  out << "</Grid></Domain></Xdmf>\n";
  write_whole(std::filesystem::path(result).replace_extension(".xdmf"), out.str());
}

}  // namespace netloft::io
