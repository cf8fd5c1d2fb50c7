// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/hdf5/journal.hpp"
#include "io/gears/drawing/drawing.hpp"
#include "io/gears/meshing/cannot_divide.hpp"
#include "io/gears/meshing/division.hpp"
#include "io/gears/plan/checked_plan.hpp"
#include "io/gears/plan/read_plan.hpp"
#include "io/pictures/picture/pdf_picture.hpp"
#include "io/pictures/picture/pixel_picture.hpp"
#include "io/program/commands/draw_polars.hpp"
#include "io/program/commands/gears.hpp"
#include "io/program/session/error_json.hpp"
#include "io/program/session/print.hpp"
#include "io/program/session/replaced_file.hpp"
#include "io/program/session/session.hpp"
#include "io/program/session/terminal.hpp"

#include <array>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace netloft::program {

namespace {

constexpr double kPlanWidth = 2200;  // width of the picture of a net plan [pixels]

/// Whether a file is a result, by its extension or by its first bytes.
bool is_result(const std::string& path) {
  if (std::filesystem::path(path).extension() == ".hdf" || formats::is_journal(path)) return true;
  std::error_code none;
  // not for a pipe: reading it would wait for ever
  if (!std::filesystem::is_regular_file(path, none)) return false;
  std::ifstream file(path, std::ios::binary);
  std::array<char, 4> start{};
  return file.read(start.data(), start.size()) && std::string_view(start.data(), 4) == "\x89HDF";
}

std::string output_of(const DrawOptions& options) {
  if (!options.output.empty()) return options.output;
  return std::filesystem::path(options.file).stem().string() + ".svg";
}

bool ends_in(const std::string& output, const char* ending) {
  return std::filesystem::path(output).extension() == ending;
}

std::vector<std::string> files_of(const gears::NetPlan& plan) {
  std::vector<std::string> paths;
  for (const auto& file : plan.files) paths.push_back(file.path);
  return paths;
}

/// Reports the errors and warnings about a file. Returns the exit code.
int say(const formats::Diagnostics& diagnostics, Terminal& terminal) {
  if (diagnostics.errors() + diagnostics.warnings() > 0) terminal.say(diagnostics);
  if (diagnostics.errors() == 0) return kDone;
  if (terminal.json()) print_line(errors_json(diagnostics, kWrongInput));
  return kWrongInput;
}

void report_written(const std::string& output, Terminal& terminal) {
  if (terminal.json())
    print_line(done_json(output));
  else
    terminal.say("written to " + output);
}

int draw_polars_command(const DrawOptions& options) {
  Terminal terminal(options);
  formats::Diagnostics diagnostics;
  const std::string output = output_of(options);
  const std::string picture = draw_polars(options.file, output.ends_with(".html"), diagnostics);
  if (const int code = say(diagnostics, terminal); code != kDone) return code;
  replace_file(output, picture, {options.file}, {".svg", ".html"});
  report_written(output, terminal);
  return kDone;
}

/// Draws a plan or, with --mesh, its mesh. Adds errors to `diagnostics`.
formats::DrawingSize draw_on(formats::LineDrawing& picture, const gears::NetPlan& plan,
                             const DrawOptions& options, formats::Diagnostics& diagnostics) {
  if (!options.mesh) return gears::draw_plan(plan, picture);
  const gears::Gear gear = gears::make_gear(plan, gears::Extent::whole);
  gears::Fineness fineness;
  fineness.nodes = options.nodes;
  try {
    return gears::draw_mesh(plan, gear, gears::divide(gear, fineness), picture);
  } catch (const gears::CannotDivide& refused) {
    refused.report(plan, diagnostics);
    return {1, 1};
  }
}

/// The content of the picture file, in the format that its ending names.
std::string picture_of(const gears::NetPlan& plan, const DrawOptions& options,
                       formats::Diagnostics& diagnostics) {
  const double pixels = options.width ? static_cast<double>(options.width) : kPlanWidth;
  try {
    if (ends_in(output_of(options), ".png")) {
      pictures::PixelPicture picture;
      return picture.finish(draw_on(picture, plan, options, diagnostics), pixels);
    }
    if (ends_in(output_of(options), ".pdf")) {
      pictures::PdfPicture picture;
      return picture.finish(draw_on(picture, plan, options, diagnostics));
    }
    formats::SvgPicture picture;
    return picture.finish(draw_on(picture, plan, options, diagnostics), pixels);
  } catch (const std::invalid_argument& e) {
    throw UsageError{e.what()};
  }
}

int draw_plan(const DrawOptions& options) {
  Terminal terminal(options);
  formats::Diagnostics diagnostics;
  refuse_undone(options.set);
  const gears::NetPlan plan = gears::read_and_check(options.file, options.set, diagnostics);
  if (diagnostics.errors() == 0) gears::check_seams(plan, diagnostics);
  if (const int code = say(diagnostics, terminal); code != kDone) return code;
  const std::string output = output_of(options);
  formats::Diagnostics of_division = diagnostics.without_messages();
  const std::string picture = picture_of(plan, options, of_division);
  if (const int code = say(of_division, terminal); code != kDone) return code;
  replace_file(output, picture, files_of(plan), {".svg", ".png", ".pdf"});
  report_written(output, terminal);
  return kDone;
}

}  // namespace

Drawable kind_of_drawable(const std::string& file) {
  if (is_result(file)) return Drawable::result;
  return holds_polars(file) ? Drawable::polars : Drawable::net_plan;
}

int draw_command(const DrawOptions& options) {
  switch (kind_of_drawable(options.file)) {
    case Drawable::result:
      return draw_result_command(options);
    case Drawable::polars:
      return draw_polars_command(options);
    default:
      return draw_plan(options);
  }
}

}  // namespace netloft::program
