// SPDX-License-Identifier: BSD-3-Clause
// Tries random files of a study. The first byte of an input says what the rest is: `m` a manifest, `r` the
// record of an item, whose checksum is corrected so that the record gets into tables and plots; otherwise it
// is a study file, which is planned if it is small.
#include "io/formats/files/whole_file.hpp"
#include "io/studies/sweep/manifest.hpp"
#include "io/studies/sweep/study_plots.hpp"
#include "tests/fuzz/scratch_file.hpp"

#include <zlib.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

using namespace netloft;

constexpr double kFewPoints = 500;

studies::VariableValue number(double value) { return {std::to_string(value), value}; }

/// A study with one item, whose hash is 1: two points along a path.
studies::Study small_study() {
  studies::Study study;
  study.name = "small", study.scene = "scene.toml";
  studies::StudyColumn speed;
  speed.variable.name = "speed", speed.variable.unit = "kn", speed.is_in_path = true;
  study.columns.push_back(speed);
  studies::StudyItem item;
  item.id = 1, item.hash = "fnv1a64:1";
  item.points = {{{"tow.speed=2"}, {number(2)}}, {{"tow.speed=3"}, {number(3)}}};
  study.items.push_back(item);
  return study;
}

void write_record(const studies::Study& study, std::string_view text) {
  const auto path = studies::record_path(fuzz::scratch_folder(), study.items.front());
  std::filesystem::create_directories(path.parent_path());
  char sum[32];
  std::snprintf(sum, sizeof sum, "crc32 %08lx\n",
                crc32_z(0, reinterpret_cast<const Bytef*>(text.data()), text.size()));
  const std::string whole = std::string(text) + sum;
  fuzz::write_scratch("items/" + path.filename().string(),
                      reinterpret_cast<const std::uint8_t*>(whole.data()), whole.size());
}

void collect_record(std::string_view text) {
  static const studies::Study study = small_study();
  write_record(study, text);
  const studies::StudyTable table = studies::collect_table(study, fuzz::scratch_folder());
  fuzz::use(studies::study_csv(table).size() + studies::study_hdf5(study, table).size());
  fuzz::use(studies::costs_csv(study, fuzz::scratch_folder()).size());
  try {
    for (const auto& plot : studies::plots_of(table, {})) fuzz::use(formats::draw_svg(plot).size());
  } catch (const studies::StudyError& e) {
    fuzz::use(std::string_view(e.what()).size());
  }
}

void read_manifest(const std::filesystem::path& path) {
  try {
    fuzz::use(studies::manifest_text(studies::read_manifest(path)).size());
  } catch (const studies::StudyError& e) {
    fuzz::use(std::string_view(e.what()).size());
  }
}

/// Plans a study; its manifest must be read back as it was written.
void plan(const std::filesystem::path& path) {
  formats::Diagnostics diagnostics;
  const studies::StudyFile file = studies::read_study_file(path, diagnostics);
  fuzz::use(diagnostics.render(false).size());
  if (diagnostics.errors() || studies::count_points(file) > kFewPoints) return;
  const std::string text =
      studies::manifest_text(studies::make_study(file, file.scene, {{"scene.toml", "fnv1a64:2"}}));
  const auto manifest =
      fuzz::write_scratch("manifest.jsonl", reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  if (studies::manifest_text(studies::read_manifest(manifest)) != text) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view rest(reinterpret_cast<const char*>(data) + 1, size - 1);
  if (*data == 'r') return collect_record(rest), 0;
  const bool is_manifest = *data == 'm';
  const auto path = fuzz::write_scratch(is_manifest ? "manifest.jsonl" : "study.toml", data + 1, size - 1);
  is_manifest ? read_manifest(path) : plan(path);
  return 0;
}
