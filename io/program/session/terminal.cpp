// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/session/terminal.hpp"

#include "io/formats/text/printable.hpp"
#include "io/program/session/error_json.hpp"
#include "io/program/session/last_words.hpp"
#include "io/program/session/print.hpp"
#include "io/program/session/reading_progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace netloft::program {

namespace {

std::atomic<bool> interrupted{false};

bool wants_color(const std::string& choice, bool is_terminal) {
  if (choice != "auto") return choice == "always";
  const char *term = std::getenv("TERM"), *no_color = std::getenv("NO_COLOR");
  return is_terminal && !(no_color && *no_color) && term && std::string(term) != "dumb";
}

/// Progress from the first residual to the required one on a logarithmic scale, from 0 to 1.
double fraction_done(const IterationRecord& r, double first, double tolerance) {
  const double goal = tolerance * r.scale;
  if (!(r.residual > 0 && goal > 0 && first > goal)) return 1;
  return std::clamp(std::log(first / r.residual) / std::log(first / goal), 0.0, 1.0);
}

/// Seconds that a stage will still take if its residual keeps decreasing at the same rate; empty during the
/// first tenth, when the rate is not yet known.
std::string seconds_left(double done, double seconds) {
  constexpr double kKnown = 0.1;
  return done > kKnown ? fmt::format("{:.0f}", seconds * (1 - done) / done) : "";
}

std::string bar_of(double fraction) {
  return fmt::format("[{:<20}]",
                     std::string(static_cast<std::size_t>(20 * std::clamp(fraction, 0.0, 1.0)), '='));
}

/// Formats a number for JSON; null if it is not finite, because JSON has no infinity.
std::string json_number(double value) { return std::isfinite(value) ? fmt::format("{:.3e}", value) : "null"; }

/// A name for use within a line: without control characters, and shortened if it is long.
std::string on_a_line(std::string_view name) {
  constexpr std::size_t kLongest = 40;
  std::string text(name.substr(0, kLongest));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7F) c = '?';
  return text;
}

// seconds between two updates of progress
constexpr double kRedraw = 0.1, kEvent = 1, kLogLine = 60;

constexpr double kSilentReading = 2;  // seconds before reading a scene shows progress

}  // namespace

Terminal::Terminal(const CommonOptions& options)
    : is_terminal_(isatty(2) == 1),
      color_(wants_color(options.color, is_terminal_)),
      json_(options.json),
      begun_(wall_seconds()),
      reading_(std::make_unique<ReadingProgress>(*this)) {}

Terminal::~Terminal() {
  reading_.reset();
  clear();
}

void Terminal::say(const std::string& text) {
  clear();
  if (!text.empty()) print_error(text.ends_with('\n') ? text.substr(0, text.size() - 1) : text);
}

void Terminal::say(const formats::Diagnostics& diagnostics) {
  clear();
  std::fputs(diagnostics.render(color_).c_str(), stderr);
}

/// Seconds between two updates.
double Terminal::pause() const { return json_ ? kEvent : is_terminal_ ? kRedraw : kLogLine; }

/// Whether the next update is due.
bool Terminal::is_due(double now) {
  if (now - begun_ < 1 || now - last_ < pause()) return false;
  last_ = now;
  return true;
}

void Terminal::show(const std::string& bar, const std::string& pairs, const std::string& object) {
  if (json_)
    print_error(object);
  else if (is_terminal_) {
    std::fputs(("\r\033[K" + formats::printable_in_line(bar)).c_str(), stderr);
    drawn_ = true;
  } else
    print_error("progress " + pairs);
  std::fflush(stderr);
}

void Terminal::progress_in_time(double t, double end, double seconds, const std::string& run) {
  if (!is_due(wall_seconds())) return;
  const double left = t > 0 ? seconds * (end - t) / t : 0;
  show(fmt::format("{} {}{:.3g} s of {:.3g} s, {:.1f} s gone, about {:.0f} s left", bar_of(t / end),
                   run.empty() ? "" : run + ": ", t, end, seconds, left),
       fmt::format("{}time={:.6g} of={:.6g} seconds={:.1f} left={:.0f}",
                   run.empty() ? "" : fmt::format("run=\"{}\" ", run), t, end, seconds, left),
       fmt::format(
           R"({{"event": "progress", {}"time": {:.6g}, "of": {:.6g}, "seconds": {:.1f}, "left": {:.0f}}})",
           run.empty() ? "" : fmt::format(R"("run": "{}", )", run), t, end, seconds, left));
}

