// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/result.hpp"
#include "io/runs/prepared_scene.hpp"

#include <atomic>
#include <functional>
#include <string>

namespace netloft::studies {

/// Finds the numbers of a scene on which the key figures of its equilibrium depend most, and adds them to
/// `result`, the result of `solution`. If there are no derivatives, or after an interruption, a note in
/// `result` says why. Requires that why_no_derivatives() returns nullopt for the scene.
void find_key_sensitivities(
    runs::PreparedScene& scene, const Solution& solution, const std::atomic<bool>* interrupt,
    const std::function<void(std::size_t done, std::size_t all, const std::string& path)>& on_number,
    results::Result& result);

}  // namespace netloft::studies
