// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/files/whole_file.hpp"
#include "io/program/commands/study_shared.hpp"
#include "io/program/session/memory_room.hpp"
#include "io/program/session/print.hpp"
#include "io/program/session/session.hpp"
#include "io/program/session/watchdog.hpp"
#include "io/program/session/worker_pool.hpp"
#include "io/studies/sweep/path_run.hpp"
#include "io/studies/sweep/study_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace netloft::program {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::size_t read_id(std::string_view word, const std::string& all, std::size_t most) {
  std::size_t id = 0;
  const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), id);
  if (word.empty() || code != std::errc() || end != word.data() + word.size())
    throw UsageError{"--items " + all + ": \"" + std::string(word) +
                     "\" is no number; write 1-10 or 1-10,15"};
  if (id < 1 || id > most)
    throw UsageError{fmt::format("--items {}: there is no item {}; the study has 1 to {}", all, id, most)};
  return id;
}

/// Reads "1-10,15" as indices of items; all items if the text is empty.
std::vector<std::size_t> read_items(const std::string& text, std::size_t count) {
  std::vector<std::size_t> places;
  if (text.empty())
    for (std::size_t i = 0; i < count; ++i) places.push_back(i);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    const std::string_view range(text.data() + at, comma - at);
    const std::size_t dash = range.find('-');
    const std::size_t from = read_id(range.substr(0, dash), text, count);
    const std::size_t to =
        dash == std::string_view::npos ? from : read_id(range.substr(dash + 1), text, count);
    if (to < from)
      throw UsageError{fmt::format("--items {}: the range begins at {}, beyond its end, {}", text, from, to)};
    for (std::size_t id = from; id <= to; ++id) places.push_back(id - 1);
    at = comma + 1;
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

void note_failure(const fs::path& folder, const studies::StudyItem& item, const std::string& reason) {
  try {
    formats::write_whole(studies::failure_path(folder, item), reason + "\n");
  } catch (const formats::WriteError&) {
    // Ignored: the disk may be full. The item then stays missing, without a recorded reason.
  }
}

/// Records that an item failed because a call of a plugin never returned.
int end_item(const fs::path& folder, const studies::StudyItem& item, const Overdue& overdue) {
  if (!overdue.interrupted) note_failure(folder, item, overdue.sentence);
  print_error(fmt::format("netloft: {}; item {} has no record", overdue.sentence, item.id));
  return overdue.interrupted ? kInterrupted : kNotConverged;
}

/// Solves one item in this process.
int compute(const StudyRunOptions& o, Terminal& terminal, const studies::Study& study,
            const studies::StudyItem& item) {
  Registry registry;
  find_plugins(o, registry);
  const fs::path folder = o.folder;
  Watchdog watchdog(terminal, [&](const Overdue& overdue) { return end_item(folder, item, overdue); });
  const runs::Watch watch{.interrupt = &interrupt_flag(),
                          .on_budget = [&](double seconds) { watchdog.allow(seconds); }};
  const studies::PathContext context{folder, &registry, watch, std::max(o.threads, 1)};
  const auto record = studies::run_path(study, item, context);
  if (!record) return kInterrupted;
  formats::write_whole(studies::record_path(folder, item), studies::record_text(*record));
  std::error_code none;
  fs::remove(studies::failure_path(folder, item), none);
  return kDone;
}

/// Computes items and counts the outcomes.
class Campaign {
 public:
  Campaign(const StudyRunOptions& o, const studies::Study& study, std::vector<std::size_t> places)
      : o_(o), study_(study), asked_(places.size()), terminal_(o) {
    std::string fault;
    for (const std::size_t place : places)
      if (!studies::find_record(o.folder, study.items[place], fault)) left_.push_back(place);
  }

  int run() {
    const int jobs = threads_for(o_.jobs);
    if (asked_ == 1 && left_.size() == 1)
      return alone();
    else
      run_workers(
          left_.size(), jobs, [&](std::size_t job) { return command(left_[job]); },
          [&](std::size_t job, const WorkerEnd& end) { note(left_[job], end); }, interrupt_flag());
    return finish();
  }

 private:
  /// Computes a single item in this process, for engines that start a process for every item.
  int alone() {
    const studies::StudyItem& item = study_.items[left_.front()];
    try {
      const int code = compute(o_, terminal_, study_, item);
      done_ = code == kDone;
      return code == kNotConverged ? code : finish();
    } catch (const studies::StudyError& e) {
      note_failure(o_.folder, item, e.what());
      throw;
    }
  }

  std::vector<std::string> command(std::size_t place) const {
    std::vector<std::string> words = {"/proc/self/exe",          "study",   "run",  o_.folder, "--items",
                                      std::to_string(place + 1), "--color", "never"};
    for (const std::string& folder : o_.plugins) words.insert(words.end(), {"--plugins", folder});
    if (o_.threads > 0) words.insert(words.end(), {"--threads", std::to_string(o_.threads)});
    return words;
  }

  void note(std::size_t place, const WorkerEnd& end) {
    if (end.code != kDone && interrupt_flag()) return;
    end.code == kDone ? ++done_ : ++failed_;
    if (end.code != kDone) {
      const std::string sentence = end.sentence();
      note_failure(o_.folder, study_.items[place], sentence);
      terminal_.say(fmt::format("netloft: item {}: {}", place + 1, sentence));
    }
    terminal_.progress_in_steps("items", done_ + failed_, left_.size(), std::to_string(place + 1));
  }

  int finish() {
    terminal_.clear();
    const std::size_t before = asked_ - left_.size();
    const Json json = {
        {"items", asked_}, {"computed", done_}, {"computed_before", before}, {"failed", failed_}};
    print_answer(o_, json,
                 fmt::format("{}: {} computed now, {} earlier, {} failed", count_of(asked_, "item"), done_,
                             before, failed_));
    if (interrupt_flag()) return end_interrupted(terminal_, what_is_left());
    return failed_ ? kOther : kDone;
  }

  std::string what_is_left() const {
    return fmt::format("{} of {} left; `netloft study run {}` computes them", left_.size() - done_ - failed_,
                       count_of(asked_, "item"), o_.folder);
  }

  const StudyRunOptions& o_;
  const studies::Study& study_;
  std::size_t asked_, done_ = 0, failed_ = 0;
  Terminal terminal_;
  std::vector<std::size_t> left_;  // indices of items without a record
};

}  // namespace

int study_run_command(const StudyRunOptions& o) {
  require_memory_to_solve();
  const studies::Study study = read_study(o.folder);
  if (const std::string changed = what_changed(study, o.folder); !changed.empty())
    throw studies::StudyError(changed + "; plan it again");
  catch_interrupts();
  return Campaign(o, study, read_items(o.items, study.items.size())).run();
}

}  // namespace netloft::program
