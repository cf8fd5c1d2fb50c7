// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/files/whole_file.hpp"
#include "io/program/commands/plugins.hpp"
#include "io/program/session/find_plugins.hpp"
#include "io/program/session/print.hpp"
#include "netloft_templates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <string_view>

namespace netloft::program {

namespace {

namespace fs = std::filesystem;

bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
char upper(char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); }

/// Converts otter_board to OtterBoard.
std::string type_name(const std::string& name) {
  std::string type;
  bool begins = true;
  for (const char c : name) {
    if (c != '_') type += begins ? upper(c) : c;
    begins = c == '_';
  }
  return type;
}

bool is_gear(const std::string& kind) { return kind.ends_with("-panel"); }

void refuse(const std::string& name, const std::string& why) {
  throw UsageError{"\"" + name + "\" cannot be the name: " + why};
}

void check_spelling(const std::string& name) {
  const bool spelled =
      !name.empty() && is_lower(name[0]) && name.back() != '_' && name.size() <= 40 &&
      std::all_of(name.begin(), name.end(), [](char c) { return is_lower(c) || is_digit(c) || c == '_'; });
  if (!spelled)
    refuse(name,
           "write small letters, digits and _ between them, a letter first, 40 at most, such as otter_board");
}

/// Names that must not be chosen: the generated files use them, or CMake reserves them for its own targets.
constexpr std::array kTaken = {"parameters", "data", "elastic",    "all",           "test",   "clean",
                               "install",    "help", "edit_cache", "rebuild_cache", "package"};

constexpr const char* kUsed = "this word already has a meaning in the files that would be written";

void check_name_of_gear(const std::string& name) {
  if (name == "tow") refuse(name, kUsed);
}

void check_name_of_plugin(const std::string& name) {
  Registry registry;
  find_plugins({}, registry);
  if (std::find(kTaken.begin(), kTaken.end(), name) != kTaken.end()) refuse(name, kUsed);
  const auto there = registry.available();
  if (std::find(there.begin(), there.end(), name) != there.end())
    refuse(name, "there is already a plugin of that name, and one would hide the other");
}

std::string replaced(std::string text, std::string_view old, std::string_view with) {
  for (auto at = text.find(old); at != std::string::npos; at = text.find(old, at + with.size()))
    text.replace(at, old.size(), with);
  return text;
}

/// Removes the licence of the template, because it does not apply to files made from it.
std::string without_licence(std::string text) {
  constexpr std::string_view first = "// SPDX-License-Identifier: BSD-3-Clause\n";
  if (text.starts_with(first)) text.erase(0, first.size());
  return text.starts_with("//\n") ? text.substr(3) : text;
}

std::string renamed(const std::string& text, const std::string& kind, const std::string& name) {
  const std::string old = is_gear(kind) ? "my_gear" : "my_" + kind;
  return replaced(replaced(text, old, name), type_name(old), type_name(name));
}

void say_what_next_of_gear(const std::string& folder, const std::string& name) {
  print(
      fmt::format("{0}/ holds {1}.toml, a scene and a README. It works as it is:\n"
                  "  netloft check {0}/{1}.toml\n"
                  "  netloft draw {0}/{1}.toml -o {1}.png\n"
                  "  netloft run {0}/tow.toml && netloft view tow.hdf\n",
                  folder, name));
}

void say_what_next(const std::string& folder, const std::string& name) {
  print(
      fmt::format("{0}/ holds {1}.cpp, a test, a scene and a README. It works as it is:\n"
                  "  cmake -S {0} -B {0}/build && cmake --build {0}/build\n"
                  "  ctest --test-dir {0}/build --output-on-failure\n"
                  "  netloft run {0}/{1}.toml --plugins {0}/build\n",
                  folder, name));
}

}  // namespace

int new_command(const NewOptions& options) {
  const bool of_gear = is_gear(options.kind);
  check_spelling(options.name);
  of_gear ? check_name_of_gear(options.name) : check_name_of_plugin(options.name);
  const fs::path folder = options.output.empty() ? options.name : options.output;
  std::error_code error;
  if (fs::exists(folder, error)) throw UsageError{folder.string() + ": a file or folder of that name exists"};
  if (!fs::create_directory(folder, error))
    throw formats::WriteError(folder.string() + " cannot be made: " + error.message());
  try {
    for (const auto& t : kTemplates)
      if (t.kind == options.kind)
        formats::write_whole(folder / renamed(t.file, options.kind, options.name),
                             renamed(without_licence(t.text), options.kind, options.name));
  } catch (const formats::WriteError&) {  // an incomplete component would block a second attempt
    std::error_code none;
    fs::remove_all(folder, none);
    throw;
  }
  of_gear ? say_what_next_of_gear(folder.string(), options.name)
          : say_what_next(folder.string(), options.name);
  return kDone;
}

}  // namespace netloft::program
