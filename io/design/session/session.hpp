// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/design/session/replies.hpp"

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
  std::string name;  // "solving", "solved", "changed", "progress"
  std::string data;  // JSON
};

/// An unknown or incomplete request; what() is a sentence.
struct WrongRequest : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// A design while somebody works on it: its texts, and a thread that finds the equilibrium of the newest
/// text. If the text changes during a search, the search is cancelled. Any thread may call the functions.
/// DESIGN.md documents the requests.
class Session {
 public:
  /// `library`: as for SceneTexts. Throws formats::ReadError if the file cannot be read.
  Session(const std::filesystem::path& scene, const std::filesystem::path& library, Registry& registry,
          int threads);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Answers a request by its name. Throws WrongRequest, Refused, formats::Interrupted (if a newer change
  /// ended the work), and exceptions about files that cannot be written.
  Json answer(const std::string& name, const Json& body);
  static std::vector<std::string> request_names();

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
  // requests about the equilibrium, which the worker answers
  Json solve(const Json& body);
  Json tangent(const Json& body);
  Json picture(const Json& body);
  Json plan(const Json& body);
  Json report(const Json& body);
  Json influences(const Json& body);
  Json sweep(const Json& body);
  Json reach(const Json& body);
  Json range(const Json& body);

  /// A change of the text since the last equilibrium: of one number (`moved`), or any other change.
  struct Step {
    std::uint64_t revision;
    std::optional<MovedNumber> moved;
  };
  /// A text whose equilibrium is being sought.
  struct Snapshot {
    std::uint64_t revision;
    std::filesystem::path file;
    formats::StoredTexts texts;
    std::optional<MovedNumber> moved;
  };
  Json text_state() const;
  Edit edit(const Json& body, std::optional<MovedNumber>& moved);
  void note_change(std::optional<MovedNumber> moved);
  std::optional<MovedNumber> only_move() const;
  Json on_worker(const std::function<Json()>& work);
  Json wait_for(std::uint64_t revision);
  void work();
  bool take_job(std::unique_lock<std::mutex>& lock);
  void follow_text(std::unique_lock<std::mutex>& lock);
  void forget_steps(const Snapshot& text, const Outcome& outcome);
  Json follow_on(LiveScene::Mesh mesh, const Snapshot& text, Outcome& outcome);
  void look_at_files();
  void announce(const std::string& name, const Json& data);

  mutable std::mutex mutex_;
  std::condition_variable news_;    // for the worker
  std::condition_variable events_;  // signals new events and outcomes
  SceneTexts texts_;
  std::uint64_t revision_ = 1, followed_ = 0;
  std::vector<Step> steps_;  // since the last equilibrium
  Json outcome_;             // of the revision followed_
  std::map<std::string, formats::NumberWords> words_;
  std::deque<std::packaged_task<Json()>> jobs_;
  std::deque<Event> log_;
  std::uint64_t last_id_ = 0;
  bool ends_ = false;
  std::atomic<bool> interrupt_{false};
  LiveScene scene_;  // of the worker alone
  std::thread worker_;
};

}  // namespace netloft::design
