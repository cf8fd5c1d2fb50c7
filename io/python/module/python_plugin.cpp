// SPDX-License-Identifier: BSD-3-Clause
#include "io/python/module/python_plugin.hpp"

#include "io/python/module/opened_scene.hpp"

#include <algorithm>
#include <cstring>
#include <deque>
#include <utility>

namespace netloft::python {

namespace py = pybind11;

namespace {

std::deque<PythonPlugin>& python_plugins() {
  static auto& all = *new std::deque<PythonPlugin>;  // never destroyed: the interpreter ends first
  return all;
}

const netloft_plugin* last_plugin() { return &python_plugins().back().plugin; }

const void* last_offer(const char* id) {
  const PythonPlugin& last = python_plugins().back();
  if (last.solvers.count && std::strcmp(id, NETLOFT_EXT_SOLVER) == 0) return &last.solvers;
  return last.strategies.count && std::strcmp(id, NETLOFT_EXT_STRATEGY) == 0 ? &last.strategies : nullptr;
}

netloft_parameter number_row(double number) {
  netloft_parameter row{};
  row.size = sizeof row;
  row.kind = NETLOFT_INTEGER;
  row.name = "callable";
  row.unit = "1";
  row.doc = "number of the callable in this process";
  row.fallback = row.lo = row.hi = number;
  return row;
}

netloft_parameter real_row(const RealParameter& p, std::size_t index) {
  netloft_parameter row{};
  row.size = sizeof row;
  row.kind = NETLOFT_REAL;
  row.name = p.name.c_str();
  row.unit = p.unit.c_str();
  row.doc = p.doc.c_str();
  row.fallback = p.fallback;
  row.lo = p.lo;
  row.hi = p.hi;
  row.flags = p.is_required ? NETLOFT_REQUIRED : 0;
  row.offset = static_cast<std::uint32_t>(8 * index);
  return row;
}

void describe_plugin(PythonPlugin& p) {
  p.plugin.size = sizeof p.plugin;
  p.plugin.abi_major = NETLOFT_ABI_MAJOR;
  p.plugin.abi_minor = NETLOFT_ABI_MINOR;
  p.plugin.flags = NETLOFT_BUILD_FLAGS;
  p.plugin.name = p.name.c_str();
  p.plugin.version = "1";
  p.plugin.doc = p.doc.c_str();
  p.plugin.compiler = "Python";
  p.plugin.extension = &last_offer;
}

PythonPlugin* find_python_plugin(const std::string& name) {
  const auto found = std::ranges::find(python_plugins(), name, &PythonPlugin::name);
  return found == python_plugins().end() ? nullptr : &*found;
}

std::vector<RealParameter> without_sentences(std::vector<RealParameter> parameters) {
  for (RealParameter& p : parameters) p.doc.clear();
  return parameters;
}

/// Checks that a new callable has the same description as the old one, because plugins are never unloaded and
/// scenes have been checked against this description.
void require_same(const PythonPlugin& old, const PythonPlugin& like) {
  const auto refuse = [&](const std::string& what) {
    throw PluginRefused("\"" + old.name + "\" is " + what +
                        " in this process already; give the new one another name, or restart Python");
  };
  if (old.solvers.count != like.solvers.count || old.strategies.count != like.strategies.count ||
      (old.element.stencil == 0) != (like.element.stencil == 0))
    refuse("a component of another kind");
  if (old.element.stencil != like.element.stencil || old.term.traits != like.term.traits ||
      old.data != like.data || without_sentences(old.parameters) != without_sentences(like.parameters))
    refuse("an element with other nodes, parameters or data");
}

}  // namespace

void add_python_plugin(const std::string& name, const std::string& doc, py::function call,
                       std::vector<RealParameter> parameters,
                       const std::function<void(PythonPlugin&)>& describe) {
  const ReadingLock lock;
  if (PythonPlugin* old = find_python_plugin(name)) {
    PythonPlugin like;
    like.parameters = std::move(parameters);
    describe(like);
    require_same(*old, like);
    old->calls.push_back(std::move(call));
    return;
  }
  if (std::ranges::count(registry().available(), name))
    throw PluginRefused("\"" + name + "\" is already the name of a plugin; choose another name");
  PythonPlugin& plugin = python_plugins().emplace_back();
  plugin.name = name;
  plugin.doc = doc;
  plugin.calls.push_back(std::move(call));
  plugin.parameters = std::move(parameters);
  plugin.rows.push_back(number_row(static_cast<double>(python_plugins().size() - 1)));
  for (const RealParameter& p : plugin.parameters) plugin.rows.push_back(real_row(p, plugin.rows.size()));
  describe_plugin(plugin);
  try {
    describe(plugin);
    read_plugin(&plugin.plugin, "", name);  // rejects a wrong description before the name is registered
  } catch (...) {
    python_plugins().pop_back();
    throw;
  }
  registry().add_builtin(name, &last_plugin);
  registry().plugin(name);  // opens the plugin now, while it is the last one
}

namespace {

thread_local std::exception_ptr error_of_this_thread;

}  // namespace

void keep_error(std::exception_ptr error) { error_of_this_thread = std::move(error); }

std::exception_ptr take_error() { return std::exchange(error_of_this_thread, nullptr); }

PythonPlugin& plugin_of(const void* parameters) {
  std::int64_t number = 0;
  std::memcpy(&number, parameters, sizeof number);
  return python_plugins()[static_cast<std::size_t>(number)];
}

}  // namespace netloft::python
