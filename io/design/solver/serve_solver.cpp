// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/solver/serve_solver.hpp"

#include "io/design/solver/solver_messages.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <thread>

namespace netloft::design {

namespace {

/// Takes standard input, a socket, away from the rest of the program.
LinePipe take_standard_streams() {
  constexpr int kAboveStandardStreams = 3;
  const int channel = ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, kAboveStandardStreams);
  const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  ::dup2(nothing, STDIN_FILENO);
  ::close(nothing);
  ::dup2(STDERR_FILENO, STDOUT_FILENO);
  return {channel, channel};
}

}  // namespace

ServedSolver::ServedSolver(std::function<void()> end_process)
    : end_process_(std::move(end_process)), pipe_(take_standard_streams()) {}

void ServedSolver::serve(const SolverCall& solver) {
  std::thread([this] { hear(); }).detach();
  const auto on_progress = [this](std::size_t done, std::size_t all) { send({{"done", done}, {"of", all}}); };
  for (;;) {
    const Json call = next_call();
    Json reply;
    try {
      reply["answer"] = solver(call["name"], call["body"], interrupt_, on_progress);
    } catch (...) {
      reply = message_of(std::current_exception());
    }
    send(reply);
  }
}

void ServedSolver::hear() {
  constexpr std::chrono::milliseconds kForEver{-1};
  while (!pipe_.is_closed())
    if (const auto line = pipe_.receive(kForEver)) take(Json::parse(*line));
  end_process_();
}

void ServedSolver::take(const Json& message) {
  const std::lock_guard lock(hearing_);
  if (message.contains("interrupt")) {
    if (message["interrupt"] == last_call_) interrupt_ = true;
    return;
  }
  last_call_ = message["call"];
  interrupt_ = false;  // a session makes a call after the answer to the one before
  calls_.push_back(message);
  heard_.notify_one();
}

Json ServedSolver::next_call() {
  std::unique_lock lock(hearing_);
  heard_.wait(lock, [this] { return !calls_.empty(); });
  Json call = std::move(calls_.front());
  calls_.pop_front();
  return call;
}

void ServedSolver::say_end(const std::string& sentence) { send({{"ended", sentence}}); }

void ServedSolver::send(const Json& message) {
  const std::lock_guard lock(sending_);
  pipe_.send(text_of(message));
}

}  // namespace netloft::design
