// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "io/formats/hdf5/fold.hpp"
#include "io/formats/hdf5/image.hpp"
#include "io/formats/hdf5/read.hpp"
#include "tests/support/work_notes.hpp"
#include "tests/unit/io/formats/hdf5/scratch.hpp"
#include "tests/unit/io/formats/hdf5/sheet.hpp"

namespace netloft::formats {
namespace {

using test::error_of;
using test::says;

const test::Sheet kSheet{20, 10};

SeriesLayout layout() {
  return {kSheet.mesh(),
          {test::height_spec(), test::velocity_spec(), test::strain_spec()},
          {test::part_field(kSheet)},
          {{"drag", "N", "drag of the sheet"}, {"gear/mouth/area", "m2", "of the mouth"}}};
}

SeriesState state(double time) {
  return {time,
          kSheet.points(time),
          {kSheet.heights(time), kSheet.points(time), kSheet.strains(time)},
          {10 * time, 20 * time}};
}

class Series : public test::InScratchFolder {
 protected:
  SeriesJournal begin(const std::string& name = "a.hdf.part") const {
    return SeriesJournal::create(in(name), "this run", "", layout());
  }
  /// Writes a journal of outputs, each with a checkpoint that contains its time.
  SeriesJournal written(const std::vector<double>& times) const {
    SeriesJournal journal = begin();
    for (const double time : times) journal.write(state(time), "after " + std::to_string(time));
    return journal;
  }
  void expect_states(const Reader& reader, const std::vector<double>& times) const {
    ASSERT_EQ(reader.times(), times);
    for (std::size_t i = 0; i < times.size(); ++i) {
      ASSERT_EQ(reader.points(i), kSheet.points(times[i])) << "state " << i << " of " << times.size();
      ASSERT_EQ(reader.field(Location::kCell, "strain", i), kSheet.strains(times[i]));
      ASSERT_EQ(reader.field(Location::kPoint, "part", i), kSheet.parts());
    }
  }
};

TEST_F(Series, BecomesAResultWithAllItsStates) {
  SeriesJournal journal = written({0.0, 0.5, 1.0});
  make_result(journal, in("a.hdf"), [](Tree& tree) { tree.write_int("/netloft/mark", 7, "1"); });
  const Reader reader(in("a.hdf"));
  expect_states(reader, {0.0, 0.5, 1.0});
  EXPECT_EQ(reader.reals("/netloft/series/drag"), (std::vector<double>{0, 5, 10}));
  EXPECT_EQ(reader.text_attribute("/netloft/series/drag", "unit"), "N");
  EXPECT_EQ(reader.integer("/netloft/mark"), 7);
  EXPECT_FALSE(exists("a.hdf.new"));
  EXPECT_TRUE(exists("a.hdf.part")) << "it goes when its owner says so";
  journal.remove();
  EXPECT_FALSE(exists("a.hdf.part"));
}

TEST_F(Series, IsReadWhileItGrows) {
  SeriesJournal journal = written({0.0, 0.5});
  const Reader reader(in("a.hdf.part"));
  expect_states(reader, {0.0, 0.5});
  EXPECT_EQ(reader.text_attribute("/netloft/status", "outcome"), "running");
  EXPECT_EQ(reader.real("/netloft/scalars/drag"), 5);
  EXPECT_EQ(reader.real("/netloft/gear/mouth/area"), 10);
  journal.write(state(1.0), "");
  expect_states(Reader(in("a.hdf.part")), {0.0, 0.5, 1.0});
}

/// The heights never change; the strains change at time 1. A resumed run must write the same file as a run
/// without a kill.
TEST_F(Series, HoldsAFieldOnceAsLongAsItStays) {
  const auto output = [](double time) {
    SeriesState s = state(time);
    s.fields[0] = kSheet.heights(0), s.fields[2] = kSheet.strains(time < 1 ? 0 : 1);
    return s;
  };
  const std::vector<double> times = {0, 0.25, 0.5, 0.75, 1, 1.25};
  const auto write = [&](SeriesJournal& journal, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) journal.write(output(times[i]), i < 3 ? "here" : "");
  };
  SeriesJournal whole = begin("whole.hdf.part");
  write(whole, 0, 6), make_result(whole, in("whole.hdf"), [](Tree&) {});
  {
    SeriesJournal killed = begin("killed.hdf.part");
    write(killed, 0, 5);
  }
  SeriesJournal other = SeriesJournal::go_on(in("killed.hdf.part"), "this run");
  ASSERT_EQ(other.size(), 3u);
  write(other, 3, 6), make_result(other, in("killed.hdf"), [](Tree&) {});
  for (const char* name : {"whole.hdf", "killed.hdf", "whole.hdf.part", "killed.hdf.part"}) {
    const Reader reader(in(name));
    ASSERT_EQ(reader.times(), times) << name;
    for (std::size_t i = 0; i < times.size(); ++i) {
      EXPECT_EQ(reader.points(i), kSheet.points(times[i])) << name << i;
      EXPECT_EQ(reader.field(Location::kPoint, "height", i), kSheet.heights(0)) << name << i;
      EXPECT_EQ(reader.field(Location::kCell, "strain", i), kSheet.strains(i < 4 ? 0 : 1)) << name << i;
    }
    EXPECT_EQ(reader.shape("/VTKHDF/PointData/height")[0], kSheet.mesh().n_points) << name;
    EXPECT_EQ(reader.shape("/VTKHDF/CellData/strain")[0], 2 * kSheet.mesh().n_cells()) << name;
  }
  EXPECT_EQ(whole.state(5).fields[0], kSheet.heights(0));
}

TEST_F(Series, SaysHowItStandsAndWhatItWasMadeFrom) {
  const std::string origins =
      hdf5_image([](Tree& tree) { tree.write_text("/netloft/provenance/version", "0.1"); });
  SeriesJournal journal = SeriesJournal::create(in("a.hdf.part"), "this run", origins, layout());
  journal.write(state(0), "");
  journal.set_status({"interrupted", "at t = 0 s"});
  const Reader reader(in("a.hdf.part"));
  EXPECT_EQ(reader.text_attribute("/netloft/status", "outcome"), "interrupted");
  EXPECT_EQ(reader.text_attribute("/netloft/status", "sentence"), "at t = 0 s");
  EXPECT_EQ(reader.text("/netloft/provenance/version"), "0.1");
}

TEST_F(Series, WithoutOutputsHoldsNoShape) {
  begin();
  EXPECT_FALSE(Reader(in("a.hdf.part")).has("/VTKHDF"));
}

TEST_F(Series, WhoseRecordsDoNotFitTogetherIsRefused) {
  const auto refuses = [&](const std::function<void(SeriesJournal&)>& spoil) {
    SeriesJournal journal = begin();
    journal.write(state(0), "after 0");
    spoil(journal);
    return error_of([&] { Reader(in("a.hdf.part")); });
  };
  SeriesState few_points = state(1), few_numbers = state(1);
  few_points.points.pop_back(), few_numbers.row.pop_back();
  const std::string words = "the records of the motion contradict each other";
  EXPECT_PRED2(says, refuses([&](auto& j) { j.write(few_points, "after 1"); }), words);
  EXPECT_PRED2(says, refuses([&](auto& j) { j.write(few_numbers, "after 1"); }), words);
  EXPECT_PRED2(says, refuses([&](auto& j) { j.set_status({"running", std::string("a\0b", 3)}); }), words);
}

TEST_F(Series, GoesOnFromItsLastCheckpoint) {
  {
    SeriesJournal journal = written({0.0, 0.25});
    journal.write(state(0.5), "");
    journal.write(state(0.75), "");
  }
  SeriesJournal journal = SeriesJournal::go_on(in("a.hdf.part"), "this run");
  EXPECT_EQ(journal.checkpoint(), "after " + std::to_string(0.25));
  EXPECT_EQ(journal.size(), 2u);
  EXPECT_EQ(SeriesJournal::read(in("a.hdf.part")).size(), 4u) << "nothing is given up before there is more";
  journal.write(state(1.0), "after the end");
  expect_states(Reader(in("a.hdf.part")), {0.0, 0.25, 1.0});
  make_result(journal, in("a.hdf"), [](Tree&) {});
  expect_states(Reader(in("a.hdf")), {0.0, 0.25, 1.0});
}

TEST_F(Series, GoesOnOnlyAsTheSameRunWithTheSameFields) {
  written({0.0});
  EXPECT_TRUE(says(error_of([&] { SeriesJournal::go_on(in("a.hdf.part"), "other"); }), "another scene"));
  const SeriesJournal journal = SeriesJournal::go_on(in("a.hdf.part"), "this run");
  EXPECT_NO_THROW(journal.require_layout(layout()));
  SeriesLayout other = layout();
  other.columns[0].unit = "kN";
  EXPECT_TRUE(says(error_of([&] { journal.require_layout(other); }), "another version of the program"));
}

TEST_F(Series, WithoutACheckpointHasNothingToGoOnFrom) {
  begin();
  EXPECT_TRUE(says(error_of([&] { SeriesJournal::go_on(in("a.hdf.part"), "this run"); }),
                   "no output from which to continue"));
}

TEST_F(Series, StaysWhereNoResultCanBeMadeOfIt) {
  SeriesJournal journal = written({0.0, 1.0});
  const std::string before = bytes_of("a.hdf.part");
  std::filesystem::create_directory(in("a.hdf.new"));
  EXPECT_TRUE(says(error_of([&] { make_result(journal, in("a.hdf"), [](Tree&) {}); }), "a.hdf.new"));
  EXPECT_EQ(bytes_of("a.hdf.part"), before);
  EXPECT_FALSE(exists("a.hdf"));
}

TEST_F(Series, StaysIfItsResultIsInterrupted) {
  SeriesJournal journal = written({0.0, 1.0});
  const std::string before = bytes_of("a.hdf.part");
  {
    const netloft::test::WorkNotes notes("writing " + in("a.hdf.new").string());
    EXPECT_THROW(make_result(journal, in("a.hdf"), [](Tree&) {}), Interrupted);
  }
  EXPECT_EQ(bytes_of("a.hdf.part"), before);
  EXPECT_FALSE(exists("a.hdf"));
  EXPECT_FALSE(exists("a.hdf.new"));
  make_result(journal, in("a.hdf"), [](Tree&) {});
  expect_states(Reader(in("a.hdf")), {0.0, 1.0});
}

/// Writes outputs without end, and one byte into the pipe `confirm` after each output that would survive a
/// kill.
[[noreturn]] void write_for_ever(const std::filesystem::path& part, int confirm) {
  SeriesJournal journal = SeriesJournal::create(part, "this run", "", layout());
  for (int i = 0;; ++i) {
    journal.write(state(i), "x");
    if (write(confirm, "x", 1) != 1) _exit(1);
  }
}

std::size_t drain(int fd) {
  char bytes[4096];
  std::size_t count = 0;
  for (ssize_t n = 0; (n = read(fd, bytes, sizeof bytes)) > 0;) count += static_cast<std::size_t>(n);
  return count;
}

TEST_F(Series, LosesNoOutputToAnyKill) {
  std::mt19937 random(20240607);
  for (int trial = 0; trial < 40; ++trial) {
    int confirmed[2];
    ASSERT_EQ(pipe(confirmed), 0);
    const pid_t child = fork();
    if (child == 0) write_for_ever(in("a.hdf.part"), confirmed[1]);
    close(confirmed[1]);
    char first = 0;
    ASSERT_EQ(read(confirmed[0], &first, 1), 1);
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 20000));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    const std::size_t least = 1 + drain(confirmed[0]);
    close(confirmed[0]);
    const SeriesJournal left = SeriesJournal::read(in("a.hdf.part"));
    ASSERT_GE(left.size(), least);
    for (std::size_t i = 0; i < left.size(); ++i)
      ASSERT_EQ(left.state(i).points, kSheet.points(static_cast<double>(i)));
  }
}

}  // namespace
}  // namespace netloft::formats
