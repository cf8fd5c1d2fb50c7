// SPDX-License-Identifier: BSD-3-Clause
#include "io/import/import.hpp"

#include "io/import/femnet_scene.hpp"

#include <algorithm>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>

namespace netloft::io {

namespace {

namespace fs = std::filesystem;
constexpr std::uintmax_t kLargestFile = 256u << 20;  // [bytes]

/// The text of a file; nothing, and an error, if it cannot be read.
std::optional<std::string> read_text(const fs::path& path, Diagnostics& diagnostics) {
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

/// The mesh of a gear: the file that was named, or the one beside it, whatever the letters of its ending.
fs::path mesh_of(const ImportRequest& request) {
  if (!request.mesh.empty()) return request.mesh;
  fs::path beside = request.gear;
  for (const char* ending : {".mdg", ".MDG"})
    if (fs::exists(beside.replace_extension(ending))) return beside;
  return beside.replace_extension(".mdg");
}

void report(const std::vector<femnet::Finding>& findings, Diagnostics& diagnostics, ImportedGear& out) {
  for (const auto& f : findings) {
    const bool is_left_out = f.kind == femnet::Finding::Kind::left_out;
    diagnostics.warning(f.place, (is_left_out ? "left out: " : "") + f.what + ": " + f.text);
    if (is_left_out) out.left_out.push_back(f.what + ": " + f.text);
  }
}

/// Reads and converts; the findings in full.
std::vector<femnet::Finding> convert(const ImportRequest& request, Diagnostics& diagnostics,
                                     ImportedGear& out) {
  const auto text = read_text(request.gear, diagnostics);
  if (!text) return {};
  const int file = diagnostics.add_source(request.gear.string(), *text);
  const auto gear = femnet::read_gear(*text, file, diagnostics);
  if (diagnostics.errors()) return gear.findings;
  const fs::path mesh_path = mesh_of(request);
  const auto mesh_text_read = read_text(mesh_path, diagnostics);
  if (!mesh_text_read) return gear.findings;
  const int mesh_file = diagnostics.add_source(mesh_path.string(), *mesh_text_read);
  const auto mesh = femnet::read_mesh_file(*mesh_text_read, mesh_file, gear, diagnostics);
  if (diagnostics.errors()) return gear.findings;
  const femnet::Names names{request.gear.filename().string(), mesh_path.filename().string(),
                            request.own_mesh};
  auto imported = femnet::import_gear(gear, mesh, names, diagnostics);
  if (diagnostics.errors()) return imported.findings;
  out.scene = std::move(imported.scene);
  out.mesh = mesh_text(imported.mesh, "the mesh of " + names.gear + ", from " + names.mesh);
  out.nodes = mesh.nodes.size(), out.elements = mesh.bars.size() + mesh.triangles.size();
  return imported.findings;
}

bool is_gear(const fs::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return ending == ".don";
}

FolderCheck::Gear check_gear(const fs::path& path, const fs::path& folder, FolderCheck& out) {
  Diagnostics diagnostics;
  ImportedGear gear;
  FolderCheck::Gear result{fs::relative(path, folder).string(), false, {}};
  std::set<std::string> needs;
  for (const auto& f : convert({path, {}, "gear.mesh"}, diagnostics, gear))
    if (f.kind == femnet::Finding::Kind::left_out)
      needs.insert(f.text), result.lines.push_back(f.what + ": " + f.text);
  for (const auto& need : needs) ++out.needs[need];
  result.is_read = diagnostics.errors() == 0;
  for (const auto& d : diagnostics.sorted())
    if (d.severity == Severity::error) result.lines.push_back(diagnostics.where(d.place) + ": " + d.message);
  return result;
}

}  // namespace

ImportedGear import_femnet(const ImportRequest& request, Diagnostics& diagnostics) {
  ImportedGear out;
  const auto findings = convert(request, diagnostics, out);
  report(findings, diagnostics, out);
  return out;
}

FolderCheck check_folder(const fs::path& folder) {
  FolderCheck out;
  std::vector<fs::path> files;
  for (const auto& entry :
       fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied))
    if (entry.is_regular_file() && is_gear(entry.path())) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    out.gears.push_back(check_gear(file, folder, out));
    out.whole += out.gears.back().is_read && out.gears.back().lines.empty();
  }
  return out;
}

}  // namespace netloft::io
