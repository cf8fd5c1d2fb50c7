// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/server/design_server.hpp"
#include "io/formats/files/installed_folder.hpp"
#include "io/formats/files/whole_file.hpp"
#include "io/program/commands/scenes.hpp"
#include "io/program/session/print.hpp"
#include "io/program/session/session.hpp"

#include <nlohmann/json.hpp>

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

/// Opens the design and serves it until an interruption or, if it was opened as a page, until the page is
/// closed.
int serve(const DesignOptions& options, bool ends_with_page) {
  Terminal terminal(options);
  Registry registry;
  find_scene_plugins(options, registry);
  catch_interrupts();
  design::Session session(options.scene, library_folder(), registry, threads_for(options.threads));
  design::DesignServer server(session, options.port);
  print_address(server.address(), options.json);
  if (ends_with_page)
    terminal.say(
        "netloft: open this address in a browser; the program ends when the page is closed or by Ctrl-C");
  server.run(interrupt_flag(), ends_with_page);
  if (!session.is_saved()) terminal.say("netloft: changes that were not saved are lost");
  return kDone;
}

int serve_or_explain(const DesignOptions& options, bool ends_with_page) {
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
