// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/import/femnet_scene.hpp"
#include "tests/folders.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

namespace netloft::scenes::femnet {

/// A file of tests/validation/femnet_files.
inline std::string sample(const std::string& name) {
  std::ifstream in(test::source_folder() + "/tests/validation/femnet_files/" + name, std::ios::binary);
  EXPECT_TRUE(in) << name;
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// The text with the first `old` replaced. The test fails if there is no `old`.
inline std::string changed(std::string text, const std::string& old, const std::string& fresh) {
  const auto at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return at == std::string::npos ? text : text.replace(at, old.size(), fresh);
}

/// A gear that was read, with the messages about it.
struct ReadGear {
  explicit ReadGear(const std::string& text)
      : gear(read_gear(text, diagnostics.add_source("gear.don", text), diagnostics)) {}
  bool says(const std::string& words) const {
    return diagnostics.render(false).find(words) != std::string::npos;
  }
  formats::Diagnostics diagnostics;
  GearFile gear;
};

/// A gear with its mesh, converted to a scene.
struct ImportedSample {
  ImportedSample(const std::string& gear_text, const std::string& mesh_text, Sought sought = Sought::rest)
      : read(gear_text) {
    if (read.diagnostics.errors()) return;
    const int file = read.diagnostics.add_source("gear.mdg", mesh_text);
    mesh = read_mesh_file(mesh_text, file, read.gear, read.diagnostics);
    if (read.diagnostics.errors()) return;
    imported = import_gear(read.gear, mesh, {"gear.don", "gear.mdg", "gear.mesh"}, read.diagnostics, sought);
    if (read.diagnostics.errors()) imported = {};
  }
  bool holds(const std::string& words) const { return imported.scene.find(words) != std::string::npos; }
  ReadGear read;
  MeshFile mesh;
  Imported imported;
};

}  // namespace netloft::scenes::femnet
