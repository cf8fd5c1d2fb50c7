// SPDX-License-Identifier: BSD-3-Clause
#include "framework/registry/trial_opening.hpp"

#include "framework/registry/descriptors.hpp"

#include <netloft/plugin.h>

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#if defined(__linux__)
#include <sys/prctl.h>
#include <sys/syscall.h>
#endif

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <new>
#include <string>

namespace netloft {

namespace {

constexpr int kSeconds = 20;                 // time limit to open and describe a plugin, on a busy machine
constexpr rlim_t kMemory = rlim_t{1} << 30;  // memory of a trial, in addition to that of the process
constexpr char kCameBack = 'b', kNeedsMemory = 'm',
               kIsLate = 'l';  // reports of a trial; a process that crashes sends none
// File descriptor through which the process that makes trials sends messages to the program.
constexpr int kTalk = STDERR_FILENO + 1;

/// Discards the output of this process, because it is of no use to users.
void be_quiet() {
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
}

void die_of_signals() {
  for (const int s : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM, SIGINT, SIGTERM, SIGHUP, SIGQUIT})
    signal(s, SIG_DFL);
#if defined(__linux__)
  prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
}

void report(char word) { [[maybe_unused]] const auto written = write(kTalk, &word, 1); }

/// Closes all files except the connection `talk`. Files of the program are open in this process, too, and
/// would otherwise stay locked until it ends.
void keep_only(int talk) {
  if (talk != kTalk) dup2(talk, kTalk);
#if defined(SYS_close_range)
  syscall(SYS_close_range, kTalk + 1, ~0U, 0U);
#endif
}

/// Address space of this process [bytes]; zero if the system does not report it.
rlim_t memory_now() {
  unsigned long pages = 0;
  if (FILE* statm = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(statm, "%lu", &pages) != 1) pages = 0;
    std::fclose(statm);
  }
  return rlim_t{pages} * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

/// Limits a resource of this process from now on. A lower limit that a user has set stays.
template <class Resource>
void limit(Resource resource, rlim_t most) {
  rlimit now{};
  if (getrlimit(resource, &now) != 0) return;
  now.rlim_cur = std::min(most, now.rlim_max);
  setrlimit(resource, &now);
}

void set_limits() {
  limit(RLIMIT_CORE, 0);
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  limit(RLIMIT_CPU, static_cast<rlim_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec + kSeconds));
  if (const rlim_t now = memory_now(); now > 0) limit(RLIMIT_AS, now + kMemory);
}

void read_text(const char* text) {
  static volatile std::size_t sink = 0;
  if (text) sink = sink + std::strlen(text);
}

void read_texts(const char* const* list) {
  for (; list && *list; ++list) read_text(*list);
}

void read_words(const std::vector<netloft_parameter>& parameters) {
  for (const auto& p : parameters) {
    for (const char* text : {p.name, p.unit, p.doc, p.fallback_of, p.fallback_text}) read_text(text);
    if (p.kind == NETLOFT_CHOICE || p.kind == NETLOFT_TEXT) read_texts(p.choices);
    if (p.kind == NETLOFT_TABLE) {
      read_texts(p.columns);
      read_texts(p.column_units);
    }
  }
}

template <class Rows>
void read_names(const Rows& rows) {
  for (const auto& row : rows) {
    read_text(row.name);
    read_text(row.doc);
  }
}

void read_words(const ElementType& e) {
  read_words(e.parameters);
  read_names(e.data);
  read_names(e.terms);
  read_names(e.outputs);
  read_names(e.laws);
  read_names(e.globals);
  for (const auto& d : e.data) read_text(d.unit);
  for (const auto& o : e.outputs) read_text(o.unit);
  for (const auto& l : e.laws) read_text(l.fallback);
  for (const char* text : {e.element.name, e.element.doc, e.rides_on}) read_text(text);
}

/// Reads every text of a plugin that this program may print.
void read_words(const PluginContent& content) {
  for (const auto& e : content.elements) read_words(e);
  for (const auto& s : content.solvers) {
    read_words(s.parameters);
    read_text(s.solver.doc);
  }
  for (const auto& l : content.laws) {
    read_words(l.parameters);
    read_text(l.law.doc);
    for (const auto& v : l.validity) {
      read_text(v.source);
      read_text(v.where);
      read_text(v.unless);
    }
  }
  for (const auto& i : content.integrators) {
    read_words(i.parameters);
    read_text(i.integrator.doc);
  }
  for (const auto& s : content.strategies) {
    read_words(s.parameters);
    read_text(s.strategy.doc);
  }
}

