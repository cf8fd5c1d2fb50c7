// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace netloft::test {

/// Of the checkout, of the build and of its plugins. They stand in one source, folders.cpp.in: among flags or
/// in a header these paths would keep a compiler cache from serving other checkouts.
const std::string& source_folder();
const std::string& build_folder();
const std::string& plugin_folder();

}  // namespace netloft::test
