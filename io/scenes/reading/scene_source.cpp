// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/scene_source.hpp"

#include "io/formats/toml/accepted_warnings.hpp"
#include "io/formats/work/long_work.hpp"
#include "io/gears/catalogue/part_choice.hpp"
#include "io/gears/meshing/division.hpp"
#include "io/gears/plan/checked_plan.hpp"
#include "io/gears/plan/read_plan.hpp"
#include "io/gears/plan/recent.hpp"
#include "io/scenes/reading/analysis.hpp"
#include "io/scenes/reading/catalogue_parts.hpp"
#include "io/scenes/reading/flow_reader.hpp"
#include "io/scenes/reading/gear_parts.hpp"
#include "io/scenes/reading/hold_reader.hpp"
#include "io/scenes/reading/join_reader.hpp"
#include "io/scenes/reading/part_reader.hpp"
#include "io/scenes/reading/read_bodies.hpp"
#include "io/scenes/reading/result_reader.hpp"
#include "io/scenes/reading/rider_reader.hpp"
#include "io/scenes/reading/scene_checks.hpp"

#include <algorithm>
#include <utility>

namespace netloft::scenes {

namespace {

/// Reports an error for tables of net plans in a scene that has no net plan.
void refuse_tables_of_plans(formats::TableReader& root) {
  constexpr std::pair<const char*, const char*> kTables[] = {
      {"gear", "cells of a part says how fine it is"},
      {"ropes", "[parts.NAME] with type = \"rope/bar\" is a rope of its own"},
      {"floats", "[parts.NAME] with type = \"float/float\" and on = \"PART\" is a float"},
      {"points", "parts have points of their own, such as rope.end; [[hold]] at = [0, 0, -5] places them"},
      {"hang", "[[join]] joins parts at their points and edges"},
      {"elements", "the type of a part, and its parameters, are in [parts.NAME]"}};
  root.has("panels");  // makes `panels` a known key, so that it is suggested for misspelt tables
  const auto keys = root.keys();
  for (const auto& [key, hint] : kTables)
    if (std::ranges::find(keys, key) != keys.end() && root.has(key))
      root.error(key, "belongs to a net plan, and this scene has none, because it has no [panels]", hint);
}

/// Reads one scene. The member functions are the steps, in the order of execution.
class SceneReader {
 public:
  /// `plan` is nullptr for a scene without a net plan.
  SceneReader(const formats::Value& root, const gears::NetPlan* plan, GearMemory& memory,
              const std::filesystem::path& folder, Registry& registry, formats::Diagnostics& diagnostics,
              bool& refused)
      : registry_(registry),
        diagnostics_(diagnostics),
        refused_(refused),
        root_(root, diagnostics),
        elements_(registry, refused),
        draft_(diagnostics),
        meshes_(folder, diagnostics),
        gear_(plan ? std::make_unique<GearParts>(*plan, root_, elements_, draft_, memory)
                   : std::make_unique<GearSteps>()) {
    for (const char* key : {"catalogue", "accept"}) root_.has(key);  // SceneSource reads these keys
    if (!plan) refuse_tables_of_plans(root_);
  }

  LoadedScene read(const std::shared_ptr<gears::Division>& like) {
    if (!gear_->divide(like)) return std::move(out_);
    water_.read();
    gear_->read_parts(parts_);
    joins_.read();
    add_bodies(draft_, diagnostics_);
    read_riders();
    read_holds();
    place_points(out_.scene);
    read_analysis_and_results();
    root_.finish();
    out_.files = meshes_.files();
    if (diagnostics_.errors() > 0) return std::move(out_);
    check_scene(root_, draft_, riders_.companions(), water_);
    holds_.report_one_sided();
    return std::move(out_);
  }

  /// Reads and checks everything that needs no mesh.
  void check() {
    water_.read();
    gear_->read_undivided(parts_);
    parts_.read_parts(formats::Presence::optional);
    for (auto& [name, table] : parts_.riders()) riders_.read_undivided(name, table);
    riders_.read_contacts_undivided();
    flow_.read_undivided();
    if (root_.has("analysis")) out_.analysis = read_analysis(root_.table("analysis"), registry_, refused_);
    for (const char* key : {"join", "hold", "results"}) root_.has(key);
    root_.finish();
    for (const Geometry& geometry : draft_.geometries) out_.parts.push_back(geometry.names);
    if (diagnostics_.errors() == 0) check_undivided(root_, draft_);
  }

 private:
  void read_riders() {
    gear_->add_pieces();
    for (auto& [name, table] : parts_.riders()) riders_.read(name, table);
    riders_.read_contacts();
    flow_.read();
    riders_.add_companions();
  }

