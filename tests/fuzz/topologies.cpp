// SPDX-License-Identifier: BSD-3-Clause
// Net plans of random topologies: each must be meshed, or refused with a message that names a place in the
// plan. Prints how many were meshed, why the others were refused, and every plan that was neither meshed nor
// refused.
//
//   topologies COUNT[:SEED]      SEED is 1 by default; each seed gives one plan
//   topologies --show SEED       prints the plan of a seed
#include "tests/fuzz/topology_trial.hpp"

#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <map>
#include <random>
#include <regex>

namespace {

using namespace netloft;

constexpr int kMostSeconds = 60;  // limit of processor time for one plan, hundreds of times the usual time

volatile unsigned seed_at_work = 0;

/// Prints the seed of the plan after a crash, a failed assertion or an endless loop.
extern "C" void say_seed(int signal) {
  char text[96];
  const int length = std::snprintf(text, sizeof text, "seed %u: signal %d\n", seed_at_work, signal);
  if (write(STDERR_FILENO, text, static_cast<std::size_t>(length)) > 0) _exit(1);
  _exit(1);
}

void start_clock() {
  const itimerval limit{{0, 0}, {kMostSeconds, 0}};
  setitimer(ITIMER_PROF, &limit, nullptr);
}

std::vector<std::uint8_t> bytes_of(unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::uint8_t> bytes(4096);
  for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
  return bytes;
}

struct Drawn {
  std::string text;
  gears::Fineness fineness;
};

Drawn draw(unsigned seed) {
  const auto bytes = bytes_of(seed);
  fuzz::Choices choices(bytes.data(), bytes.size());
  Drawn drawn;
  drawn.fineness = fuzz::draw_fineness(choices);
  drawn.text = fuzz::TopologyDrawer(choices).draw();
  return drawn;
}

/// The message with placeholders for names and numbers of the plan; a list of names has one placeholder.
std::string kind_of(const std::string& message) {
  static const std::regex names("(port-|starboard-)?\\b[pqrtf][0-9]+(\\.[a-z0-9-]+)?( \\+ p[0-9.a-z-]+)*"),
      numbers("[+-]?[0-9]+(\\.[0-9]+)?"), lists("N and N(, N and N)+");
  const std::string unnamed = std::regex_replace(message, names, "N");
  return std::regex_replace(std::regex_replace(unnamed, numbers, "N"), lists, "several");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 3 && !std::strcmp(argv[1], "--show"))
    return std::fputs(draw(static_cast<unsigned>(std::atol(argv[2]))).text.c_str(), stdout), 0;
  const long count = argc == 2 ? std::atol(argv[1]) : 0;
  if (count <= 0) return std::fputs("usage: topologies COUNT[:SEED] | --show SEED\n", stderr), 2;
  const char* colon = std::strchr(argv[1], ':');
  const unsigned first = colon ? static_cast<unsigned>(std::atol(colon + 1)) : 1;
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL, SIGPROF}) std::signal(signal, say_seed);
  long meshed = 0, faulty = 0;
  double longest = 0;
  std::map<std::string, long> refusals;
  for (long k = 0; k < count; ++k) {
    seed_at_work = first + static_cast<unsigned>(k);
    start_clock();
    const std::clock_t begin = std::clock();
    const Drawn drawn = draw(seed_at_work);
    const auto trial = fuzz::try_topology(drawn.text, drawn.fineness);
    longest = std::max(longest, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    if (trial.is_meshed())
      ++meshed;
    else
      ++refusals[kind_of(trial.refusals.front())];
    if (!trial.faults.empty()) {
      ++faulty;
      std::printf("seed %u: %s (%zu)\n", seed_at_work, trial.faults.front().c_str(), trial.faults.size());
    }
  }
  std::vector<std::pair<long, std::string>> rows;
  for (const auto& [message, times] : refusals) rows.emplace_back(times, message);
  std::sort(rows.rbegin(), rows.rend());
  std::printf("| plans | what became of them |\n|---|---|\n| %ld | all |\n| %ld | meshed |\n", count, meshed);
  for (const auto& [times, message] : rows) std::printf("| %ld | refused: %s |\n", times, message.c_str());
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  std::printf("%ld faulty; the longest took %.2f s of processor time; %ld MB at most\n", faulty, longest,
              used.ru_maxrss / 1024);
  const bool reaches_the_mesher = 2 * meshed >= count;
  if (!reaches_the_mesher)
    std::puts("fewer than half of the plans were meshed: too many of the random plans are invalid");
  return faulty == 0 && reaches_the_mesher ? 0 : 1;
}
