// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/session/commands.hpp"
#include "io/program/session/prefix.hpp"

#include <cstdlib>
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

}  // namespace

void find_plugins(const Options& options, Registry& registry) {
  for (const auto& folder : options.plugins) {
    if (!std::filesystem::is_directory(folder)) throw UsageError{"--plugins " + folder + ": is no folder"};
    registry.add_folder(folder);
  }
  if (options.scene_plugins && !options.target.empty()) {
    const auto folder = std::filesystem::path(options.target).parent_path();
    registry.add_folder(folder.empty() ? "." : folder);
  }
  add_from_environment(registry);
#ifdef NETLOFT_STATIC
  for (const auto& [name, describe] : static_plugins()) registry.add_builtin(name, describe);
#endif
  registry.add_folder(installed_prefix() / "lib" / "netloft");
}

}  // namespace netloft::program
