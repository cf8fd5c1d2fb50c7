// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>

namespace netloft::formats {

/// The folder of the installation to which this code belongs: it contains lib/netloft (plugins) and
/// share/netloft (library of gears). It is searched above the file that contains this code (the program or
/// the Python module), so that an installation can be moved. The build folder has the same layout. Empty if
/// there is no such folder.
std::filesystem::path installed_folder();

}  // namespace netloft::formats
