// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/files/installed_folder.hpp"

#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>

namespace netloft::formats {

namespace {

/// The whole path of the file from which this function was loaded; empty if it is not known. dladdr() is not
/// used, because it gives only the name under which the file was opened.
std::filesystem::path own_file() {
  const auto here = reinterpret_cast<std::uintptr_t>(&own_file);
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    // 7f2a40000000-7f2a40021000 r-xp 00000000 08:02 135522  /usr/bin/netloft
    std::istringstream words(line);
    std::uintptr_t begin = 0, end = 0;
    std::string rights, offset, device, inode, path;
    words >> std::hex >> begin;
    words.ignore(1) >> end;
    if (here < begin || here >= end) continue;
    std::getline(words >> rights >> offset >> device >> inode >> std::ws, path);
    return path;
  }
  return {};
}

std::filesystem::path find_installed_folder() {
  std::error_code none;
  for (auto folder = own_file().parent_path(); folder.has_relative_path(); folder = folder.parent_path())
    if (std::filesystem::is_directory(folder / "share" / "netloft", none)) return folder;
  return {};
}

}  // namespace

std::filesystem::path installed_folder() {
  static const std::filesystem::path folder = find_installed_folder();
  return folder;
}

}  // namespace netloft::formats
