// SPDX-License-Identifier: BSD-3-Clause
//
// Converts gears of other programs into scenes.
#include "io/program/commands/gears.hpp"
#include "io/program/session/print.hpp"
#include "io/program/session/replaced_file.hpp"
#include "io/program/session/terminal.hpp"
#include "io/scenes/import/import.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace netloft::program {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

void print_import(const Json& json) { print_line(json.dump(2, ' ', false, Json::error_handler_t::replace)); }

Json findings_json(const formats::Diagnostics& diagnostics) {
  Json all = Json::array();
  for (const auto& d : diagnostics.sorted())
    all.push_back({{"severity", d.severity == formats::Severity::error ? "error" : "warning"},
                   {"at", diagnostics.where(d.place)},
                   {"message", d.message}});
  return all;
}

std::string verdict_of(const scenes::FolderCheck::Gear& gear) {
  if (!gear.is_read) return "not read";
  return gear.lines.empty() ? "converts" : "converts, but leaves out";
}

void print_check(const scenes::FolderCheck& check) {
  for (const auto& gear : check.gears) {
    print_line(fmt::format("{:<50} {}", gear.name, verdict_of(gear)));
    for (const auto& line : gear.lines) print_line("    " + line);
  }
  for (const auto& [feature, gears] : check.features)
    print_line(fmt::format("needed in {:>5}: {}", gears, feature));
  for (const auto& [need, gears] : check.needs) print_line(fmt::format("left out in {:>3}: {}", gears, need));
  print_line(fmt::format("{} of {} gears can be converted completely", check.whole, check.gears.size()));
}

int check_gears(const ImportOptions& options) {
  const scenes::FolderCheck check = scenes::check_folder(options.folder, options.motion);
  if (check.gears.empty()) throw UsageError{"--check " + options.folder + ": there is no GEAR.don in it"};
  if (!options.json) {
    print_check(check);
    return kDone;
  }
  Json json = {{"status", "done"},
               {"whole", check.whole},
               {"needs", check.needs},
               {"features", check.features},
               {"gears", Json::array()}};
  for (const auto& gear : check.gears)
    json["gears"].push_back({{"name", gear.name},
                             {"verdict", verdict_of(gear)},
                             {"lines", gear.lines},
                             {"features", gear.features}});
  print_import(json);
  return kDone;
}

/// The paths of the scene and of its mesh.
struct Outputs {
  explicit Outputs(const ImportOptions& options)
      : scene(options.output.empty() ? fs::path(options.gear).stem().string() + ".toml" : options.output),
        mesh(fs::path(scene).replace_extension(".mesh")) {
    require_ending("-o", scene.string(), {".toml"});
  }
  fs::path scene, mesh;
};

auto import_of(const std::string& format) {
  return format == "table"     ? scenes::import_table
         : format == "moordyn" ? scenes::import_moordyn
                               : scenes::import_femnet;
}

int import_gear(const ImportOptions& options) {
  const Outputs to(options);
  Terminal terminal(options);
  formats::Diagnostics diagnostics;
  const scenes::ImportedGear gear = import_of(options.format)(
      {options.gear, options.mesh, to.mesh.filename().string(), options.divide, options.motion}, diagnostics);
  if (diagnostics.errors() + diagnostics.warnings() > 0) terminal.say(diagnostics);
  const int code = diagnostics.errors() ? kWrongInput : kDone;
  if (code == kDone) {
    const std::vector<std::string> sources{options.gear, options.mesh};
    replace_file(to.mesh.string(), gear.mesh, sources);
    replace_file(to.scene.string(), gear.scene, sources, {".toml"});
  }
  if (options.json)
    print_import({{"status", code == kDone ? "done" : "wrong input"},
                  {"output", to.scene.string()},
                  {"left_out", gear.left_out},
                  {"findings", findings_json(diagnostics)}});
  else if (code == kDone)
    terminal.say(fmt::format("written to {} and {}: {} nodes, {} elements, {} left out", to.scene.string(),
                             to.mesh.string(), gear.nodes, gear.elements, gear.left_out.size()));
  return code;
}

}  // namespace

int import_command(const ImportOptions& options) {
  if (!options.folder.empty()) return check_gears(options);
  if (options.gear.empty()) throw UsageError{"import: GEAR is missing, the file of the gear"};
  return import_gear(options);
}

}  // namespace netloft::program
