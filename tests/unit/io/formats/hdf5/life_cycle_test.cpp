// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/resource.h>

#include <csignal>
#include <memory>

#include "io/formats/hdf5/read.hpp"
#include "tests/unit/io/formats/hdf5/scratch.hpp"
#include "tests/unit/io/formats/hdf5/sheet.hpp"

namespace netloft::formats {
namespace {

using test::error_of;
using test::says;

class LifeCycle : public test::InScratchFolder {
 protected:
  /// Writes a finished result, which `mark` identifies.
  void write_result(const std::string& name, std::int64_t mark) const {
    ResultFile file(in(name));
    file.tree().write_int("/netloft/mark", mark, "1");
    file.finish();
  }
  std::int64_t mark_of(const std::string& name) const { return Reader(in(name)).integer("/netloft/mark"); }
};

TEST_F(LifeCycle, GrowsAsPartAndTakesItsNameWhenFinished) {
  ResultFile file(in("a.hdf"));
  EXPECT_TRUE(exists("a.hdf.part"));
  EXPECT_FALSE(exists("a.hdf"));
  file.finish();
  EXPECT_FALSE(exists("a.hdf.part"));
  EXPECT_FALSE(exists("a.hdf~"));
  EXPECT_EQ(Reader(in("a.hdf")).real_attribute("/netloft", "schema"), 1);
}

TEST_F(LifeCycle, WithoutFinishThePartStaysAndTheEarlierResultIsUntouched) {
  write_result("a.hdf", 1);
  {
    ResultFile file(in("a.hdf"));
    file.tree().write_int("/netloft/mark", 2, "1");
  }
  EXPECT_EQ(mark_of("a.hdf"), 1);
  EXPECT_EQ(mark_of("a.hdf.part"), 2);
  EXPECT_FALSE(exists("a.hdf~"));
}

TEST_F(LifeCycle, TheEarlierResultIsKeptAsBackup) {
  write_result("a.hdf", 1);
  write_result("a.hdf", 2);
  EXPECT_EQ(mark_of("a.hdf"), 2);
  EXPECT_EQ(mark_of("a.hdf~"), 1);
  write_result("a.hdf", 3);
  EXPECT_EQ(mark_of("a.hdf"), 3);
  EXPECT_EQ(mark_of("a.hdf~"), 2);
  EXPECT_FALSE(exists("a.hdf~.new"));
}

TEST_F(LifeCycle, ABackupThatAlreadyIsTheResultDoesNotConfuse) {
  write_result("a.hdf", 1);
  // state of the folder after a kill between the two renames
  std::filesystem::create_hard_link(in("a.hdf"), in("a.hdf~"));
  write_result("a.hdf", 2);
  EXPECT_EQ(mark_of("a.hdf"), 2);
  EXPECT_EQ(mark_of("a.hdf~"), 1);
  EXPECT_FALSE(exists("a.hdf~.new"));
}

TEST_F(LifeCycle, TheResultHasItsNameAtEveryInstant) {
  write_result("a.hdf", 0);
  const pid_t watcher = fork();
  if (watcher == 0) {
    for (int i = 0; i < 400000; ++i)
      if (access(in("a.hdf").c_str(), F_OK) != 0) _exit(1);
    _exit(0);
  }
  int status = 0;
  for (int mark = 1; waitpid(watcher, &status, WNOHANG) == 0; ++mark) write_result("a.hdf", mark);
  EXPECT_EQ(status, 0);
}

TEST_F(LifeCycle, APartOfADeadWriterIsReplaced) {
  put("a.hdf.part", "not even HDF5");
  write_result("a.hdf", 7);
  EXPECT_EQ(mark_of("a.hdf"), 7);
  EXPECT_FALSE(exists("a.hdf.part"));
}

TEST_F(LifeCycle, APartOfALiveWriterIsRefusedAndUnharmed) {
  ResultFile first(in("a.hdf"));
  first.tree().write_int("/netloft/mark", 1, "1");
  const std::string message = error_of([&] { ResultFile second(in("a.hdf")); });
  EXPECT_TRUE(says(message, "a.hdf.part: another process is writing it now")) << message;
  first.finish();
  EXPECT_EQ(mark_of("a.hdf"), 1);
}

TEST_F(LifeCycle, APartOfALiveWriterInAnotherProcessIsRefused) {
  {
    const test::Companion writer([&] { return std::make_unique<ResultFile>(in("a.hdf")); });
    EXPECT_TRUE(says(error_of([&] { ResultFile file(in("a.hdf")); }), "another process"));
  }
  EXPECT_NO_THROW(ResultFile file(in("a.hdf")));
}

TEST_F(LifeCycle, AViewerOfAnOldPartKeepsItsBytes) {
  put("a.hdf.part", "old bytes");
  const int viewer = open(in("a.hdf.part").c_str(), O_RDONLY);
  ASSERT_EQ(flock(viewer, LOCK_SH), 0);
  write_result("a.hdf", 1);
  char seen[9] = {};
  EXPECT_EQ(pread(viewer, seen, 9, 0), 9);
  EXPECT_EQ(std::string(seen, 9), "old bytes");
  close(viewer);
}

TEST_F(LifeCycle, HoldsWhateverHdf5IsToldAboutLocking) {
  for (const char* setting : {"TRUE", "FALSE", "BEST_EFFORT"}) {
    const auto write_and_refuse_another = [&] {
      test::restart_hdf5_with_locking(setting);
      ResultFile first(in("a.hdf"));
      const bool refused = says(error_of([&] { ResultFile second(in("a.hdf")); }), "another process");
      first.finish();
      return refused ? 0 : 1;
    };
    EXPECT_EQ(test::run_in_child(write_and_refuse_another), 0) << setting;
  }
}

TEST_F(LifeCycle, AMissingFolderIsNamed) {
  const std::string message = error_of([&] { ResultFile file(in("none") / "a.hdf"); });
  EXPECT_TRUE(says(message, "the folder " + in("none").string() + " does not exist")) << message;
}

TEST_F(LifeCycle, AFolderOfThatNameIsRefused) {
  std::filesystem::create_directory(in("a.hdf"));
  EXPECT_TRUE(says(error_of([&] { ResultFile file(in("a.hdf")); }), "is a folder"));
  EXPECT_TRUE(says(error_of([&] { ResultFile file(in("b") / ""); }), "names no file"));
}

TEST_F(LifeCycle, AFolderWithoutWritePermissionIsAnError) {
  constexpr uid_t kNobody = 65534;
  std::filesystem::permissions(in(""),
                               std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec |
                                   std::filesystem::perms::others_read | std::filesystem::perms::others_exec);
  const bool is_root = geteuid() == 0;  // file permissions do not restrict root
  ASSERT_EQ(is_root ? seteuid(kNobody) : 0, 0);
  const std::string message = error_of([&] { ResultFile file(in("a.hdf")); });
  ASSERT_EQ(is_root ? seteuid(0) : 0, 0);
  std::filesystem::permissions(in(""), std::filesystem::perms::owner_all);
  EXPECT_TRUE(says(message, "a.hdf.part: Permission denied")) << message;
}

/// Writes under a limit on the file size, at which writing fails as on a full disk.
int write_on_a_full_disk(const std::filesystem::path& path, const std::filesystem::path& another) {
  std::signal(SIGXFSZ, SIG_IGN);
  {
    ResultFile file(path);
    const test::Sheet sheet{100, 10};
    test::begin(file, sheet, 101);
    test::write_state(file, sheet, 0.25);
    const rlimit limit = {static_cast<rlim_t>(std::filesystem::file_size(file.part_path())) + 20000,
                          RLIM_INFINITY};
    setrlimit(RLIMIT_FSIZE, &limit);
    const std::string message = error_of([&] {
      for (int i = 0; i < 100; ++i) test::write_state(file, sheet, 0.5);
    });
    if (!says(message, "cannot write") || !says(message, "File too large")) return 1;
  }
  ResultFile(another).finish();
  return 0;
}

TEST_F(LifeCycle, AFullDiskIsAnErrorThatLeavesTheEarlierResultAndOtherFilesAlone) {
  write_result("a.hdf", 1);
  EXPECT_EQ(test::run_in_child([&] { return write_on_a_full_disk(in("a.hdf"), in("b.hdf")); }), 0);
  EXPECT_EQ(mark_of("a.hdf"), 1);
  EXPECT_FALSE(exists("a.hdf~"));
  EXPECT_NO_THROW(Reader(in("b.hdf")));
}

TEST_F(LifeCycle, NothingCanBeWrittenAfterFinish) {
  ResultFile file(in("a.hdf"));
  file.finish();
  EXPECT_NO_THROW(file.finish());
  EXPECT_FALSE(error_of([&] { file.tree().write_int("/netloft/late", 1, "1"); }).empty());
}

TEST_F(LifeCycle, EqualContentGivesEqualBytes) {
  for (const char* name : {"a.hdf", "b.hdf"}) {
    ResultFile file(in(name));
    const test::Sheet sheet;
    test::begin(file, sheet, 3);
    for (const double time : {0.0, 0.5, 1.0}) test::write_state(file, sheet, time);
    file.tree().write_text("/netloft/text", "same");
    file.finish();
    sleep(name[0] == 'a' ? 1 : 0);  // time stamps count seconds
  }
  EXPECT_TRUE(bytes_of("a.hdf") == bytes_of("b.hdf"));
}

}  // namespace
}  // namespace netloft::formats
