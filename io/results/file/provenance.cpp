// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/file/provenance.hpp"

#include <sys/utsname.h>

#include <ctime>
#include <fstream>

namespace netloft::results {

std::string program_version() { return NETLOFT_VERSION; }

std::string compiler_description() { return std::string(NETLOFT_COMPILER) + " " + __VERSION__; }

std::string machine_description() {
  utsname name{};
  uname(&name);
  std::string processor, line;
  for (std::ifstream info("/proc/cpuinfo"); std::getline(info, line);)
    if (line.starts_with("model name") && line.find(':') != std::string::npos) {
      processor = ", " + line.substr(line.find(':') + 2);
      break;
    }
  return std::string(name.nodename) + ", " + name.sysname + " " + name.release + " " + name.machine +
         processor;
}

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

}  // namespace netloft::results
