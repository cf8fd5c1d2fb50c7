// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "io/formats/hdf5/handle.hpp"

namespace netloft::formats::test {

/// A fixture with an empty folder of its own.
class InScratchFolder : public testing::Test {
 protected:
  InScratchFolder() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) /
              ("netloft-" + std::string(info->test_suite_name()) + info->name() + std::to_string(getpid()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~InScratchFolder() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  std::filesystem::path in(const std::string& name) const { return folder_ / name; }

  void put(const std::string& name, const std::string& content) const { std::ofstream(in(name)) << content; }

  std::string bytes_of(const std::string& name) const {
    std::ifstream file(in(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  bool exists(const std::string& name) const { return std::filesystem::exists(in(name)); }

 private:
  std::filesystem::path folder_;
};

/// Runs `action` in its own process. Returns the exit status, or 1000 + the signal that killed the process.
template <class Action>
int run_in_child(Action&& action) {
  const pid_t child = fork();
  if (child == 0) {
    try {
      exit(action());
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s\n", error.what());
      exit(99);
    }
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
}

/// A process that calls `action` and then waits until this object is destroyed.
class Companion {
 public:
  template <class Action>
  explicit Companion(Action&& action) {
    int ready[2];
    if (pipe(ready) != 0) throw std::runtime_error("no pipe");
    child_ = fork();
    if (child_ == 0) {
      const auto held = action();
      if (write(ready[1], "x", 1) == 1) pause();
      _exit(0);
    }
    char byte = 0;
    if (read(ready[0], &byte, 1) != 1) throw std::runtime_error("the companion died");
    close(ready[0]);
    close(ready[1]);
  }
  ~Companion() {
    kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
  }

 private:
  pid_t child_;
};

/// Reopens HDF5 with this setting of file locking, because HDF5 reads its environment only when it is opened.
/// Call it in child processes only.
inline void restart_hdf5_with_locking(const char* setting) {
  setenv("HDF5_USE_FILE_LOCKING", setting, 1);
  H5close();
  H5open();
}

/// The message of the FileError that `action` throws; empty if there is none.
template <class Action>
std::string error_of(Action&& action) {
  try {
    action();
  } catch (const FileError& error) {
    return error.what();
  }
  return {};
}

inline bool says(const std::string& sentence, const std::string& part) {
  return sentence.find(part) != std::string::npos;
}

}  // namespace netloft::formats::test
