// SPDX-License-Identifier: BSD-3-Clause
#include "io/cli/launched.hpp"

#include "framework/ranks/share_server.hpp"
#include "io/cli/commands.hpp"
#include "io/cli/prefix.hpp"

#include <algorithm>
#include <csignal>
#include <stdexcept>
#include <string>

namespace netloft::io {

namespace {

std::filesystem::path ranks_module() {
  return installed_prefix() / "lib" / "netloft" / "mpi" / "mumps_mpi.so";
}

void find_plugins_of(const Options& options, Registry& registry) {
  try {
    find_plugins(options, registry);
  } catch (const UsageError& e) {
    throw std::runtime_error(e.message);
  }
}

bool is_given(const Options& options, const std::string& name) {
  return std::find(options.given.begin(), options.given.end(), name) != options.given.end();
}

}  // namespace

std::unique_ptr<Ranks> start_ranks(const Options& options, const Launch& launch) {
  for (const std::string name : {"--ranks-from", "--same-bits"})
    if (is_given(options, name) && !launch.is_launched)
      throw UsageError{name + " is for runs on several ranks: mpirun -n 4 netloft run …"};
  if (launch.size < 2) return nullptr;
  const std::string started = "the launcher of MPI has started " + std::to_string(launch.size) + " processes";
  if (options.command != "run")
    throw UsageError{started + ", but `" + options.command + "` works in one; only `run` works in several"};
  try {
    return std::make_unique<Ranks>(ranks_module(), launch);
  } catch (const std::runtime_error& e) {
    throw UsageError{started + ", which cannot work together: " + e.what()};
  }
}

void serve_ranks(const Options& options, const Launch& launch) {
  for (const int s : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) std::signal(s, SIG_IGN);
  try {
    Ranks ranks(ranks_module(), launch);
    ShareServer shares(ranks, [&](Registry& registry) { find_plugins_of(options, registry); });
    ranks.serve(&shares);
  } catch (const std::runtime_error&) {
  }
}

}  // namespace netloft::io
