// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "io/formats/hdf5/locked_file.hpp"

namespace netloft::formats {

/// An HDF5 file that is written as NAME.hdf.part and gets its final name, NAME.hdf, only when it is complete.
///
///   construct   creates NAME.hdf.part, or replaces one that a dead writer left; throws if a writer is alive
///   finish()    appends checksums (seal.hpp), renames NAME.hdf to NAME.hdf~, and the .part to NAME.hdf;
///               an earlier NAME.hdf is never missing
///   destroy     without finish(), the .part keeps the state of the last flush()
///
/// The lock against other writers also refuses readers that use HDF5, unless they set
/// HDF5_USE_FILE_LOCKING=FALSE.
class PartFile {
 public:
  explicit PartFile(std::filesystem::path final_path);
  /// Uses `part_path` for the growing file instead of NAME.hdf.part.
  PartFile(std::filesystem::path final_path, std::filesystem::path part_path);

  hid_t id() const { return file_; }
  const std::filesystem::path& part_path() const { return part_; }
  const std::filesystem::path& final_path() const { return final_; }

  void flush();
  void finish();
  void finish_as(std::filesystem::path final_path);
  /// Removes the .part if it has no useful content; nothing can be written afterwards.
  void discard();

 private:
  std::filesystem::path final_;
  std::filesystem::path part_;
  // Destroyed after file_, so that no other process can open the .part for writing while HDF5 is still
  // closing it.
  Descriptor lock_;
  Handle file_;
  bool finished_ = false;
};

/// Waits until the directory entries in the folder of a file are on the disk.
void sync_folder_of(const std::filesystem::path& file);

}  // namespace netloft::formats
