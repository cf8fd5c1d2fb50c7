// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"

#include <string>
#include <vector>

namespace netloft::results {

/// The range of validity of a law as text: "Reynolds number 330 to 1e+05, Choo and Casarella 1971", with the
/// parameters on which it depends.
std::string validity_text(const netloft_validity& range);

/// Returns a sentence for every law (of drag, for example) that some elements use outside its range of
/// validity. A law is ignored if the fraction of the gear concerned rounds to 0 %.
std::vector<std::string> law_range_warnings(const Scene& scene, const std::vector<LawUse>& uses);

}  // namespace netloft::results
