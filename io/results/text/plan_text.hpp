// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene_plan.hpp"

#include <string>

namespace netloft::results {

/// Facts about the solve that are not part of the plan but that a reader of the plan needs.
struct PlanExtras {
  std::string solver, factorisation;
  std::size_t matrix_entries = 0;
  int threads_given = 1, threads_used = 1;
  std::string strategy, attempts;  // attempts: those of the strategy with their reasons, a line each
  std::string material_damping;    // the loss factors that apply to a motion, or why none does
  // Expected memory: total, factor, stability check [bytes]
  double memory = 0, factor_memory = 0, stability_memory = 0;
};

/// The forces that each family of elements evaluates, and why the others are off.
std::string plan_text(const ScenePlan& plan, const PlanExtras& extras);
std::string plan_json(const Scene& scene, const ScenePlan& plan, const PlanExtras& extras);

}  // namespace netloft::results
