// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/design/solver/solver_call.hpp"

#include <exception>

namespace netloft::design {

// The messages between a session and the process of its solver are lines of JSON. The session sends
//   {"call": 7, "name": "follow", "body": {…}}   and, while the solver works,   {"interrupt": 7};
// the solver sends any number of {"done": 3, "of": 12}, and then {"answer": {…}},
//   {"refused": "a sentence"} with the kind of the exception as its name, or {"ended": "a sentence"} before
//   it ends because a plugin does not return.

/// A message as a line.
std::string text_of(const Json& message);
/// The message for an exception that ended a call.
Json message_of(const std::exception_ptr& thrown);
/// Throws the exception of such a message.
[[noreturn]] void throw_sent(const Json& message);

}  // namespace netloft::design
