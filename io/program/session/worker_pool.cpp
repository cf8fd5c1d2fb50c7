// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/session/worker_pool.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <thread>

namespace netloft::program {

namespace {

constexpr std::size_t kMostWords = 4096;  // number of bytes that are read from the end of standard error

// Interval between two checks for ended workers: too short to be noticed, long enough to cost hardly any
// time.
constexpr std::chrono::milliseconds kMoment{1};

struct Worker {
  std::size_t job = 0;
  int words = -1;  // file descriptor of its standard error, a file in memory
};

/// Replaces this process by the program of a command line. Returns only on failure.
void become(const std::vector<std::string>& command, int words, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(128 + SIGTERM);
  const int nothing = open("/dev/null", O_RDWR);
  dup2(nothing, STDIN_FILENO);
  dup2(nothing, STDOUT_FILENO);
  dup2(words, STDERR_FILENO);
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  execv(arguments[0], arguments.data());
}

std::string read_last_words(int file) {
  const off_t size = lseek(file, 0, SEEK_END);
  std::string text(std::min<std::size_t>(kMostWords, static_cast<std::size_t>(std::max<off_t>(size, 0))),
                   '\0');
  const ssize_t got = pread(file, text.data(), text.size(), size - static_cast<off_t>(text.size()));
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const std::size_t line = text.rfind('\n');
  return line == std::string::npos ? text : text.substr(line + 1);
}

class Pool {
 public:
  ~Pool() {
    for (auto& [pid, worker] : workers_) {
      kill(pid, SIGTERM);
      close(worker.words);
    }
  }

  bool is_empty() const { return workers_.empty(); }
  std::size_t size() const { return workers_.size(); }

  void start(std::size_t job, const std::vector<std::string>& command) {
    const int words = memfd_create("standard error", MFD_CLOEXEC);
    const pid_t parent = getpid(), pid = words < 0 ? -1 : fork();
    if (pid == 0) {
      become(command, words, parent);
      const std::string why = command[0] + ": " + std::strerror(errno) + "\n";
      [[maybe_unused]] const ssize_t said = write(STDERR_FILENO, why.data(), why.size());
      _exit(127);
    }
    if (pid < 0) {
      const int error = errno;
      close(words);
      throw std::runtime_error("no more programs can be started: " + std::generic_category().message(error));
    }
    workers_[pid] = {job, words};
  }

  /// Waits briefly for a worker to end. Returns whether one has ended.
  bool wait_for_one(std::size_t& job, WorkerEnd& end) {
    int status = 0;
    const pid_t pid = waitpid(-1, &status, WNOHANG);
    if (pid <= 0) std::this_thread::sleep_for(kMoment);
    const auto found = workers_.find(pid);
    if (found == workers_.end()) return false;
    job = found->second.job;
    end.code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    end.last_words = read_last_words(found->second.words);
    close(found->second.words);
    workers_.erase(found);
    return true;
  }

  void ask_to_end() const {
    for (const auto& [pid, worker] : workers_) kill(pid, SIGTERM);
  }

 private:
  std::map<pid_t, Worker> workers_;
};

}  // namespace

std::string WorkerEnd::sentence() const {
  constexpr std::string_view kOwnName = "netloft: ";
  std::string words = last_words;
  if (words.starts_with(kOwnName)) words.erase(0, kOwnName.size());
  const std::string how = code > 128 ? "the worker was ended by signal " + std::to_string(code - 128)
                                     : "the worker ended with exit code " + std::to_string(code);
  return words.empty() ? how : how + ": " + words;
}

std::size_t run_workers(std::size_t count, int jobs,
                        const std::function<std::vector<std::string>(std::size_t)>& command,
                        const std::function<void(std::size_t, const WorkerEnd&)>& on_end,
                        const std::atomic<bool>& interrupt) {
  Pool pool;
  std::size_t started = 0, job = 0;
  bool was_asked = false;
  while (!pool.is_empty() || (started < count && !interrupt)) {
    while (started < count && !interrupt && pool.size() < static_cast<std::size_t>(jobs)) {
      pool.start(started, command(started));
      ++started;
    }
    if (interrupt && !was_asked) {
      pool.ask_to_end();
      was_asked = true;
    }
    WorkerEnd end;
    if (!pool.is_empty() && pool.wait_for_one(job, end)) on_end(job, end);
  }
  return started;
}

}  // namespace netloft::program
