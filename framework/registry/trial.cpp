// SPDX-License-Identifier: BSD-3-Clause
#include "framework/registry/trial.hpp"

#include "framework/registry/descriptors.hpp"

#include <netloft/plugin.h>

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#if defined(__linux__)
#include <sys/prctl.h>
#endif

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>

namespace netloft {

namespace {

constexpr int kSeconds = 20;                 // for opening and describing, on a busy machine
constexpr rlim_t kMemory = rlim_t{1} << 30;  // beyond what this program has
constexpr char kCameBack = 'b', kNeedsMemory = 'm',
               kIsLate = 'l';  // what a trial reports; nothing: it ended before
int report = -1;               // where to, in the trial

/// What a plugin has to say before it dies is not for the user.
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

[[noreturn]] void leave_with(char word) {
  [[maybe_unused]] const auto written = write(report, &word, 1);
  _exit(0);
}

/// Address space of this process [bytes]; zero where the system does not say.
rlim_t memory_now() {
  unsigned long pages = 0;
  if (FILE* statm = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(statm, "%lu", &pages) != 1) pages = 0;
    std::fclose(statm);
  }
  return rlim_t{pages} * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

void set_limits() {
  const rlimit no_core{0, 0}, seconds{kSeconds, kSeconds};
  setrlimit(RLIMIT_CORE, &no_core), setrlimit(RLIMIT_CPU, &seconds);
  const rlim_t now = memory_now();
  const rlimit memory{now + kMemory, now + kMemory};
  if (now > 0) setrlimit(RLIMIT_AS, &memory);
  std::set_new_handler([] { leave_with(kNeedsMemory); });
}

/// Reads a text to its end.
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
    if (p.kind == NETLOFT_CHOICE) read_texts(p.choices);
    if (p.kind == NETLOFT_TABLE) read_texts(p.columns), read_texts(p.column_units);
  }
}

template <class Rows>
void read_names(const Rows& rows) {
  for (const auto& row : rows) read_text(row.name), read_text(row.doc);
}

void read_words(const ElementType& e) {
  read_words(e.parameters);
  read_names(e.data), read_names(e.terms), read_names(e.outputs), read_names(e.laws), read_names(e.globals);
  for (const auto& d : e.data) read_text(d.unit);
  for (const auto& o : e.outputs) read_text(o.unit);
  for (const auto& l : e.laws) read_text(l.fallback);
  for (const char* text : {e.element.name, e.element.doc, e.element.rides_on}) read_text(text);
}

/// Every word that this program may ever print of a plugin.
void read_words(const PluginContent& content) {
  for (const auto& e : content.elements) read_words(e);
  for (const auto& s : content.solvers) read_words(s.parameters), read_text(s.solver.doc);
  for (const auto& l : content.laws) {
    read_words(l.parameters), read_text(l.law.doc);
    for (const auto& v : l.validity) read_text(v.source), read_text(v.where), read_text(v.unless);
  }
  for (const auto& i : content.integrators) read_words(i.parameters), read_text(i.integrator.doc);
  for (const auto& s : content.strategies) read_words(s.parameters), read_text(s.strategy.doc);
}

[[noreturn]] void open_and_leave(const char* file) {
  be_quiet();
  die_of_signals();
  set_limits();
  void* handle = dlopen(file, RTLD_NOW | RTLD_LOCAL);
  void* symbol = handle ? dlsym(handle, "netloft_plugin_v1") : nullptr;
  try {
    if (symbol) {
      const auto* plugin = reinterpret_cast<netloft_plugin_function>(symbol)();
      read_words(read_plugin(plugin, file, std::filesystem::path(file).stem().string()));
    }
  } catch (...) {  // said when it is opened for good
  }
  leave_with(kCameBack);
}

/// What the trial reports within the time it has; 0: it ended without a word.
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
    return "wanted more than " + std::to_string(kMemory >> 20) + " MiB of memory when it was opened";
  if (word == kIsLate || (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU))
    return "did not come back within " + std::to_string(kSeconds) + " s when it was opened";
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

}  // namespace

std::string fault_on_trial(const std::filesystem::path& file) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return {};
  const pid_t child = fork();
  if (child == 0) report = ends[1], open_and_leave(file.c_str());
  close(ends[1]);
  const char word = child > 0 ? read_report(ends[0]) : kCameBack;  // no room for a trial
  close(ends[0]);
  if (child < 0) return {};
  kill(child, SIGKILL);  // what it has not said by now is of no interest; one that has ended keeps its status
  return fault_of(word, wait_for(child));
}

}  // namespace netloft
