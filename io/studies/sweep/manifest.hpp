// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/studies/sweep/study.hpp"

#include <stdexcept>

namespace netloft::studies {

/// Thrown if a file of a study cannot be used; what() is a sentence for the user.
class StudyError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The manifest of a study as JSON lines: the first line describes the study, and each further line an item.
/// Equal studies give equal bytes.
std::string manifest_text(const Study& study);

/// Reads a manifest that manifest_text() wrote. Throws StudyError, with the line number if there is one, for
/// three faults: the checksum is wrong, so that the manifest is damaged; a name cannot be used as a file name
/// or in a script; a value in the tables differs from the value to which the scene is set.
Study read_manifest(const std::filesystem::path& path);

/// Paths of files in the folder of a study.
std::filesystem::path manifest_path(const std::filesystem::path& folder);
std::filesystem::path record_path(const std::filesystem::path& folder, const StudyItem& item);
std::filesystem::path failure_path(const std::filesystem::path& folder, const StudyItem& item);

}  // namespace netloft::studies
