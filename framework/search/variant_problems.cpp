// SPDX-License-Identifier: BSD-3-Clause
#include "framework/search/variant_problems.hpp"

#include "framework/search/settings.hpp"

#include <cassert>
#include <utility>

namespace netloft {

VariantProblems::VariantProblems(VariantSource source) : source_(std::move(source)) {
  auto own = std::make_shared<VariantProblem>();
  own->scene = source_.scene;
  own->assembler = source_.assembler;
  own->model = make_work_model(*own->assembler, source_.make);
  unit_ = own->model.unit = own->model.of_iteration();
  levels_.emplace(0u, std::move(own));
}

std::shared_ptr<VariantProblem> VariantProblems::find_level(unsigned level) {
  if (const auto known = levels_.find(level); known != levels_.end()) return known->second;
  const Scene* scene = source_.levels ? source_.levels->scene(level) : nullptr;
  return levels_.emplace(level, scene ? make_problem_as_set(*scene) : nullptr).first->second;
}

/// Creates the problem of a coarser mesh. Its settings have the same factors as the settings of the source.
std::shared_ptr<VariantProblem> VariantProblems::make_problem_as_set(const Scene& scene) const {
  if (scene.settings.empty()) return make_problem(scene);
  auto own = std::make_unique<Scene>(scene);
  std::vector<double> factors;
  for (const Setting& setting : source_.scene->settings) factors.push_back(setting.factor);
  set_factors(*own, factors);
  auto variant_problem = make_problem(*own);
  variant_problem->own_scene = std::move(own);
  return variant_problem;
}

std::shared_ptr<VariantProblem> VariantProblems::at(const netloft_variant& variant) {
  const auto level = find_level(variant.level);
  assert(level && "the level of a variant exists");
  netloft_variant of_level = as_written();
  of_level.level = variant.level;
  if (is_same(variant, of_level)) return level;
  if (last_ && is_same(variant, last_variant_)) return last_;
  last_.reset();  // frees memory for the next problem
  auto easier = std::make_unique<Scene>(make_variant(*level->scene, *source_.registry, variant));
  last_ = make_problem(*easier);
  last_->own_scene = std::move(easier);
  last_variant_ = variant;
  return last_;
}

std::shared_ptr<VariantProblem> VariantProblems::make_problem(const Scene& scene) const {
  auto variant_problem = std::make_shared<VariantProblem>();
  variant_problem->scene = &scene;
  variant_problem->own_plan =
      std::make_unique<ScenePlan>(make_scene_plan(scene, *source_.registry, source_.tangent));
  variant_problem->own_assembler =
      std::make_unique<Assembler>(scene, *variant_problem->own_plan, source_.threads);
  variant_problem->assembler = variant_problem->own_assembler.get();
  variant_problem->model = make_work_model(*variant_problem->assembler, source_.make);
  variant_problem->model.unit = unit_;
  return variant_problem;
}

std::vector<double> VariantProblems::transfer(unsigned from, std::span<const double> u, unsigned to) {
  const auto source = find_level(from), target = find_level(to);
  if (!source || !target) return {};
  std::vector<double> x(source->assembler->start());
  source->assembler->place(u, x);
  const auto positions = source->assembler->node_positions(x);
  const auto carried = from == to ? positions : source_.levels->carry(from, positions, to);
  if (carried.empty()) return {};
  auto moved = target->assembler->displacements(carried);
  if (source->scene->bodies.size() == target->scene->bodies.size())
    target->assembler->take_rotations(*source->assembler, x, moved);
  target->assembler->take_shared_unknowns(*source->assembler, x, moved);
  return moved;
}

}  // namespace netloft
