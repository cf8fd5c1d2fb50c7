// SPDX-License-Identifier: BSD-3-Clause
#include "io/hdf5/result_file.hpp"

namespace netloft::io {
namespace {

constexpr int kSchema = 1;  // incremented when readers of /netloft must change

}  // namespace

ResultFile::ResultFile(std::filesystem::path final_path)
    : ResultFile(final_path, final_path.string() + ".part") {}

ResultFile::ResultFile(std::filesystem::path final_path, std::filesystem::path part_path)
    : part_(std::move(final_path), std::move(part_path)), tree_(part_.id(), part_.part_path().string()) {
  tree_.set_attribute("/netloft", "schema", kSchema);
  tree_.set_attribute("/netloft/status", "outcome", std::string_view("running"));
  tree_.set_attribute("/netloft/status", "sentence",
                      std::string_view("the run that writes this file has not ended, or was killed"));
  part_.flush();  // from here on it opens
}

void ResultFile::begin(const Mesh& mesh, std::vector<FieldSpec> changing,
                       std::span<const StaticField> fixed) {
  silence_hdf5();
  if (grid_) throw std::invalid_argument("the mesh of a result file is given once");
  with_context("cannot write " + part_path().string(),
               [&] { grid_.emplace(part_.id(), mesh, std::move(changing), fixed); });
}

void ResultFile::write_state(double time, std::span<const double> points,
                             std::span<const std::span<const double>> fields) {
  silence_hdf5();
  if (!grid_) throw std::invalid_argument("a state needs the mesh first: call begin()");
  with_context("cannot write " + part_path().string(), [&] { grid_->write_state(time, points, fields); });
}

void ResultFile::finish() {
  grid_.reset();
  part_.finish();
}

void ResultFile::finish_as(std::filesystem::path final_path) {
  grid_.reset();
  part_.finish_as(std::move(final_path));
}

}  // namespace netloft::io
