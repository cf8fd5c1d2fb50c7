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

/// A variant of a scene, ready to be evaluated, and what its operations cost.
struct VariantProblem {
  const Scene* scene = nullptr;
  Assembler* assembler = nullptr;
  WorkModel model;
  // What it owns: all but that of the scene as it is written.
  std::unique_ptr<Scene> own_scene;
  std::unique_ptr<ScenePlan> own_plan;
  std::unique_ptr<Assembler> own_assembler;
};

/// A search takes its problems from here: the scene with its assembler, and how others like them are made.
struct VariantSource {
  const Scene* scene = nullptr;
  Assembler* assembler = nullptr;
  Registry* registry = nullptr;
  Levels* levels = nullptr;  // null: the scene's own mesh only
  MakeFactorisation make;
  TangentChoice tangent = TangentChoice::exact;
  int threads = 1;
};

/// Makes the variants of a scene when they are first asked for. Each level as it is written is kept, of all
/// others the last one.
class VariantProblems {
 public:
  explicit VariantProblems(VariantSource source);

  unsigned most_levels() const { return source_.levels ? source_.levels->most() : 1; }
  /// Null: there is no such level.
  std::shared_ptr<VariantProblem> find_level(unsigned level);
  /// The level of the variant must exist. Throws SceneError where the plugins refuse the variant.
  std::shared_ptr<VariantProblem> at(const netloft_variant& variant);
  /// Displacements of one level read off those of another; empty where that is not possible.
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
