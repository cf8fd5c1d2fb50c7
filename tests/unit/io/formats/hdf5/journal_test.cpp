// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/hdf5/journal.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <zlib.h>

#include <cstring>

#include "tests/unit/io/formats/hdf5/scratch.hpp"

namespace netloft::formats {
namespace {

using test::error_of;
using test::says;

class RecordsOfAJournal : public test::InScratchFolder {
 protected:
  using Contents = std::vector<std::pair<std::uint32_t, std::string>>;

  /// Three records of different lengths, one of them without any content.
  void SetUp() override {
    Journal journal = Journal::create(in("a"));
    for (const auto& [kind, content] : kThree) journal.append(kind, content);
  }
  static Journal::Visit into(Contents& contents) {
    return [&](const Journal::Record& record, std::string_view content) {
      contents.emplace_back(record.kind, content);
    };
  }
  Contents contents_of(const std::string& name) const {
    Contents contents;
    Journal::read(in(name), into(contents));
    return contents;
  }

  const Contents kThree = {{1, "first"}, {7, ""}, {2, std::string("third\0with a NUL", 16)}};
};

TEST_F(RecordsOfAJournal, ComeBackInTheirOrder) { EXPECT_EQ(contents_of("a"), kThree); }

TEST_F(RecordsOfAJournal, AreReadWhereTheyLie) {
  std::vector<Journal::Record> records;
  const Journal journal = Journal::read(
      in("a"), [&](const Journal::Record& record, std::string_view) { records.push_back(record); });
  EXPECT_EQ(journal.content(records.at(2)), kThree[2].second);
  EXPECT_EQ(journal.content(records.at(0)), kThree[0].second);
}

TEST_F(RecordsOfAJournal, CountUpToTheOneThatAKillCutWhereverItCut) {
  const std::string whole = bytes_of("a");
  const std::size_t last = 16 + kThree[2].second.size() + 4;
  for (std::size_t cut = 1; cut <= last; ++cut) {
    put("cut", whole.substr(0, whole.size() - cut));
    EXPECT_EQ(contents_of("cut"), Contents(kThree.begin(), kThree.begin() + 2)) << cut;
    Contents before;
    Journal journal = Journal::go_on(in("cut"), into(before));
    journal.append(2, kThree[2].second);
    EXPECT_EQ(bytes_of("cut"), whole) << cut;
  }
}

TEST_F(RecordsOfAJournal, AreNotChangedByOpeningOneToGoOn) {
  put("cut", bytes_of("a") + "remainder");
  const std::string before = bytes_of("cut");
  Contents contents;
  Journal::go_on(in("cut"), into(contents));
  EXPECT_EQ(bytes_of("cut"), before);
}

TEST_F(RecordsOfAJournal, AreNeverReadWrongWhateverBitIsFlipped) {
  const std::string whole = bytes_of("a");
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    std::string flipped = whole;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << bit % 8));
    put("flipped", flipped);
    EXPECT_TRUE(says(error_of([&] { contents_of("flipped"); }), "cannot read " + in("flipped").string()))
        << "bit " << bit;
  }
}

TEST_F(RecordsOfAJournal, BeforeADamageAreGoneOnFromAndTheDamagedFileIsKept) {
  const std::string whole = bytes_of("a");
  const std::size_t second = 16 + 16 + 5 + 4;  // behind the head of the file and the first record
  for (std::size_t byte = second; byte < whole.size(); ++byte) {
    std::string flipped = whole;
    flipped[byte] = static_cast<char>(flipped[byte] ^ 4);
    put("flipped", flipped);
    Contents before;
    Journal journal = Journal::go_on(in("flipped"), into(before));
    EXPECT_TRUE(says(journal.damage(), "does not match its checksum")) << byte;
    EXPECT_EQ(bytes_of("flipped"), flipped) << "opening it changed it";
    ASSERT_EQ(before, Contents(kThree.begin(), kThree.begin() + std::ptrdiff_t(before.size())));
    EXPECT_EQ(before.size(), byte < second + 20 ? 1u : 2u);
    journal.append(9, "anew");
    EXPECT_EQ(contents_of("flipped").back(), (Contents::value_type{9, "anew"}));
    EXPECT_EQ(bytes_of("flipped~"), flipped);
  }
}

TEST_F(RecordsOfAJournal, AreFollowedByZerosWhereAPowerCutLeftThem) {
  put("blank", bytes_of("a") + std::string(5000, '\0'));
  EXPECT_EQ(contents_of("blank"), kThree);
  put("other", bytes_of("a") + std::string(5000, '\0') + "x");
  EXPECT_TRUE(says(error_of([&] { contents_of("other"); }), "does not match its checksum"));
}

TEST_F(RecordsOfAJournal, OfANewerFormatAreRefused) {
  std::string bytes = bytes_of("a");
  bytes[8] = 3;
  const auto sum =
      static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const unsigned char*>(bytes.data()), 12));
  std::memcpy(bytes.data() + 12, &sum, sizeof sum);
  put("newer", bytes);
  EXPECT_TRUE(says(error_of([&] { contents_of("newer"); }),
                   "written by a newer netloft, in format 3; this program reads format 2"));
}

TEST_F(RecordsOfAJournal, AreNoneInAnotherFile) {
  put("b", "[water]\ndensity = 1025\n");
  EXPECT_FALSE(is_journal(in("b")));
  EXPECT_FALSE(is_journal(in("none")));
  EXPECT_TRUE(is_journal(in("a")));
  EXPECT_TRUE(says(error_of([&] { contents_of("b"); }), "it is not the journal of a motion"));
}

TEST_F(RecordsOfAJournal, HaveOneWriterAndAnyNumberOfReaders) {
  const test::Companion writer([&] {
    return std::make_unique<Journal>(
        Journal::go_on(in("a"), [](const Journal::Record&, std::string_view) {}));
  });
  EXPECT_EQ(contents_of("a"), kThree);
  Contents none;
  EXPECT_TRUE(says(error_of([&] { Journal::go_on(in("a"), into(none)); }), "another process is writing it"));
  EXPECT_TRUE(says(error_of([&] { Journal::create(in("a")); }), "another process is writing it"));
  EXPECT_EQ(contents_of("a"), kThree);
}

TEST_F(RecordsOfAJournal, StayWhenTheDiskIsFullAndMoreFollowOnceItIsNot) {
  const auto append_to_a_full_disk = [&] {
    std::signal(SIGXFSZ, SIG_IGN);
    Contents before;
    Journal journal = Journal::go_on(in("a"), into(before));
    const rlimit small = {4096, RLIM_INFINITY}, large = {RLIM_INFINITY, RLIM_INFINITY};
    setrlimit(RLIMIT_FSIZE, &small);
    if (!says(error_of([&] { journal.append(3, std::string(10000, 'x')); }), "File too large")) return 1;
    if (contents_of("a") != kThree) return 2;
    setrlimit(RLIMIT_FSIZE, &large);
    journal.append(3, "fourth");
    return contents_of("a").size() == 4 && contents_of("a").back().second == "fourth" ? 0 : 3;
  };
  EXPECT_EQ(test::run_in_child(append_to_a_full_disk), 0);
}

}  // namespace
}  // namespace netloft::formats
