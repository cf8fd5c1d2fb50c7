// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/formats/hdf5/bytes.hpp"
#include "io/formats/hdf5/journal.hpp"
#include "io/formats/hdf5/vtkhdf.hpp"

namespace netloft::formats {

/// A column of the series: one number per state, under /netloft/series/<name>.
struct SeriesColumn {
  std::string name, unit, doc;
};

/// What all outputs of a motion have in common.
struct SeriesLayout {
  Mesh mesh;
  std::vector<FieldSpec> changing;
  std::vector<StaticField> fixed;
  std::vector<SeriesColumn> columns;
};

/// One output of a motion.
struct SeriesState {
  double time = 0;
  std::vector<double> points;               // 3n [m]
  std::vector<std::vector<double>> fields;  // in the order of `changing`
  std::vector<double> row;                  // in the order of the columns
};

/// How a motion stands, as the attributes of /netloft/status have it.
struct SeriesStatus {
  std::string outcome, sentence;
};

/// The outputs of a motion that runs, or ran until it was killed, in NAME.hdf.part: a journal (journal.hpp)
/// whose records are, by kind,
///   1 layout   identity of the run, an HDF5 image of what is known at the start (see fold.hpp), SeriesLayout
///   2 output   checkpoint (empty: none), time, points, fields, row; a field without numbers is that of the
///              output before, to the bit
///   3 rewind   only the first so many outputs count: the run goes on from there
///   4 status   outcome, sentence: the last one counts
class SeriesJournal {
 public:
  /// Begins one. `identity` tells the runs that may go on with it.
  static SeriesJournal create(const std::filesystem::path& part, const std::string& identity,
                              const std::string& origins, const SeriesLayout& layout);
  static SeriesJournal read(const std::filesystem::path& part);
  /// Opens one to go on from its last checkpoint, or from the last before damage(); what comes after that
  /// does not count any more. Nothing is changed before something is written, and a damaged file is kept as
  /// path_of_damaged() then. Throws FileError if there is no checkpoint, or if it belongs to another run.
  static SeriesJournal go_on(const std::filesystem::path& part, const std::string& identity);

  const std::filesystem::path& path() const { return journal_->path(); }
  const SeriesLayout& layout() const { return layout_; }
  /// An HDF5 image of what was known at the start; empty if there is none.
  const std::string& origins() const { return origins_; }
  const SeriesStatus& status() const { return status_; }
  /// What go_on() found in the middle of the file; mostly empty.
  const std::string& damage() const { return journal_->damage(); }
  std::filesystem::path path_of_damaged() const { return journal_->path_of_damaged(); }
  /// Outputs that count.
  std::size_t size() const { return outputs_.size(); }
  SeriesState state(std::size_t i) const;
  /// The same without the fields that the output before has, which are empty.
  SeriesState stored_state(std::size_t i) const;
  /// By field: which outputs have it, and not only the one before.
  const std::vector<std::vector<bool>>& stored() const { return stored_; }
  /// What belongs to the last output that has any, to go on from.
  const std::string& checkpoint() const { return checkpoint_; }

  /// At the latest when this returns, the output survives a kill of the program.
  void write(const SeriesState& state, const std::string& checkpoint);
  /// Throws FileError if the run that goes on would write other fields than the one before.
  void require_layout(const SeriesLayout& layout) const;
  void set_status(const SeriesStatus& status);
  void remove() { journal_->remove(); }

 private:
  SeriesJournal() = default;
  Journal::Visit reader(const std::filesystem::path& part);
  void interpret(const Journal::Record& record, std::string_view content);
  void note_output(const Journal::Record& record, std::string_view content);
  void keep_outputs(std::size_t count);
  void append(std::uint32_t kind, const ByteWriter& content);

  std::optional<Journal> journal_;
  SeriesLayout layout_;
  std::string identity_, origins_, checkpoint_;
  SeriesStatus status_;
  std::vector<Journal::Record> outputs_;
  std::vector<std::vector<bool>> stored_;
  std::vector<std::vector<double>> last_fields_;  // of the last output
  Journal::Record last_;
  std::size_t resumable_ = 0;  // outputs up to the last one with a checkpoint
  bool is_to_rewind_ = false;  // the file does not say yet that a run goes on
  ByteWriter buffer_;
};

}  // namespace netloft::formats
