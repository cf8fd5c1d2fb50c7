// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/descriptors.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string_view>

namespace netloft {

/// Thrown if no plugin offers the requested component. The message gives the searched paths and similar
/// names.
struct UnknownComponent : PluginRefused {
  using PluginRefused::PluginRefused;
};

/// Finds, opens and checks plugins. The name of a component contains the name of the file: "rope/bar" is the
/// element "bar" of rope.so. Only requested plugins are opened, and none is ever closed.
class Registry {
 public:
  /// Folders are searched in the order they were added.
  void add_folder(std::filesystem::path folder);
  /// Adds a plugin that is compiled into the program; it has precedence over all folders.
  void add_builtin(const std::string& name, netloft_plugin_function describe);
  /// Adds a plugin by its file in any folder; its name is the stem of the file.
  const PluginContent& add_file(const std::filesystem::path& file);

  /// The element with this name, such as "rope/bar". Throws UnknownComponent or PluginRefused.
  const ElementType& element(const std::string& type);
  /// The solver with this name; "newton" is short for "newton/newton".
  const SolverType& solver(const std::string& type);
  /// The integrator with this name; "newmark" is short for "newmark/newmark".
  const IntegratorType& integrator(const std::string& type);
  /// The strategy with this name; "auto" is short for "auto/auto".
  const StrategyType& strategy(const std::string& type);
  /// The law with this name, such as "hydro/morison".
  const LawType& law(const std::string& type);
  const PluginContent& plugin(const std::string& name);

  /// Sorted names of all plugins in the searched folders and in the program. Opens no plugin, and searches
  /// each folder only once.
  std::vector<std::string> available() const;
  /// Plugins opened so far.
  std::vector<const PluginOrigin*> opened() const;

 private:
  template <class Types>
  const typename Types::value_type& find(const Types& types, const std::string& type, const char* what,
                                         const std::string& plugin) const;
  const PluginContent& keep(PluginContent content);
  std::string hidden(const std::string& name) const;
  [[noreturn]] void not_found(const std::string& name) const;

  std::vector<std::filesystem::path> folders_;
  mutable std::set<std::string> in_folders_;  // names found in the first `searched_` folders
  mutable std::size_t searched_ = 0;
  std::map<std::string, netloft_plugin_function> builtin_;
  std::map<std::string, std::unique_ptr<PluginContent>> opened_;
};

}  // namespace netloft
