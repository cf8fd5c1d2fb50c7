// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/session/last_words.hpp"

#include "framework/conformance/conformance.hpp"
#include "framework/registry/plugin_call.hpp"
#include "io/formats/text/printable.hpp"
#include "io/program/session/error_json.hpp"
#include "io/program/session/options.hpp"
#include "io/program/session/print.hpp"
#include "io/program/session/terminal.hpp"

#include <signal.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>
#if defined(__linux__)
#include <ucontext.h>
#endif

namespace netloft::program {

namespace {

/// A text for a signal handler. It is assembled in advance, because most functions must not be called in a
/// signal handler.
template <std::size_t size>
struct Words {
  char bytes[size] = {};
  std::size_t length = 0;

  void set(const std::string& text) { length = text.copy(bytes, size); }
  bool empty() const { return length == 0; }
  std::string_view view() const { return {bytes, length}; }
};

Words<512> under_test;
Words<4096> damaged, damaged_as_json;  // messages about the file that is being read

void say(std::string_view words, int stream = STDERR_FILENO) {
  while (!words.empty()) {
    const auto written = write(stream, words.data(), words.size());
    if (written <= 0) return;
    words.remove_prefix(static_cast<std::size_t>(written));
  }
}

void say_if(const char* words) {
  if (words) say({words, std::strlen(words)});
}

const char* name_of_signal(int signal) {
  switch (signal) {
    case SIGSEGV:
      return "Segmentation fault";
    case SIGBUS:
      return "Bus error";
    case SIGFPE:
      return "Arithmetic exception";
    case SIGILL:
      return "Illegal instruction";
    default:
      return "Aborted";
  }
}

/// Prints "rope/bar crashed in term elastic".
void say_who(const CallFrame& frame, std::string_view did) {
  say_if(frame.type);
  say(did);
  say_if(frame.what);
  if (frame.name) {
    say(" ");
    say_if(frame.name);
  }
}

CallFrame innermost_plugin(const CallStack* calls) {
  if (!calls) return {};
  return calls->innermost_plugin().value_or(CallFrame{});
}

/// Prints which component was running; `did` is a phrase such as " crashed in ". Returns whether it was a
/// plugin.
bool say_what_happened(std::string_view did) {
  const CallStack* calls = known_calls_of_this_thread();
  const CallFrame plugin = innermost_plugin(calls);
  say("netloft: ");
  if (!under_test.empty()) {
    say(under_test.view());
    say(did);
    const char* check = check_under_way();
    say(check ? "the check " : "its construction or first evaluation");
    say_if(check);
  } else if (plugin.type && calls->innermost().kind != CallFrame::Kind::host) {
    say_who(plugin, did);
  } else if (plugin.type) {
    say("the program itself, in a function that was called by ");
    say_if(plugin.type);
    say(",");
    say(did);
    say_if(plugin.what);
  } else {
    say("the program itself");
    say(did);
    say("no plugin");
  }
  return !under_test.empty() || (plugin.type && calls->innermost().kind != CallFrame::Kind::host);
}

#if defined(__linux__) && (defined(__x86_64__) || defined(__aarch64__))
std::uintptr_t stack_pointer(void* context) {
  const auto& machine = static_cast<ucontext_t*>(context)->uc_mcontext;
#if defined(__x86_64__)
  return static_cast<std::uintptr_t>(machine.gregs[REG_RSP]);
#else
  return static_cast<std::uintptr_t>(machine.sp);
#endif
}
bool used_up_its_stack(int signal, const siginfo_t* info, void* context) {
  constexpr std::uintptr_t kNear = std::uintptr_t{1}
                                   << 16;  // a stack overflow accesses memory this close to the stack pointer
  const auto at = reinterpret_cast<std::uintptr_t>(info->si_addr), top = stack_pointer(context);
  return signal == SIGSEGV && at + kNear > top && at < top + kNear;
}
#else
bool used_up_its_stack(int, const siginfo_t*, void*) { return false; }
#endif

// The earlier handlers of the signals: the default ones, or those of a sanitizer.
struct sigaction before[NSIG];

/// Restores the earlier handler after a crash of the program itself, so that a core file is written.
void die_as_before(int signal) {
  say("\n");
  sigaction(signal, &before[signal], nullptr);
}

/// Ends the program after a crash of HDF5 on a damaged file.
[[noreturn]] void die_of_damaged_file() {
  say(damaged.view());
  say(damaged_as_json.view(), STDOUT_FILENO);
  end_at_once(kWrongInput);
}

void die(int signal, siginfo_t* info, void* context) {
  if (!damaged.empty() && (signal == SIGSEGV || signal == SIGBUS || signal == SIGABRT)) die_of_damaged_file();
  if (const CallStack* calls = known_calls_of_this_thread(); calls && calls->has_blame(0)) {
    say("netloft: ");
    say_if(calls->blame_text());
    say("\n");
    end_at_once(kOther);
  }
  const bool is_plugins = say_what_happened(" crashed in ");
  say(" (");
  say_if(name_of_signal(signal));
  say(")");
  if (used_up_its_stack(signal, info, context))
    say(": it used up its stack\n  usually: a function that calls itself for ever, or a very large local "
        "array");
  else
    say("\n  usually: an index past the end of an array, or a null input that was read");
  if (!is_plugins) return die_as_before(signal);
  say(". `gdb --args netloft …` shows the line of a plugin compiled with -g\n");
  end_at_once(kOther);
}

/// Ends the program during a check that takes too long or is interrupted.
void end_check(int signal) {
  const bool is_over = signal == SIGPROF;
  const char* check = check_under_way();
  say("netloft: ");
  say(under_test.view());
  say(is_over ? " did not return from " : " was interrupted in ");
  say(check ? "the check " : "its construction or first evaluation");
  say_if(check);
  say(is_over ? " within its processor time (--seconds)\n" : "\n");
  end_at_once(is_over ? kOther : kInterrupted);
}

void limit_checks(double seconds) {
  const auto action = seconds > 0 ? end_check : SIG_DFL;
  signal(SIGPROF, action);
  on_interrupts(action);
  const auto whole = static_cast<time_t>(seconds);
  const itimerval limit{{0, 0}, {whole, static_cast<suseconds_t>(1e6 * (seconds - double(whole)))}};
  setitimer(ITIMER_PROF, &limit, nullptr);
}

// `watched` is the process that reports its own early end; its child processes report nothing.
// `is_at_its_last_step` says whether the program has reached last_step().
pid_t watched = 0;
volatile bool is_at_its_last_step = false;

/// Reports that a plugin or a library has ended the program before its last step. The exit code is then never
/// that of a success.
void tell_of_an_early_end() {
  if (is_at_its_last_step || getpid() != watched) return;
  const CallStack* calls = known_calls_of_this_thread();
  std::fflush(stdout);
  if (!under_test.empty() || innermost_plugin(calls).type) {
    say_what_happened(" ended the program (exit) in ");
    say("; a plugin must return, with a status and a sentence if it cannot continue\n");
  } else
    say("netloft: a plugin or a library ended the program (exit) before its last step\n");
  end_at_once(kOther);
}

}  // namespace

void end_at_once(int code) {
#if defined(__linux__)
  for (;;) syscall(SYS_exit_group, code);
#else
  ::_exit(code);
#endif
}

int last_step(int code) {
  is_at_its_last_step = true;
  const std::string broken = take_broken_rule();
  if (broken.empty()) return code;
  print_error("netloft: " + broken);
  return code == kDone ? kOther : code;
}

void end_called_from_outside(int code) {
  tell_of_an_early_end();
  end_at_once(code);
}

void explain_crashes() {
  calls_of_this_thread();  // creates the record of calls of this thread, with a stack for signal handlers
  watched = getpid();
  std::atexit(tell_of_an_early_end);
  std::at_quick_exit(tell_of_an_early_end);
  struct sigaction action {};
  action.sa_sigaction = die;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK | static_cast<int>(SA_RESETHAND);
  for (const int s : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) sigaction(s, &action, &before[s]);
}

void explain_crashes_of(const std::string& type, double seconds) {
  under_test.set(type);
  limit_checks(seconds);
}

DamagedFileWatch::DamagedFileWatch(const std::string& path, bool json) {
  const std::string message = "cannot read " + formats::printable_in_line(path) +
                              ": the HDF5 library crashed on it; the file is damaged";
  damaged_as_json.set(json ? error_json(message, kWrongInput) + "\n" : "");
  damaged.set("netloft: " + message + "\n");
}

DamagedFileWatch::~DamagedFileWatch() { damaged.set(""); }

}  // namespace netloft::program

#if defined(__linux__)
// Plugins call these functions instead of those of the C library, because symbols are first searched for in
// the program. They are needed because _exit does not run the handlers of atexit().
extern "C" {
NETLOFT_EXPORT void _exit(int status) { netloft::program::end_called_from_outside(status); }
NETLOFT_EXPORT void _Exit(int status) noexcept { netloft::program::end_called_from_outside(status); }
}
#endif
