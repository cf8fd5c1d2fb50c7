// SPDX-License-Identifier: BSD-3-Clause
#include "io/cli/command_line/command_line.hpp"
#include "io/cli/commands.hpp"
#include "io/cli/error_json.hpp"
#include "io/cli/last_words.hpp"
#include "io/cli/memory_room.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <string_view>

namespace netloft::io {
namespace {

/// `solves`: it may want more memory than the machine has room for, and says so before it begins.
struct Command {
  std::string_view name;
  int (*run)(const Options&);
  bool solves = false;
};

constexpr Command kCommands[] = {
    {"run", run_command, true},
    {"plan", plan_command},
    {"list", list_command},
    {"describe", describe_command},
    {"schema", schema_command},
    {"compare", compare_command, true},
    {"diff", diff_command},
    {"refine", refine_command, true},
    {"scope", scope_command, true},
    {"stability", stability_command, true},
    {"study", study_command, true},
    {"calibrate", calibrate_command, true},
    {"new", new_command},
    {"reference", reference_command},
    {"catalogue", catalogue_command},
    {"check", check_command},
    {"draw", draw_command},
    {"report", report_command},
    {"view", view_command},
    {"export", export_command},
    {"import", import_command},
    {"test", test_command, true},
};

const Command& command_of(const Options& o) {
  return *std::ranges::find(kCommands, o.command, &Command::name);
}

int fail(const Options& o, const std::string& message, int code) {
  std::fprintf(stderr, "netloft: %s\n", message.c_str());
  if (o.json) std::puts(error_json(message, code).c_str());
  return code;
}

int guarded(const Options& o) {
  explain_crashes();
  if (const std::string lack = lack_of_memory(); command_of(o).solves && !lack.empty())
    return fail(o, lack, kOther);
  try {
    return command_of(o).run(o);
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

/// A file that is opened must not become a stream that was closed: what is printed would land in it. Nor is a
/// limit on the size of files a reason to die without a word.
void guard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0 && errno == EBADF) open("/dev/null", O_RDONLY);
  std::signal(SIGXFSZ, SIG_IGN);
}

/// What was printed has to arrive.
int after_printing(int code) {
  if (std::fflush(stdout) == 0 && !std::ferror(stdout) && std::cout.flush()) return code;
  std::fprintf(stderr, "netloft: standard output cannot be written: %s\n", std::strerror(errno));
  return code == kDone ? kOther : code;
}

int start(int argc, char** argv) {
  Options o;
  o.words.assign(argv, argv + argc);
  CLI::App app{"Netloft finds the shape and the forces of trawl gears.", "netloft"};
  app.set_version_flag("--version", std::string("netloft " NETLOFT_VERSION));
  add_commands(app, o);
  if (argc == 1) {
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
  o.command = app.get_subcommands().front()->get_name();
  o.given = given_options(app);
  return guarded(o);
}

}  // namespace
}  // namespace netloft::io

int main(int argc, char** argv) {
  netloft::io::guard_streams();
  return netloft::io::after_printing(netloft::io::start(argc, argv));
}
