// SPDX-License-Identifier: BSD-3-Clause
//
// Commands about results that are there already: report, view, draw, export.
#include "io/formats/hdf5/handle.hpp"
#include "io/pictures/picture/gltf.hpp"
#include "io/pictures/picture/sheet.hpp"
#include "io/pictures/view/page.hpp"
#include "io/program/session/commands.hpp"
#include "io/program/session/error_json.hpp"
#include "io/program/session/last_words.hpp"
#include "io/program/session/replaced_file.hpp"
#include "io/program/session/terminal.hpp"
#include "io/results/file/result_mesh.hpp"
#include "io/results/text/result_report.hpp"
#include "io/results/text/tables.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>

namespace netloft::program {

namespace {

std::string output_of(const Options& options, const std::string& source, const char* ending) {
  if (!options.output.empty()) return options.output;
  std::filesystem::path name = std::filesystem::path(source).filename();
  if (name.extension() == ".part") name = name.stem();  // the journal of a motion
  return name.stem().string() + ending;
}

const std::vector<std::string> kPage = {".html", ".htm"}, kPicture = {".svg", ".png"};

/// The number of the state that is asked for; else of the last.
std::size_t state_of(const Options& options, const results::StoredResult& result) {
  const std::size_t count = std::max<std::size_t>(1, result.times.size());
  if (options.picture.state < 0) return count - 1;
  const auto state = static_cast<std::size_t>(options.picture.state);
  if (state < count) return state;
  throw UsageError{"--state " + std::to_string(state) + ": " + options.target +
                   (count == 1 ? " has one state, 0" : " has states 0 to " + std::to_string(count - 1))};
}

/// Writes a file and says so.
void write_and_say(const Options& options, const std::string& output, const std::string& content,
                   const std::vector<std::string>& sources, const std::vector<std::string>& endings = {}) {
  replace_file(output, content, sources, endings);
  if (options.json)
    std::puts(done_json(output).c_str());
  else
    Terminal(options.color).say("written to " + output);
}

pictures::SheetOptions sheet_options(const Options& options, const results::StoredResult& result) {
  pictures::SheetOptions sheet;
  sheet.view = pictures::view_of(options.picture.view).value_or(pictures::View::oblique);
  sheet.colouring = {options.picture.field, options.picture.log, options.picture.elements};
  sheet.with_dimensions = options.picture.dimensions;
  sheet.width = options.picture.width;
  sheet.framing = pictures::framing_called(options.picture.fit).value_or(pictures::Framing::netting);
  sheet.is_dark = options.picture.dark;
  sheet.state = state_of(options, result);
  return sheet;
}

int report(const Options& options) {
  const results::StoredResult result(options.target);
  if (options.html)
    write_and_say(options, output_of(options, options.target, ".html"), pictures::report_page(result),
                  {options.target}, kPage);
  else
    std::fputs((options.json  ? results::result_json(result) + "\n"
                : options.csv ? results::result_csv(result)
                              : results::result_text(result))
                   .c_str(),
               stdout);
  return result.is_answer() ? kDone : kNotConverged;
}

int view(const Options& options) {
  std::vector<std::unique_ptr<results::StoredResult>> results;
  std::vector<const results::StoredResult*> all;
  for (const auto& path : options.targets) {
    results.push_back(std::make_unique<results::StoredResult>(path));
    all.push_back(results.back().get());
  }
  write_and_say(options, output_of(options, options.targets.front(), ".html"),
                pictures::view_page(all, options.picture.states), options.targets, kPage);
  return kDone;
}

int draw_result(const Options& options) {
  const results::StoredResult result(options.target);
  const std::string output = output_of(options, options.target, ".svg");
  const bool is_png = std::filesystem::path(output).extension() == ".png";
  try {
    const pictures::SheetOptions how = sheet_options(options, result);
    write_and_say(options, output,
                  is_png ? pictures::png_sheet(result, how) : pictures::svg_sheet(result, how),
                  {options.target}, kPicture);
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

int export_result(const Options& options) {
  const std::string ending = std::filesystem::path(options.output).extension().string();
  if (ending != ".glb") refuse_idle(options, {"--field"}, "it is of a .glb");
  if (ending != ".csv") refuse_idle(options, {"--table"}, "it is of a .csv");
  const results::StoredResult result(options.target);
  const pictures::SheetOptions how = sheet_options(options, result);
  const std::size_t state = how.state;
  try {
    if (ending == ".glb")
      write_and_say(options, options.output, pictures::glb(pictures::shape_of(result, state, how.colouring)),
                    {options.target});
    else if (ending == ".csv")
      write_and_say(options, options.output,
                    options.kind == "elements" ? results::elements_csv(result, state)
                                               : results::nodes_csv(result, state),
                    {options.target});
    else if (const auto mesh = mesh_format_of(ending))
      write_and_say(options, options.output, results::mesh_of(result, state, *mesh), {options.target});
    else
      throw UsageError{options.output +
                       ": the ending says what is written, and there are .glb, .csv, .mesh, .obj and .vtk"};
  } catch (const std::invalid_argument& e) {
    throw UsageError{e.what()};
  }
  return kDone;
}

}  // namespace

int report_command(const Options& options) {
  return on_file(options.target, options.json, [&] { return report(options); });
}

int view_command(const Options& options) {
  std::string files;
  for (const auto& path : options.targets) files += (files.empty() ? "" : " or ") + path;
  return on_file(files, options.json, [&] { return view(options); });
}

int draw_result_command(const Options& options) {
  return on_file(options.target, options.json, [&] { return draw_result(options); });
}

int export_command(const Options& options) {
  return on_file(options.target, options.json, [&] { return export_result(options); });
}

}  // namespace netloft::program
