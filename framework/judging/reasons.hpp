// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/assessment.hpp"

namespace netloft {

constexpr const char* kTimeIsOver = "the time limit was reached";

/// The reason for which a solver returned, as a sentence: "the limit of 300 iterations was reached".
std::string why_it_ended(netloft_outcome outcome, const StaticProblem& problem, const Assembler& assembler,
                         const Scene& scene);

/// Describes the growing motion, such as "a small disturbance grows tenfold in 2.3 s, swinging with a period
/// of 5.9 s, most at net node 4; 12 of 900 nodes move a tenth as far or more"
std::string growth_sentence(const Assessment& a, const Assembler& assembler, const Scene& scene);

/// The node with the largest amplitude in the growing motion, which must exist.
std::string node_of_growth(const Assessment& a, const Assembler& assembler, const Scene& scene);

/// The sentence about an assessment whose status and stability have been determined. `ending` says why the
/// solver returned, `worst` names the node with the largest residual, and `why_unstable` says why the point
/// is not stable.
std::string reason_of(const Assessment& a, const std::string& ending, const std::string& worst,
                      const std::string& why_unstable);

/// Describes the balance, such as "largest residual 3.2e-05 N at net node 4, largest load 120 N"
std::string balance_text(const Balance& balance, const std::string& worst);

}  // namespace netloft
