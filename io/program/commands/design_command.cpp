// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/server/design_server.hpp"
#include "io/design/solver/live_solver.hpp"
#include "io/design/solver/serve_solver.hpp"
#include "io/design/solver/solver_process.hpp"
#include "io/formats/files/installed_folder.hpp"
#include "io/formats/files/whole_file.hpp"
#include "io/program/commands/scenes.hpp"
#include "io/program/session/last_words.hpp"
#include "io/program/session/print.hpp"
#include "io/program/session/session.hpp"
#include "io/program/session/watchdog.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <system_error>

namespace netloft::program {

namespace {

/// The folder of the gear library of the installation. Gears in it are opened as variants.
std::filesystem::path library_folder() {
  const std::filesystem::path installed = formats::installed_folder();
  return installed.empty() ? installed : installed / "share/netloft/gear-library";
}

void print_address(const std::string& address, bool json) {
  print_line(json ? nlohmann::ordered_json{{"address", address}}.dump() : address);
  flush_answers();
}

/// The command line of the solver of this design.
std::vector<std::string> solver_command(const DesignOptions& options) {
  std::vector<std::string> words = {"/proc/self/exe", "serve", "--as-solver", "--threads",
                                    std::to_string(threads_for(options.threads))};
  for (const std::string& folder : options.plugins) words.insert(words.end(), {"--plugins", folder});
  if (options.scene_plugins) words.push_back("--scene-plugins");
  words.push_back(options.scene);
  return words;
}

/// Answers the calls of a design, until the design ends. A watchdog ends calls that do not return.
[[noreturn]] void serve_as_solver(const DesignOptions& options) {
  Terminal terminal(options);
  Registry registry;
  find_scene_plugins(options, registry);
  design::LiveSolver solver(options.scene, registry, options.threads);
  design::ServedSolver served([] { end_at_once(kDone); });
  served.serve([&](const std::string& name, const design::Json& body, const std::atomic<bool>& interrupt,
                   const design::OnProgress& on_progress) {
    const auto last_act = [&](const Overdue& overdue) {
      served.say_end(overdue.sentence);
      return overdue.interrupted ? kInterrupted : kNotConverged;
    };
    Watchdog watchdog(terminal, last_act, interrupt);
    solver.on_budget([&](double seconds) { watchdog.allow(seconds); });
    return solver.answer(name, body, interrupt, on_progress);
  });
}

/// Opens an address as the desktop does, if there is one. The address was printed in any case.
void open_browser(const std::string& address) {
  if (!std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY")) return;
  posix_spawn_file_actions_t streams;
  posix_spawn_file_actions_init(&streams);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&streams, stream, "/dev/null", O_RDWR, 0);
  const char* const words[] = {"xdg-open", address.c_str(), nullptr};
  pid_t process = 0;
  posix_spawnp(&process, words[0], &streams, nullptr, const_cast<char* const*>(words), environ);
  posix_spawn_file_actions_destroy(&streams);
}

/// Opens the design and serves it until an interruption or, if it was opened as a page, until the page is
/// closed.
int serve(const DesignOptions& options, bool ends_with_page) {
  Terminal terminal(options);
  Registry registry;
  find_scene_plugins(options, registry);  // refuses a wrong --plugins before the solver does
  catch_interrupts();
  design::SolverProcess solver(solver_command(options));
  const auto call = [&](const std::string& name, const design::Json& body, const std::atomic<bool>& interrupt,
                        const design::OnProgress& on_progress) {
    return solver.answer(name, body, interrupt, on_progress);
  };
  if (!options.beside.empty() && !std::filesystem::exists(options.beside))
    throw formats::ReadError(options.beside + " does not exist");
  design::Session session(options.scene, library_folder(), call, options.beside);
  design::DesignServer server(session, options.port);
  print_address(server.address(), options.json);
  if (ends_with_page) {
    terminal.say(
        "netloft: open this address in a browser; the program ends when the page is closed or by Ctrl-C");
    if (!options.no_browser && !options.json) open_browser(server.address());
  }
  server.run(interrupt_flag(), ends_with_page);
  if (!session.is_saved()) terminal.say("netloft: changes that were not saved are lost");
  return kDone;
}

int serve_or_explain(const DesignOptions& options, bool ends_with_page) {
  if (options.as_solver) serve_as_solver(options);
  try {
    return serve(options, ends_with_page);
  } catch (const formats::ReadError& e) {
    throw UsageError{e.what()};
  } catch (const std::system_error& e) {
    throw UsageError{std::string(e.what()) + "; leave out --port, or choose another one"};
  }
}

}  // namespace

int design_command(const DesignOptions& options) { return serve_or_explain(options, true); }

int serve_command(const DesignOptions& options) { return serve_or_explain(options, false); }

}  // namespace netloft::program
