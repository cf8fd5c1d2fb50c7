// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/session/memory_room.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include <cerrno>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace netloft::program {

namespace {

// OpenBLAS 0.3.21 requests 128 MiB at once (BUFFER_SIZE of x86-64, seen with strace); the rest is enough for
// the smallest scene.
constexpr std::size_t kMebibyte = std::size_t{1} << 20, kRoom = 144 * kMebibyte;

// A forecast is not reported if it is below this fraction of the available memory.
constexpr double kLittle = 0.25;

// Least measured memory of a run as a fraction of the forecast (io/runs/README.md).
constexpr double kSurely = 0.85;

std::string gibibytes(double bytes) { return fmt::format("{:.3g} GiB", bytes / 0x1p30); }

bool is_limited(int resource) {
  rlimit limit{};
  return getrlimit(static_cast<__rlimit_resource>(resource), &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
}

}  // namespace

void require_memory_to_solve() {
  if (!is_limited(RLIMIT_AS) && !is_limited(RLIMIT_DATA)) return;
  void* room = mmap(nullptr, kRoom, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (room == MAP_FAILED)
    throw std::runtime_error(
        fmt::format("not enough memory: solving needs {} MiB more than the limit on memory leaves ({}); "
                    "`ulimit -v` and `ulimit -d` show the limits",
                    kRoom / kMebibyte, std::strerror(errno)));
  munmap(room, kRoom);
}

std::string memory_text(const runs::MemoryForecast& f, double within_reach) {
  return fmt::format(
      "memory: about {}, {} of it for the factorised matrix{}; {}", gibibytes(f.total()), gibibytes(f.factor),
      f.stability > 0 ? ", " + gibibytes(f.stability) + " to judge stability" : "",
      within_reach < std::numeric_limits<double>::infinity() ? gibibytes(within_reach) + " are available"
                                                             : "the available memory is not known");
}

std::string note_of_memory(const runs::MemoryForecast& f, double within_reach) {
  if (f.total() <= kLittle * within_reach) return {};
  if (kSurely * f.total() > within_reach)
    throw std::runtime_error("not enough " + memory_text(f, within_reach) +
                             "; a coarser mesh takes less, such as fewer nodes of a gear or cells of a part");
  return memory_text(f, within_reach);
}

}  // namespace netloft::program
