// SPDX-License-Identifier: BSD-3-Clause
#include "io/cli/memory_room.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include <cerrno>
#include <cstring>

namespace netloft::io {

namespace {

// OpenBLAS 0.3.21 asks for 128 MiB at once (BUFFER_SIZE of x86-64, seen with strace); the rest is for the
// smallest scene beside it.
constexpr std::size_t kMebibyte = std::size_t{1} << 20, kRoom = 144 * kMebibyte;

bool is_limited(int resource) {
  rlimit limit{};
  return getrlimit(static_cast<__rlimit_resource>(resource), &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
}

}  // namespace

std::string lack_of_memory() {
  if (!is_limited(RLIMIT_AS) && !is_limited(RLIMIT_DATA)) return {};
  void* room = mmap(nullptr, kRoom, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (room == MAP_FAILED)
    return fmt::format(
        "not enough memory: solving wants {} MiB more than the limit on memory leaves ({}); "
        "`ulimit -v` and `ulimit -d` show the limits",
        kRoom / kMebibyte, std::strerror(errno));
  munmap(room, kRoom);
  return {};
}

}  // namespace netloft::io