  void read_holds() {
    gear_->add_holds();
    holds_.read();
    gear_->follow_holds();
  }

  void read_analysis_and_results() {
    out_.analysis = read_analysis(root_.table("analysis", formats::Presence::optional), registry_, refused_);
    water_.take_model();
    if (out_.analysis.kind == AnalysisKind::statics && diagnostics_.errors() == 0) {
      holds_.check_guides();
      water_.check_waves();
    }
    ResultReader(root_, draft_).read();
    if (diagnostics_.errors() == 0) water_.lay_bottom();
    gear_->complete_winches(registry_);
    if (out_.gear && out_.gear->times == 2) check_symmetry(root_, draft_, water_);
  }

  Registry& registry_;
  formats::Diagnostics& diagnostics_;
  bool& refused_;
  formats::TableReader root_;
  ElementChoice elements_;
  Draft draft_;
  LoadedScene& out_ = draft_.out;
  MeshParts meshes_;
  std::unique_ptr<GearSteps> gear_;
  WaterReader water_{root_, draft_, *gear_};
  PartReader parts_{root_, elements_, draft_, meshes_, *gear_};
  JoinReader joins_{root_, draft_, meshes_, *gear_};
  RiderReader riders_{root_, elements_, draft_, *gear_};
  FlowReader flow_{root_, elements_, draft_, *gear_};
  HoldReader holds_{root_, draft_, *gear_};
};

/// All inputs of a net plan: its tables, and the catalogue, which stays the same.
struct PlanInput {
  formats::Value tables;
  std::shared_ptr<const gears::Catalogue> catalogue;
  gears::HintTrials trials;
  bool operator==(const PlanInput&) const = default;
};

/// A plan that was read and checked, and the messages about it.
struct PlanRead {
  gears::NetPlan plan;
  std::vector<formats::Diagnostic> messages;
};

/// Reads and checks a plan. `memory` is the one for the catalogue of the plan. `said` has the sources of the
/// scene, for places in messages, but no messages yet.
std::shared_ptr<const PlanRead> read_and_check(const PlanInput& input, gears::PlanMemory& memory,
                                               formats::Diagnostics said) {
  auto read = std::make_shared<PlanRead>();
  read->plan = gears::read_and_check(input.tables, *input.catalogue, memory, input.trials, said);
  read->messages = said.messages();
  return read;
}

void append_new(std::vector<formats::SourceFile>& files, const std::vector<formats::SourceFile>& more) {
  for (const auto& file : more)
    if (std::none_of(files.begin(), files.end(), [&](const auto& f) { return f.path == file.path; }))
      files.push_back(file);
}

}  // namespace

/// The file of a scene, and its document, which is read at the first instance.
class SceneSource::Texts {
 public:
  explicit Texts(std::filesystem::path file, formats::StoredTexts edited = {})
      : file_(std::move(file)), edited_(std::move(edited)) {}

  const std::filesystem::path& file() const { return file_; }
  std::filesystem::path folder() const { return file_.parent_path(); }
  const std::vector<formats::SourceFile>& files() const { return document_->files(); }

  /// The tables of the document, with the changes applied. Their places refer to the sources of
  /// `diagnostics`.
  formats::Value changed(const std::vector<formats::Change>& changes, formats::Diagnostics& diagnostics) {
    if (!document_) document_ = formats::Document::load_edited(file_, edited_, said_);
    formats::Value root = document_->root();
    if (const int first = diagnostics.append(said_); first != 0) formats::shift_files(root, first);
    for (const formats::Change& change : changes)
      formats::apply(root, change, diagnostics, gears::keys_that_name_parts());
    return root;
  }

 private:
  std::filesystem::path file_;
  formats::StoredTexts edited_;
  std::optional<formats::Document> document_;
  formats::Diagnostics said_;  // messages about the document when it was loaded
};

/// The stored results of expensive steps, from the last instances of the scene.
class SceneSource::Memory {
 public:
  LoadedScene instance(Texts& texts, const std::vector<formats::Change>& changes, Registry& registry,
                       formats::Diagnostics& diagnostics, bool& refused,
                       const std::shared_ptr<gears::Division>& like) {
    formats::Value root = texts.changed(changes, diagnostics);
    if (diagnostics.errors()) return {};
    SceneCatalogue catalogue(catalogue_, root, texts.folder(), diagnostics);
    std::map<std::string, Strength> strengths;
    const auto plan =
        read_plan(root, catalogue, registry, gears::HintTrials::of_errors, diagnostics, strengths);
    if (plan && diagnostics.errors()) return {};  // without the gear, the rest of the scene cannot be checked
    LoadedScene loaded =
        SceneReader(root, plan ? &plan->plan : nullptr, gear_, texts.folder(), registry, diagnostics, refused)
            .read(like);
    formats::accept_warnings(root, diagnostics);
    loaded.scene.name = texts.file().stem().string();
    loaded.strengths.merge(strengths);
    if (auto& start = loaded.analysis.dynamics.start_file; !start.empty()) start = texts.folder() / start;
    const auto meshes = std::exchange(loaded.files, texts.files());
    append_new(loaded.files, meshes);
    if (const gears::Catalogue* used = catalogue.loaded()) append_new(loaded.files, used->files());
    return loaded;
  }

