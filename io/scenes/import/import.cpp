// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/import/import.hpp"

#include "io/scenes/import/bar_table.hpp"
#include "io/scenes/import/femnet_scene.hpp"
#include "io/scenes/import/moordyn.hpp"

#include <algorithm>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>

namespace netloft::scenes {

namespace {

namespace fs = std::filesystem;
constexpr std::uintmax_t kLargestFile = 256u << 20;  // [bytes]

/// The text of a file. If the file cannot be read, reports an error and returns nullopt.
std::optional<std::string> read_text(const fs::path& path, formats::Diagnostics& diagnostics) {
  std::error_code fault;
  if (!fs::is_regular_file(path, fault)) {
    diagnostics.error({}, path.string() + ": there is no such file");
    return {};
  }
  if (fs::file_size(path, fault) > kLargestFile) {
    diagnostics.error({}, path.string() + ": the file is larger than 256 MiB");
    return {};
  }
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in) diagnostics.error({}, path.string() + ": cannot be read");
  return in ? std::optional(std::move(text).str()) : std::nullopt;
}

/// The path of the mesh of a gear: the requested path, or the path of the gear with the extension .mdg or
/// .MDG.
fs::path mesh_of(const ImportRequest& request) {
  if (!request.mesh.empty()) return request.mesh;
  fs::path beside = request.gear;
  for (const char* ending : {".mdg", ".MDG"})
    if (fs::exists(beside.replace_extension(ending))) return beside;
  return beside.replace_extension(".mdg");
}

void report(const std::vector<femnet::Finding>& findings, formats::Diagnostics& diagnostics,
            ImportedGear& out) {
  for (const auto& f : findings) {
    const bool is_left_out = f.kind == femnet::Finding::Kind::left_out;
    diagnostics.warning(f.place, (is_left_out ? "left out: " : "") + f.what + ": " + f.text);
    if (is_left_out) out.left_out.push_back(f.what + ": " + f.text);
  }
}

/// A mesh and the file from which it was read.
struct FoundMesh {
  femnet::MeshFile mesh;
  std::string name;  // name of the file; empty if the import divided the gear
};

/// Divides the gear into elements, although it may have a mesh. Requested outputs at nodes are dropped,
/// because they name nodes by their numbers in FEMNET's mesh. Panels with netting2ropes get triangles,
/// because only FEMNET knows the places of their bars.
FoundMesh divide(femnet::GearFile& gear, const std::string& why, formats::Diagnostics& diagnostics) {
  using femnet::Finding, femnet::Wanted;
  gear.findings.push_back(
      {{}, Finding::Kind::note, "the mesh", why + ": the gear is divided into elements here"});
  gear.findings.insert(gear.findings.end(), gear.of_mesher.begin(), gear.of_mesher.end());
  const auto wanted = std::erase_if(gear.wanted, [](auto& w) { return w.kind != Wanted::Kind::tension; });
  if (wanted > 0)
    gear.findings.push_back(
        {{},
         Finding::Kind::note,
         "requested results",
         std::to_string(wanted) +
             " of them are left out, because they name nodes by their numbers in FEMNET's mesh"});
  for (auto& p : gear.panels) {
    if (p.twines > 0)
      gear.findings.push_back({p.place, Finding::Kind::note, "netting2ropes", "its panel is in triangles"});
    p.twines = 0;
  }
  return {femnet::divide_gear(gear, diagnostics), {}};
}

/// Reads the mesh of the gear, or divides the gear. A mesh that the user did not name but that is beside the
/// gear is used only if all its parts are parts of the gear; otherwise it is outdated.
FoundMesh find_mesh(const ImportRequest& request, femnet::GearFile& gear, formats::Diagnostics& diagnostics) {
  const fs::path path = mesh_of(request);
  const bool is_named = !request.mesh.empty();
  if (request.divides) return divide(gear, "not used", diagnostics);
  if (!is_named && !fs::exists(path)) return divide(gear, "there is none", diagnostics);
  const auto text = read_text(path, diagnostics);
  if (!text) return {};
  formats::Diagnostics of_mesh;
  const auto tried =
      femnet::read_mesh_file(*text, of_mesh.add_source(path.filename().string(), *text), gear, of_mesh);
  if (tried.is_of_another_gear && !is_named) {
    const auto first = of_mesh.sorted().front();
    return divide(gear, "older than the gear, " + of_mesh.where(first.place) + ": " + first.message,
                  diagnostics);
  }
  if (of_mesh.errors())
    femnet::read_mesh_file(*text, diagnostics.add_source(path.string(), *text), gear, diagnostics);
  return {tried, path.filename().string()};
}

/// Reads and converts a gear; returns all findings.
std::vector<femnet::Finding> convert(const ImportRequest& request, formats::Diagnostics& diagnostics,
                                     ImportedGear& out) {
  const auto text = read_text(request.gear, diagnostics);
  if (!text) return {};
  const int file = diagnostics.add_source(request.gear.string(), *text);
  auto gear = femnet::read_gear(*text, file, diagnostics);
  if (diagnostics.errors()) return gear.findings;
  out.features = femnet::features_of(gear);
  const auto [mesh, mesh_name] = find_mesh(request, gear, diagnostics);
  if (diagnostics.errors()) return gear.findings;
  const femnet::Names names{request.gear.filename().string(), mesh_name, request.own_mesh};
  auto imported = femnet::import_gear(gear, mesh, names, diagnostics,
                                      request.moves ? femnet::Sought::motion : femnet::Sought::rest);
  if (diagnostics.errors()) return imported.findings;
  out.scene = std::move(imported.scene);
  out.mesh = formats::mesh_text(
      imported.mesh,
      "the mesh of " + names.gear + (mesh_name.empty() ? ", divided on its import" : ", from " + mesh_name));
  out.nodes = mesh.nodes.size();
  out.elements = mesh.bars.size() + mesh.triangles.size();
  return imported.findings;
}

bool is_gear(const fs::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return ending == ".don";
}

FolderCheck::Gear check_gear(const fs::path& path, const fs::path& folder, bool moves, FolderCheck& out) {
  formats::Diagnostics diagnostics;
  ImportedGear gear;
  FolderCheck::Gear result{fs::relative(path, folder).string(), false, {}};
  std::set<std::string> needs;
  for (const auto& f : convert({path, {}, "gear.mesh", false, moves}, diagnostics, gear))
    if (f.kind == femnet::Finding::Kind::left_out) {
      needs.insert(f.text);
      result.lines.push_back(f.what + ": " + f.text);
    }
  for (const auto& need : needs) ++out.needs[need];
  for (const auto& feature : gear.features) ++out.features[feature];
  result.features = gear.features;
  result.is_read = diagnostics.errors() == 0;
  for (const auto& d : diagnostics.sorted())
    if (d.severity == formats::Severity::error)
      result.lines.push_back(diagnostics.where(d.place) + ": " + d.message);
  return result;
}

ImportedGear of_bars(const BarTable& table, const std::vector<std::string>& head,
                     const ImportRequest& request) {
  auto written = scene_of(table, head, request.own_mesh);
  ImportedGear out{std::move(written.scene),
                   formats::mesh_text(written.mesh, "the bars of " + request.gear.filename().string())};
  out.nodes = written.mesh.node_count();
  for (const auto& region : written.mesh.regions) out.elements += region.size();
  return out;
}

}  // namespace

