// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/judging/verdict.hpp"
#include "framework/scene/scene_plan.hpp"
#include "framework/search/variant_problems.hpp"
#include "io/formats/toml/diagnostics.hpp"
#include "io/scenes/reading/scene_source.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace netloft::runs {

class Meshes;

/// A scene file, the changes to it, and the number of threads. Copies share the data read from the file.
struct CaseSource {
  /// `set`: changes in the syntax of `--set`, "path=value".
  CaseSource(std::filesystem::path file, const std::vector<std::string>& set = {}, int thread_count = 1)
      : scene(std::move(file)), changes(formats::read_changes(set)), threads(thread_count) {}

  scenes::SceneSource scene;
  std::vector<formats::Change> changes;
  int threads;  // threads of the assembly and of large factorisations
};

/// A scene that is ready to be evaluated: read, checked and assembled, with a plan of the forces to evaluate.
/// equilibrium.hpp and march.hpp solve it. It is not movable, because the assembler refers to the scene.
class PreparedScene {
 public:
  enum class State { ready, wrong_input, refused };
  struct Seconds {
    double reading = 0, setup = 0;
  };

  /// `make` creates factorisations of matrices. If scenes share a `make` that stores its analyses
  /// (keep_analyses), a matrix pattern that they have in common is ordered and analysed only once.
  PreparedScene(CaseSource source, Registry& registry, MakeFactorisation make = {});
  ~PreparedScene();
  PreparedScene(const PreparedScene&) = delete;
  PreparedScene& operator=(const PreparedScene&) = delete;

  /// Reads, checks and assembles. `change` may alter the scene between reading and planning, for example its
  /// start or its water. If the state is not `ready`, diagnostics() has the reasons. Throws
  /// formats::Interrupted if the user interrupts.
  State prepare(const std::function<void(scenes::LoadedScene&)>& change = {});
  /// Prepares the scene with the mesh topology of another instance of it: the mesh is then a smooth function
  /// of the numbers of the net plan (SceneSource::instance()), and the assemblers share their data as far as
  /// possible.
  State prepare_like(const PreparedScene& other);
  const formats::Diagnostics& diagnostics() const { return diagnostics_; }

  scenes::LoadedScene& loaded() { return loaded_; }
  const scenes::LoadedScene& loaded() const { return loaded_; }
  const CaseSource& source() const { return source_; }
  const ScenePlan& plan() const { return plan_; }
  Assembler& assembler() { return *assembler_; }
  const Assembler& assembler() const { return *assembler_; }
  Registry& registry() { return registry_; }
  const MakeFactorisation& factorisations() const { return make_; }
  /// A sentence that says which loss factors of materials are used, or why none is. Empty if no part has a
  /// loss factor.
  const std::string& material_damping() const { return material_damping_; }
  const Seconds& seconds() const { return seconds_; }

  /// The scene and its coarser meshes, for the search of an equilibrium.
  VariantSource variants();
  /// Sets the quantities that the scene leaves to the search (Scene::settings), such as the length of a rope,
  /// to the values found, and makes a new assembler with these values.
  void adopt(const Solution& solution);

 private:
  State read(const PreparedScene* like = nullptr);
  State assemble(const PreparedScene* like = nullptr);
  void plan_terms();
  std::vector<std::string> unused() const;
  void set_length_in_bill(const Setting& setting);

  CaseSource source_;
  Registry& registry_;
  formats::Diagnostics diagnostics_;
  scenes::LoadedScene loaded_;
  ScenePlan plan_;
  std::string material_damping_;
  std::unique_ptr<Assembler> assembler_;
  std::unique_ptr<Meshes> meshes_;
  MakeFactorisation make_;
  Seconds seconds_;
};

/// The changes to the scene that an option means. For example, `--solver newton:method=classic` sets
/// analysis.solver and analysis.newton.method. `key` is "solver", "strategy" or "integrator". Throws
/// std::invalid_argument with a sentence if `specification` cannot be read.
std::vector<formats::Change> choose_method(const std::string& key, const std::string& specification);

}  // namespace netloft::runs
