// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/session/replaced_file.hpp"

#include "io/formats/files/whole_file.hpp"
#include "io/program/session/options.hpp"
#include "io/program/session/terminal.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace netloft::program {

namespace fs = std::filesystem;

namespace {

/// The extensions as text: ".svg or .png".
std::string list_of(const std::vector<std::string>& endings) {
  std::string list;
  for (const auto& ending : endings) list += (list.empty() ? "" : " or ") + ending;
  return list;
}

bool has_one_of(const std::string& file, const std::vector<std::string>& endings) {
  const std::string ending = fs::path(file).extension().string();
  return endings.empty() || std::find(endings.begin(), endings.end(), ending) != endings.end();
}

}  // namespace

void require_ending(const std::string& option, const std::string& file,
                    const std::vector<std::string>& endings) {
  if (!file.empty() && !has_one_of(file, endings))
    throw UsageError{option + " " + file + ": the name of this file must end in " + list_of(endings)};
}

void replace_file(const std::string& output, const std::string& content,
                  const std::vector<std::string>& sources, const std::vector<std::string>& endings) {
  std::error_code none;
  if (fs::exists(output, none) && !fs::is_regular_file(output, none))
    throw UsageError{output + " is a folder or a device, and cannot be replaced"};
  for (const auto& source : sources)
    if (fs::equivalent(output, source, none))
      throw UsageError{output + " is an input of this command; name another file with -o"};
  if (!has_one_of(output, endings))
    throw UsageError{output + ": the name of this file must end in " + list_of(endings)};
  formats::write_keeping(output, content);
}

void require_place(const std::string& file, const std::vector<std::string>& sources) {
  if (file.empty()) return;
  std::error_code none;
  for (const auto& source : sources)
    if (fs::equivalent(file, source, none))
      throw UsageError{file + " cannot be written: the scene is read from it"};
  if (fs::exists(file, none) && !fs::is_regular_file(file, none))
    throw UsageError{file + " cannot be written: it is a folder or a device"};
  const fs::path folder = fs::path(file).parent_path();
  if (!folder.empty() && !fs::is_directory(folder, none))
    throw UsageError{file + " cannot be written: there is no folder " + folder.string()};
}

int write_last(Terminal& terminal, int code, const std::function<void()>& write) {
  std::fflush(stdout);
  try {
    write();
    return code;
  } catch (const formats::WriteError& e) {
    terminal.say(std::string("netloft: ") + e.what());
    return kOther;
  }
}

}  // namespace netloft::program
