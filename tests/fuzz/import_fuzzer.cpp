// SPDX-License-Identifier: BSD-3-Clause
// Tries random input in all readers of gears and meshes of other programs. An input is a .don, a zero byte
// and its .mdg; only a .don, which is divided into elements; a table of nodes and bars; a mooring; or a mesh
// file of Netloft, of VTK or an OBJ. An imported mesh must be readable again in every format.
#include "io/scenes/import/femnet_scene.hpp"
#include "io/scenes/import/moordyn.hpp"

#include <cstdint>
#include <cstdlib>
#include <string>

namespace {

using namespace netloft;

constexpr double kMostNodes = 2000;  // largest number of nodes of a gear that is divided, so that no input
                                     // takes seconds

/// Makes the compiler compute `size`, although nothing needs it.
void use(std::size_t size) {
  static volatile std::size_t sink = 0;
  sink = size;
}

void expect_again(const std::string& text, const formats::InputMesh& mesh) {
  formats::Diagnostics diagnostics;
  const formats::InputMesh again =
      formats::read_any_mesh(text, diagnostics.add_source("gear.mesh", text), diagnostics);
  if (diagnostics.errors() && mesh.node_count() > 0) std::abort();
  if (again.node_count() != mesh.node_count()) std::abort();
}

void read_again(const formats::InputMesh& mesh) {
  expect_again(formats::mesh_text(mesh, "a source"), mesh);
  if (mesh.node_count() == 0) return;
  expect_again(formats::obj_text(mesh, "a source"), mesh);
  expect_again(formats::vtk_text(mesh, "a source"), mesh);
}

void try_mesh(const std::string& text) {
  formats::Diagnostics diagnostics;
  const int file = diagnostics.add_source("gear.mesh", text);
  const formats::InputMesh mesh = formats::read_any_mesh(text, file, diagnostics);
  if (diagnostics.errors() == 0) read_again(mesh);
  use(diagnostics.render(false).size());
}

void try_bars(const scenes::BarTable& table, const formats::Diagnostics& diagnostics) {
  if (diagnostics.errors()) return;
  const auto scene = scenes::scene_of(table, {"a source"}, "gear.mesh");
  use(scene.scene.size());
  read_again(scene.mesh);
}

void try_table(const std::string& text) {
  formats::Diagnostics diagnostics;
  try_bars(scenes::read_bar_table(text, diagnostics.add_source("gear.csv", text), diagnostics), diagnostics);
  use(diagnostics.render(false).size());
}

void try_mooring(const std::string& text) {
  formats::Diagnostics diagnostics;
  try_bars(scenes::read_moordyn(text, diagnostics.add_source("lines.txt", text), diagnostics).table,
           diagnostics);
  use(diagnostics.render(false).size());
}

void try_femnet(const std::string& gear_text, const std::string* mesh_text) {
  formats::Diagnostics diagnostics;
  const auto gear =
      scenes::femnet::read_gear(gear_text, diagnostics.add_source("gear.don", gear_text), diagnostics);
  scenes::femnet::MeshFile mesh;
  if (diagnostics.errors() == 0)
    mesh = mesh_text ? scenes::femnet::read_mesh_file(
                           *mesh_text, diagnostics.add_source("gear.mdg", *mesh_text), gear, diagnostics)
                     : scenes::femnet::divide_gear(gear, diagnostics, kMostNodes);
  if (diagnostics.errors() == 0) {
    for (const auto sought : {scenes::femnet::Sought::rest, scenes::femnet::Sought::motion}) {
      const auto imported =
          scenes::femnet::import_gear(gear, mesh, {"gear.don", "gear.mdg", "gear.mesh"}, diagnostics, sought);
      use(imported.scene.size());
      if (diagnostics.errors() == 0) read_again(imported.mesh);
    }
  }
  use(diagnostics.render(false).size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto begins = [&](const char* words) { return text.starts_with(words); };
  if (formats::is_mesh_text(text) || begins("# vtk") || begins("v ") || begins("glTF")) {
    try_mesh(text);
    return 0;
  }
  if (begins("node") || begins("bar")) {
    try_table(text);
    return 0;
  }
  if (begins("---")) {
    try_mooring(text);
    return 0;
  }
  const auto zero = text.find('\0');
  const std::string mesh = zero == std::string::npos ? "" : text.substr(zero + 1);
  try_femnet(text.substr(0, zero), zero == std::string::npos ? nullptr : &mesh);
  return 0;
}
