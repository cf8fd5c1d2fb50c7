// SPDX-License-Identifier: BSD-3-Clause
#include "io/cli/replaced_file.hpp"

#include "io/cli/options.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

namespace netloft::io {

namespace fs = std::filesystem;

void replace_file(const std::string& output, const std::string& content,
                  const std::vector<std::string>& sources) {
  std::error_code none;
  if (fs::exists(output, none) && !fs::is_regular_file(output, none))
    throw UsageError{output + " is no file that may be replaced"};
  for (const auto& source : sources)
    if (fs::equivalent(output, source, none))
      throw UsageError{output + " is what it would be made from; name another file with -o"};
  const std::string beside = output + ".new";
  {
    std::ofstream file(beside, std::ios::binary);
    file << content << std::flush;
    if (!file) {
      fs::remove(beside, none);
      throw UsageError{output + " cannot be written"};
    }
  }
  fs::rename(beside, output, none);
  if (!none) return;
  const std::string why = none.message();
  fs::remove(beside, none);
  throw UsageError{output + " cannot be written: " + why};
}

std::string in_json(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace netloft::io
