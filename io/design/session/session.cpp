// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/session/session.hpp"

#include "io/design/session/questions.hpp"
#include "io/design/session/request_values.hpp"
#include "io/formats/files/whole_file.hpp"
#include "io/formats/units/units.hpp"
#include "io/formats/work/long_work.hpp"

#include <algorithm>

namespace netloft::design {

namespace {

constexpr std::size_t kKeptEvents = 64;            // stored; readers that missed more request the state
constexpr std::chrono::seconds kBetweenLooks{1};   // between checks for changes of files by other programs
constexpr std::chrono::seconds kLongestWait{600};  // for an outcome

}  // namespace

Session::Session(const std::filesystem::path& scene, const std::filesystem::path& library, Registry& registry,
                 int threads)
    : texts_(scene, library), scene_(texts_.file(), registry, threads), worker_([this] { work(); }) {}

Session::~Session() {
  end();
  worker_.join();
}

void Session::end() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
    interrupt_ = true;
  }
  news_.notify_all();
  events_.notify_all();
}

bool Session::has_ended() const {
  const std::lock_guard lock(mutex_);
  return ends_;
}

bool Session::is_saved() const {
  const std::lock_guard lock(mutex_);
  return texts_.is_saved();
}

const std::map<std::string, Session::Request>& Session::requests() {
  static const std::map<std::string, Request> all{
      {"state", &Session::state}, {"apply", &Session::apply},   {"undo", &Session::undo},
      {"redo", &Session::redo},   {"save", &Session::save},     {"check", &Session::check},
      {"solve", &Session::solve}, {"jvp", &Session::tangent},   {"picture", &Session::picture},
      {"plan", &Session::plan},   {"report", &Session::report}, {"influences", &Session::influences},
      {"sweep", &Session::sweep}, {"reach", &Session::reach},   {"range", &Session::range}};
  return all;
}

std::vector<std::string> Session::request_names() {
  std::vector<std::string> names;
  for (const auto& [name, request] : requests()) names.push_back(name);
  return names;
}

Json Session::answer(const std::string& name, const Json& body) {
  const auto at = requests().find(name);
  if (at == requests().end()) throw WrongRequest("there is no request \"" + name + "\"");
  if (!body.is_object()) throw WrongRequest("the body is not a JSON object");
  return (this->*at->second)(body);
}

// ---- texts

/// The texts, their numbers, and whether an edit can be undone. The caller must hold the lock.
Json Session::text_state() const {
  formats::Diagnostics said;
  const formats::Document document = texts_.document(said);
  Json files = Json::array();
  for (const auto& [name, text] : texts_.own()) files.push_back({{"name", name}, {"text", text}});
  return {{"revision", revision_},
          {"file", texts_.file().string()},
          {"files", files},
          {"saved", texts_.is_saved()},
          {"can_undo", texts_.can_undo()},
          {"can_redo", texts_.can_redo()},
          {"messages", messages_json(said)},
          {"numbers", numbers_json(document, words_)}};
}

Json Session::state(const Json&) {
  const std::lock_guard lock(mutex_);
  Json json = text_state();
  json["outcome"] = outcome_;
  json["event"] = last_id_;
  return json;
}

/// Changes the text as the body of a request demands. The caller must hold the lock.
Edit Session::edit(const Json& body, std::optional<MovedNumber>& moved) {
  const bool goes_on = flag_in(body, "goes_on");
  if (body.contains("text")) return texts_.replace(text_in(body, "file"), text_in(body, "text"), goes_on);
  if (body.contains("set")) return texts_.set(formats::read_change(text_in(body, "set")), goes_on);
  const std::string path = text_in(body, "path");
  const double to = number_in(body, "to");
  formats::Diagnostics unheard;
  for (const studies::SceneNumber& number : studies::numbers_of(texts_.document(unheard).root())) {
    if (number.path != path) continue;
    moved = MovedNumber{path, to};
    return texts_.set(number.to(to).front(), goes_on);
  }
  return texts_.set(formats::read_change(path + "=" + formats::format(to)), goes_on);
}

Json Session::apply(const Json& body) {
  std::uint64_t revision = 0;
  Json json;
  {
    const std::lock_guard lock(mutex_);
    std::optional<MovedNumber> moved;
    const Edit made = edit(body, moved);
    note_change(moved);
    json = text_state();
    json["edit"] = edit_json(made, texts_.own());
    revision = revision_;
  }
  if (flag_in(body, "wait")) json["outcome"] = wait_for(revision);
  return json;
}

