// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/design/parts/gear_parts.hpp"
#include "io/design/solver/replies.hpp"
#include "io/design/solver/solver_call.hpp"
#include "io/design/texts/scene_texts.hpp"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <future>
#include <mutex>
#include <thread>

namespace netloft::design {

/// An event, such as a new equilibrium, for a page that shows the design.
struct Event {
  std::uint64_t id = 0;
  std::string name;  // "solving", "solved", "confirmed", "ended", "changed", "progress"
  std::string data;  // JSON
};

/// A design while somebody works on it: its texts, and a thread that has a solver find the equilibrium of the
/// newest text. If the text changes during a search, the search is cancelled. When nothing has changed for a
/// moment, the solver runs the text from its sketch, and the equilibrium of this run takes the place of that
/// which was found from its neighbour. Any thread may call the functions. DESIGN.md documents the requests.
class Session {
 public:
  /// `library`: as for SceneTexts. `beside`: a file that the page shows beside the design; empty: none.
  /// Throws formats::ReadError if the scene cannot be read.
  Session(const std::filesystem::path& scene, const std::filesystem::path& library, SolverCall solver,
          std::string beside = {});
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Answers a request by its name. Throws WrongRequest, Refused, formats::Interrupted (if a newer change
  /// ended the work), and exceptions about files that cannot be written.
  Json answer(const std::string& name, const Json& body);

  /// Ends all work. Threads that wait for an answer get formats::Interrupted.
  void end();
  bool has_ended() const;
  bool is_saved() const;

  /// Waits for events after the event `id` and returns them; returns no events if the time is over.
  std::vector<Event> events_after(std::uint64_t id, std::chrono::milliseconds most);

 private:
  using Request = Json (Session::*)(const Json&);
  static const std::map<std::string, Request>& requests();

  // requests about texts
  Json state(const Json& body);
  Json apply(const Json& body);
  Json undo(const Json& body);
  Json redo(const Json& body);
  Json save(const Json& body);
  Json check(const Json& body);
  Json catalogue(const Json& body);
  Json parts(const Json& body);
  Json add(const Json& body);
  Json remove(const Json& body);
  // requests about the equilibrium, which the worker answers
  Json solve(const Json& body);
  Json run(const Json& body);
  Json stop(const Json& body);
  Json report(const Json& body);
  Json beside(const Json& body);
  Json from_solver(const std::string& name, const Json& body);

  /// A change of the text since the last equilibrium: of one number (`moved`), or any other change.
  struct Step {
    std::uint64_t revision;
    std::optional<MovedNumber> moved;
  };
  /// Documents that a request may lead to, and the sentence that begins a refusal.
  struct Proposal {
    std::vector<formats::Value> documents;
    std::string refusal;
  };
  struct PartsChange;
  SceneTexts copy_of_texts() const;
  Json take_parts(const SceneTexts& before, PartsChange change);
  PartedGear parted_gear(const SceneTexts& texts) const;
  Json change_parts(const Json& body, const std::function<Proposal(const PartedGear&)>& propose);
  Json messages_of(const SceneTexts& texts);
  Json text_state() const;
  Json text_to_follow() const;
  Edit edit(const Json& body, std::optional<MovedNumber>& moved);
  void note_change(std::optional<MovedNumber> moved);
  std::optional<MovedNumber> only_move() const;
  Json on_worker(const std::function<Json()>& work);
  Json wait_for(std::uint64_t revision);
  Json call(const std::string& name, const Json& body);
  void work();
  bool take_job(std::unique_lock<std::mutex>& lock);
  void follow_text(std::unique_lock<std::mutex>& lock);
  void forget_steps(std::uint64_t revision, const Json& outcome);
  Json outcome_of(const std::string& name, const Json& body, std::uint64_t revision);
  void confirm(std::unique_lock<std::mutex>& lock);
  void learn(Json& outcome);
  Json with_start(Json figures);
  void look_at_files();
  void announce(const std::string& name, const Json& data);

  mutable std::mutex mutex_;
  std::condition_variable news_;    // for the worker
  std::condition_variable events_;  // signals new events and outcomes
  SceneTexts texts_;
  const SceneTexts first_;    // as the design was opened
  const std::string beside_;  // name of the file that the page shows beside the design
  std::uint64_t revision_ = 1, followed_ = 0, confirmed_ = 0;
  std::vector<Step> steps_;  // since the last equilibrium
  Json outcome_;             // of the revision followed_
  int waiting_for_run_ = 0;  // number of requests that wait until the outcome is that of a run
  bool confirms_ = false;    // whether the solver runs the text from its sketch now
  std::map<std::string, formats::NumberWords> words_;
  std::deque<std::packaged_task<Json()>> jobs_;
  std::deque<Event> log_;
  std::uint64_t last_id_ = 0;
  bool ends_ = false;
  std::atomic<bool> interrupt_{false};
  // of the worker alone
  SolverCall solver_;
  Json start_ = Json::object();  // figures of the first equilibrium, with which later ones are compared
  std::thread worker_;
};

}  // namespace netloft::design
