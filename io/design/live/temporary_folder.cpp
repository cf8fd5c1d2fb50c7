// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/live/temporary_folder.hpp"

#include <cstdlib>
#include <system_error>

namespace netloft::design {

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "netloft-design-XXXXXX").string();
  if (!::mkdtemp(name.data()))
    throw std::filesystem::filesystem_error("no temporary folder can be made", name,
                                            std::error_code(errno, std::generic_category()));
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code none;
  std::filesystem::remove_all(path_, none);
}

}  // namespace netloft::design
