// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/hdf5/result_file.hpp"

namespace netloft::formats {
ResultFile::ResultFile(std::filesystem::path final_path)
    : ResultFile(final_path, final_path.string() + ".part") {}

ResultFile::ResultFile(std::filesystem::path final_path, std::filesystem::path part_path)
    : part_(std::move(final_path), std::move(part_path)), tree_(part_.id(), part_.part_path().string()) {
  begin_result(tree_, "running", "the run that writes this file has not ended, or was killed");
  part_.flush();  // from now on readers can open the file
}

void ResultFile::begin(const Mesh& mesh, std::vector<FieldSpec> changing, std::span<const StaticField> fixed,
                       std::size_t states) {
  silence_hdf5();
  if (grid_) throw std::invalid_argument("begin() was called twice: a result file has one mesh");
  with_context("cannot write " + part_path().string(),
               [&] { grid_.emplace(part_.id(), mesh, std::move(changing), fixed, states); });
}

void ResultFile::write_state(double time, std::span<const double> points,
                             std::span<const std::span<const double>> fields) {
  silence_hdf5();
  if (!grid_) throw std::invalid_argument("write the mesh before the first state: call begin()");
  with_context("cannot write " + part_path().string(), [&] { grid_->write_state(time, points, fields); });
}

void ResultFile::flush() {
  if (grid_) with_context("cannot write " + part_path().string(), [&] { grid_->write_blocks(); });
  part_.flush();
}

void ResultFile::finish_grid() {
  if (grid_) with_context("cannot write " + part_path().string(), [&] { grid_->finish(); });
  grid_.reset();
}

void ResultFile::finish() {
  finish_grid();
  part_.finish();
}

void ResultFile::finish_as(std::filesystem::path final_path) {
  finish_grid();
  part_.finish_as(std::move(final_path));
}

void begin_result(Tree& tree, std::string_view outcome, std::string_view sentence) {
  tree.set_attribute("/netloft", "schema", kResultFormat);
  tree.set_attribute("/netloft/status", "outcome", outcome);
  tree.set_attribute("/netloft/status", "sentence", sentence);
}

}  // namespace netloft::formats