ImportedGear import_femnet(const ImportRequest& request, formats::Diagnostics& diagnostics) {
  ImportedGear out;
  const auto findings = convert(request, diagnostics, out);
  report(findings, diagnostics, out);
  return out;
}

ImportedGear import_table(const ImportRequest& request, formats::Diagnostics& diagnostics) {
  const auto text = read_text(request.gear, diagnostics);
  if (!text) return {};
  const auto table = read_bar_table(*text, diagnostics.add_source(request.gear.string(), *text), diagnostics);
  const std::string name = request.gear.filename().string();
  return diagnostics.errors() ? ImportedGear()
                              : of_bars(table, {"Imported from " + name + ", nodes and bars."}, request);
}

ImportedGear import_moordyn(const ImportRequest& request, formats::Diagnostics& diagnostics) {
  const auto text = read_text(request.gear, diagnostics);
  if (!text) return {};
  const auto mooring = read_moordyn(*text, diagnostics.add_source(request.gear.string(), *text), diagnostics);
  std::vector<std::string> head{"Imported from " + request.gear.filename().string() +
                                ", a file of MoorDyn. Names have the numbers of that file."};
  ImportedGear out;
  for (const auto& f : mooring.findings) {
    diagnostics.warning(f.place, (f.is_left_out ? "left out: " : "") + f.text);
    head.push_back(std::string(f.is_left_out ? "left out" : "note") + ", line " +
                   std::to_string(f.place.line) + ": " + f.text);
    if (f.is_left_out) out.left_out.push_back(f.text);
  }
  if (diagnostics.errors()) return out;
  auto imported = of_bars(mooring.table, head, request);
  imported.left_out = out.left_out;
  return imported;
}

FolderCheck check_folder(const fs::path& folder, bool moves) {
  FolderCheck out;
  std::vector<fs::path> files;
  for (const auto& entry :
       fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied))
    if (entry.is_regular_file() && is_gear(entry.path())) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    out.gears.push_back(check_gear(file, folder, moves, out));
    out.whole += out.gears.back().is_read && out.gears.back().lines.empty();
  }
  return out;
}

}  // namespace netloft::scenes