Json Session::undo(const Json&) {
  const std::lock_guard lock(mutex_);
  if (texts_.undo()) note_change(std::nullopt);
  return text_state();
}

Json Session::redo(const Json&) {
  const std::lock_guard lock(mutex_);
  if (texts_.redo()) note_change(std::nullopt);
  return text_state();
}

Json Session::save(const Json& body) {
  const std::lock_guard lock(mutex_);
  Json json = {{"written", Json::array()}};
  if (body.contains("as")) {
    texts_.save_as(text_in(body, "as"));
    json["written"].push_back(texts_.file().string());
    note_change(std::nullopt);  // the scene has a new name
  } else {
    json["written"] = texts_.save();
  }
  json.update(text_state());
  return json;
}

/// If the request has a text: the errors in its syntax, which are found fast enough for every key press.
/// Otherwise: all messages about the plan of the session, which the worker computes.
Json Session::check(const Json& body) {
  if (!body.contains("text"))
    return on_worker([this] { return Json{{"messages", messages_json(scene_.check())}}; });
  formats::StoredTexts texts;
  std::filesystem::path file;
  {
    const std::lock_guard lock(mutex_);
    texts = texts_.own();
    file = texts_.file();
  }
  const auto at = texts.find(text_in(body, "file"));
  if (at == texts.end()) throw Refused("\"" + text_in(body, "file") + "\" is not among the files");
  at->second = text_in(body, "text");
  formats::Diagnostics said;
  formats::Document::load_edited(file, texts, said);
  return {{"messages", messages_json(said)}};
}

/// Announces that the text has changed, and cancels the search for an older text. The caller must hold the
/// lock.
void Session::note_change(std::optional<MovedNumber> moved) {
  ++revision_;
  steps_.push_back({revision_, std::move(moved)});
  interrupt_ = true;
  news_.notify_all();
}

/// The number that has changed since the last equilibrium, if it is the only change. The caller must hold the
/// lock.
std::optional<MovedNumber> Session::only_move() const {
  for (const Step& step : steps_)
    if (!step.moved || step.moved->path != steps_.back().moved.value_or(MovedNumber{}).path)
      return std::nullopt;
  return steps_.empty() ? std::nullopt : steps_.back().moved;
}

// ---- the equilibrium

Json Session::solve(const Json&) {
  std::uint64_t revision = 0;
  {
    const std::lock_guard lock(mutex_);
    revision = revision_;
  }
  return wait_for(revision);
}

/// Waits for the outcome of this text or of a newer one.
Json Session::wait_for(std::uint64_t revision) {
  std::unique_lock lock(mutex_);
  events_.wait_for(lock, kLongestWait, [&] { return followed_ >= revision || ends_; });
  if (followed_ < revision) throw formats::Interrupted{};
  return outcome_;
}

Json Session::tangent(const Json& body) {
  const std::string path = text_in(body, "path");
  return on_worker([this, path] { return tangents_json(scene_.tangents(path), *scene_.last()); });
}

Json Session::picture(const Json&) {
  return on_worker([this] { return picture_json(scene_); });
}

Json Session::plan(const Json&) {
  return on_worker([this] { return Json{{"svg", scene_.plan_drawing()}}; });
}

Json Session::report(const Json&) {
  return on_worker([this] { return report_json(scene_); });
}

Json Session::influences(const Json& body) {
  const std::string figure = text_in(body, "figure");
  return on_worker([this, figure] {
    return influences_json(scene_, figure, interrupt_, [this](std::size_t done, std::size_t all) {
      announce("progress", {{"done", done}, {"of", all}});
    });
  });
}

Json Session::sweep(const Json& body) {
  const SweepQuestion question{text_in(body, "path"), number_in(body, "from"), number_in(body, "to"),
                               static_cast<int>(number_in(body, "points"))};
  return on_worker([this, question] {
    return sweep_json(scene_, question, interrupt_, [this](std::size_t done, std::size_t all) {
      announce("progress", {{"done", done}, {"of", all}});
    });
  });
}

Json Session::reach(const Json& body) {
  const ReachQuestion question{text_in(body, "figure"), number_in(body, "target"), text_in(body, "path")};
  return on_worker([this, question] { return reach_json(scene_, question, interrupt_); });
}

Json Session::range(const Json& body) {
  RangeQuestion question{text_in(body, "path"), {}};
  if (body.contains("figure")) question.figure = text_in(body, "figure");
  if (body.contains("least")) question.least = number_in(body, "least");
  if (body.contains("largest")) question.largest = number_in(body, "largest");
  return on_worker([this, question] { return range_json(scene_, question, interrupt_); });
}