void open_and_read(const char* file) {
  set_limits();
  void* handle = dlopen(file, RTLD_NOW | RTLD_LOCAL);
  void* symbol = handle ? dlsym(handle, "netloft_plugin_v1") : nullptr;
  try {
    if (symbol) {
      const auto* plugin = reinterpret_cast<netloft_plugin_function>(symbol)();
      read_words(read_plugin(plugin, file, std::filesystem::path(file).stem().string()));
    }
  } catch (...) {  // the exception is reported when the program itself opens the plugin
  }
}

/// Runs the process that makes trials: opens one file after another, until the program ends or a plugin ends
/// this process.
[[noreturn]] void try_files(int talk) {
  keep_only(talk);
  be_quiet();
  die_of_signals();
  std::set_new_handler([] {
    report(kNeedsMemory);
    _exit(0);
  });
  char file[PATH_MAX + 1];
  for (;;) {
    const auto length = read(kTalk, file, PATH_MAX);
    if (length <= 0) _exit(0);
    file[length] = '\0';
    open_and_read(file);
    report(kCameBack);
  }
}

/// Returns the report of a trial within its time limit, or 0 if the process ended without a report.
char read_report(int pipe) {
  using std::chrono::steady_clock, std::chrono::milliseconds;
  const auto end = steady_clock::now() + std::chrono::seconds(kSeconds);
  for (;;) {
    const auto left = std::chrono::duration_cast<milliseconds>(end - steady_clock::now()).count();
    pollfd waiting{pipe, POLLIN, 0};
    const int ready = left > 0 ? poll(&waiting, 1, static_cast<int>(left)) : 0;
    if (ready == 0) return kIsLate;
    if (ready < 0 && errno != EINTR) return 0;
    char word = 0;
    if (ready > 0) return read(pipe, &word, 1) == 1 ? word : '\0';
  }
}

std::string fault_of(char word, int status) {
  if (word == kCameBack) return "";
  if (word == kNeedsMemory)
    return "needed more than " + std::to_string(kMemory >> 20) + " MiB of memory when it was opened";
  if (word == kIsLate || (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU))
    return "did not return within " + std::to_string(kSeconds) + " s when it was opened";
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) return "was interrupted when it was opened";
  if (WIFSIGNALED(status))
    return std::string("crashed while it was opened (") + strsignal(WTERMSIG(status)) +
           "); look at what runs before `main` (static objects) and at the table of the plugin";
  return "ended the program while it was opened";
}

int wait_for(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return 0;
  return status;
}

/// The process that makes trials, and the program's end of the connection to this process.
class Trials {
 public:
  /// Returns the report of the trial of a file, or 0 if the process ended without a report or does not exist.
  char of(const std::string& file);
  int end();
  bool is_running() const { return process_ > 0 && owner_ == getpid(); }
  bool start();
  bool is_fresh() const { return tried_ == 0; }

 private:
  // owner_: the process that started the trials. A process forked from the owner starts trials of its own.
  pid_t process_ = -1, owner_ = -1;
  int talk_ = -1;
  int tried_ = 0;
};

bool Trials::start() {
  int ends[2];
  if (talk_ >= 0) close(talk_);
  talk_ = -1;
  tried_ = 0;
  process_ = -1;
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) return false;
  process_ = fork();
  owner_ = getpid();
  if (process_ == 0) try_files(ends[1]);
  close(ends[1]);
  talk_ = ends[0];
  return process_ > 0;
}

char Trials::of(const std::string& file) {
  ++tried_;
  if (send(talk_, file.data(), file.size(), MSG_NOSIGNAL) < 0) return 0;
  return read_report(talk_);
}

int Trials::end() {
  kill(process_,
       SIGKILL);  // no report can follow; an exit status that the process already had is kept
  const int status = wait_for(process_);
  process_ = -1;
  return status;
}

}  // namespace

std::string fault_on_trial(const std::filesystem::path& file) {
  static std::mutex one_at_a_time;
  static Trials trials;
  const std::lock_guard lock(one_at_a_time);
  const std::string path = std::filesystem::absolute(file).string();
  for (;;) {
    // If the system has no resources for a trial, the file is opened without one.
    if (!trials.is_running() && !trials.start()) return {};
    const bool was_fresh = trials.is_fresh();
    const char word = trials.of(path);
    if (word == kCameBack) return {};
    const std::string fault = fault_of(word, trials.end());
    // A file that was opened earlier in this process may have caused the fault. Therefore this file is tried
    // again in a new process.
    if (was_fresh || word != 0) return fault;
  }
}

}  // namespace netloft
