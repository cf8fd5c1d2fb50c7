// SPDX-License-Identifier: BSD-3-Clause
#include "io/cli/last_words.hpp"

#include "framework/conformance/conformance.hpp"
#include "io/cli/options.hpp"

#include <unistd.h>

#include <csignal>
#include <cstring>
#include <string_view>

namespace netloft::io {

namespace {

// Put together beforehand: little is safe when the time has come.
char last_words[512];
std::size_t length = 0;

void say(std::string_view words) {
  while (!words.empty()) {
    const auto written = write(STDERR_FILENO, words.data(), words.size());
    if (written <= 0) return;
    words.remove_prefix(static_cast<std::size_t>(written));
  }
}

void die(int) {
  say({last_words, length});
  const char* check = check_under_way();
  say(check ? "in the check " : "when it was made and first evaluated");
  if (check) say({check, std::strlen(check)});
  say("\n  usually: an index past the end of an array, or a null input that was read. "
      "`gdb --args netloft test …` shows the line of a plugin compiled with -g\n");
  _exit(kOther);
}

}  // namespace

void explain_crashes_of(const std::string& type) {
  const std::string words = "netloft: " + type + " crashed ";
  length = words.copy(last_words, sizeof last_words);
  for (const int s : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) std::signal(s, die);
}

}  // namespace netloft::io
