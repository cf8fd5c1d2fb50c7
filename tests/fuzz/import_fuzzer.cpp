// SPDX-License-Identifier: BSD-3-Clause
// Nonsense for everything that reads gears and meshes of other programs. An input is a .don, a zero byte and
// its .mdg, or a mesh of ours. What is imported must be a mesh that can be read again.
#include "io/import/femnet_scene.hpp"

#include <cstdint>
#include <cstdlib>
#include <string>

namespace {

using namespace netloft::io;

/// The compiler cannot leave out what is used.
void use(std::size_t size) {
  static volatile std::size_t sink = 0;
  sink = size;
}

void try_mesh(const std::string& text) {
  Diagnostics diagnostics;
  const int file = diagnostics.add_source("gear.mesh", text);
  use(read_mesh(text, file, diagnostics).node_count());
  use(diagnostics.render(false).size());
}

void read_again(const InputMesh& mesh) {
  Diagnostics diagnostics;
  const std::string text = mesh_text(mesh, "a source");
  const InputMesh again = read_mesh(text, diagnostics.add_source("gear.mesh", text), diagnostics);
  if (diagnostics.errors() && mesh.node_count() > 0) std::abort();
  if (again.node_count() != mesh.node_count()) std::abort();
}

void try_femnet(const std::string& gear_text, const std::string& mesh_text) {
  Diagnostics diagnostics;
  const auto gear = femnet::read_gear(gear_text, diagnostics.add_source("gear.don", gear_text), diagnostics);
  if (diagnostics.errors() == 0) {
    const int file = diagnostics.add_source("gear.mdg", mesh_text);
    const auto mesh = femnet::read_mesh_file(mesh_text, file, gear, diagnostics);
    if (diagnostics.errors() == 0) {
      const auto imported =
          femnet::import_gear(gear, mesh, {"gear.don", "gear.mdg", "gear.mesh"}, diagnostics);
      use(imported.scene.size());
      if (diagnostics.errors() == 0) read_again(imported.mesh);
    }
  }
  use(diagnostics.render(false).size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  if (is_mesh_text(text)) {
    try_mesh(text);
    return 0;
  }
  const auto zero = text.find('\0');
  try_femnet(text.substr(0, zero), zero == std::string::npos ? "" : text.substr(zero + 1));
  return 0;
}
