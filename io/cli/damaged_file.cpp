// SPDX-License-Identifier: BSD-3-Clause
#include "io/cli/damaged_file.hpp"

#include "io/cli/error_json.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace netloft::io {

namespace {

constexpr int kSignals[] = {SIGSEGV, SIGBUS, SIGABRT};

/// Texts that a signal handler may write, prepared while all is well.
struct Words {
  std::array<char, 4096> bytes{};
  std::size_t length = 0;

  void set(const std::string& text) {
    length = std::min(text.size(), bytes.size());
    std::memcpy(bytes.data(), text.data(), length);
  }
  void write(int stream) const {
    if (::write(stream, bytes.data(), length) < 0) return;
  }
};

Words sentence, object;

void end(int) {
  sentence.write(2);
  object.write(1);
  _exit(kWrongInput);
}

}  // namespace

DamagedFileWatch::DamagedFileWatch(const std::string& path, bool json) {
  const std::string message = "cannot read " + path + ": the HDF5 library crashed on it; the file is damaged";
  sentence.set("netloft: " + message + "\n");
  object.set(json ? error_json(message, kWrongInput) + "\n" : "");
  struct sigaction action {};
  action.sa_handler = end;
  for (std::size_t i = 0; i < 3; ++i) sigaction(kSignals[i], &action, &before_[i]);
}

DamagedFileWatch::~DamagedFileWatch() {
  for (std::size_t i = 0; i < 3; ++i) sigaction(kSignals[i], &before_[i], nullptr);
}

}  // namespace netloft::io
