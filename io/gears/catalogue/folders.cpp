// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/catalogue/folders.hpp"

#include "io/formats/files/installed_folder.hpp"
#include "io/formats/toml/table_reader.hpp"

#include <cstdlib>
#include <sstream>

namespace netloft::gears {

namespace {

std::filesystem::path library_folder() {
  std::error_code none;
  const auto library = formats::installed_folder() / "share/netloft/gear-library/catalogue";
  return std::filesystem::is_directory(library, none) ? library : std::filesystem::path();
}

}  // namespace

std::string folder_fault(const std::filesystem::path& folder) {
  std::error_code fault;
  if (!std::filesystem::exists(folder, fault)) return "there is no folder " + folder.string();
  if (!std::filesystem::is_directory(folder, fault)) return folder.string() + " is no folder";
  std::filesystem::directory_iterator(folder, fault);
  return fault ? folder.string() + " cannot be read: " + fault.message() : "";
}

std::vector<std::filesystem::path> named_folders(const formats::Value& document,
                                                 const std::filesystem::path& folder,
                                                 formats::Diagnostics& diagnostics) {
  formats::TableReader root(document, diagnostics);
  std::vector<std::filesystem::path> folders;
  for (const auto& name :
       root.texts("catalogue", {.doc = "folders with catalogues", .fallback = std::vector<std::string>{}})) {
    folders.push_back(folder / name);
    if (const auto fault = folder_fault(folders.back()); !fault.empty()) root.error("catalogue", fault);
  }
  return folders;
}

std::vector<std::filesystem::path> catalogue_folders(formats::Diagnostics& diagnostics,
                                                     std::vector<std::filesystem::path> own) {
  if (const char* listed = std::getenv("NETLOFT_CATALOGUE")) {
    std::istringstream words(listed);
    for (std::string folder; std::getline(words, folder, ':');) {
      if (folder.empty()) continue;
      if (const auto fault = folder_fault(folder); !fault.empty())
        diagnostics.error({}, "NETLOFT_CATALOGUE: " + fault);
      own.emplace_back(folder);
    }
  }
  if (const auto library = library_folder(); !library.empty()) own.push_back(library);
  return own;
}

}  // namespace netloft::gears
