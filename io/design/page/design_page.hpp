// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace netloft::design {

/// The page of a design: the viewer of `netloft view` and the scripts beside this file, which run with this
/// nonce only. It has no content of its own; its scripts ask the server for it.
std::string design_page(const std::string& nonce);
/// The Content-Security-Policy of that page: its own scripts and styles, requests to its own server alone.
std::string design_policy(const std::string& nonce);

}  // namespace netloft::design
