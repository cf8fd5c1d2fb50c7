// SPDX-License-Identifier: BSD-3-Clause
#include "framework/registry/trial.hpp"

#include "framework/registry/descriptors.hpp"

#include <netloft/plugin.h>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>

namespace netloft {

namespace {

constexpr int kCameBack = 77;  // exit code of a trial that ended where it should
constexpr unsigned kSeconds = 20;

/// What a plugin has to say before it dies is not for the user.
void be_quiet() {
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
}

void die_of_signals() {
  for (const int s : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM, SIGINT, SIGTERM}) signal(s, SIG_DFL);
}

[[noreturn]] void open_and_leave(const char* file) {
  be_quiet();
  die_of_signals();
  alarm(kSeconds);
  void* handle = dlopen(file, RTLD_NOW | RTLD_LOCAL);
  void* symbol = handle ? dlsym(handle, "netloft_plugin_v1") : nullptr;
  try {
    if (symbol) {
      const auto* plugin = reinterpret_cast<netloft_plugin_function>(symbol)();
      read_plugin(plugin, file, std::filesystem::path(file).stem().string());
    }
  } catch (...) {  // said when it is opened for good
  }
  _exit(kCameBack);
}

std::string fault_of(int status) {
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM)
    return "did not come back within " + std::to_string(kSeconds) + " s when it was opened";
  if (WIFSIGNALED(status))
    return std::string("crashed while it was opened (") + strsignal(WTERMSIG(status)) +
           "); look at what runs before `main` (static objects) and at the table of the plugin";
  return WEXITSTATUS(status) == kCameBack ? "" : "ended the program while it was opened";
}

}  // namespace

std::string fault_on_trial(const std::filesystem::path& file) {
  const pid_t child = fork();
  if (child == 0) open_and_leave(file.c_str());
  if (child < 0) return {};  // no room for a trial
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return {};
  return fault_of(status);
}

}  // namespace netloft
