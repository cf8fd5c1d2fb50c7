// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/live/live_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "io/design/texts/scene_texts.hpp"
#include "io/runs/equilibrium.hpp"
#include "tests/folders.hpp"
#include "tests/unit/io/studies/truss.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::design {
namespace {

using Status = Outcome::Status;

/// A scene of the library with changes, which are followed and never saved.
class Followed {
 public:
  Followed(const std::string& scene, const std::string& nodes)
      : texts(test::source_folder() + "/gear-library/scenes/" + scene,
              test::source_folder() + "/gear-library"),
        live(texts.file(), test::shipped_plugins(), 1) {
    texts.set(formats::read_change("gear.nodes=" + nodes));
  }
  Outcome follow(const std::optional<MovedNumber>& moved = {}) {
    return live.follow(texts.file(), texts.own(), moved, never);
  }
  Outcome move(const std::string& path, double to) {
    texts.set(live.number(path).to(to).front());
    return follow(MovedNumber{path, to});
  }
  double figure(const std::string& name) const {
    const auto all = studies::all_figures(live.last()->result);
    return results::find_scalar(all, name)->value;
  }

  std::atomic<bool> never{false};
  SceneTexts texts;
  LiveScene live;
};

/// The figures of the same texts, computed by a separate run from the sketch.
std::vector<results::NamedScalar> figures_of_batch_run(const SceneTexts& texts) {
  runs::CaseSource source(texts.file());
  source.scene = source.scene.with_texts(texts.file(), texts.own());
  runs::PreparedScene scene(source, test::shipped_plugins());
  EXPECT_EQ(scene.prepare(), runs::PreparedScene::State::ready);
  const Solution solution = runs::find_equilibrium(scene);
  return studies::all_figures(results::make_result(scene.loaded(), scene.assembler(), solution));
}

TEST(LiveScene, ContinuesToWhereABatchRunArrives) {
  Followed trawl("83-112-flume-3.0kn.toml", "150");
  trawl.texts.set(formats::read_change("analysis.tolerance=1e-11"));
  ASSERT_EQ(trawl.follow().status, Status::converged);
  ASSERT_EQ(trawl.move("tow.speed", 3.2).status, Status::converged);
  ASSERT_EQ(trawl.move("ropes.headrope.length", 25.4).status, Status::converged);
  const auto batch = figures_of_batch_run(trawl.texts);
  const auto live = studies::all_figures(trawl.live.last()->result);
  ASSERT_EQ(live.size(), batch.size());
  for (const char* name : {"mouth/headline_height", "mouth/upper_wing_spread", "force/drag"}) {
    const auto* a = results::find_scalar(live, name);
    const auto* b = results::find_scalar(batch, name);
    if (a && b) EXPECT_NEAR(a->value, b->value, 1e-7 * std::abs(b->value)) << name;
  }
}

TEST(LiveScene, IsAfterARerunExactlyWhereABatchRunArrives) {
  Followed trawl("83-112-flume-3.0kn.toml", "150");
  ASSERT_EQ(trawl.follow().status, Status::converged);
  const Outcome near = trawl.move("ropes.headrope.length", 25.5);
  ASSERT_EQ(near.status, Status::converged);
  EXPECT_FALSE(near.is_as_run);
  const Outcome run = trawl.live.rerun(trawl.never);
  ASSERT_EQ(run.status, Status::converged);
  EXPECT_TRUE(run.is_as_run);
  EXPECT_GT(run.ghost_off.value(), 0);
  EXPECT_FALSE(run.jump);
  const auto batch = figures_of_batch_run(trawl.texts);
  const auto live = studies::all_figures(trawl.live.last()->result);
  ASSERT_EQ(live.size(), batch.size());
  for (std::size_t f = 0; f < batch.size(); ++f) EXPECT_EQ(live[f].value, batch[f].value) << batch[f].name;
}

TEST(LiveScene, ExpectsTheEquilibriumWhereTheTangentLeads) {
  Followed trawl("83-112-flume-3.0kn.toml", "150");
  trawl.texts.set(formats::read_change("analysis.tolerance=1e-10"));
  ASSERT_EQ(trawl.follow().status, Status::converged);
  const double before = trawl.figure("mouth/headline_height");
  const Tangents& tangents = trawl.live.tangents("tow.speed");
  ASSERT_EQ(tangents.effect.why_not, "");
  ASSERT_EQ(tangents.motion.size(), trawl.live.last()->points.size());
  const auto figures = studies::all_figures(trawl.live.last()->result);
  double slope = NAN;
  for (std::size_t f = 0; f < figures.size(); ++f)
    if (figures[f].name == "mouth/headline_height") slope = tangents.effect.per_unit[f];
  const Outcome near = trawl.move("tow.speed", 3.01);
  ASSERT_EQ(near.status, Status::converged);
  EXPECT_TRUE(near.has_same_mesh);
  EXPECT_LT(near.ghost_off.value(), 2e-3);
  EXPECT_FALSE(near.jump);
  EXPECT_NEAR(trawl.figure("mouth/headline_height") - before, 0.01 * slope, 2e-4);
}

/// A scene of one text, of which one number moves.
class OneNumber {
 public:
  OneNumber(const std::string& text, std::string path, const std::string& start)
      : path_(std::move(path)), live_("own.toml", test::shipped_plugins(), 1), text_(text) {
    std::string first = text;
    first.replace(first.find("MOVED"), 5, start);
    EXPECT_EQ(live_.follow("own.toml", {{"own.toml", first}}, {}, never_).status, Status::converged);
  }
  Outcome move(double to) {
    std::string text = text_;
    text.replace(text.find("MOVED"), 5, std::to_string(to));
    return live_.follow("own.toml", {{"own.toml", text}}, MovedNumber{path_, to}, never_);
  }
  double height_of(std::size_t node) const { return live_.last()->points[3 * node + 2]; }

