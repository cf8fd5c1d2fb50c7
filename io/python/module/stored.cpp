// SPDX-License-Identifier: BSD-3-Clause
//
// Result files: their contents, and pictures and pages made from them.
#include "io/pictures/picture/sheet.hpp"
#include "io/pictures/view/page.hpp"
#include "io/python/module/module.hpp"
#include "io/python/module/report_of.hpp"
#include "io/results/file/stored_shape.hpp"

#include <pybind11/stl/filesystem.h>

#include <memory>

namespace netloft::python {

namespace py = pybind11;

namespace {

using results::StoredShape;

std::size_t count_states(const StoredShape& shape) { return std::max<std::size_t>(1, shape.times.size()); }

/// The index of a state; as in Python, negative numbers count from the end.
std::size_t state_at(const StoredShape& shape, std::int64_t state) {
  const auto count = static_cast<std::int64_t>(count_states(shape));
  if (state < -count || state >= count)
    throw py::index_error("there is no state " + std::to_string(state) + "; the result has " +
                          std::to_string(count));
  return static_cast<std::size_t>(state < 0 ? state + count : state);
}

py::array points_at(const StoredShape& shape, std::int64_t state) {
  return copy_of(shape.points(state_at(shape, state))).attr("reshape")(-1, 3);
}

template <std::size_t n>
py::array cells_of(const std::vector<std::array<std::uint32_t, n>>& cells) {
  py::array_t<std::uint32_t> all({static_cast<py::ssize_t>(cells.size()), static_cast<py::ssize_t>(n)});
  for (std::size_t c = 0; c < cells.size(); ++c)
    std::copy(cells[c].begin(), cells[c].end(), all.mutable_data(static_cast<py::ssize_t>(c), 0));
  return all;
}

/// The cells of the mesh: "triangle" and "line", each a tuple (nodes, numbers of the cells, parts of the
/// cells).
py::dict mesh_of(const StoredShape& shape) {
  const auto& mesh = shape.mesh;
  const auto parts = [&](const std::vector<std::uint32_t>& cells) {
    py::list names;
    for (const std::uint32_t c : cells) names.append(shape.parts.at(mesh.cell_part.at(c)).name);
    return names;
  };
  py::dict all;
  all["triangle"] =
      py::make_tuple(cells_of(mesh.triangles), copy_of(mesh.triangle_cells), parts(mesh.triangle_cells));
  all["line"] = py::make_tuple(cells_of(mesh.bars), copy_of(mesh.bar_cells), parts(mesh.bar_cells));
  return all;
}

py::dict series_of(const StoredShape& shape) {
  py::dict all;
  for (const auto& s : shape.series) all[py::str(s.name)] = py::make_tuple(copy_of(s.values), s.unit);
  return all;
}

py::array field_at(const StoredShape& shape, const std::string& name, std::int64_t state) {
  return copy_of(shape.field(name, state_at(shape, state)));
}

// Limits of the width of a picture [pixels]. The time for a picture grows with the square of its width, up to
// several seconds.
constexpr std::size_t kLeastWidth = 100, kMostWidth = 5000;

/// A picture of a state as SVG or PNG. Throws std::invalid_argument for an unknown field or view.
std::string picture_of(const StoredShape& shape, bool is_png, const std::string& view,
                       const std::string& field, std::int64_t state, std::size_t width) {
  pictures::SheetOptions options;
  const auto from = pictures::view_of(view);
  if (!from) throw std::invalid_argument("no view \"" + view + "\"; there are oblique, side, top, front");
  options.view = *from;
  options.colouring.field = field;
  options.state = state_at(shape, state);
  options.width = width;
  if (width < kLeastWidth || width > kMostWidth)
    throw std::invalid_argument("a picture is " + std::to_string(kLeastWidth) + " to " +
                                std::to_string(kMostWidth) + " pixels wide");
  const py::gil_scoped_release others_may_run;
  return is_png ? pictures::png_sheet(shape, options) : pictures::svg_sheet(shape, options);
}

std::string page_of(const std::vector<std::shared_ptr<StoredShape>>& shapes, std::size_t most_states) {
  std::vector<const StoredShape*> all;
  for (const auto& shape : shapes) all.push_back(shape.get());
  return pictures::view_page(all, most_states);
}

}  // namespace

void bind_stored(py::module_& module) {
  py::class_<StoredShape, std::shared_ptr<StoredShape>> stored(module, "Stored");
  stored.def(py::init<const std::filesystem::path&>(), py::arg("path"))
      .def_property_readonly("title", [](const StoredShape& s) { return s.result.title; })
      .def_property_readonly("times", [](const StoredShape& s) { return copy_of(s.times); })
      .def_property_readonly("stages", [](const StoredShape& s) { return s.stages; })
      .def("fields",
           [](const StoredShape& s) {
             std::vector<std::string> names;
             for (const auto& field : s.fields) names.push_back(field.name);
             return names;
           })
      .def("points", &points_at, py::arg("state") = -1)
      .def("mesh", &mesh_of)
      .def("field", &field_at, py::arg("name"), py::arg("state") = -1)
      .def("series", &series_of)
      .def(
          "picture",
          [](const StoredShape& s, bool is_png, const std::string& view, const std::string& field,
             std::int64_t state,
             std::size_t width) { return py::bytes(picture_of(s, is_png, view, field, state, width)); },
          py::arg("is_png"), py::arg("view"), py::arg("field"), py::arg("state"), py::arg("width"));
  add_report(stored, [](const StoredShape& s) -> const results::Result& { return s.result; });
  module.def("page", &page_of, py::arg("shapes"), py::arg("most_states"));
}

}  // namespace netloft::python
