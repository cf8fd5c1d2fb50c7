// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/session/session.hpp"

#include "io/design/live/live_scene.hpp"
#include "io/design/solver/request_values.hpp"
#include "io/formats/files/whole_file.hpp"
#include "io/formats/units/units.hpp"
#include "io/formats/work/long_work.hpp"
#include "io/gears/catalogue/catalogue.hpp"
#include "io/gears/catalogue/folders.hpp"
#include "io/gears/plan/read_plan.hpp"

#include <algorithm>
#include <array>

namespace netloft::design {

namespace {

constexpr std::size_t kKeptEvents = 64;            // stored; readers that missed more request the state
constexpr std::chrono::seconds kBetweenLooks{1};   // between checks for changes of files by other programs
constexpr std::chrono::seconds kLongestWait{600};  // for an outcome
// Time without a request before the text is run from its sketch. A page that has an equilibrium first asks
// for the picture, the checks and the report.
constexpr std::chrono::milliseconds kQuiet{800};

bool has_converged(const Json& outcome) { return outcome["status"] == name_of(Outcome::Status::converged); }

bool was_interrupted(const Json& outcome) {
  return outcome["status"] == name_of(Outcome::Status::interrupted);
}

std::vector<std::filesystem::path> folders_of(const SceneTexts& texts, const formats::Value& root,
                                              formats::Diagnostics& said) {
  const std::filesystem::path folder = texts.file().parent_path();
  return gears::catalogue_folders(said, gears::named_folders(root, folder.empty() ? "." : folder, said));
}

Json template_json(const PartTemplate& kind, const PartedGear& gear) {
  Json fields = Json::array();
  for (const PartField& field : kind.fields)
    fields.push_back({{"name", field.name},
                      {"of", field.of},
                      {"words", field.words},
                      {"usual", field.usual},
                      {"choices", choices_of(field, gear)}});
  return {{"kind", kind.kind}, {"doc", kind.doc}, {"fields", fields}};
}

/// A choice as it stands in the text: 5, 2.5, or a name.
std::string choice_in(const Json& value, const char* name) {
  if (value.is_string()) return value;
  if (!value.is_number()) throw WrongRequest("\"" + std::string(name) + "\" is neither a number nor a text");
  return formats::format(value.get<double>());
}

/// The messages that are not among those that were known.
Json new_messages(const Json& messages, const Json& known) {
  Json fresh = Json::array();
  for (const Json& one : messages)
    if (std::ranges::none_of(known, [&](const Json& other) { return other["message"] == one["message"]; }))
      fresh.push_back(one);
  return fresh;
}

std::string sentences_of(const Json& messages) {
  std::string text;
  for (const Json& one : messages)
    if (one["severity"] == "error") text += (text.empty() ? "" : "; ") + one["message"].get<std::string>();
  return text;
}

}  // namespace

/// Texts that a request may lead to.
struct Session::PartsChange {
  SceneTexts texts;
  std::vector<Edit> edits;
  Json messages;  // of the check, as far as they are new

  /// 0: nothing new; 1: new warnings; 2: new errors.
  int rank() const { return sentences_of(messages).empty() ? !messages.empty() : 2; }
};

Session::Session(const std::filesystem::path& scene, const std::filesystem::path& library, SolverCall solver,
                 std::string beside)
    : texts_(scene, library),
      first_(texts_),
      beside_(std::move(beside)),
      solver_(std::move(solver)),
      worker_([this] { work(); }) {}

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
      {"state", &Session::state},         {"apply", &Session::apply},
      {"undo", &Session::undo},           {"redo", &Session::redo},
      {"save", &Session::save},           {"check", &Session::check},
      {"solve", &Session::solve},         {"run", &Session::run},
      {"stop", &Session::stop},           {"report", &Session::report},
      {"catalogue", &Session::catalogue}, {"beside", &Session::beside},
      {"parts", &Session::parts},         {"add", &Session::add},
      {"remove", &Session::remove}};
  return all;
}