void Terminal::progress(const IterationRecord& r, double tolerance) {
  if (last_iteration_ >= 0 && r.iteration <= last_iteration_ && r.iteration == 0) ++stage_;
  const double now = wall_seconds();
  if (r.iteration == 0 || first_residual_ == 0) {
    first_residual_ = r.residual;
    stage_begun_ = now;
  }
  last_iteration_ = r.iteration;
  if (!is_due(now)) return;
  const double wanted = tolerance * r.scale, seconds = now - begun_;
  const double done = fraction_done(r, first_residual_, tolerance);
  const std::string left = seconds_left(done, now - stage_begun_);
  show(
      fmt::format("{} stage {}, iteration {}, residual {:.2e} N of {:.2e} N, {:.1f} s gone{}", bar_of(done),
                  stage_, r.iteration, r.residual, wanted, seconds,
                  left.empty() ? "" : ", about " + left + " s left in this stage"),
      fmt::format("iteration={} residual={:.3e} wanted={:.3e} stage={} seconds={:.1f}{}", r.iteration,
                  r.residual, wanted, stage_, seconds, left.empty() ? "" : " left=" + left),
      fmt::format(
          R"({{"event": "progress", "stage": {}, "iteration": {}, "residual": {}, "wanted": {}, "seconds": {:.1f}, "left": {}}})",
          stage_, r.iteration, json_number(r.residual), json_number(wanted), seconds,
          left.empty() ? "null" : left));
}

void Terminal::progress_in_steps(const std::string& things, std::size_t done, std::size_t all,
                                 const std::string& last) {
  const double now = wall_seconds(), seconds = now - begun_;
  if (!is_due(now)) return;
  const double fraction = all ? static_cast<double>(done) / static_cast<double>(all) : 0;
  const std::string left = seconds_left(fraction, seconds), of = std::to_string(all);
  show(fmt::format("{}{}{} {}, {:.1f} s gone{}; last {}", all ? bar_of(fraction) + " " : "", done,
                   all ? " of " + of : "", things, seconds, left.empty() ? "" : ", about " + left + " s left",
                   last),
       fmt::format("{}={}{} seconds={:.1f}{}", things, done, all ? " of=" + of : "", seconds,
                   left.empty() ? "" : " left=" + left),
       fmt::format(R"({{"event": "progress", "{}": {}, "of": {}, "seconds": {:.1f}, "left": {}}})", things,
                   done, all ? of : "null", seconds, left.empty() ? "null" : left));
}

void Terminal::progress_in_reading(const formats::Step& step, double seconds) {
  const double now = wall_seconds();
  if (seconds < kSilentReading || now - last_of_reading_ < pause()) return;
  last_of_reading_ = now;
  const std::string of = on_a_line(step.of);
  const auto counted = [&](const char* form) {
    return step.unit.empty() ? std::string() : fmt::format(fmt::runtime(form), step.unit, step.done);
  };
  show(fmt::format("{} {}{}, {:.1f} s gone", step.deed, of, counted(": {1} {0}"), seconds),
       fmt::format("{}=\"{}\"{} seconds={:.1f}", step.deed, of, counted(" {}={}"), seconds),
       fmt::format(R"({{"event": "progress", "{}": {}{}, "seconds": {:.1f}}})", step.deed, json_text(of),
                   counted(R"(, "{}": {})"), seconds));
}

void Terminal::clear() {
  if (drawn_) {
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
  }
  drawn_ = false;
}

const std::atomic<bool>& interrupt_flag() { return interrupted; }

void on_interrupts(void (*action)(int)) {
  for (const int signal : {SIGINT, SIGTERM, SIGQUIT}) std::signal(signal, action);
  if (std::signal(SIGHUP, action) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
}

void end_on_interrupts(bool json) {
  static std::string said, object;
  const std::string sentence = "interrupted; nothing has been solved";
  said = "netloft: " + sentence + "\n";
  object = json ? error_json(sentence, kInterrupted) + "\n" : "";
  on_interrupts([](int) {
    [[maybe_unused]] auto written = write(STDERR_FILENO, said.data(), said.size());
    written = write(STDOUT_FILENO, object.data(), object.size());
    end_at_once(kInterrupted);
  });
}

void catch_interrupts() {
  on_interrupts([](int number) {
    interrupted = true;
    std::signal(number, SIG_DFL);
  });
}

int end_interrupted(Terminal& terminal, const std::string& what_is_left) {
  terminal.clear();
  terminal.say("netloft: interrupted; " + what_is_left);
  return kInterrupted;
}

}  // namespace netloft::program
