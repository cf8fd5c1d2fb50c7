// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/factorisation/ranks.hpp"

#include <dlfcn.h>

#include <charconv>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "solvers/factorisation/mumps.hpp"
#include "solvers/factorisation/rank_branches.hpp"

namespace netloft {
namespace {

std::optional<int> number_in_environment(const char* name) {
  const char* text = std::getenv(name);
  if (!text) return {};
  const std::string_view all(text);
  int number = 0;
  const auto [end, error] = std::from_chars(all.data(), all.data() + all.size(), number);
  if (error != std::errc{} || end != all.data() + all.size()) return {};
  return number;
}

const RanksModule* open_module(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file))
    throw std::runtime_error("there is no " + file.string() +
                             ", which works on several ranks; it is built where libmumps-dev is installed");
  // Never closed: MPI does not start a second time.
  void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) throw std::runtime_error(file.string() + " cannot be opened: " + dlerror());
  const auto function = reinterpret_cast<RanksFunction>(dlsym(library, kRanksSymbol));
  if (!function) throw std::runtime_error(file.string() + " is of another version of this program");
  const RanksModule* module = function();
  if (!fits_mumps(module->mumps_version, module->structure_bytes))
    throw std::runtime_error(file.string() +
                             " is built with another MUMPS than this program: " + module->mumps_version);
  return module;
}

}  // namespace

Launch launch_of_environment() {
  constexpr struct {
    const char *size, *rank;
  } kLaunchers[] = {{"OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK"}, {"PMI_SIZE", "PMI_RANK"}};
  for (const auto& [size, rank] : kLaunchers)
    if (const auto all = number_in_environment(size), own = number_in_environment(rank); all && own)
      return {*own, *all, true};
  return {};
}

Ranks::Ranks(const std::filesystem::path& module, const Launch& launch)
    : Ranks(*open_module(module), launch) {}

Ranks::Ranks(const RanksModule& module, const Launch& launch) : module_(&module) {
  if (const char* fault = module_->start(&rank_, &size_)) throw std::runtime_error(fault);
  if (size_ != launch.size)
    throw std::runtime_error("the launcher has started " + std::to_string(launch.size) +
                             " processes, but MPI connects " + std::to_string(size_) +
                             ": the launcher is that of another MPI");
}

Ranks::~Ranks() {
  const std::lock_guard lock(one_at_a_time_);
  const RanksOrder end;
  if (rank_ == 0) module_->give(&end);
}

void Ranks::serve(ServesShares* shares) {
  BranchServer branches(*this);
  for (RanksOrder order;;) {
    module_->wait(&order);
    if (order.kind == RanksOrder::end) return;
    if (order.kind == RanksOrder::mumps)
      module_->run_mumps(&order, nullptr);
    else if (order.kind == RanksOrder::shares)
      shares->serve(order.instance, order.job);
    else
      branches.serve(order.instance, static_cast<BranchJob>(order.job));
  }
}

void Ranks::call(int instance, int job, int symmetry, void* mumps) {
  const std::lock_guard lock(one_at_a_time_);
  const RanksOrder order{RanksOrder::mumps, instance, job, symmetry};
  module_->give(&order);
  module_->run_mumps(&order, mumps);
}

std::unique_lock<std::mutex> Ranks::begin(int instance, int job) {
  return give({RanksOrder::branches, instance, job});
}

std::unique_lock<std::mutex> Ranks::begin_shares(int instance, int job) {
  return give({RanksOrder::shares, instance, job});
}

std::unique_lock<std::mutex> Ranks::give(const RanksOrder& order) {
  std::unique_lock lock(one_at_a_time_);
  module_->give(&order);
  return lock;
}

}  // namespace netloft
