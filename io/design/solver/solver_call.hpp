// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nlohmann/json.hpp>

#include <atomic>
#include <functional>
#include <stdexcept>
#include <string>

namespace netloft::design {

using Json = nlohmann::ordered_json;
using OnProgress = std::function<void(std::size_t done, std::size_t all)>;

/// An unknown or incomplete request; what() is a sentence.
struct WrongRequest : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// The process of the solver has crashed or was ended; what() is a sentence. The next call has a new process,
/// which knows no equilibrium yet.
struct SolverEnded : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Calls a LiveSolver, in this process or in another one. Throws what LiveSolver::answer throws, and
/// SolverEnded.
using SolverCall = std::function<Json(const std::string& name, const Json& body,
                                      const std::atomic<bool>& interrupt, const OnProgress& on_progress)>;

}  // namespace netloft::design