// ---- the worker

Json Session::on_worker(const std::function<Json()>& work) {
  std::future<Json> answer;
  {
    const std::lock_guard lock(mutex_);
    if (ends_) throw formats::Interrupted{};
    answer = jobs_.emplace_back(work).get_future();
  }
  news_.notify_all();
  try {
    return answer.get();
  } catch (const std::future_error&) {  // the session ended first
    throw formats::Interrupted{};
  }
}

void Session::work() {
  std::unique_lock lock(mutex_);
  while (!ends_) {
    if (followed_ < revision_)
      follow_text(lock);
    else if (!take_job(lock) && !news_.wait_for(lock, kBetweenLooks, [&] {
               return ends_ || followed_ < revision_ || !jobs_.empty();
             }))
      look_at_files();
  }
  jobs_.clear();  // requests that still wait get an exception
}

bool Session::take_job(std::unique_lock<std::mutex>& lock) {
  if (jobs_.empty()) return false;
  auto job = std::move(jobs_.front());
  jobs_.pop_front();
  interrupt_ = false;
  lock.unlock();
  job();
  lock.lock();
  return true;
}

/// Finds the equilibrium of the newest text: first on the present mesh, so that the shape appears soon, then
/// on the mesh of the text, so that the equilibrium is the same as that of a run.
void Session::follow_text(std::unique_lock<std::mutex>& lock) {
  const Snapshot text{revision_, texts_.file(), texts_.own(), only_move()};
  interrupt_ = false;
  lock.unlock();
  announce("solving", {{"revision", text.revision}});
  Outcome outcome;
  Json json = follow_on(LiveScene::Mesh::kept, text, outcome);
  if (!outcome.has_own_mesh) {
    if (outcome.status == Outcome::Status::converged) announce("solved", json);
    forget_steps(text, outcome);
    const Json ghost_off = json["ghost_off"], jump = json["jump"];
    json = follow_on(LiveScene::Mesh::own, text, outcome);
    json["ghost_off"] = ghost_off, json["jump"] = jump;  // a prediction on another mesh cannot be compared
  }
  forget_steps(text, outcome);
  lock.lock();
  words_ = scene_.words();
  if (outcome.status == Outcome::Status::interrupted && text.revision != revision_) return;
  followed_ = text.revision;
  outcome_ = json;
  lock.unlock();
  announce("solved", json);
  lock.lock();
}

/// Forgets the changes of the text that this equilibrium includes.
void Session::forget_steps(const Snapshot& text, const Outcome& outcome) {
  if (outcome.status != Outcome::Status::converged) return;
  const std::lock_guard lock(mutex_);
  std::erase_if(steps_, [&](const Step& step) { return step.revision <= text.revision; });
}

/// An exception here is a bug or a failure of the machine: it is reported, and the session continues.
Json Session::follow_on(LiveScene::Mesh mesh, const Snapshot& text, Outcome& outcome) {
  try {
    outcome = scene_.follow(text.file, text.texts, text.moved, interrupt_, mesh);
  } catch (const std::exception& e) {
    outcome = {};
    outcome.status = Outcome::Status::not_converged;
    outcome.sentence = e.what();
  }
  Json json = outcome_json(outcome, scene_);
  json["revision"] = text.revision;
  return json;
}

/// Reads files again that other programs have changed. The caller must hold the lock.
void Session::look_at_files() {
  try {
    if (texts_.reread().empty()) return;
  } catch (const formats::ReadError&) {
    return;  // the file is just being written; the next check will read it
  }
  note_change(std::nullopt);
  log_.push_back({++last_id_, "changed", text_state().dump(-1, ' ', false, Json::error_handler_t::replace)});
  events_.notify_all();
}

void Session::announce(const std::string& name, const Json& data) {
  {
    const std::lock_guard lock(mutex_);
    log_.push_back({++last_id_, name, data.dump(-1, ' ', false, Json::error_handler_t::replace)});
    while (log_.size() > kKeptEvents) log_.pop_front();
  }
  events_.notify_all();
}

std::vector<Event> Session::events_after(std::uint64_t id, std::chrono::milliseconds most) {
  std::unique_lock lock(mutex_);
  events_.wait_for(lock, most, [&] { return last_id_ > id || ends_; });
  std::vector<Event> all;
  for (const Event& event : log_)
    if (event.id > id) all.push_back(event);
  return all;
}

}  // namespace netloft::design
