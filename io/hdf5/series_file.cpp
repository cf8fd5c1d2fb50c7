// SPDX-License-Identifier: BSD-3-Clause
#include "io/hdf5/series_file.hpp"

#include "io/hdf5/step_views.hpp"

#include <algorithm>

namespace netloft::io {

namespace {

const std::string kSeries = "/netloft/series/";

}  // namespace

SeriesFile::SeriesFile(std::filesystem::path final_path, Layout layout)
    : final_(std::move(final_path)),
      part_(final_.string() + ".part"),
      twin_part_(final_.string() + ".twin.part"),
      layout_(std::move(layout)) {
  front_ = make(part_), twin_ = make(twin_part_);
}

SeriesFile::SeriesFile(std::filesystem::path final_path, Layout layout, const Killed& killed)
    : final_(std::move(final_path)),
      part_(final_.string() + ".part"),
      twin_part_(final_.string() + ".twin.part"),
      layout_(std::move(layout)) {
  require_no_writer(twin_part_);
  front_ = make(final_.string() + ".resumed.part");
  try {
    copy(killed, *front_);
    front_->part().sync();
    front_->part().take_name_of(part_);
  } catch (...) {
    front_->discard();
    throw;
  }
  twin_ = make(twin_part_);
  try {
    copy(killed, *twin_);
  } catch (...) {
    twin_->discard();
    throw;
  }
}

std::unique_ptr<ResultFile> SeriesFile::make(const std::filesystem::path& part) const {
  auto file = std::make_unique<ResultFile>(final_, part);
  file->begin(layout_.mesh, layout_.changing, layout_.fixed);
  return file;
}

void SeriesFile::write(const SeriesState& state, const std::function<void(Tree&)>& extra) {
  if (twin_) {
    write_into(*twin_, state, extra);
    if (twin_->part().exchange_names(front_->part()))
      twin_.swap(front_);
    else {
      std::filesystem::remove(twin_->part_path());
      twin_.reset();
      return write_into(*front_, state, extra);
    }
  }
  write_into(twin_ ? *twin_ : *front_, state, extra);
}

/// The row is written first; a state counts only after `write_state` has counted it.
void SeriesFile::write_into(ResultFile& file, const SeriesState& state,
                            const std::function<void(Tree&)>& extra) const {
  for (std::size_t k = 0; k < layout_.columns.size(); ++k) {
    const SeriesColumn& c = layout_.columns[k];
    file.tree().append_real(kSeries + c.name, state.row[k], c.unit, c.doc);
  }
  if (extra) extra(file.tree());
  const std::vector<std::span<const double>> fields(state.fields.begin(), state.fields.end());
  file.write_state(state.time, state.points, fields);
}

void SeriesFile::copy(const Killed& killed, ResultFile& to) const {
  for (std::size_t i = 0; i < killed.states; ++i)
    write_into(to, read_state(killed.reader, layout_, i),
               i + 1 == killed.states ? killed.extra : std::function<void(Tree&)>{});
}

void SeriesFile::finish(const std::function<void(Tree&)>& rest, const std::filesystem::path& as) {
  if (!twin_) twin_.swap(front_);
  write_views(*twin_);
  rest(twin_->tree());
  twin_->finish_as(as.empty() ? final_ : as);
  if (front_) front_->discard();
  twin_.reset(), front_.reset();
}

void SeriesFile::write_views(ResultFile& file) const {
  const std::size_t cells = layout_.mesh.n_cells(), points = layout_.mesh.n_points;
  std::vector<SlottedArray> arrays = {{"Points", points, 3}};
  for (const auto& f : layout_.changing) {
    const bool on_points = f.location == Location::kPoint;
    arrays.push_back(
        {(on_points ? "PointData/" : "CellData/") + f.name, on_points ? points : cells, f.components});
  }
  write_step_views(file.part().id(), file.n_states(), arrays);
}

SeriesState read_state(const Reader& reader, const SeriesFile::Layout& layout, std::size_t i) {
  SeriesState state;
  state.time = reader.times().at(i);
  state.points = reader.points(i);
  for (const auto& field : layout.changing)
    state.fields.push_back(reader.field(field.location, field.name, i));
  for (const auto& column : layout.columns) state.row.push_back(reader.reals(kSeries + column.name).at(i));
  return state;
}

}  // namespace netloft::io
