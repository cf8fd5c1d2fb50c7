// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>

namespace netloft::design {

/// A private folder among the temporary files of the system, which is removed with this object.
class TemporaryFolder {
 public:
  /// Throws std::filesystem::filesystem_error if the disk is full, for example.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace netloft::design
