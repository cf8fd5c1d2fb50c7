// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene_plan.hpp"

#include <string>

namespace netloft::results {

/// Facts about the solve that the plan does not decide but that a reader of the plan needs.
struct PlanExtras {
  std::string solver, factorisation;
  std::size_t matrix_entries = 0;
  int threads_given = 1, threads_used = 1;
  std::string strategy, attempts;  // of the search; its attempts with their reasons, a line each
  std::string material_damping;    // loss factors that count in a motion, or why none does
  double memory = 0, factor_memory = 0, stability_memory = 0;  // expected, in all and for two uses [bytes]
};

/// The forces that each family of elements evaluates, and why the others are off.
std::string plan_text(const ScenePlan& plan, const PlanExtras& extras);
std::string plan_json(const Scene& scene, const ScenePlan& plan, const PlanExtras& extras);

}  // namespace netloft::results
