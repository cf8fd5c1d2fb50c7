// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/solver/solver_process.hpp"

#include "io/design/solver/solver_messages.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <system_error>
#include <thread>

namespace netloft::design {

namespace {

// Interval at which the flag of an interruption is read while the solver works.
constexpr std::chrono::milliseconds kLook{2};
// Time to answer after an interruption. The watchdog in the process of the solver needs up to two seconds to
// find the plugin that does not return.
constexpr std::chrono::seconds kGrace{6};
constexpr int kLooksAtEnd = 100;  // before a process that has closed its pipe, or lost it, is killed

using Clock = std::chrono::steady_clock;

/// The sentence of this program that stands last in a text: a crash is reported as "netloft: rope/bar crashed
/// in term elastic (Segmentation fault)".
std::string last_sentence(const std::string& text) {
  constexpr std::string_view kOwnName = "netloft: ";
  const std::size_t begin = text.rfind(kOwnName);
  if (begin == std::string::npos) return {};
  const std::size_t from = begin + kOwnName.size();
  return text.substr(from, text.find('\n', from) - from);
}

std::string text_of_file(int file) {
  std::string text(static_cast<std::size_t>(std::max<off_t>(lseek(file, 0, SEEK_END), 0)), '\0');
  const ssize_t got = pread(file, text.data(), text.size(), 0);
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  return text;
}

/// An array of C strings, as system calls take it, that lives as long as the texts.
std::vector<char*> pointers_to(const std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (const std::string& text : texts) pointers.push_back(const_cast<char*>(text.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

/// The environment of this process with another folder for temporary files.
std::vector<std::string> environment_with(const std::filesystem::path& folder) {
  constexpr std::string_view kName = "TMPDIR=";
  std::vector<std::string> all = {std::string(kName) + folder.string()};
  for (char** one = environ; *one; ++one)
    if (!std::string_view(*one).starts_with(kName)) all.emplace_back(*one);
  return all;
}

/// Starts a program with these standard streams, in a process group of its own, so that Ctrl-C in the
/// terminal reaches this program alone. Returns its process.
pid_t spawn(const std::vector<std::string>& command, const std::vector<std::string>& environment,
            int in_and_out, int words) {
  const auto arguments = pointers_to(command), variables = pointers_to(environment);
  posix_spawn_file_actions_t streams;
  posix_spawn_file_actions_init(&streams);
  posix_spawn_file_actions_adddup2(&streams, in_and_out, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&streams, in_and_out, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&streams, words, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  pid_t process = 0;
  const int error =
      posix_spawn(&process, arguments[0], &streams, &attributes, arguments.data(), variables.data());
  posix_spawn_file_actions_destroy(&streams);
  posix_spawnattr_destroy(&attributes);
  if (error != 0) throw std::system_error(error, std::generic_category(), "the solver cannot be started");
  return process;
}

}  // namespace

SolverProcess::~SolverProcess() {
  if (process_ > 0) end();
}

Json SolverProcess::answer(const std::string& name, const Json& body, const std::atomic<bool>& interrupt,
                           const OnProgress& on_progress) {
  if (process_ == 0) start();
  ++call_;
  if (!pipe_.send(text_of({{"call", call_}, {"name", name}, {"body", body}}))) throw_end("");
  for (;;) {
    Json message = next_message(interrupt);
    if (message.contains("done"))
      on_progress(message["done"], message["of"]);
    else if (message.contains("ended"))
      throw_end(message["ended"]);
    else if (message.contains("answer"))
      return std::move(message["answer"]);
    else
      throw_sent(message);
  }
}

void SolverProcess::start() {
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw std::system_error(errno, std::generic_category(), "the solver cannot be started");
  pipe_ = LinePipe(ends[0], ends[0]);
  const LinePipe theirs(ends[1], ends[1]);
  words_ = memfd_create("standard error", MFD_CLOEXEC);
  process_ = spawn(command_, environment_with(folder_.path()), ends[1], words_);
}

/// The next message of the solver, which is interrupted if the flag is set.
Json SolverProcess::next_message(const std::atomic<bool>& interrupt) {
  std::optional<Clock::time_point> interrupted;
  for (;;) {
    if (const auto line = pipe_.receive(kLook)) return Json::parse(*line);
    if (pipe_.is_closed()) throw_end("");
    if (!interrupt) continue;
    if (!interrupted) {
      interrupted = Clock::now();
      pipe_.send(text_of({{"interrupt", call_}}));
    } else if (Clock::now() - *interrupted > kGrace) {
      throw_end("it did not answer for " + std::to_string(kGrace.count()) + " s after an interruption");
    }
  }
}

/// Throws SolverEnded with the sentence, or else with the last words of the process.
void SolverProcess::throw_end(const std::string& sentence) {
  const std::string words = end();
  throw SolverEnded("the solver has ended: " + (sentence.empty() ? words : sentence));
}

/// Ends the process and returns its last words.
std::string SolverProcess::end() {
  pipe_ = LinePipe();
  int status = 0;
  pid_t ended = 0;  // a process that crashes needs a moment, in which it says why
  for (int look = 0; look < kLooksAtEnd && (ended = ::waitpid(process_, &status, WNOHANG)) == 0; ++look)
    std::this_thread::sleep_for(kLook);
  if (ended == 0) {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, &status, 0);
  }
  process_ = 0;
  std::string said = last_sentence(text_of_file(words_));
  ::close(words_);
  if (!said.empty()) return said;
  return WIFSIGNALED(status) ? "signal " + std::to_string(WTERMSIG(status)) + " ended it"
                             : "its exit code is " + std::to_string(WEXITSTATUS(status));
}

}  // namespace netloft::design
