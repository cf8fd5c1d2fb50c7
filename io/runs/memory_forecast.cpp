// SPDX-License-Identifier: BSD-3-Clause
#include "io/runs/memory_forecast.hpp"

#include "solvers/factorisation/foreseen_memory.hpp"
#include "solvers/factorisation/make_factorisation.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace netloft::runs {

namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

// Numbers of matrices and vectors that a problem stores (framework/balance: StaticProblem), and number of
// matrices that the check of its stability stores in addition (framework/judging: find_growth).
// tests/bench/memory.py compares the forecast with measured memory.
constexpr double kMatrices = 4, kVectors = 40, kMatricesOfMotion = 3;
// 1 + 1/4 + 1/16 + …: strategies also store coarser meshes, each with a quarter of the nodes of the previous
// one.
constexpr double kWithCoarser = 4.0 / 3;
// Vectors of positions and velocities in the Krylov space of the stability check
// (framework/judging/growth.cpp).
constexpr double kKrylov = 2 * 49;

/// Memory of this process [bytes]: the size of its address space, and its pages that are in main memory.
struct Pages {
  double addressed = 0, resident = 0;
};

Pages pages() {
  std::ifstream in("/proc/self/statm");
  Pages found;
  in >> found.addressed >> found.resident;
  const auto size = static_cast<double>(sysconf(_SC_PAGESIZE));
  return {found.addressed * size, found.resident * size};
}

/// Whether the strategy may solve the problem with the tensions of members as unknowns. The factor of this
/// second problem is stored in addition to the factor of the scene.
bool may_ask_for_tensions(PreparedScene& scene) {
  return !scene.loaded().analysis.strategy.empty() &&
         std::ranges::any_of(scene.assembler().families(), [](const auto& family) {
           return std::ranges::any_of(family->type().terms,
                                      [](const auto& term) { return term.traits & NETLOFT_OF_MEMBERS; });
         });
}

/// The value of a line "name: number kB" of /proc/meminfo [bytes]; infinite if the line is missing.
double memory_of_machine(const std::string& name) {
  std::ifstream in("/proc/meminfo");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(name + ":")) return 1024 * std::stod(line.substr(name.size() + 1));
  return kUnlimited;
}

double number_in(const std::string& file) {
  std::ifstream in(file);
  double number = 0;
  return in >> number ? number : kUnlimited;
}

/// Memory that the limit of this process's control group leaves [bytes]; infinite without a limit.
double left_by_group() {
  std::ifstream in("/proc/self/cgroup");
  std::string line;
  if (!std::getline(in, line) || !line.starts_with("0::")) return kUnlimited;
  const std::string folder = "/sys/fs/cgroup" + line.substr(3);
  const double most = number_in(folder + "/memory.max");
  return most < kUnlimited ? most - number_in(folder + "/memory.current") : kUnlimited;
}

double left_by_limit(const Pages& now) {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kUnlimited;
  return static_cast<double>(limit.rlim_cur) - now.addressed;
}

}  // namespace

MemoryForecast foresee_memory(PreparedScene& scene) {
  const SparsePattern& pattern = scene.assembler().pattern();
  if (pattern.size == 0) return {.taken = pages().resident};
  const auto factorisation =
      scene.factorisations()(pattern.symmetric ? MatrixClass::positive_definite : MatrixClass::unsymmetric);
  factorisation->analyse(pattern);
  const double factor = factor_bytes_of(*factorisation), size = static_cast<double>(pattern.size);
  // If all forces have a potential, the factor of the tangent decides the stability, and nothing more is
  // stored.
  const bool is_judged_by_motion =
      !pattern.symmetric && scene.loaded().analysis.kind == AnalysisKind::statics;
  MemoryForecast forecast;
  forecast.taken = pages().resident;
  forecast.factor = factor * (!pattern.symmetric && may_ask_for_tensions(scene) ? 2 : 1);
  const auto slots = static_cast<double>(scene.assembler().value_slots());
  if (is_judged_by_motion) forecast.stability = sizeof(double) * (kMatricesOfMotion * slots + kKrylov * size);
  forecast.numbers = kWithCoarser * sizeof(double) * (kMatrices * slots + kVectors * size);
  return forecast;
}

double memory_within_reach() {
  const Pages now = pages();
  return now.resident +
         std::max(0.0, std::min({memory_of_machine("MemAvailable"), left_by_group(), left_by_limit(now)}));
}

}  // namespace netloft::runs
