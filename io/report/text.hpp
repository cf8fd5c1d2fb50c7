// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/report/run_result.hpp"

namespace netloft::io {

/// Facts of the solve that the plan does not decide but a reader of the plan wants.
struct PlanExtras {
  std::string solver, factorisation;
  std::size_t matrix_entries = 0;
  int threads_given = 1, threads_used = 1;
  std::string way;  // what is done around the solver; empty: nothing
};

/// What the scene needs, term by term, and why not the rest.
std::string plan_text(const Plan& plan, const PlanExtras& extras);
std::string plan_json(const Scene& scene, const Plan& plan, const PlanExtras& extras);

/// The result for a person.
std::string run_text(const LoadedScene& loaded, const Plan& plan, const RunResult& result);
/// The result for a program: one JSON object.
std::string run_json(const LoadedScene& loaded, const Plan& plan, const RunResult& result);

}  // namespace netloft::io
