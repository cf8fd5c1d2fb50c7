// SPDX-License-Identifier: BSD-3-Clause
// Tries random scene files: each input is one, with the shipped plugins and the gear library available. A
// small scene that is read without an error is planned and assembled.
#include "framework/assembler/assembler.hpp"
#include "framework/scene/scene_plan.hpp"
#include "io/scenes/reading/scene_source.hpp"
#include "tests/folders.hpp"
#include "tests/fuzz/scratch_file.hpp"

namespace {

using namespace netloft;

constexpr std::size_t kMostNodes = 2000;  // that a fuzzer has time for

void assemble(const scenes::LoadedScene& loaded, Registry& registry) {
  if (loaded.scene.node_count() > kMostNodes) return;
  try {
    const ScenePlan plan =
        make_scene_plan(loaded.scene, registry, loaded.analysis.tangent, loaded.analysis.kind);
    const Assembler assembler(loaded.scene, plan, 1);
    fuzz::use(assembler.numbering().dofs());
  } catch (const SceneError& e) {
    fuzz::use(e.faults.size());
  }
}

/// Links the folders in which scenes find included files: `include = ["scenes/four-panel.toml"]`.
void link_library() {
  for (const char* part : {"scenes", "gears"})
    std::filesystem::create_directory_symlink(
        std::filesystem::path(netloft::test::source_folder()) / "gear-library" / part,
        fuzz::scratch_folder() / part);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static Registry registry = [] {
    Registry plugins;
    plugins.add_folder(netloft::test::plugin_folder());
    link_library();
    return plugins;
  }();
  formats::Diagnostics diagnostics;
  bool refused = false;
  const auto scene = scenes::SceneSource(fuzz::write_scratch("scene.toml", data, size))
                         .instance({}, registry, diagnostics, refused);
  fuzz::use(diagnostics.render(false).size());
  if (diagnostics.errors() == 0) assemble(scene, registry);
  return 0;
}
