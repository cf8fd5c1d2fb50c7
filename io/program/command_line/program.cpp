// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/command_line/program.hpp"

#include "framework/registry/registry.hpp"
#include "io/program/command_line/command_line.hpp"
#include "io/program/session/error_json.hpp"
#include "io/program/session/last_words.hpp"
#include "io/program/session/memory_room.hpp"

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

int guarded(const Options& o, const std::function<int()>& work) {
  explain_crashes();
  try {
    return work();
  } catch (const UsageError& e) {
    return fail(o, e.message, kWrongInput);
  } catch (const PluginRefused& e) {
    return fail(o, e.what(), kRefused);
  } catch (const std::bad_alloc&) {
    return fail(o, "not enough memory", kOther);
  } catch (const std::exception& e) {
    return fail(o, e.what(), kOther);
  }
}

/// Help and versions go to standard output and are no error.
int explain(const CLI::App& app, const CLI::ParseError& error, const Options& o) {
  const bool is_error = error.get_exit_code() != 0;
  if (const std::string fault = unknown_option(app); is_error && !fault.empty())
    return fail(o, fault, kWrongInput);
  app.exit(error);
  if (is_error && o.json) std::puts(error_json(error.what(), kWrongInput).c_str());
  return is_error ? kWrongInput : kDone;
}

int read_and_work(CLI::App& app, Options& o, int argc, char** argv, const std::function<int()>& work) {
  o.words.assign(argv, argv + argc);
  if (argc == 1 && app.get_require_subcommand_min() > 0) {
    std::fputs(app.help().c_str(), stdout);
    return kDone;
  }
  const bool wants_json = std::find(o.words.begin(), o.words.end(), "--json") != o.words.end();
  if (const std::string fault = unknown_command(app, std::span(o.words).subspan(1)); !fault.empty()) {
    o.json = wants_json;
    return fail(o, fault, kWrongInput);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    o.json = wants_json;
    return explain(app, e, o);
  }
  return guarded(o, work);
}

/// What was printed has to arrive.
int after_printing(int code) {
  if (std::fflush(stdout) == 0 && !std::ferror(stdout) && std::cout.flush()) return code;
  std::fprintf(stderr, "netloft: standard output cannot be written: %s\n", std::strerror(errno));
  return code == kDone ? kOther : code;
}

}  // namespace

int run_program(CLI::App& app, Options& o, int argc, char** argv, const std::function<int()>& work) {
  guard_streams();
  return after_printing(read_and_work(app, o, argc, argv, work));
}

void require_memory_to_solve() {
  if (const std::string lack = lack_of_memory(); !lack.empty()) throw std::runtime_error(lack);
}

void guard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0 && errno == EBADF) open("/dev/null", O_RDONLY);
  std::signal(SIGXFSZ, SIG_IGN);
}

int fail(const Options& o, const std::string& message, int code) {
  std::fprintf(stderr, "netloft: %s\n", message.c_str());
  if (o.json) std::puts(error_json(message, code).c_str());
  return code;
}

}  // namespace netloft::program