Json Session::answer(const std::string& name, const Json& body) {
  if (!body.is_object()) throw WrongRequest("the body is not a JSON object");
  constexpr std::array kOfSolver = {"jvp",        "picture", "plan",  "export", "errors",
                                    "influences", "sweep",   "reach", "range"};
  if (std::ranges::find(kOfSolver, name) != kOfSolver.end()) return from_solver(name, body);
  const auto at = requests().find(name);
  if (at == requests().end()) throw WrongRequest("there is no request \"" + name + "\"");
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
  json["beside"] = beside_.empty() ? Json(nullptr) : Json(beside_);
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
/// Otherwise: all messages about the plan of the session, which the solver computes.
Json Session::check(const Json& body) {
  if (!body.contains("text")) return from_solver("check", Json::object());
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

/// The parts of a kind in the catalogues that the scene can name.
Json Session::catalogue(const Json& body) {
  const std::string kind = text_in(body, "kind");
  formats::Diagnostics unheard;
  const auto folders = [&] {
    const std::lock_guard lock(mutex_);
    return folders_of(texts_, texts_.document(unheard).root(), unheard);
  }();
  Json names = Json::array();
  for (const gears::CataloguePart& part : gears::Catalogue::load(folders, unheard).parts())
    if (part.kind->name == kind) names.push_back(part.name);
  return {{"names", names}};
}

// ---- parts

PartedGear Session::parted_gear(const SceneTexts& texts) const {
  formats::Diagnostics said, unheard;
  PartedGear gear{texts.document(said).root(), {}, {}, {}};
  if (said.errors()) throw Refused("the text has an error; correct it first: " + first_error_of(said));
  gear.catalogue = gears::Catalogue::load(folders_of(texts, gear.root, unheard), unheard);
  if (gears::holds_plan(gear.root))
    gear.plan = gears::read_plan(gears::tables_of_plan(gear.root), gear.catalogue, unheard);
  return gear;
}

/// The kinds of parts that can be added, with what can be chosen, the parts that can be removed, and the
/// points of the gear.
Json Session::parts(const Json&) {
  return on_worker([this] {
    const PartedGear gear = parted_gear(copy_of_texts());
    Json json = call("points", Json::object());
    json["parts"] = parts_of(gear.root);
    json["templates"] = Json::array();
    for (const PartTemplate& kind : part_templates()) json["templates"].push_back(template_json(kind, gear));
    return json;
  });
}

Json Session::add(const Json& body) {
  const std::string name = text_in(body, "kind");
  const auto kind = std::ranges::find(part_templates(), name, &PartTemplate::kind);
  if (kind == part_templates().end()) throw WrongRequest("there is no template \"" + name + "\"");
  PartChoices choices;
  for (const PartField& field : kind->fields)
    if (body.contains(field.name)) choices[field.name] = choice_in(body[field.name], field.name);
  return change_parts(body, [&](const PartedGear& gear) {
    return Proposal{with_part(gear, *kind, choices), "this part cannot be added"};
  });
}

Json Session::remove(const Json& body) {
  const std::string part = text_in(body, "part");
  return change_parts(body, [&](const PartedGear& gear) {
    return Proposal{{without_part(gear.root, part)}, part + " cannot be removed"};
  });
}

/// Changes the text to the first proposed document about which the check has nothing new to say, or else to
/// the first without a new error.
Json Session::change_parts(const Json& body, const std::function<Proposal(const PartedGear&)>& propose) {
  Json answer = on_worker([&] {
    const SceneTexts before = copy_of_texts();
    PartedGear gear = parted_gear(before);
    const Json points = call("points", Json::object());
    for (const Json& point : points["points"]) gear.points[point["name"]] = point["at"];
    const Proposal proposal = propose(gear);
    const Json known = messages_of(before);
    std::optional<PartsChange> best;
    for (const formats::Value& document : proposal.documents) {
      PartsChange change{before, {}, {}};
      change.edits = change.texts.become(document);
      change.messages = new_messages(messages_of(change.texts), known);
      if (!best || change.rank() < best->rank()) best = std::move(change);
      if (best->messages.empty()) break;
    }
    if (best->rank() > 1) throw Refused(proposal.refusal + ": " + sentences_of(best->messages));
    return take_parts(before, std::move(*best));
  });
  if (flag_in(body, "wait")) answer["outcome"] = wait_for(answer["revision"]);
  return answer;
}

SceneTexts Session::copy_of_texts() const {
  const std::lock_guard lock(mutex_);
  return texts_;
}

Json Session::messages_of(const SceneTexts& texts) {
  return call("consider", {{"file", texts.file().string()}, {"texts", texts.own()}})["messages"];
}

/// Takes over changed texts, unless somebody has changed them meanwhile.
Json Session::take_parts(const SceneTexts& before, PartsChange change) {
  const std::lock_guard lock(mutex_);
  if (texts_.own() != before.own() || texts_.file() != before.file()) throw formats::Interrupted{};
  texts_ = std::move(change.texts);
  note_change(std::nullopt);
  Json json = text_state();
  json["edits"] = Json::array();
  for (const Edit& edit : change.edits) json["edits"].push_back(edit_json(edit, before.own()));
  json["new_messages"] = std::move(change.messages);
  return json;
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

/// Waits until the outcome of the present text is that of a run.
Json Session::run(const Json&) {
  std::unique_lock lock(mutex_);
  const std::uint64_t revision = revision_;
  ++waiting_for_run_;
  news_.notify_all();
  events_.wait_for(lock, kLongestWait, [&] { return confirmed_ >= revision || ends_; });
  --waiting_for_run_;
  if (confirmed_ < revision) throw formats::Interrupted{};
  return outcome_;
}

/// Ends the search, the run or the question that is under way.
Json Session::stop(const Json&) {
  const std::lock_guard lock(mutex_);
  interrupt_ = true;
  return Json::object();
}

Json Session::report(const Json&) {
  return on_worker([this] {
    Json json = call("report", Json::object());
    json["figures"] = with_start(std::move(json["figures"]));
    return json;
  });
}

/// A gear to compare with: this one as it was opened or as it is now, or another file.
Json Session::beside(const Json& body) {
  if (body.contains("file"))
    return from_solver("beside", {{"file", text_in(body, "file")}, {"texts", Json::object()}});
  const std::string of = text_in(body, "of");
  if (of == "now") return from_solver("beside", Json::object());
  if (of != "start") throw WrongRequest("\"of\" is neither \"start\" nor \"now\"");
  return from_solver("beside", {{"file", first_.file().string()}, {"texts", first_.own()}});
}

Json Session::from_solver(const std::string& name, const Json& body) {
  return on_worker([this, name, body] { return call(name, body); });
}

// ---- the worker

Json Session::on_worker(const std::function<Json()>& work) {
  std::future<Json> answer;
  {
    const std::lock_guard lock(mutex_);
    if (ends_) throw formats::Interrupted{};
    if (confirms_) interrupt_ = true;  // a person waits for this answer, but not for the run
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
    const bool is_unconfirmed = confirmed_ < followed_;
    if (followed_ < revision_)
      follow_text(lock);
    else if (take_job(lock))
      continue;
    else if (is_unconfirmed && waiting_for_run_ > 0)
      confirm(lock);
    else if (!news_.wait_for(lock, is_unconfirmed ? kQuiet : kBetweenLooks, [&] {
               return ends_ || followed_ < revision_ || !jobs_.empty() ||
                      (waiting_for_run_ > 0 && confirmed_ < followed_);
             }))
      is_unconfirmed ? confirm(lock) : look_at_files();
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

/// The body of a request to the solver that follows the text. The caller must hold the lock.
Json Session::text_to_follow() const {
  Json body = {
      {"file", texts_.file().string()}, {"texts", texts_.own()}, {"moved", nullptr}, {"own_mesh", false}};
  if (const auto moved = only_move()) body["moved"] = {{"path", moved->path}, {"to", moved->to}};
  return body;
}

/// Finds the equilibrium of the newest text: first on the present mesh, so that the shape appears soon, then
/// on the mesh of the text.
void Session::follow_text(std::unique_lock<std::mutex>& lock) {
  const std::uint64_t revision = revision_;
  Json body = text_to_follow();
  interrupt_ = false;
  lock.unlock();
  announce("solving", {{"revision", revision}});
  Json json = outcome_of("follow", body, revision);
  if (json["own_mesh"] == false && !was_interrupted(json)) {
    if (has_converged(json)) announce("solved", json);
    forget_steps(revision, json);
    const Json ghost_off = json["ghost_off"], jump = json["jump"];
    body["own_mesh"] = true;
    json = outcome_of("follow", body, revision);
    json["ghost_off"] = ghost_off, json["jump"] = jump;  // a prediction on another mesh cannot be compared
  }
  forget_steps(revision, json);
  lock.lock();
  if (was_interrupted(json) && revision != revision_) return;
  followed_ = revision;
  outcome_ = json;
  if (!has_converged(json) || json["as_run"] == true) confirmed_ = revision;
  lock.unlock();
  announce("solved", json);
  lock.lock();
}

/// Runs the text from its sketch. The equilibrium found takes the place of the last one, so that what is
/// shown is what a run of the saved text finds.
void Session::confirm(std::unique_lock<std::mutex>& lock) {
  const std::uint64_t revision = followed_;
  interrupt_ = false;
  confirms_ = true;
  lock.unlock();
  const Json json = outcome_of("rerun", Json::object(), revision);
  lock.lock();
  confirms_ = false;
  if (was_interrupted(json)) return;
  confirmed_ = revision;
  if (has_converged(json))
    outcome_ = json;
  else
    outcome_["run_failed"] = json["sentence"];
  lock.unlock();
  announce("confirmed", json);
  lock.lock();
}

/// Forgets the changes of the text that this equilibrium includes.
void Session::forget_steps(std::uint64_t revision, const Json& outcome) {
  if (!has_converged(outcome)) return;
  const std::lock_guard lock(mutex_);
  std::erase_if(steps_, [&](const Step& step) { return step.revision <= revision; });
}

Json Session::call(const std::string& name, const Json& body) {
  const auto on_progress = [this](std::size_t done, std::size_t all) {
    announce("progress", {{"done", done}, {"of", all}});
  };
  try {
    return solver_(name, body, interrupt_, on_progress);
  } catch (const SolverEnded& e) {
    announce("ended", {{"sentence", e.what()}});
    throw;
  }
}

/// An exception here is a crash, a bug or a failure of the machine: it is reported, and the session
/// continues.
Json Session::outcome_of(const std::string& name, const Json& body, std::uint64_t revision) {
  Outcome failed;
  Json json;
  try {
    json = call(name, body);
    learn(json);
  } catch (const std::exception& e) {
    failed.status =
        dynamic_cast<const SolverEnded*>(&e) ? Outcome::Status::ended : Outcome::Status::not_converged;
    failed.sentence = e.what();
    json = verdict_json(failed);
  }
  json["revision"] = revision;
  return json;
}

/// Takes the words of numbers out of an outcome, and adds the figures of the first equilibrium to its
/// figures.
void Session::learn(Json& outcome) {
  if (outcome.contains("figures")) outcome["figures"] = with_start(std::move(outcome["figures"]));
  const Json words = outcome.value("words", Json::object());
  outcome.erase("words");
  const std::lock_guard lock(mutex_);
  for (const auto& [path, of] : words.items()) words_[path] = words_in(of);
}

Json Session::with_start(Json figures) {
  const bool is_first = start_.empty();
  for (Json& figure : figures) {
    const std::string name = figure["name"];
    if (is_first) start_[name] = figure["value"];
    figure["start"] = start_.value(name, Json());
  }
  return figures;
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
