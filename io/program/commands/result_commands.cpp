// SPDX-License-Identifier: BSD-3-Clause
//
// Commands about existing results: report, view, draw, export.
#include "io/formats/hdf5/handle.hpp"
#include "io/pictures/picture/gltf.hpp"
#include "io/pictures/picture/sheet.hpp"
#include "io/pictures/view/page.hpp"
#include "io/program/commands/gears.hpp"
#include "io/program/commands/results.hpp"
#include "io/program/session/error_json.hpp"
#include "io/program/session/last_words.hpp"
#include "io/program/session/print.hpp"
#include "io/program/session/replaced_file.hpp"
#include "io/program/session/terminal.hpp"
#include "io/results/file/read_result.hpp"
#include "io/results/file/result_mesh.hpp"
#include "io/results/text/result_text.hpp"
#include "io/results/text/tables.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>

namespace netloft::program {

namespace {

/// Returns `given`; if that is empty, the name of a result with another extension, in the current folder.
std::string output_or(const std::string& given, const std::string& result, const char* ending) {
  if (!given.empty()) return given;
  std::filesystem::path name = std::filesystem::path(result).filename();
  if (name.extension() == ".part") name = name.stem();  // the journal of a motion
  return name.stem().string() + ending;
}

const std::vector<std::string> kPage = {".html", ".htm"}, kPicture = {".svg", ".png"};

/// The index of the state that --state selects; the last state by default.
std::size_t state_of(int state, const results::StoredShape& result, const std::string& file) {
  const std::size_t count = std::max<std::size_t>(1, result.times.size());
  if (state < 0) return count - 1;
  if (static_cast<std::size_t>(state) < count) return static_cast<std::size_t>(state);
  throw UsageError{"--state " + std::to_string(state) + ": " + file +
                   (count == 1 ? " has one state, 0" : " has states 0 to " + std::to_string(count - 1))};
}

void write_and_report(const CommonOptions& options, const std::string& output, const std::string& content,
                      const std::vector<std::string>& sources, const std::vector<std::string>& endings = {}) {
  replace_file(output, content, sources, endings);
  if (options.json)
    print_line(done_json(output));
  else
    Terminal(options).say("written to " + output);
}

int report(const ReportOptions& options) {
  const results::Result result = results::read_result(options.result);
  if (!options.output.empty())
    write_and_report(options, options.output, pictures::report_page(results::StoredShape(options.result)),
                     {options.result}, kPage);
  else
    print(options.json  ? results::result_json(result) + "\n"
          : options.csv ? results::result_csv(result)
                        : results::result_text(result));
  return result.is_answer() ? kDone : kNotConverged;
}

int view(const ViewOptions& options) {
  std::vector<std::unique_ptr<results::StoredShape>> results;
  std::vector<const results::StoredShape*> all;
  for (const auto& path : options.results) {
    results.push_back(std::make_unique<results::StoredShape>(path));
    all.push_back(results.back().get());
  }
  write_and_report(options, output_or(options.output, options.results.front(), ".html"),
                   pictures::view_page(all, options.states), options.results, kPage);
  return kDone;
}

pictures::SheetOptions sheet_options(const DrawOptions& options, const results::StoredShape& result) {
  pictures::SheetOptions sheet;
  sheet.view = pictures::view_of(options.view).value_or(pictures::View::oblique);
  sheet.colouring = {options.field, options.log, options.elements};
  sheet.with_dimensions = options.dimensions;
  if (options.width) sheet.width = options.width;
  sheet.framing = pictures::framing_called(options.fit).value_or(pictures::Framing::netting);
  sheet.is_dark = options.dark;
  sheet.state = state_of(options.state, result, options.file);
  return sheet;
}

int draw_result(const DrawOptions& options) {
  const results::StoredShape result(options.file);
  const std::string output = output_or(options.output, options.file, ".svg");
  const bool is_png = std::filesystem::path(output).extension() == ".png";
  try {
    const pictures::SheetOptions how = sheet_options(options, result);
    write_and_report(options, output,
                     is_png ? pictures::png_sheet(result, how) : pictures::svg_sheet(result, how),
                     {options.file}, kPicture);
  } catch (const std::invalid_argument& e) {
    throw UsageError{e.what()};
  }
  return kDone;
}

std::optional<results::MeshFormat> mesh_format_of(const std::string& ending) {
  if (ending == ".mesh") return results::MeshFormat::own;
  if (ending == ".obj") return results::MeshFormat::obj;
  return ending == ".vtk" ? std::optional(results::MeshFormat::vtk) : std::nullopt;
}

/// The content of an exported file in the format of its extension.
std::string exported(const ExportOptions& options) {
  const results::StoredShape result(options.result);
  const std::string ending = std::filesystem::path(options.output).extension().string();
  const std::size_t state = state_of(options.state, result, options.result);
  if (ending == ".glb")
    return pictures::glb(pictures::shape_of(result, state, {options.field, false, false}));
  if (ending == ".csv")
    return options.table == "elements" ? results::elements_csv(result, state)
                                       : results::nodes_csv(result, state);
  if (const auto mesh = mesh_format_of(ending)) return results::mesh_of(result, state, *mesh);
  throw UsageError{options.output +
                   ": the ending of the name chooses the format; it must be .glb, .csv, .mesh, .obj or .vtk"};
}

int export_result(const ExportOptions& options) {
  try {
    write_and_report(options, options.output, exported(options), {options.result});
  } catch (const std::invalid_argument& e) {
    throw UsageError{e.what()};
  }
  return kDone;
}

}  // namespace

int report_command(const ReportOptions& options) {
  return on_file(options.result, options.json, [&] { return report(options); });
}

int view_command(const ViewOptions& options) {
  std::string files;
  for (const auto& path : options.results) files += (files.empty() ? "" : " or ") + path;
  return on_file(files, options.json, [&] { return view(options); });
}

int draw_result_command(const DrawOptions& options) {
  return on_file(options.file, options.json, [&] { return draw_result(options); });
}

int export_command(const ExportOptions& options) {
  return on_file(options.result, options.json, [&] { return export_result(options); });
}

}  // namespace netloft::program
