// SPDX-License-Identifier: BSD-3-Clause
#include "framework/registry/registry.hpp"

#include "framework/parameters/nearest.hpp"
#include "framework/registry/library.hpp"
#include "framework/registry/wrong_kind.hpp"

#include <set>

namespace netloft {

namespace {

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none" : text;
}

std::string suggestion(const std::string& wanted, const std::vector<std::string>& names) {
  const auto near = nearest(wanted, names);
  return near ? "; did you mean \"" + *near + "\"?" : "; there is: " + joined(names);
}

/// If the plugin has a component of another kind with this name, returns that kind, such as "a law".
std::string other_kind(const PluginContent& plugin, const std::string& type) {
  std::string kind;
  const auto look = [&](const auto& types, const char* what) {
    for (const auto& t : types)
      if (t.type == type) kind = what;
  };
  look(plugin.elements, "an element");
  look(plugin.laws, "a law");
  look(plugin.solvers, "a solver");
  look(plugin.integrators, "an integrator");
  look(plugin.strategies, "a strategy");
  return kind;
}

std::string plugin_of(const std::string& type) { return type.substr(0, type.find('/')); }

/// Completes a short name: "newton" becomes "newton/newton".
std::string full_name(const std::string& type) {
  return type.find('/') == std::string::npos ? type + "/" + type : type;
}

}  // namespace

void Registry::add_folder(std::filesystem::path folder) { folders_.push_back(std::move(folder)); }

void Registry::add_builtin(const std::string& name, netloft_plugin_function describe) {
  builtin_[name] = describe;
}

const PluginContent& Registry::add_file(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) throw UnknownComponent(file.string() + ": there is no such file");
  return keep(open_library(std::filesystem::absolute(file)));
}

const ElementType& Registry::element(const std::string& type) {
  const auto slash = type.find('/');
  if (slash == std::string::npos || slash == 0 || slash + 1 == type.size())
    throw WrongKind("\"" + type +
                    "\" is no element type; a type is written plugin/element, such as rope/bar");
  const std::string name = plugin_of(type);
  return find(plugin(name).elements, type, "element", name);
}

const SolverType& Registry::solver(const std::string& type) {
  const std::string full = full_name(type), name = plugin_of(full);
  return find(plugin(name).solvers, full, "solver", name);
}

const IntegratorType& Registry::integrator(const std::string& type) {
  const std::string full = full_name(type), name = plugin_of(full);
  return find(plugin(name).integrators, full, "integrator", name);
}

const StrategyType& Registry::strategy(const std::string& type) {
  const std::string full = full_name(type), name = plugin_of(full);
  return find(plugin(name).strategies, full, "strategy", name);
}

const LawType& Registry::law(const std::string& type) {
  if (type.find('/') == std::string::npos)
    throw WrongKind("\"" + type + "\" is no law; a law is written plugin/law, such as hydro/morison");
  const std::string name = plugin_of(type);
  return find(plugin(name).laws, type, "law", name);
}

template <class Types>
const typename Types::value_type& Registry::find(const Types& types, const std::string& type,
                                                 const char* what, const std::string& name) const {
  for (const auto& t : types)
    if (t.type == type) return t;
  if (const auto kind = other_kind(*opened_.at(name), type); !kind.empty())
    throw WrongKind("\"" + type + "\" is " + kind + ", and no " + what + hidden(name));
  std::vector<std::string> names;
  for (const auto& t : types) names.push_back(t.type);
  const std::string sentence = "the plugin \"" + name + "\" has no " + what + " \"" + type + "\"" +
                               suggestion(type, names) + hidden(name);
  if (types.empty()) throw WrongKind(sentence);
  throw UnknownComponent(sentence);
}

const PluginContent& Registry::plugin(const std::string& name) {
  if (const auto at = opened_.find(name); at != opened_.end()) return *at->second;
  if (const auto at = builtin_.find(name); at != builtin_.end())
    return keep(read_plugin(at->second(), "compiled-in plugin " + name, name));
  for (const auto& folder : folders_)
    if (const auto file = best_build(folder, name); !file.empty()) return keep(open_library(file));
  not_found(name);
}

const PluginContent& Registry::keep(PluginContent content) {
  auto owned = std::make_unique<PluginContent>(std::move(content));
  for (auto& e : owned->elements) e.origin = &owned->origin;
  for (auto& s : owned->solvers) s.origin = &owned->origin;
  for (auto& l : owned->laws) l.origin = &owned->origin;
  for (auto& i : owned->integrators) i.origin = &owned->origin;
  for (auto& s : owned->strategies) s.origin = &owned->origin;
  auto& slot = opened_[owned->origin.name];
  if (!slot) slot = std::move(owned);
  return *slot;
}

/// Returns a text about the files that the opened file hides: those of the same name in later folders of the
/// search path.
std::string Registry::hidden(const std::string& name) const {
  const auto at = opened_.find(name);
  const std::string opened = at == opened_.end() ? "" : at->second->origin.file;
  std::string text;
  for (const auto& folder : folders_)
    if (const auto file = best_build(folder, name); !file.empty() && file != opened)
      text += "; " + opened + " hides " + file.string();
  return text;
}

void Registry::not_found(const std::string& name) const {
  std::string tried;
  for (const auto& folder : folders_) tried += "\n  tried " + (folder / (name + ".so")).string();
  throw UnknownComponent("there is no plugin \"" + name + "\"" + suggestion(name, available()) + tried);
}

std::vector<std::string> Registry::available() const {
  std::set<std::string> names;
  for (const auto& [name, describe] : builtin_) names.insert(name);
  for (const auto& [name, content] : opened_) names.insert(name);
  for (; searched_ < folders_.size(); ++searched_) in_folders_.merge(names_of_builds(folders_[searched_]));
  names.insert(in_folders_.begin(), in_folders_.end());
  return {names.begin(), names.end()};
}

std::vector<const PluginOrigin*> Registry::opened() const {
  std::vector<const PluginOrigin*> origins;
  for (const auto& [name, content] : opened_) origins.push_back(&content->origin);
  return origins;
}

}  // namespace netloft
