// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/scene/scene_plan.hpp"

#include <string>

namespace netloft::results {

/// Facts about the solve that are printed with the plan of a scene. The plan lists the forces that are
/// evaluated.
struct PlanExtras {
  std::string solver, factorisation;
  std::size_t matrix_entries = 0;
  int threads_given = 1, threads_used = 1;
  std::string strategy, attempts;  // attempts: one line with a reason for each attempt of the strategy
  std::string material_damping;    // which loss factors are used in a motion, or why none is
  // Expected memory: total, factor, stability check [bytes]
  double memory = 0, factor_memory = 0, stability_memory = 0;
};

/// The forces that each family (elements of one type) evaluates, and why the others are off.
std::string plan_text(const ScenePlan& plan, const PlanExtras& extras);
std::string plan_json(const Scene& scene, const ScenePlan& plan, const PlanExtras& extras);

}  // namespace netloft::results
