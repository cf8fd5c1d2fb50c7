// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>

namespace netloft::formats {

/// The folder of the installation to which this code belongs: it contains lib/netloft (plugins) and
/// share/netloft (library of gears), and is found above the file of this code, which is the program or a
/// module of Python. So the installation may be moved. The build folder has the same layout. Empty if there
/// is no such folder.
std::filesystem::path installed_folder();

}  // namespace netloft::formats
