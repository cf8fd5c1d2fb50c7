// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "io/hdf5/read.hpp"
#include "tests/unit/io/hdf5/scratch.hpp"
#include "tests/unit/io/hdf5/sheet.hpp"

namespace netloft::io {
namespace {

const test::Sheet kSheet{20, 10};

class KilledWriter : public test::InScratchFolder {
 protected:
  void expect_whole_states(const Reader& reader) const {
    const std::vector<double> times = reader.times();
    for (std::size_t i = 0; i < times.size(); ++i) {
      ASSERT_EQ(reader.points(i), kSheet.points(times[i])) << "state " << i << " of " << times.size();
      ASSERT_EQ(reader.field(Location::kCell, "strain", i), kSheet.strains(times[i]));
      ASSERT_EQ(reader.field(Location::kPoint, "part", i), kSheet.parts());
    }
  }

  /// Whether the file of a killed writer opens and holds what it had confirmed.
  bool holds(const std::filesystem::path& part, std::size_t n_confirmed) const {
    try {
      const Reader reader(part);
      EXPECT_GE(reader.times().size(), n_confirmed);
      expect_whole_states(reader);
      return true;
    } catch (const FileError&) {
      return false;
    }
  }
};

TEST_F(KilledWriter, LeavesAllFlushedStatesInThePart) {
  const pid_t child = fork();
  if (child == 0) {
    ResultFile file(in("a.hdf"));
    test::begin(file, kSheet);
    for (const double time : {0.0, 0.5, 1.0}) test::write_state(file, kSheet, time);
    file.tree().write_text("/netloft/lost", "never flushed");
    kill(getpid(), SIGKILL);
  }
  waitpid(child, nullptr, 0);
  EXPECT_FALSE(exists("a.hdf"));
  const Reader reader(in("a.hdf.part"));
  EXPECT_EQ(reader.times(), (std::vector<double>{0.0, 0.5, 1.0}));
  expect_whole_states(reader);
}

/// Writes states without end; one byte down the pipe for each that is on disk.
[[noreturn]] void write_for_ever(const std::filesystem::path& path, int confirm) {
  ResultFile file(path);
  test::begin(file, kSheet);
  for (int i = 0;; ++i) {
    test::write_state(file, kSheet, i);
    if (write(confirm, "x", 1) != 1) _exit(1);
  }
}

std::size_t drain(int fd) {
  char bytes[4096];
  std::size_t count = 0;
  for (ssize_t n = 0; (n = read(fd, bytes, sizeof bytes)) > 0;) count += static_cast<std::size_t>(n);
  return count;
}

// A kill in the instant when HDF5 rebuilds the index of an array's chunks leaves a file that it refuses:
// about 3 kills in a thousand were found to (README). What opens is whole.
TEST_F(KilledWriter, LosesConfirmedStatesInNextToNoKill) {
  std::mt19937 random(20240607);
  int lost = 0;
  for (int trial = 0; trial < 40; ++trial) {
    int confirmed[2];
    ASSERT_EQ(pipe(confirmed), 0);
    const pid_t child = fork();
    if (child == 0) write_for_ever(in("a.hdf"), confirmed[1]);
    close(confirmed[1]);
    char first = 0;
    ASSERT_EQ(read(confirmed[0], &first, 1), 1);
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 50000));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    const std::size_t n_confirmed = 1 + drain(confirmed[0]);
    close(confirmed[0]);
    lost += !holds(in("a.hdf.part"), n_confirmed);
  }
  EXPECT_LE(lost, 3);
}

}  // namespace
}  // namespace netloft::io
