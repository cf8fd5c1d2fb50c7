// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/read_scene.hpp"

#include "io/gears/plan/check.hpp"
#include "io/gears/plan/read_plan.hpp"
#include "io/scenes/reading/analysis.hpp"
#include "io/scenes/reading/catalogue_parts.hpp"
#include "io/scenes/reading/hold_reader.hpp"
#include "io/scenes/reading/join_reader.hpp"
#include "io/scenes/reading/part_reader.hpp"
#include "io/scenes/reading/read_bodies.hpp"
#include "io/scenes/reading/read_winches.hpp"
#include "io/scenes/reading/result_reader.hpp"
#include "io/scenes/reading/rider_reader.hpp"
#include "io/scenes/reading/scene_checks.hpp"

#include <algorithm>
#include <utility>

namespace netloft::scenes {

namespace {

/// Reads one scene; members are steps in the order they happen.
class SceneReader {
 public:
  /// `plan`: of a gear that stands in the scene; null without.
  SceneReader(const formats::Value& root, const gears::NetPlan* plan, const std::filesystem::path& file,
              Registry& registry, formats::Diagnostics& diagnostics, bool& refused)
      : reading_(root, plan, file, registry, diagnostics, refused),
        diagnostics_(diagnostics),
        out_(reading_.out()),
        gear_(reading_.gear) {}

  LoadedScene read() {
    if (gear_ && !gear_->is_divided()) return std::move(out_);
    water_.read();
    read_parts();
    joins_.read();
    add_bodies(reading_.draft, diagnostics_);
    read_riders();
    read_holds();
    place_points(out_.scene);
    read_analysis_and_results();
    reading_.root.finish();
    out_.files = reading_.meshes.files();
    if (diagnostics_.errors() > 0) return std::move(out_);
    check_scene(reading_, water_);
    holds_.report_one_sided();
    return std::move(out_);
  }

 private:
  void read_parts() {
    if (gear_) {
      parts_.read_bodies_of_plan();
      gear_->add_parts();
    }
    parts_.read_parts();
    if (!gear_) parts_.read_bodies();
  }

  void read_riders() {
    if (gear_) gear_->add_pieces();
    for (auto& [name, table] : parts_.riders()) riders_.read(name, table);
    if (gear_) riders_.read_contacts();
    riders_.add_companions();
  }

  void read_holds() {
    if (gear_) {
      gear_->hold_middle();
      gear_->hold_blocks();
    }
    holds_.read();
    if (gear_) gear_->follow_holds();
  }

  void read_analysis_and_results() {
    out_.analysis = read_analysis(reading_.root.table("analysis", formats::Presence::optional),
                                  reading_.registry, reading_.refused);
    water_.take_model();
    if (out_.analysis.kind == AnalysisKind::statics && diagnostics_.errors() == 0) {
      holds_.check_guides();
      water_.check_waves();
    }
    ResultReader(reading_).read();
    if (diagnostics_.errors() == 0) water_.lay_bottom();
    if (reading_.plan) ready_winches(*reading_.plan, reading_.registry, out_, diagnostics_);
    if (gear_ && out_.gear && out_.gear->times == 2) check_symmetry(reading_, water_);
  }

  SceneReading reading_;
  formats::Diagnostics& diagnostics_;
  LoadedScene& out_;  // of the draft
  std::optional<GearParts>& gear_;
  WaterReader water_{reading_};
  PartReader parts_{reading_};
  JoinReader joins_{reading_};
  RiderReader riders_{reading_};
  HoldReader holds_{reading_};
};

/// The net plan in a scene, checked; nothing if there is none.
std::optional<gears::NetPlan> read_plan_of(const formats::Document& document,
                                           const std::filesystem::path& folder,
                                           formats::Diagnostics& diagnostics) {
  if (!gears::holds_plan(document)) return {};
  gears::NetPlan plan = gears::read_plan(document, folder, diagnostics);
  if (diagnostics.errors() == 0) gears::check_plan(plan, diagnostics);
  return plan;
}

void append_new(std::vector<formats::SourceFile>& files, const std::vector<formats::SourceFile>& more) {
  for (const auto& file : more)
    if (std::none_of(files.begin(), files.end(), [&](const auto& f) { return f.path == file.path; }))
      files.push_back(file);
}

}  // namespace

LoadedScene read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                       Registry& registry, formats::Diagnostics& diagnostics, bool& refused) {
  const formats::Document document = formats::Document::load(file, overrides, diagnostics);
  if (diagnostics.errors()) return {};
  formats::Value root = document.root();
  std::map<std::string, Strength> strengths;
  const auto catalogues = put_catalogue_parts(root, file.parent_path(), registry, diagnostics, strengths);
  const auto plan = read_plan_of(document, file.parent_path(), diagnostics);
  if (diagnostics.errors() && plan) return {};  // nothing in a scene can be judged without its gear
  LoadedScene loaded =
      SceneReader(root, plan ? &*plan : nullptr, file, registry, diagnostics, refused).read();
  loaded.strengths.merge(strengths);
  if (auto& start = loaded.analysis.dynamics.start_file; !start.empty()) start = file.parent_path() / start;
  const auto meshes = std::exchange(loaded.files, document.files());
  append_new(loaded.files, meshes);
  append_new(loaded.files, catalogues);
  if (plan) append_new(loaded.files, plan->files);
  return loaded;
}

}  // namespace netloft::scenes
