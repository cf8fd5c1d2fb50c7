// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/session/session.hpp"

#include <gtest/gtest.h>

#include "io/design/solver/live_solver.hpp"
#include "io/formats/work/long_work.hpp"
#include "tests/folders.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::design {
namespace {

/// A session of a trawl with few nodes, whose solver is in this process.
struct Trawl {
  Trawl() { ask("apply", {{"set", "gear.nodes=100"}, {"wait", true}}); }
  Json ask(const std::string& name, const Json& body = Json::object()) { return session.answer(name, body); }

  const std::string scene = test::source_folder() + "/gear-library/scenes/83-112-flume-3.0kn.toml";
  LiveSolver solver{scene, test::shipped_plugins(), 1};
  bool crashes = false;  // in the next call
  Session session{scene, test::source_folder() + "/gear-library",
                  [this](const std::string& name, const Json& body, const std::atomic<bool>& interrupt,
                         const OnProgress& on_progress) {
                    if (std::exchange(crashes, false)) throw SolverEnded("it crashed");
                    return solver.answer(name, body, interrupt, on_progress);
                  }};
};

const Json* find_number(const Json& state, const std::string& path) {
  for (const Json& number : state["numbers"])
    if (number["path"] == path) return &number;
  return nullptr;
}

TEST(DesignSession, MovesANumberAndReportsTheDifference) {
  Trawl trawl;
  const Json before = trawl.ask("state");
  ASSERT_EQ(before["outcome"]["status"], "converged");
  EXPECT_EQ((*find_number(before, "tow.speed"))["unit"], "kn");
  EXPECT_GT((*find_number(before, "tow.speed"))["largest"], 10.0);
  EXPECT_FALSE((*find_number(before, "tow.speed"))["doc"].get<std::string>().empty());
  const Json after = trawl.ask("apply", {{"path", "tow.speed"}, {"to", 3.1}, {"wait", true}});
  EXPECT_EQ(after["edit"]["after"], "\n[tow]\nspeed = \"3.1 kn\"\n");
  EXPECT_EQ(after["outcome"]["status"], "converged");
  EXPECT_LT(after["outcome"]["ghost_off"], 0.05);
  bool has_height = false;
  for (const Json& figure : after["outcome"]["figures"])
    if (figure["name"] == "mouth/headline_height") {
      has_height = true;
      EXPECT_LT(figure["value"], figure["start"]);
      EXPECT_TRUE(figure["key"]);
    }
  EXPECT_TRUE(has_height);
}

TEST(DesignSession, TakesBackEverythingToTheFirstText) {
  Trawl trawl;
  const Json first = trawl.ask("state");
  trawl.ask("apply", {{"path", "tow.speed"}, {"to", 3.1}});
  trawl.ask("apply", {{"path", "ropes.headrope.length"}, {"to", 25.5}});
  trawl.ask("undo");
  const Json last = trawl.ask("undo");
  EXPECT_EQ(last["files"], first["files"]);
  EXPECT_TRUE(last["can_redo"]);
}

TEST(DesignSession, DropsTheSearchForATextThatIsNoLongerTheNewest) {
  Trawl trawl;
  for (int i = 1; i < 20; ++i)
    trawl.ask("apply", {{"path", "tow.speed"}, {"to", 3 + 0.01 * i}, {"goes_on", true}});
  const Json end =
      trawl.ask("apply", {{"path", "tow.speed"}, {"to", 3.2}, {"goes_on", true}, {"wait", true}});
  EXPECT_EQ(end["outcome"]["revision"], end["revision"]);
  EXPECT_EQ(end["outcome"]["status"], "converged");
  std::size_t solved = 0;
  for (const Event& event : trawl.session.events_after(0, std::chrono::milliseconds(0)))
    solved += event.name == "solved";
  EXPECT_LT(solved, 20u);
}

TEST(DesignSession, AnswersAWrongTextAndGoesOn) {
  Trawl trawl;
  const Json state = trawl.ask("state");
  const std::string file = state["files"][0]["name"], text = state["files"][0]["text"];
  const Json broken = trawl.ask("apply", {{"file", file}, {"text", text + "[tow\n"}, {"wait", true}});
  EXPECT_EQ(broken["outcome"]["status"], "wrong input");
  const Json& message = broken["outcome"]["messages"][0];
  EXPECT_EQ(message["severity"], "error");
  EXPECT_EQ(message["file"], file);
  EXPECT_GT(message["line"], 1);
  EXPECT_THROW(trawl.ask("apply", {{"path", "tow.speed"}, {"to", 1}}), Refused);
  EXPECT_EQ(trawl.ask("check", {{"file", file}, {"text", text}})["messages"].size(), 0u);
  trawl.ask("undo");
  EXPECT_EQ(trawl.ask("solve")["status"], "converged");
}

TEST(DesignSession, RefusesRequestsThatSayTooLittle) {
  Trawl trawl;
  EXPECT_THROW(trawl.ask("nonsense"), WrongRequest);
  EXPECT_THROW(trawl.ask("apply"), WrongRequest);
  EXPECT_THROW(trawl.ask("apply", Json::array()), WrongRequest);
  EXPECT_THROW(trawl.ask("apply", {{"path", "tow.speed"}, {"to", "fast"}}), WrongRequest);
  EXPECT_THROW(trawl.ask("apply", {{"path", "tow.speed"}, {"to", 1}, {"wait", 3}}), WrongRequest);
  EXPECT_THROW(trawl.ask("jvp", {{"path", "no.number"}}), Refused);
  EXPECT_THROW(trawl.ask("influences", {{"figure", "no figure"}}), Refused);
  EXPECT_THROW(trawl.ask("sweep", {{"path", "tow.speed"}, {"from", 1}, {"to", 2}, {"points", 1e6}}),
               WrongRequest);
}

TEST(DesignSession, FindsTheNumberThatGivesAFigureItsTarget) {
  Trawl trawl;
  const Json found =
      trawl.ask("reach", {{"figure", "mouth/headline_height"}, {"target", 2.0}, {"paths", {"tow.speed"}}});
  const Json there =
      trawl.ask("apply", {{"path", "tow.speed"}, {"to", found["numbers"][0]["value"]}, {"wait", true}});
  for (const Json& figure : there["outcome"]["figures"])
    if (figure["name"] == "mouth/headline_height") EXPECT_NEAR(figure["value"], 2.0, 1e-4);
  EXPECT_THROW(
      trawl.ask("reach", {{"figure", "mouth/headline_height"}, {"target", 200}, {"paths", {"tow.speed"}}}),
      Refused);
  EXPECT_THROW(trawl.ask("reach", {{"figure", "mouth/headline_height"}, {"target", 2}, {"paths", {1}}}),
               WrongRequest);
}

TEST(DesignSession, ReachesATargetWithSeveralNumbersByLessOfEach) {
  Trawl trawl;
  const auto reach = [&](const Json& paths) {
    return trawl.ask("reach",
                     {{"figure", "mouth/headline_height"}, {"target", 1.3}, {"paths", paths}})["numbers"];
  };
  const Json alone = reach({"tow.speed"}), both = reach({"tow.speed", "elements.netting.drag.measured_at"});
  ASSERT_EQ(both.size(), 2u);
  EXPECT_LT(both[0]["value"], alone[0]["value"]);
  EXPECT_GT(both[0]["value"], 3.0);
  Json there;
  for (const Json& number : both)
    there = trawl.ask("apply", {{"path", number["path"]}, {"to", number["value"]}, {"wait", true}});
  for (const Json& figure : there["outcome"]["figures"])
    if (figure["name"] == "mouth/headline_height") EXPECT_NEAR(figure["value"], 1.3, 1e-4);
}

TEST(DesignSession, GivesFilesForOthersAndErrorsOfTheMesh) {
  Trawl trawl;
  const Json result = trawl.ask("export", {{"as", "hdf"}}), page = trawl.ask("export", {{"as", "html"}});
  EXPECT_TRUE(result["name"].get<std::string>().ends_with(".hdf"));
  EXPECT_TRUE(result["base64"].get<std::string>().starts_with("iUhERg0KGgo"));  // the signature of HDF5
  EXPECT_GT(page["base64"].get<std::string>().size(), 100000u);
  EXPECT_THROW(trawl.ask("export", {{"as", "exe"}}), WrongRequest);
  trawl.ask("apply", {{"set", "gear.nodes=500"}, {"wait", true}});
  int known = 0;
  const Json errors = trawl.ask("errors");
  for (const Json& figure : errors["figures"]) known += !figure["mesh_error"].is_null();
  EXPECT_GT(known, 10) << errors["note"];
}

TEST(DesignSession, SweepsANumberOnBothSides) {
  Trawl trawl;
  const Json sweep = trawl.ask("sweep", {{"path", "tow.speed"}, {"from", 2.5}, {"to", 3.5}, {"points", 5}});
  const Json& heights = sweep["figures"]["mouth/headline_height"];
  ASSERT_EQ(heights.size(), 5u);
  for (std::size_t i = 1; i < 5; ++i) EXPECT_LT(heights[i], heights[i - 1]);
  EXPECT_EQ(sweep["values"][4], 3.5);
}

TEST(DesignSession, RanksTheNumbersThatMoveAFigure) {
  Trawl trawl;
  const Json found = trawl.ask("influences", {{"figure", "mouth/headline_height"}});
  ASSERT_GT(found["ranked"].size(), 5u);
  for (std::size_t i = 1; i < found["ranked"].size(); ++i)
    EXPECT_GE(std::abs(found["ranked"][i - 1]["per_percent"].get<double>()),
              std::abs(found["ranked"][i]["per_percent"].get<double>()));
}

TEST(DesignSession, GoesAsFarAsAFigureStaysWithinItsBound) {
  Trawl trawl;
  const Json found =
      trawl.ask("range", {{"path", "tow.speed"}, {"figure", "mouth/headline_height"}, {"least", 1.3}});
  EXPECT_NE(found["up"]["why"].get<std::string>().find("falls below 1.3"), std::string::npos);
  const Json there =
      trawl.ask("apply", {{"path", "tow.speed"}, {"to", found["up"]["value"]}, {"wait", true}});
  for (const Json& figure : there["outcome"]["figures"])
    if (figure["name"] == "mouth/headline_height") {
      EXPECT_GE(figure["value"], 1.3 - 1e-6);
      EXPECT_LT(figure["value"], 1.31);
    }
  EXPECT_LT(found["down"]["value"], 3.0);
}

TEST(DesignSession, RunsATextThatIsLeftAloneFromItsSketch) {
  Trawl trawl;
  const Json near = trawl.ask("apply", {{"path", "tow.speed"}, {"to", 3.1}, {"wait", true}})["outcome"];
  EXPECT_FALSE(near["as_run"]);
  const std::uint64_t before = trawl.ask("state")["event"];
  const Json run = trawl.ask("run");
  EXPECT_TRUE(run["as_run"]);
  EXPECT_EQ(run["revision"], near["revision"]);
  EXPECT_LT(run["ghost_off"], 1e-2);
  EXPECT_TRUE(run["jump"].is_null());
  EXPECT_EQ(trawl.ask("state")["outcome"], run);
  bool is_told = false;
  for (const Event& event : trawl.session.events_after(before, std::chrono::milliseconds(0)))
    is_told = is_told || event.name == "confirmed";
  EXPECT_TRUE(is_told);
}

TEST(DesignSession, OutlivesItsSolver) {
  Trawl trawl;
  trawl.crashes = true;
  const Json outcome = trawl.ask("apply", {{"path", "tow.speed"}, {"to", 3.1}, {"wait", true}})["outcome"];
  EXPECT_EQ(outcome["status"], "solver ended");
  EXPECT_EQ(outcome["sentence"], "it crashed");
  EXPECT_EQ(trawl.ask("undo")["can_redo"], true);
  EXPECT_EQ(trawl.ask("solve")["status"], "converged");
  trawl.crashes = true;
  EXPECT_THROW(trawl.ask("plan"), SolverEnded);
  EXPECT_FALSE(trawl.ask("plan")["svg"].get<std::string>().empty());
}

TEST(DesignSession, StopsASearchOnDemand) {
  Trawl trawl;
  trawl.ask("apply", {{"set", "gear.nodes=3000"}});
  trawl.ask("stop");
  const std::string status = trawl.ask("solve")["status"];
  EXPECT_TRUE(status == "interrupted" || status == "converged") << status;
}

TEST(DesignSession, EndsWhileSomebodyWaits) {
  auto trawl = std::make_unique<Trawl>();
  trawl->session.end();
  EXPECT_THROW(trawl->ask("picture"), formats::Interrupted);
  EXPECT_TRUE(trawl->session.has_ended());
}

}  // namespace
}  // namespace netloft::design
