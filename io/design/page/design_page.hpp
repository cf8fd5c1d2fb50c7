// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace netloft::design {

/// The page of a design: the viewer of `netloft view` and the scripts beside this file, which a browser runs
/// only with this nonce. The page has no content of its own: its scripts request it from the server.
std::string design_page(const std::string& nonce);
/// The Content-Security-Policy of that page: only its own scripts and styles, and requests only to its own
/// server.
std::string design_policy(const std::string& nonce);

}  // namespace netloft::design
