// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/design/solver/solver_call.hpp"

#include <string>

namespace netloft::design {

// These functions return a member of the body of a request. They throw WrongRequest if the member is missing
// or of another kind.
std::string text_in(const Json& body, const char* name);
double number_in(const Json& body, const char* name);
/// Returns false if the member is missing.
bool flag_in(const Json& body, const char* name);

}  // namespace netloft::design
