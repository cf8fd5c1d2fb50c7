// SPDX-License-Identifier: BSD-3-Clause
//
// Commands for net plans, parts of the catalogue and gears of other programs.
#include "io/program/command_line/groups.hpp"
#include "io/program/command_line/shared.hpp"

namespace netloft::program {

namespace {

void add_net_plan_options(CLI::App& command, Options& o) {
  command.add_option("GEAR", o.target, "net plan (TOML); draw takes a result, too")->required();
  add_set_option(command, o, "a value of the plan: panels.top-wing.aft=130");
  add_plugin_options(command, o);
}

void add_picture_options(CLI::App& command, Options& o) {
  PictureOptions& p = o.picture;
  command.add_option("--view", p.view, "of a result: where from; else oblique")
      ->check(CLI::IsMember({"side", "top", "front", "oblique"}));
  as_word(command.add_option("--field", p.field, "of a result: what is coloured, or part; else tension"),
          "NAME");
  add_state_option(command, o);
  command.add_option("--width", p.width, "of a result: pixels; else 1000")->check(CLI::Range(300, 8000));
  command.add_option("--fit", p.fit, "of a result: what there is room for; else netting")
      ->check(CLI::IsMember({"netting", "boards", "all"}));
  command.add_flag("--dark", p.dark, "of a result: on dark ground");
  command.add_flag("--log", p.log, "of a result: logarithmic colours");
  command.add_flag("--elements", p.elements,
                   "of a result: netting in the value of each triangle, not in means at nodes");
  command.add_flag("--dimensions", p.dimensions,
                   "of a result: headline height and spreads as dimension lines");
}

}  // namespace

void add_gear_commands(CLI::App& app, Options& o) {
  auto* catalogue = app.add_subcommand("catalogue", "list the parts that scenes and gears name");
  catalogue->add_option("NAME", o.target, "a part, for all that is known of it, or a kind, such as twine");
  add_plugin_options(*catalogue, o);
  add_net_plan_options(
      *app.add_subcommand("check", "say whether a net plan can be sewn, and what to change if not"), o);
  auto* draw = app.add_subcommand("draw", "draw a net plan to scale, or the shape of a result");
  add_net_plan_options(*draw, o);
  add_picture_options(*draw, o);
  auto* mesh = draw->add_flag("--mesh", o.mesh, "in triangles, as it is divided for a simulation");
  draw->add_option("--nodes", o.mesh_nodes, "about as many, ropes included (2000)")
      ->needs(mesh)
      ->check(CLI::Range(3, 1000000))
      ->type_name("N");
  as_word(draw->add_option("-o,--output", o.output,
                           "picture; else the name of the gear or result with .svg, in this folder"),
          "FILE.svg|FILE.png");
}

void add_import_command(CLI::App& app, Options& o) {
  auto* command = app.add_subcommand(
      "import",
      "write a gear of another program as a scene; what cannot be carried over is said line by line");
  command
      ->add_option("FORMAT", o.kind,
                   "femnet: GEAR.don, with its mesh GEAR.mdg or without one; table: nodes and bars as "
                   "GEAR.csv; moordyn: a mooring")
      ->check(CLI::IsMember({"femnet", "table", "moordyn"}));
  auto* gear = command->add_option("GEAR", o.target, "file of the gear");
  command->add_flag("--divide", o.divides, "divide it into elements here, whatever mesh lies beside it");
  command->add_flag("--motion", o.moves,
                    "of FEMNET: the scene is the motion that its file describes, with waves and drums");
  as_word(
      command->add_option("--mesh", o.mesh_file,
                          "file of its mesh; else the one of the same name beside it, if it is of this gear"),
      "FILE")
      ->excludes("--divide");
  as_word(command->add_option(
              "-o,--output", o.output,
              "scene; else the gear's name with .toml, in this folder. Its mesh is written beside it"),
          "FILE.toml");
  command
      ->add_option(
          "--check", o.folder,
          "write nothing: say of all gears in a folder, and those below, what they need and how many convert")
      ->check(CLI::ExistingDirectory)
      ->type_name("FOLDER")
      ->excludes(gear);
  add_color_option(*command, o);
  add_json_option(*command, o);
}

}  // namespace netloft::program
