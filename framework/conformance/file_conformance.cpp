// SPDX-License-Identifier: BSD-3-Clause
//
// Checks of the file of a plugin, in addition to the checks made when a plugin is loaded.
#include "framework/conformance/conformance.hpp"
#include "framework/registry/exports.hpp"

#include <algorithm>

namespace netloft {

namespace {

constexpr std::size_t kNamed = 3;

/// A sentence such as "exports 12 more than netloft_plugin_v1: a, b, c …"
std::string sentence(const std::vector<std::string>& extra) {
  std::string text = "exports " + std::to_string(extra.size()) + " more than netloft_plugin_v1: ";
  for (std::size_t i = 0; i < std::min(extra.size(), kNamed); ++i) text += (i ? ", " : "") + extra[i];
  return text + (extra.size() > kNamed ? " …" : "");
}

CheckResult exports_one_symbol(const std::filesystem::path& file) {
  std::vector<std::string> names = exported_symbols(file);
  std::erase(names, "netloft_plugin_v1");
  CheckResult r;
  r.name = "exports-one-symbol";
  r.figure = static_cast<double>(names.size());
  r.passed = names.empty();
  if (!r.passed) r.detail = sentence(names);
  r.hint =
      "compile with the flags of `netloft --cflags` or with netloft_add_plugin: an exported symbol may be "
      "taken for a symbol of the same name in another plugin";
  return r;
}

}  // namespace

ConformanceReport check_file(const std::filesystem::path& file) {
  return {file.filename().string(), {exports_one_symbol(file)}, {}};
}

}  // namespace netloft
