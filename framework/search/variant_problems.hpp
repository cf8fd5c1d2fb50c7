// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/balance/factorisation.hpp"
#include "framework/balance/work.hpp"
#include "framework/search/levels.hpp"
#include "framework/search/variants.hpp"

#include <map>
#include <memory>

namespace netloft {

/// A variant of a scene, ready to be evaluated, with the cost of its operations (WorkModel).
struct VariantProblem {
  const Scene* scene = nullptr;
  Assembler* assembler = nullptr;
  WorkModel model;
  // Owned objects, empty for the original scene.
  std::unique_ptr<Scene> own_scene;
  std::unique_ptr<ScenePlan> own_plan;
  std::unique_ptr<Assembler> own_assembler;
};

/// The original scene with its assembler, from which a search makes variants.
struct VariantSource {
  const Scene* scene = nullptr;
  Assembler* assembler = nullptr;
  Registry* registry = nullptr;
  Levels* levels = nullptr;  // nullptr: no coarser meshes
  MakeFactorisation make;
  TangentChoice tangent = TangentChoice::exact;
  int threads = 1;
};

/// Creates the variants of a scene when they are first requested. Of variants that change only the mesh, it
/// stores the problem of each level; of all others, only the last problem.
class VariantProblems {
 public:
  explicit VariantProblems(VariantSource source);

  unsigned most_levels() const { return source_.levels ? source_.levels->most() : 1; }
  /// The problem of a level of mesh; nullptr if the level does not exist.
  std::shared_ptr<VariantProblem> find_level(unsigned level);
  /// The problem of a variant, whose level must exist. Throws SceneError if a plugin refuses the variant.
  std::shared_ptr<VariantProblem> at(const netloft_variant& variant);
  /// Displacements of one level of mesh interpolated to another; empty if that is not possible.
  std::vector<double> transfer(unsigned from, std::span<const double> u, unsigned to);

  const VariantSource& source() const { return source_; }

 private:
  std::shared_ptr<VariantProblem> make_problem(const Scene& scene) const;
  std::shared_ptr<VariantProblem> make_problem_as_set(const Scene& scene) const;

  VariantSource source_;
  double unit_ = 1;
  std::map<unsigned, std::shared_ptr<VariantProblem>> levels_;
  netloft_variant last_variant_{};
  std::shared_ptr<VariantProblem> last_;
};

}  // namespace netloft
