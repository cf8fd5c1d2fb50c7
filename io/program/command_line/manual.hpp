// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <CLI/CLI.hpp>

#include <string>

namespace netloft::program {

/// The manual page of the program in the format man(7), made from the table of commands.
std::string manual_page(const CLI::App& app);

}  // namespace netloft::program
