// SPDX-License-Identifier: BSD-3-Clause
//
// Commands for net plans, parts of the catalogue and gears of other programs.
#include "io/program/commands/gears.hpp"

#include "io/program/command_line/chosen.hpp"
#include "io/program/command_line/shared.hpp"

namespace netloft::program {

namespace {

// groups of options
constexpr const char *kForPlans = "For a net plan", *kForResults = "For a result", *kForPolars = "For polars",
                     *kForShapes = "For a net plan or a result", *kForFemnet = "For FEMNET";

constexpr const char* kSetInPlan = "a value of the plan: panels.top-wing.aft=130";

void add_check_command(CLI::App& app, Chosen& chosen) {
  auto [check, o] = add_command(
      app, chosen, "check", "say whether a net plan can be sewn, and what to change if not", check_command);
  check.add_option("GEAR", o.scene, "net plan")->required()->type_name("FILE.toml");
  add_set_option(check, o.set, kSetInPlan);
  add_scene_plugins_option(check, o);
  add_plugin_options(check, o);
}

void add_plan_options(CLI::App& draw, DrawOptions& o) {
  add_set_option(draw, o.set, kSetInPlan)->group(kForPlans);
  auto* mesh = draw.add_flag("--mesh", o.mesh, "draw the triangles into which a simulation divides the plan");
  mesh->group(kForPlans);
  draw.add_option("--nodes", o.nodes, "about how many nodes, those of ropes included; default: 2000")
      ->needs(mesh)
      ->check(CLI::Range(3, 1000000))
      ->type_name("N")
      ->group(kForPlans);
}

void add_picture_options(CLI::App& draw, DrawOptions& o) {
  draw.add_option("--width", o.width, "pixels; default: 2200 for a net plan, 1000 for a result")
      ->check(CLI::Range(300, 8000))
      ->group(kForShapes);
  const auto option = [&](const char* name, auto& value, const char* doc) {
    return draw.add_option(name, value, doc)->group(kForResults);
  };
  const auto flag = [&](const char* name, bool& value, const char* doc) {
    draw.add_flag(name, value, doc)->group(kForResults);
  };
  option("--view", o.view, "direction of view; default: oblique")
      ->check(CLI::IsMember({"side", "top", "front", "oblique"}));
  as_word(option("--field", o.field, "quantity that is shown by colours, or the word part; default: tension"),
          "NAME");
  add_state_option(draw, o.state)->group(kForResults);
  option("--fit", o.fit, "what has to fit into the picture; default: netting")
      ->check(CLI::IsMember({"netting", "boards", "all"}));
  flag("--dark", o.dark, "draw on dark ground");
  flag("--log", o.log, "logarithmic colours");
  flag("--elements", o.elements,
       "colour each triangle of netting by its own value, not by averages at nodes");
  flag("--dimensions", o.dimensions, "headline height and spreads as dimension lines");
}

void refuse_options_of_others(const DrawOptions& o, const CLI::App& draw) {
  switch (kind_of_drawable(o.file)) {
    case Drawable::net_plan:
      return require_group(draw, {kForPlans, kForShapes}, o.file + " is a net plan");
    case Drawable::result:
      return require_group(draw, {kForResults, kForShapes}, o.file + " is a result");
    case Drawable::polars:
      return require_group(draw, {kForPolars}, o.file + " holds polars");
  }
}

void add_draw_command(CLI::App& app, Chosen& chosen) {
  auto [draw, o] = add_command(app, chosen, "draw", "draw a net plan to scale, or the shape of a result",
                               draw_command, refuse_options_of_others);
  draw.add_option("GEAR", o.file, "net plan or polars, or result")
      ->required()
      ->type_name("FILE.toml|FILE.hdf");
  as_word(
      draw.add_option("-o,--output", o.output,
                      "picture, for net plans also .pdf, for polars .svg or .html; default: the name of the "
                      "gear or result with .svg, in this folder"),
      "FILE.svg|FILE.png|FILE.pdf|FILE.html");
  add_common_options(draw, o);
  add_plan_options(draw, o);
  add_picture_options(draw, o);
}

void add_catalogue_command(CLI::App& app, Chosen& chosen) {
  auto [catalogue, o] =
      add_command(app, chosen, "catalogue", "list the parts of the catalogue that scenes and gears can name",
                  catalogue_command);
  catalogue.add_option("NAME", o.name,
                       "a part, to print all its properties, or a kind of parts, such as twine");
  add_common_options(catalogue, o);
}

void refuse_options_of_femnet(const ImportOptions& o, const CLI::App& import) {
  if (!o.format.empty() && o.format != "femnet") require_group(import, {}, "the format is " + o.format);
}

/// Adds the options for FEMNET. --check applies to all gears in a folder, and excludes the options of a
/// single gear.
void add_femnet_options(CLI::App& import, ImportOptions& o, CLI::Option* gear, CLI::Option* output) {
  auto* divide = import
                     .add_flag("--divide", o.divide,
                               "divide the gear into elements, even if a mesh lies beside its file")
                     ->group(kForFemnet);
  import.add_flag("--motion", o.motion, "write the motion that the file describes, with waves and drums")
      ->group(kForFemnet);
  auto* mesh =
      as_word(
          import.add_option(
              "--mesh", o.mesh,
              "file of the mesh; default: the file of the same name beside GEAR, if it belongs to this gear"),
          "FILE")
          ->group(kForFemnet)
          ->excludes(divide);
  auto* check = import.add_option("--check", o.folder,
                                  "write nothing, but print what each gear in a folder and its subfolders "
                                  "needs, and how many gears can be converted");
  check->check(CLI::ExistingDirectory)->type_name("FOLDER")->group(kForFemnet);
  for (CLI::Option* of_one_gear : {gear, output, divide, mesh}) check->excludes(of_one_gear);
}

void add_import_command(CLI::App& app, Chosen& chosen) {
  auto [import, o] = add_command(
      app, chosen, "import",
      "write a gear of another program as a scene, and list line by line what cannot be carried over",
      import_command, refuse_options_of_femnet);
  import
      .add_option("FORMAT", o.format,
                  "femnet: GEAR.don, with its mesh GEAR.mdg or without one; table: nodes and bars as "
                  "GEAR.csv; moordyn: a mooring")
      ->check(CLI::IsMember({"femnet", "table", "moordyn"}));
  auto* gear = import.add_option("GEAR", o.gear, "file of the gear")->type_name("FILE");
  auto* output = as_word(
      import.add_option(
          "-o,--output", o.output,
          "scene; default: the gear's name with .toml, in this folder. The mesh is written beside the scene"),
      "FILE.toml");
  add_common_options(import, o);
  add_femnet_options(import, o, gear, output);
}

}  // namespace

void add_gear_commands(CLI::App& app, Chosen& chosen) {
  add_check_command(app, chosen);
  add_draw_command(app, chosen);
  add_import_command(app, chosen);
  add_catalogue_command(app, chosen);
}

}  // namespace netloft::program
