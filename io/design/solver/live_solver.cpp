// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/solver/live_solver.hpp"

#include "io/design/solver/questions.hpp"
#include "io/design/solver/replies.hpp"
#include "io/design/solver/request_values.hpp"
#include "io/formats/work/long_work.hpp"

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
  if (name == "consider")
    return {{"messages", messages_json(scene_.check(text_in(body, "file"), texts_in(body)))}};
  if (name == "points") return points_json(scene_);
  if (name == "plan") return plan_json(scene_);
  if (name == "picture") return picture_json(scene_);
  if (name == "beside") return body.contains("file") ? beside(body, interrupt) : beside_json(scene_.shape());
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

/// The equilibrium of another scene, as a run finds it, or the shape in a result file.
Json LiveSolver::beside(const Json& body, const std::atomic<bool>& interrupt) {
  const std::string name = text_in(body, "file");
  if (std::filesystem::path(name).extension() == ".hdf") try {
      return beside_json(results::StoredShape(name));
    } catch (const formats::FileError& e) {
      throw Refused(e.what());
    }
  LiveScene other(name, registry_, threads_);
  other.on_budget = scene_.on_budget;
  const Outcome outcome = other.follow(name, texts_in(body), std::nullopt, interrupt);
  if (outcome.status == Outcome::Status::interrupted) throw formats::Interrupted{};
  if (outcome.status == Outcome::Status::converged) return beside_json(other.shape());
  const std::string error = first_error_of(outcome.diagnostics);
  throw Refused(name + " has no equilibrium to be shown: " + (error.empty() ? outcome.sentence : error));
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
