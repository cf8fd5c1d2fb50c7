// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/files/whole_file.hpp"
#include "tests/folders.hpp"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <iterator>
#include <thread>
#include <vector>

namespace netloft::formats {
namespace {

namespace fs = std::filesystem;

class WholeFile : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(netloft::test::build_folder()) / "scratch" /
              ::testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  static std::string content(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::size_t count_files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {}));
  }
  fs::path folder_;
};

TEST_F(WholeFile, IsWrittenAndReplaced) {
  write_whole(folder_ / "a", "first, and longer");
  write_whole(folder_ / "a", "second");
  EXPECT_EQ(content(folder_ / "a"), "second");
  EXPECT_EQ(count_files(), 1u);
}
TEST_F(WholeFile, KeepsWhatItReplacesUnlessThatIsTheSame) {
  write_keeping(folder_ / "a", "first");
  EXPECT_EQ(count_files(), 1u);
  write_keeping(folder_ / "a", "first");
  EXPECT_EQ(count_files(), 1u);
  write_keeping(folder_ / "a", "second");
  EXPECT_EQ(content(folder_ / "a"), "second");
  EXPECT_EQ(content(folder_ / "a~"), "first");
  write_keeping(folder_ / "a", "third");
  EXPECT_EQ(content(folder_ / "a~"), "second");
  EXPECT_EQ(count_files(), 2u);
}
TEST_F(WholeFile, IsNotReplacedWhereItCannotBeKept) {
  write_whole(folder_ / "a", "first");
  fs::create_directories(folder_ / "a~" / "full");
  EXPECT_THROW(write_keeping(folder_ / "a", "second"), WriteError);
  EXPECT_EQ(content(folder_ / "a"), "first");
  EXPECT_EQ(count_files(), 2u);
}
TEST_F(WholeFile, IsReadOrThereIsNone) {
  EXPECT_EQ(read_whole(folder_ / "a"), std::nullopt);
  const std::string bytes("longer than a block\0and with a null", 35);
  std::string all;
  while (all.size() < 200000) all += bytes;
  write_whole(folder_ / "a", all);
  EXPECT_EQ(read_whole(folder_ / "a"), all);
  write_whole(folder_ / "empty", "");
  EXPECT_EQ(read_whole(folder_ / "empty"), "");
}
TEST_F(WholeFile, ThatMayNeverEndIsNotRead) {
  ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  for (const auto& path : {folder_ / "pipe", folder_, fs::path("/dev/zero")})
    EXPECT_THROW(read_whole(path), ReadError);
}
TEST_F(WholeFile, TakesThePlaceOfWhatAKilledWriterLeft) {
  std::ofstream(folder_ / "a.new") << "something longer that was never finished";
  write_whole(folder_ / "a", "whole");
  EXPECT_EQ(content(folder_ / "a"), "whole");
  EXPECT_EQ(count_files(), 1u);
}
TEST_F(WholeFile, DoesNotFollowALinkOrAPipeBeside) {
  std::ofstream(folder_ / "other") << "kept";
  fs::create_symlink(folder_ / "other", folder_ / "a.new");
  fs::create_hard_link(folder_ / "other", folder_ / "b.new");
  ASSERT_EQ(mkfifo((folder_ / "c.new").c_str(), 0600), 0);
  for (const char* name : {"a", "b", "c"}) write_whole(folder_ / name, "whole");
  EXPECT_EQ(content(folder_ / "other"), "kept");
  EXPECT_EQ(content(folder_ / "c"), "whole");
  EXPECT_EQ(count_files(), 4u);
}
TEST_F(WholeFile, IsAlwaysOneOfThoseThatSeveralWritersWrite) {
  constexpr int kTimes = 100;
  const std::string contents[] = {std::string(20000, 'a'), std::string(10, 'b'), std::string(70000, 'c')};
  write_whole(folder_ / "a", contents[0]);
  std::atomic<bool> ends = false;
  std::atomic<int> torn = 0, failed = 0;
  std::thread reader([&] {
    while (!ends)
      if (const auto read = content(folder_ / "a");
          std::find(std::begin(contents), std::end(contents), read) == std::end(contents))
        ++torn;
  });
  std::vector<std::thread> writers;
  for (const std::string& text : contents)
    writers.emplace_back([&] {
      for (int i = 0; i < kTimes; ++i) try {
          write_whole(folder_ / "a", text);
        } catch (const WriteError&) {
          ++failed;
        }
    });
  for (auto& writer : writers) writer.join();
  ends = true;
  reader.join();
  EXPECT_EQ(torn, 0);
  EXPECT_EQ(failed, 0);
  EXPECT_EQ(count_files(), 1u);
}

}  // namespace
}  // namespace netloft::formats
