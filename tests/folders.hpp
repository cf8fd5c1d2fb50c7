// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace netloft::test {

/// Folders of the checkout, the build and its plugins. The source folders.cpp.in contains them, because these
/// paths in flags or in a header would prevent a compiler cache from serving other checkouts.
const std::string& source_folder();
const std::string& build_folder();
const std::string& plugin_folder();

}  // namespace netloft::test
