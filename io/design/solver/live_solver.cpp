// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/solver/live_solver.hpp"

#include "io/design/solver/questions.hpp"
#include "io/design/solver/replies.hpp"
#include "io/design/solver/request_values.hpp"

namespace netloft::design {

namespace {

formats::StoredTexts texts_in(const Json& body) {
  formats::StoredTexts texts;
  for (const auto& [name, text] : body.at("texts").items()) texts[name] = text.get<std::string>();
  return texts;
}

SweepQuestion sweep_in(const Json& body) {
  return {text_in(body, "path"), number_in(body, "from"), number_in(body, "to"),
          static_cast<int>(number_in(body, "points"))};
}

ReachQuestion reach_in(const Json& body) {
  ReachQuestion question{text_in(body, "figure"), number_in(body, "target"), {}};
  const auto paths = body.find("paths");
  if (paths == body.end() || !paths->is_array() || paths->empty())
    throw WrongRequest("\"paths\" is missing or not an array of names of numbers");
  for (const Json& path : *paths) {
    if (!path.is_string()) throw WrongRequest("\"paths\" has something other than names of numbers");
    question.paths.push_back(path);
  }
  return question;
}

RangeQuestion range_in(const Json& body) {
  RangeQuestion question{text_in(body, "path"), {}};
  if (body.contains("figure")) question.figure = text_in(body, "figure");
  if (body.contains("least")) question.least = number_in(body, "least");
  if (body.contains("largest")) question.largest = number_in(body, "largest");
  return question;
}

}  // namespace

Json LiveSolver::answer(const std::string& name, const Json& body, const std::atomic<bool>& interrupt,
                        const OnProgress& on_progress) {
  if (name == "follow") return follow(body, interrupt);
  if (name == "rerun") return outcome_json(scene_.rerun(interrupt), scene_);
  if (name == "jvp") {
    const Tangents& tangents = scene_.tangents(text_in(body, "path"));
    return tangents_json(tangents, *scene_.last());
  }
  if (name == "check") return {{"messages", messages_json(scene_.check())}};
  if (name == "plan") return {{"svg", scene_.plan_drawing()}};
  if (name == "picture") return picture_json(scene_);
  if (name == "report") return report_json(scene_);
  if (name == "export") return export_json(scene_, text_in(body, "as"));
  if (name == "errors") {
    const results::Result result = scene_.with_mesh_errors(interrupt);
    return {{"figures", figures_json(result)}, {"note", result.mesh_note}};
  }
  if (name == "influences") return influences_json(scene_, text_in(body, "figure"), interrupt, on_progress);
  if (name == "sweep") return sweep_json(scene_, sweep_in(body), interrupt, on_progress);
  if (name == "reach") return reach_json(scene_, reach_in(body), interrupt);
  if (name == "range") return range_json(scene_, range_in(body), interrupt);
  throw WrongRequest("there is no request \"" + name + "\"");
}

Json LiveSolver::follow(const Json& body, const std::atomic<bool>& interrupt) {
  std::optional<MovedNumber> moved;
  if (const Json& one = body.at("moved"); !one.is_null())
    moved = MovedNumber{one.at("path").get<std::string>(), one.at("to").get<double>()};
  const auto mesh = flag_in(body, "own_mesh") ? LiveScene::Mesh::own : LiveScene::Mesh::kept;
  Json json =
      outcome_json(scene_.follow(text_in(body, "file"), texts_in(body), moved, interrupt, mesh), scene_);
  json["words"] = new_words();
  return json;
}

Json LiveSolver::new_words() {
  Json fresh = Json::object();
  for (const auto& [path, words] : scene_.words()) {
    Json json = words_json(words);
    Json& known = words_[path];
    if (known == json) continue;
    fresh[path] = json;
    known = std::move(json);
  }
  return fresh;
}

}  // namespace netloft::design