  gears::NetPlan check_plan(Texts& texts, const std::vector<formats::Change>& changes, Registry& registry,
                            formats::Diagnostics& diagnostics, bool& refused) {
    formats::Value root = texts.changed(changes, diagnostics);
    if (diagnostics.errors()) return {};
    SceneCatalogue catalogue(catalogue_, root, texts.folder(), diagnostics);
    std::map<std::string, Strength> strengths;
    const auto plan = read_plan(root, catalogue, registry, gears::HintTrials::of_all, diagnostics, strengths);
    if (!plan) return gears::read_plan(root, *catalogue.load(), diagnostics);  // reports the missing plan
    if (diagnostics.errors() == 0) gears::check_seams(plan->plan, diagnostics);
    if (diagnostics.errors() == 0)
      SceneReader(root, &plan->plan, gear_, texts.folder(), registry, diagnostics, refused).check();
    formats::accept_warnings(root, diagnostics);
    return plan->plan;
  }

 private:
  /// Replaces the names of catalogue parts in a scene by their numbers, and reads its plan; nullptr if there
  /// is none.
  std::shared_ptr<const PlanRead> read_plan(formats::Value& root, SceneCatalogue& catalogue,
                                            Registry& registry, gears::HintTrials trials,
                                            formats::Diagnostics& diagnostics,
                                            std::map<std::string, Strength>& strengths) {
    const bool is_there = gears::holds_plan(root);
    formats::Value tables = is_there ? gears::tables_of_plan(root) : formats::Value{};
    put_catalogue_parts(root, catalogue, registry, diagnostics, strengths);
    return is_there ? read_plan({std::move(tables), catalogue.load(), trials}, diagnostics) : nullptr;
  }

  /// Reads the plan, or returns the stored one for an equal input. If the scene has errors, the plan is read
  /// only to report its own errors, and is not stored.
  std::shared_ptr<const PlanRead> read_plan(PlanInput input, formats::Diagnostics& diagnostics) {
    if (diagnostics.errors())
      return std::make_shared<PlanRead>(
          PlanRead{gears::read_plan(input.tables, *input.catalogue, diagnostics), {}});
    const auto read = plans_.of(std::move(input), [&](const PlanInput& one) {
      if (plan_.catalogue != one.catalogue) plan_ = {one.catalogue, {}, {}};
      return read_and_check(one, plan_, diagnostics.without_messages());
    });
    diagnostics.take_messages(read->messages);
    return read;
  }

  gears::KeptCatalogue catalogue_;
  gears::Recent<PlanInput, const PlanRead> plans_{4};
  gears::PlanMemory plan_;
  GearMemory gear_;
};

SceneSource::SceneSource(std::filesystem::path file)
    : texts_(std::make_shared<Texts>(std::move(file))), memory_(std::make_shared<Memory>()) {}

const std::filesystem::path& SceneSource::file() const { return texts_->file(); }

SceneSource SceneSource::with_texts(std::filesystem::path file, formats::StoredTexts texts) const {
  SceneSource other = *this;
  other.texts_ = std::make_shared<Texts>(std::move(file), std::move(texts));
  return other;
}

formats::Value SceneSource::tables(const std::vector<formats::Change>& changes,
                                   formats::Diagnostics& diagnostics) const {
  return texts_->changed(changes, diagnostics);
}

LoadedScene SceneSource::instance(const std::vector<formats::Change>& changes, Registry& registry,
                                  formats::Diagnostics& diagnostics, bool& refused,
                                  const std::shared_ptr<gears::Division>& like) const {
  const std::string name = file().string();
  const formats::LongWork reading({"reading", name});
  return memory_->instance(*texts_, changes, registry, diagnostics, refused, like);
}

gears::NetPlan SceneSource::check_plan(const std::vector<formats::Change>& changes, Registry& registry,
                                       formats::Diagnostics& diagnostics, bool& refused) const {
  return memory_->check_plan(*texts_, changes, registry, diagnostics, refused);
}

}  // namespace netloft::scenes
