// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"

#include <string>
#include <vector>

namespace netloft::results {

/// "Reynolds number 330 to 1e+05, Choo and Casarella 1971", with the parameters it depends on.
std::string validity_text(const netloft_validity& range);

/// A sentence for every range of a law that a part of the gear lies outside of, where that part does not
/// round to 0 %.
std::vector<std::string> law_range_warnings(const Scene& scene, const std::vector<LawUse>& uses);

}  // namespace netloft::results
