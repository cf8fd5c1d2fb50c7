// SPDX-License-Identifier: BSD-3-Clause
// Tries random changes of the journal of a motion, NAME.hdf.part. Each input says how a good journal is
// changed: records are left out, repeated, or get another kind or other bytes, all with correct checksums;
// then bytes of the file are changed. The journal is read and reported as a result, and a run continues from
// it. The part that HDF5 itself reads, the image of all data known at the start, stays unchanged or refers to
// another file.
#include "io/formats/hdf5/series_journal.hpp"
#include "io/results/motion/checkpoint.hpp"
#include "io/results/text/result_text.hpp"
#include "io/results/text/tables.hpp"
#include "tests/fuzz/choices.hpp"
#include "tests/fuzz/lead_elsewhere.hpp"
#include "tests/fuzz/scratch_file.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace {

using namespace netloft;
namespace fs = std::filesystem;

constexpr std::uint32_t kLayout = 1;

struct Record {
  std::uint32_t kind = 0;
  std::string content;
  std::size_t whole_from = 0, whole_to = 0;  // bytes that are not changed
};

/// Protects the length of the image and the image, which follow the identity of the run, from changes.
void spare_image(Record& record) {
  formats::ByteReader from(record.content);
  record.whole_from = sizeof(std::uint64_t) + from.text().size();
  record.whole_to = record.whole_from + sizeof(std::uint64_t) + from.text().size();
}

struct GoodJournal {
  std::vector<Record> records;
  std::string identity;

  /// Reads the files that make_results.sh has put into the folder NETLOFT_FUZZ_RESULTS.
  GoodJournal() {
    const char* folder = std::getenv("NETLOFT_FUZZ_RESULTS");
    if (!folder)
      std::fputs("NETLOFT_FUZZ_RESULTS: name the folder that make_results.sh has filled\n", stderr),
          std::exit(1);
    formats::Journal::read(fs::path(folder) / "rope-that-runs.hdf.part",
                           [&](const auto& record, auto content) {
                             records.push_back({record.kind, std::string(content)});
                           });
    for (auto& record : records)
      if (record.kind == kLayout) {
        identity = formats::ByteReader(record.content).text();
        spare_image(record);
      }
  }
};

/// Overwrites, removes or inserts some bytes.
void change(Record& record, fuzz::Choices& source) {
  std::string& content = record.content;
  const std::size_t at = source.in<std::size_t>(0, content.size()), length = source.in<std::size_t>(1, 9);
  if (at + length > record.whole_from && at < record.whole_to) return;
  switch (source.in<int>(0, 3)) {
    case 0:
      content.resize(std::max(at, record.whole_to));
      return;
    case 1:
      content.insert(at, source.text(24));
      return;
    default: {
      const auto bytes = source.bytes(length);
      content.replace(at, bytes.size(), std::string(bytes.begin(), bytes.end()));
    }
  }
}

/// Changes the image by lead_elsewhere().
void change_image(Record& record, fuzz::Choices& source) {
  formats::ByteReader from(record.content);
  const std::size_t begin = sizeof(std::uint64_t) + from.text().size();
  const std::string image(from.text());
  const auto path =
      fuzz::write_scratch("image.h5", reinterpret_cast<const std::uint8_t*>(image.data()), image.size());
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  fuzz::lead_elsewhere(file, "/netloft/elsewhere", source.in<int>(1, fuzz::kWaysElsewhere));
  H5Fclose(file);
  std::ifstream in(path, std::ios::binary);
  const std::string changed{std::istreambuf_iterator<char>(in), {}};
  const std::uint64_t size = changed.size();
  record.content.replace(begin, sizeof size + image.size(),
                         std::string(reinterpret_cast<const char*>(&size), sizeof size) + changed);
}

void write_changed(const fs::path& path, const GoodJournal& good, fuzz::Choices& source) {
  formats::Journal journal = formats::Journal::create(path);
  for (Record record : good.records) {
    const int what = source.in<int>(0, 9);
    if (what == 1) continue;
    if (what == 2) record.kind = source.in<std::uint32_t>(0, 5);
    if (what == 3 || what == 4) change(record, source);
    if (what == 6 && record.kind == kLayout) change_image(record, source);
    for (int n = what == 5 ? 2 : 1; n > 0; --n) journal.append(record.kind, record.content);
  }
}

void damage(const fs::path& path, fuzz::Choices& source) {
  const auto size = static_cast<std::size_t>(fs::file_size(path));
  std::FILE* file = std::fopen(path.c_str(), "r+b");
  for (int n = source.in<int>(0, 2); n > 0; --n) {
    std::fseek(file, static_cast<long>(source.in<std::size_t>(0, size - 1)), SEEK_SET);
    std::fputc(source.any<std::uint8_t>(), file);
  }
  std::fclose(file);
}

void read(const fs::path& path) {
  try {
    const results::StoredShape shape(path);
    fuzz::use(results::result_text(shape.result).size() + results::result_json(shape.result).size());
    fuzz::use(results::nodes_csv(shape, 0).size() + results::elements_csv(shape, 0).size());
  } catch (const formats::FileError& e) {
    fuzz::use(std::strlen(e.what()));
  }
}

void go_on(const fs::path& path, const std::string& identity) {
  try {
    formats::SeriesJournal series = formats::SeriesJournal::go_on(path, identity);
    fuzz::use(results::unpack_checkpoint(series.checkpoint()).state.u.size());
    const formats::SeriesState last = series.state(series.size() - 1);
    for (std::size_t i = 0; i < series.size(); ++i) fuzz::use(series.state(i).points.size());
    series.write(last, series.checkpoint());
  } catch (const formats::FileError& e) {
    fuzz::use(std::strlen(e.what()));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const GoodJournal good;
  formats::silence_hdf5();
  fuzz::Choices source(data, size);
  const auto path = fuzz::scratch_folder() / "r.hdf.part";
  write_changed(path, good, source);
  damage(path, source);
  read(path);
  go_on(path, good.identity);
  read(path);
  return 0;
}
