// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/command_line/program.hpp"

#include "framework/registry/wrong_kind.hpp"
#include "io/formats/work/long_work.hpp"
#include "io/program/command_line/command_line.hpp"
#include "io/program/session/error_json.hpp"
#include "io/program/session/last_words.hpp"
#include "io/program/session/options.hpp"
#include "io/program/session/print.hpp"
#include "io/program/session/terminal.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <stdexcept>

namespace netloft::program {

namespace {

/// Reports an error on standard error and, with --json, as an object on standard output. Returns the code.
int fail(const std::string& message, int code, bool json) {
  print_error("netloft: " + message);
  if (json) print_line(error_json(message, code));
  return code;
}

int guarded(bool json, const std::function<int()>& work) {
  explain_crashes();
  end_on_interrupts(json);
  try {
    return work();
  } catch (const formats::Interrupted&) {
    return fail("interrupted; nothing has been solved", kInterrupted, json);
  } catch (const UsageError& e) {
    return fail(e.message, kWrongInput, json);
  } catch (const PluginRefused& e) {
    return fail(e.what(), blames_plugin(e) ? kRefused : kWrongInput, json);
  } catch (const std::bad_alloc&) {
    return fail("not enough memory", kOther, json);
  } catch (const std::exception& e) {
    return fail(e.what(), kOther, json);
  }
}

/// Reports the end of parsing. Help and versions go to standard output and are not errors.
int explain(const CLI::App& app, const CLI::ParseError& error, bool json) {
  const bool is_error = error.get_exit_code() != 0;
  if (const std::string fault = unknown_option(app); is_error && !fault.empty())
    return fail(fault, kWrongInput, json);
  app.exit(error);
  if (is_error && json) print_line(error_json(error.what(), kWrongInput));
  return is_error ? kWrongInput : kDone;
}

int read_and_work(CLI::App& app, int argc, char** argv, const std::function<int()>& work) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.empty() && app.get_require_subcommand_min() > 0) {
    print(app.help());
    return kDone;
  }
  const bool json = std::ranges::find(words, "--json") != words.end();
  if (const std::string fault = unknown_command(app, words); !fault.empty())
    return fail(fault, kWrongInput, json);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return explain(app, e, json);
  }
  return guarded(json, work);
}

/// Opens closed standard streams on /dev/null. Otherwise, a file opened later would get the number of a
/// stream and receive its output. Ignores SIGXFSZ, because a limit on file sizes would otherwise end the
/// program without a message.
void guard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0 && errno == EBADF) open("/dev/null", O_RDONLY);
  std::signal(SIGXFSZ, SIG_IGN);
}

/// Returns the exit code; it is an error if the answer could not be printed.
int after_printing(int code) {
  if (std::fflush(stdout) == 0 && !std::ferror(stdout) && std::cout.flush()) return code;
  print_error(std::string("netloft: standard output cannot be written: ") + std::strerror(errno));
  return code == kDone ? kOther : code;
}

}  // namespace

int run_program(CLI::App& app, int argc, char** argv, const std::function<int()>& work) {
  guard_streams();
  return last_step(after_printing(read_and_work(app, argc, argv, work)));
}

}  // namespace netloft::program
