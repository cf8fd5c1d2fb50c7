// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/hdf5/series_journal.hpp"

#include <cstring>

namespace netloft::formats {
namespace {

enum Kind : std::uint32_t { kLayout = 1, kOutput = 2, kRewind = 3, kStatus = 4 };

void put(ByteWriter& to, const FieldSpec& spec) {
  to.put(spec.name);
  to.put(spec.unit);
  to.put(spec.doc);
  to.put(std::uint64_t{spec.location == Location::kCell});
  to.put(std::uint64_t{spec.components});
  to.put(std::uint64_t{spec.is_integer});
}

FieldSpec read_spec(ByteReader& from) {
  FieldSpec spec;
  spec.name = from.text();
  spec.unit = from.text();
  spec.doc = from.text();
  spec.location = from.integer() == 0 ? Location::kPoint : Location::kCell;
  spec.components = from.integer();
  spec.is_integer = from.integer() != 0;
  return spec;
}

void put(ByteWriter& to, const SeriesLayout& layout) {
  const Mesh& mesh = layout.mesh;
  to.put(std::uint64_t{mesh.n_points});
  to.put_array(std::span<const std::int64_t>(mesh.connectivity));
  to.put_array(std::span<const std::int64_t>(mesh.offsets));
  to.put_array(std::span<const std::uint8_t>(mesh.types));
  to.put(std::uint64_t{layout.changing.size()});
  for (const auto& spec : layout.changing) put(to, spec);
  to.put(std::uint64_t{layout.fixed.size()});
  for (const auto& field : layout.fixed) {
    put(to, field.spec);
    to.put_array(field.values);
  }
  to.put(std::uint64_t{layout.columns.size()});
  for (const auto& column : layout.columns) {
    to.put(column.name);
    to.put(column.unit);
    to.put(column.doc);
  }
}

SeriesLayout read_layout(ByteReader& from) {
  SeriesLayout layout;
  layout.mesh.n_points = from.integer();
  layout.mesh.connectivity = from.array<std::int64_t>();
  layout.mesh.offsets = from.array<std::int64_t>();
  layout.mesh.types = from.array<std::uint8_t>();
  for (std::uint64_t left = from.integer(); left > 0; --left) layout.changing.push_back(read_spec(from));
  for (std::uint64_t left = from.integer(); left > 0; --left) {
    StaticField field{read_spec(from), {}};
    field.values = from.reals();
    layout.fixed.push_back(std::move(field));
  }
  for (std::uint64_t left = from.integer(); left > 0; --left) {
    SeriesColumn column;
    column.name = from.text();
    column.unit = from.text();
    column.doc = from.text();
    layout.columns.push_back(std::move(column));
  }
  return layout;
}

bool have_same_bits(std::span<const double> a, std::span<const double> b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}

std::string bytes_of(const SeriesLayout& layout) {
  ByteWriter bytes;
  put(bytes, layout);
  return bytes.bytes();
}

}  // namespace

SeriesJournal SeriesJournal::create(const std::filesystem::path& part, const std::string& identity,
                                    const std::string& origins, const SeriesLayout& layout) {
  SeriesJournal series;
  series.journal_ = Journal::create(part);
  ByteWriter head;
  head.put(identity);
  head.put(origins);
  put(head, layout);
  series.append(kLayout, head);
  series.layout_ = layout;
  series.identity_ = identity;
  series.origins_ = origins;
  series.stored_.resize(layout.changing.size());
  series.set_status(kRunning);
  return series;
}

SeriesJournal SeriesJournal::read(const std::filesystem::path& part) {
  SeriesJournal series;
  series.journal_ = Journal::read(part, series.reader(part));
  return series;
}

SeriesJournal SeriesJournal::go_on(const std::filesystem::path& part, const std::string& identity) {
  SeriesJournal series;
  series.journal_ = Journal::go_on(part, series.reader(part));
  if (series.checkpoint_.empty())
    throw FileError(part.string() + ": " + (series.damage().empty() ? "" : series.damage() + "; ") +
                    "the file has no output from which to continue");
  if (series.identity_ != identity)
    throw FileError(part.string() + ": the file belongs to another scene, or to another command line");
  series.keep_outputs(series.resumable_);
  series.last_fields_ = series.state(series.resumable_ - 1).fields;
  series.is_to_rewind_ = true;
  return series;
}

Journal::Visit SeriesJournal::reader(const std::filesystem::path& part) {
  return [this, name = part.string()](const Journal::Record& record, std::string_view content) {
    with_context("cannot read " + name, [&] { interpret(record, content); });
  };
}

void SeriesJournal::interpret(const Journal::Record& record, std::string_view content) {
  ByteReader from(content);
  if (record.kind == kLayout) {
    identity_ = from.text();
    origins_ = from.text();
    layout_ = read_layout(from);
    stored_.assign(layout_.changing.size(), {});
  } else if (record.kind == kOutput) {
    note_output(record, content);
  } else if (record.kind == kRewind) {
    const std::uint64_t kept = from.integer();
    if (kept > outputs_.size()) throw FileError("it is damaged: it continues from an output that is missing");
    keep_outputs(kept);
  } else if (record.kind == kStatus) {
    status_.outcome = from.text();
    status_.sentence = from.text();
  }
}

void SeriesJournal::note_output(const Journal::Record& record, std::string_view content) {
  outputs_.push_back(record);
  ByteReader from(content);
  const std::string_view checkpoint = from.text();
  from.real();
  from.skip_reals();
  for (auto& stored : stored_) stored.push_back(from.skip_reals() > 0);
  if (checkpoint.empty()) return;
  checkpoint_ = checkpoint;
  resumable_ = outputs_.size();
}

/// Appends a record. In a continued run, a record that invalidates outputs after its checkpoint comes first.
void SeriesJournal::append(std::uint32_t kind, const ByteWriter& content) {
  if (std::exchange(is_to_rewind_, false)) {
    ByteWriter kept;
    kept.put(std::uint64_t{outputs_.size()});
    append(kRewind, kept);
    set_status(kRunning);
  }
  last_ = journal_->append(kind, content.bytes());
}

void SeriesJournal::keep_outputs(std::size_t count) {
  outputs_.resize(count);
  for (auto& stored : stored_) stored.resize(count);
}

SeriesState SeriesJournal::state(std::size_t i) const {
  SeriesState state = stored_state(i);
  for (std::size_t k = 0; k < stored_.size(); ++k) {
    std::size_t from = i;
    while (from > 0 && !stored_[k][from]) --from;
    if (from < i) state.fields[k] = stored_state(from).fields[k];
  }
  return state;
}

SeriesState SeriesJournal::stored_state(std::size_t i) const {
  const std::string content = journal_->content(outputs_.at(i));
  return with_context("cannot read " + path().string(), [&] {
    ByteReader from(content);
    from.text();  // skips the checkpoint
    SeriesState state;
    state.time = from.real();
    state.points = from.reals();
    for (std::size_t k = 0; k < layout_.changing.size(); ++k) state.fields.push_back(from.reals());
    state.row = from.reals();
    return state;
  });
}

void SeriesJournal::write(const SeriesState& state, const std::string& checkpoint) {
  buffer_.clear();
  buffer_.put(checkpoint);
  buffer_.put(state.time);
  buffer_.put_array(state.points);
  last_fields_.resize(state.fields.size());
  for (std::size_t k = 0; k < state.fields.size(); ++k) {
    const bool is_new = outputs_.empty() || !have_same_bits(state.fields[k], last_fields_[k]);
    buffer_.put_array(is_new ? std::span(state.fields[k]) : std::span<const double>());
    if (is_new) last_fields_[k] = state.fields[k];
  }
  buffer_.put_array(state.row);
  append(kOutput, buffer_);
  note_output(last_, buffer_.bytes());
}

void SeriesJournal::require_layout(const SeriesLayout& layout) const {
  if (bytes_of(layout) != bytes_of(layout_))
    throw FileError(path().string() +
                    ": the file belongs to another version of the program, which wrote other fields");
}

void SeriesJournal::set_status(const SeriesStatus& status) {
  ByteWriter bytes;
  bytes.put(status.outcome);
  bytes.put(status.sentence);
  append(kStatus, bytes);
  status_ = status;
}

}  // namespace netloft::formats
