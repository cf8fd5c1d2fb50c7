// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/motion/xdmf.hpp"

#include "io/formats/files/whole_file.hpp"
#include "io/formats/hdf5/read.hpp"
#include "io/formats/svg/svg.hpp"

#include <fmt/format.h>

namespace netloft::results {

namespace {

/// A dataset with the rows of all states; the rows of a state begin at offsets[state]. `before` and `after`
/// are the XML texts before and after the number that gives the position of a state in the file.
struct SteppedArray {
  std::string before, after;
  std::uint64_t place;  // position of the array in the file [bytes]
  std::size_t columns;
  std::vector<std::int64_t> offsets;

  void append_to(std::string& text, std::size_t step) const {
    const auto first = static_cast<std::size_t>(offsets.at(step)) * columns;
    text += before;
    text += std::to_string(place + 8 * first);
    text += after;
  }
};

/// The beginning of an XML item that refers to bytes in the HDF5 file. It does not refer to a selection of a
/// dataset, because XDMF 2 and XDMF 3 count the start of a selection along different dimensions.
const char* const kItem =
    "<DataItem Format=\"Binary\" NumberType=\"{}\" Precision=\"8\" Endian=\"Little\" Seek=\"";

SteppedArray array_at(const formats::Reader& reader, const std::string& path, const std::string& offsets_path,
                      std::size_t rows, const std::string& file) {
  const auto shape = reader.shape(path);
  const std::size_t columns = shape.size() == 1 ? 1 : shape[1];
  return {fmt::format(fmt::runtime(kItem), "Float"),
          fmt::format("\" Dimensions=\"{}{}\">{}</DataItem>", rows,
                      columns == 1 ? "" : fmt::format(" {}", columns), file),
          reader.place(path), columns, reader.integers(offsets_path)};
}

/// Returns the fields of the file; part numbers and panel coordinates are left out.
std::vector<SteppedArray> fields_of(const formats::Reader& reader, const std::string& file) {
  std::vector<SteppedArray> arrays;
  for (const auto& [group, center] : {std::pair{"PointData", "Node"}, {"CellData", "Cell"}}) {
    const auto rows = static_cast<std::size_t>(
        reader.integer(center[0] == 'N' ? "/VTKHDF/NumberOfPoints" : "/VTKHDF/NumberOfCells"));
    if (rows == 0) continue;
    for (const auto& name : reader.list(std::string("/VTKHDF/") + group)) {
      const std::string offsets = std::string("/VTKHDF/Steps/") + group + "Offsets/" + name,
                        path = std::string("/VTKHDF/") + group + "/" + name;
      SteppedArray array = array_at(reader, path, offsets, rows, file);
      if (!reader.holds_reals(path) || (array.columns != 1 && array.columns != 3)) continue;
      array.before =
          fmt::format("<Attribute Name=\"{}\" Center=\"{}\" AttributeType=\"{}\">",
                      formats::escape_markup(name), center, array.columns == 1 ? "Scalar" : "Vector") +
          array.before;
      array.after += "</Attribute>\n";
      arrays.push_back(std::move(array));
    }
  }
  return arrays;
}

std::string topology(const formats::Reader& reader, const std::string& file) {
  const std::string path = "/netloft/xdmf/cells";
  return fmt::format("<Topology TopologyType=\"Mixed\" NumberOfElements=\"{}\">",
                     reader.shape("/VTKHDF/Types")[0]) +
         fmt::format(fmt::runtime(kItem), "Int") +
         fmt::format("{}\" Dimensions=\"{}\">{}</DataItem></Topology>\n", reader.place(path),
                     reader.shape(path)[0], file);
}

}  // namespace

void write_xdmf(const std::filesystem::path& result) {
  const formats::Reader reader = formats::Reader::of_own(result);
  const auto times = reader.times();
  if (times.size() < 2) return;
  const std::string file = formats::escape_markup(result.filename().string());
  std::string out =
      "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\"><Domain>\n"
      "<Grid Name=\"series\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  const std::string cells = topology(reader, file);
  const auto arrays = fields_of(reader, file);
  const SteppedArray points =
      array_at(reader, "/VTKHDF/Points", "/VTKHDF/Steps/PointOffsets",
               static_cast<std::size_t>(reader.integer("/VTKHDF/NumberOfPoints")), file);
  for (std::size_t i = 0; i < times.size(); ++i) {
    out += fmt::format("<Grid Name=\"step {}\"><Time Value=\"{:.17g}\"/>\n", i, times[i]);
    out += cells;
    out += "<Geometry GeometryType=\"XYZ\">";
    points.append_to(out, i);
    out += "</Geometry>\n";
    for (const SteppedArray& array : arrays) array.append_to(out, i);
    out += "</Grid>\n";
  }
  out += "</Grid></Domain></Xdmf>\n";
  formats::write_keeping(std::filesystem::path(result).replace_extension(".xdmf"), out);
}

}  // namespace netloft::results
