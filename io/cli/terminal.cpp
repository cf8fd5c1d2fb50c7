// SPDX-License-Identifier: BSD-3-Clause
#include "io/cli/terminal.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace netloft::io {

namespace {

std::atomic<bool> interrupted{false};

bool wants_color(const std::string& choice, bool is_terminal) {
  if (choice != "auto") return choice == "always";
  const char *term = std::getenv("TERM"), *no_color = std::getenv("NO_COLOR");
  return is_terminal && !(no_color && *no_color) && term && std::string(term) != "dumb";
}

/// Share of the way from the first residual to the wanted one, in decades.
double share_done(const IterationRecord& r, double tolerance) {
  static double first = 0;
  if (r.iteration == 0 || first == 0) first = r.residual;
  const double goal = tolerance * r.scale;
  if (!(r.residual > 0 && goal > 0 && first > goal)) return 1;
  return std::clamp(std::log(first / r.residual) / std::log(first / goal), 0.0, 1.0);
}

}  // namespace

Terminal::Terminal(const std::string& color)
    : is_terminal_(isatty(2) == 1), color_(wants_color(color, is_terminal_)), begun_(wall_seconds()) {}

void Terminal::say(const std::string& text) {
  clear();
  std::fputs(text.c_str(), stderr);
  if (!text.empty() && text.back() != '\n') std::fputc('\n', stderr);
}

/// Whether it is time for another line.
bool Terminal::is_due(double now) {
  const double pause = is_terminal_ ? 0.1 : 5;
  if (now - begun_ < 1 || now - last_ < pause) return false;
  last_ = now;
  return true;
}

void Terminal::progress_in_time(double t, double end, double seconds) {
  if (!is_due(wall_seconds())) return;
  if (is_terminal_) {
    const auto bar = static_cast<std::size_t>(20 * std::clamp(t / end, 0.0, 1.0));
    std::fputs(fmt::format("\r\033[K[{:<20}] {:.3g} s of {:.3g} s, {:.1f} s gone", std::string(bar, '='), t,
                           end, seconds)
                   .c_str(),
               stderr);
    drawn_ = true;
  } else {
    std::fputs(fmt::format("progress time={:.6g} of={:.6g} seconds={:.1f}\n", t, end, seconds).c_str(),
               stderr);
  }
  std::fflush(stderr);
}

void Terminal::progress(const IterationRecord& r, double tolerance) {
  if (!is_due(wall_seconds())) return;
  if (is_terminal_) {
    const int bar = static_cast<int>(20 * share_done(r, tolerance));
    const auto line = fmt::format("\r\033[K[{:<20}] iteration {}, residual {:.2e} N of {:.2e} N, {:.1f} s",
                                  std::string(static_cast<std::size_t>(bar), '='), r.iteration, r.residual,
                                  tolerance * r.scale, r.seconds);
    std::fputs(line.c_str(), stderr);
    drawn_ = true;
  } else {
    std::fputs(fmt::format("progress iteration={} residual={:.3e} wanted={:.3e} seconds={:.1f}\n",
                           r.iteration, r.residual, tolerance * r.scale, r.seconds)
                   .c_str(),
               stderr);
  }
  std::fflush(stderr);
}

void Terminal::clear() {
  if (drawn_) std::fputs("\r\033[K", stderr), std::fflush(stderr);
  drawn_ = false;
}

const std::atomic<bool>& interrupt_flag() { return interrupted; }

void catch_interrupts() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT})
    std::signal(signal, [](int number) {
      interrupted = true;
      std::signal(number, SIG_DFL);
    });
}

}  // namespace netloft::io