 private:
  std::atomic<bool> never_{false};
  std::string path_;
  LiveScene live_;
  std::string text_;
};

TEST(LiveScene, SaysThatTheGearJumpedAtAFoldAndNotBeforeIt) {
  std::string truss = test::kTruss;
  truss.replace(truss.find("z = 0"), 5, "z = MOVED");
  OneNumber scene(truss, "parts.load.force.z", "1");
  for (const double part : {0.3, 0.6, 0.8, 0.95}) {
    const double load = part * test::load_of_fold();
    const Outcome near = scene.move(load);
    ASSERT_EQ(near.status, Status::converged);
    EXPECT_NEAR(scene.height_of(1), test::height_at(load), 1e-6);
    EXPECT_FALSE(near.jump) << part;
  }
  const double before = scene.height_of(1);
  const Outcome beyond = scene.move(1.05 * test::load_of_fold());
  ASSERT_EQ(beyond.status, Status::converged);
  EXPECT_LT(scene.height_of(1), -0.2) << "snapped through";
  ASSERT_TRUE(beyond.jump);
  EXPECT_NEAR(beyond.jump->moved, before - scene.height_of(1), 1e-9);
  EXPECT_NE(beyond.jump->why.find("another equilibrium"), std::string::npos);
}

TEST(LiveScene, SaysWhichNodesTouchedTheGroundWhereNoTangentLeadsTo) {
  OneNumber scene(
      "[parts.rope]\ntype = \"rope/bar\"\ncells = 2\nlength = \"10 m\"\nsketch = [[0, 0, 0], [0, 0, "
      "-10]]\nrope = { "
      "diameter = \"20 mm\", EA = \"10 kN\", density = 2000 }\n[parts.bed]\ntype = \"seabed/plane\"\non = "
      "\"rope\"\nseabed = "
      "{ depth = MOVED }\n[[hold]]\non = \"rope.start\"\n",
      "parts.bed.seabed.depth", "12");
  const Outcome above = scene.move(11);  // the rope hangs straight above the bed
  EXPECT_EQ(above.ghost_off, 0);
  EXPECT_FALSE(above.jump);
  const Outcome touching = scene.move(9);
  ASSERT_EQ(touching.status, Status::converged);
  ASSERT_TRUE(touching.jump);
  EXPECT_NE(touching.jump->why.find("nodes of rope touched the ground"), std::string::npos)
      << touching.jump->why;
}

TEST(LiveScene, KeepsTheLastShapeWhenATextIsWrong) {
  Followed trawl("83-112-flume-3.0kn.toml", "100");
  ASSERT_EQ(trawl.follow().status, Status::converged);
  const Equilibrium* last = trawl.live.last();
  trawl.texts.set(formats::read_change("tow.speed=3 kg"));
  const Outcome wrong = trawl.follow();
  EXPECT_EQ(wrong.status, Status::wrong_input);
  EXPECT_EQ(wrong.diagnostics.errors(), 1);
  EXPECT_EQ(trawl.live.last(), last);
  trawl.texts.undo();
  EXPECT_EQ(trawl.follow().status, Status::converged);
}

TEST(LiveScene, SaysWhatDoesNotConverge) {
  Followed trawl("83-112-flume-3.0kn.toml", "100");
  trawl.texts.set(formats::read_change("analysis.max_iterations=2"));
  trawl.texts.set(formats::read_change("analysis.strategy=direct"));
  const Outcome outcome = trawl.follow();
  EXPECT_EQ(outcome.status, Status::not_converged);
  EXPECT_FALSE(outcome.sentence.empty());
  EXPECT_FALSE(outcome.at_fault.empty());
  EXPECT_EQ(trawl.live.last(), nullptr);
  EXPECT_THROW(trawl.live.tangents("tow.speed"), Refused);
}

TEST(LiveScene, IsInterruptedAndGoesOn) {
  Followed trawl("83-112-flume-3.0kn.toml", "100");
  std::atomic<bool> now{true};
  EXPECT_EQ(trawl.live.follow(trawl.texts.file(), trawl.texts.own(), {}, now).status, Status::interrupted);
  EXPECT_EQ(trawl.follow().status, Status::converged);
}

TEST(LiveScene, FollowsALengthOnTheMeshThatIsThereAndThenOnItsOwn) {
  Followed trawl("83-112-flume-3.0kn.toml", "200");
  ASSERT_EQ(trawl.follow().status, Status::converged);
  trawl.texts.set(trawl.live.number("ropes.lower-bridle.length").to(55).front());
  const MovedNumber moved{"ropes.lower-bridle.length", 55};
  const auto on = [&](LiveScene::Mesh mesh) {
    return trawl.live.follow(trawl.texts.file(), trawl.texts.own(), moved, trawl.never, mesh);
  };
  const Outcome first = on(LiveScene::Mesh::kept);
  ASSERT_EQ(first.status, Status::converged);
  EXPECT_TRUE(first.has_same_mesh);
  EXPECT_FALSE(first.has_own_mesh);
  EXPECT_TRUE(first.ghost_off);
  const double drag = trawl.figure("drag/all/x");
  const Outcome second = on(LiveScene::Mesh::own);
  ASSERT_EQ(second.status, Status::converged);
  EXPECT_TRUE(second.has_own_mesh);
  EXPECT_NEAR(trawl.figure("drag/all/x"), drag, 0.03 * drag);
}

TEST(LiveScene, SeeksFromTheSketchWhatIsFarAway) {
  Followed trawl("83-112-flume-3.0kn.toml", "200");
  ASSERT_EQ(trawl.follow().status, Status::converged);
  trawl.texts.set(trawl.live.number("ropes.lower-bridle.length").to(50).front());
  const MovedNumber moved{"ropes.lower-bridle.length", 50};
  const Outcome far =
      trawl.live.follow(trawl.texts.file(), trawl.texts.own(), moved, trawl.never, LiveScene::Mesh::kept);
  ASSERT_EQ(far.status, Status::converged);
  EXPECT_TRUE(far.has_own_mesh);
  EXPECT_TRUE(far.ghost_off);
  const auto near = studies::all_figures(trawl.live.last()->result);
  const Outcome run = trawl.live.rerun(trawl.never);
  EXPECT_TRUE(run.is_as_run);
  const auto again = studies::all_figures(trawl.live.last()->result);
  for (std::size_t f = 0; f < near.size(); ++f) EXPECT_EQ(near[f].value, again[f].value) << near[f].name;
}

TEST(LiveScene, CarriesTheShapeToAnotherMesh) {
  Followed trawl("83-112-flume-3.0kn.toml", "100");
  ASSERT_EQ(trawl.follow().status, Status::converged);
  trawl.texts.set(formats::read_change("gear.nodes=200"));
  const Outcome finer = trawl.follow();
  EXPECT_EQ(finer.status, Status::converged);
  EXPECT_FALSE(finer.has_same_mesh);
  EXPECT_FALSE(finer.ghost_off);
}

TEST(LiveScene, SeeksNoEquilibriumOfAMotion) {
  SceneTexts texts(test::source_folder() + "/gear-library/scenes/dynamics/elastic-pendulum.toml",
                   test::source_folder() + "/gear-library");
  LiveScene live(texts.file(), test::shipped_plugins(), 1);
  const std::atomic<bool> never{false};
  const Outcome outcome = live.follow(texts.file(), texts.own(), {}, never);
  EXPECT_EQ(outcome.status, Status::no_equilibrium_sought);
  EXPECT_NE(outcome.sentence.find("analysis.kind"), std::string::npos);
}

TEST(LiveScene, KnowsRangesAndSentencesOfNumbers) {
  Followed trawl("83-112-flume-3.0kn.toml", "100");
  trawl.follow();
  const auto& words = trawl.live.words();
  ASSERT_TRUE(words.contains("tow.speed"));
  EXPECT_EQ(words.at("tow.speed").unit, "m/s");
  EXPECT_EQ(words.at("panels.top-wing.depth").doc, "meshes from the fore to the aft edge");
  EXPECT_EQ(words.at("panels.top-wing.depth").range.lo, 0);
}

}  // namespace
}  // namespace netloft::design
