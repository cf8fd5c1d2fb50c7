// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/session/find_plugins.hpp"

#include "io/formats/files/installed_folder.hpp"

#include <cstdlib>
#include <filesystem>
#include <sstream>

#ifdef NETLOFT_STATIC
#include "netloft_static_plugins.hpp"
#endif

namespace netloft::program {

namespace {

void add_from_environment(Registry& registry) {
  const char* folders = std::getenv("NETLOFT_PLUGINS");
  std::istringstream list(folders ? folders : "");
  for (std::string folder; std::getline(list, folder, ':');)
    if (!folder.empty()) registry.add_folder(folder);
}

void add_named(const std::vector<std::string>& folders, Registry& registry) {
  for (const auto& folder : folders) {
    if (!std::filesystem::is_directory(folder)) throw UsageError{"--plugins " + folder + ": is no folder"};
    registry.add_folder(folder);
  }
}

void add_known(Registry& registry) {
  add_from_environment(registry);
#ifdef NETLOFT_STATIC
  for (const auto& [name, describe] : static_plugins()) registry.add_builtin(name, describe);
#endif
  registry.add_folder(formats::installed_folder() / "lib" / "netloft");
}

}  // namespace

void find_plugins(const PluginOptions& options, Registry& registry) {
  add_named(options.plugins, registry);
  add_known(registry);
}

void find_scene_plugins(const SceneOptions& options, Registry& registry) {
  add_named(options.plugins, registry);
  if (options.scene_plugins) {
    const auto folder = std::filesystem::path(options.scene).parent_path();
    registry.add_folder(folder.empty() ? "." : folder);
  }
  add_known(registry);
}

}  // namespace netloft::program
