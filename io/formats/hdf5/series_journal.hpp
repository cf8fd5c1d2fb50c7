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

/// The data that are common to all outputs of a motion.
struct SeriesLayout {
  Mesh mesh;
  std::vector<FieldSpec> changing;
  std::vector<StaticField> fixed;
  std::vector<SeriesColumn> columns;
};

struct SeriesState {
  double time = 0;
  std::vector<double> points;               // positions, 3n [m]
  std::vector<std::vector<double>> fields;  // fields in the order of `changing`
  std::vector<double> row;                  // numbers in the order of the columns
};

/// The state of a run, as in the attributes of /netloft/status.
struct SeriesStatus {
  std::string outcome, sentence;
};
inline const SeriesStatus kRunning = {"running",
                                      "the run that writes this file has not ended, or was killed"};

/// The outputs of a motion that is running or was killed, in the journal NAME.hdf.part (journal.hpp). The
/// kinds of its records:
///   1 layout   identity of the run, an HDF5 image of the inputs (image.hpp), SeriesLayout
///   2 output   checkpoint (may be empty), time, points, fields, row; a field without numbers has the same
///              bits as in the output before
///   3 rewind   number of outputs that remain valid: the run continues after them
///   4 status   outcome, sentence; the last status record is valid
class SeriesJournal {
 public:
  /// Creates a journal. Only runs with the same `identity` may continue it.
  static SeriesJournal create(const std::filesystem::path& part, const std::string& identity,
                              const std::string& origins, const SeriesLayout& layout);
  static SeriesJournal read(const std::filesystem::path& part);
  /// Opens a journal to continue from its last checkpoint, or from the last checkpoint before damage(); later
  /// outputs become invalid. The file does not change before the first write, which keeps a damaged file as
  /// path_of_damaged(). Throws FileError if there is no checkpoint, or if the journal belongs to another run.
  static SeriesJournal go_on(const std::filesystem::path& part, const std::string& identity);

  const std::filesystem::path& path() const { return journal_->path(); }
  const SeriesLayout& layout() const { return layout_; }
  /// An HDF5 image of the inputs of the run; empty if there is none.
  const std::string& origins() const { return origins_; }
  const SeriesStatus& status() const { return status_; }
  /// A sentence about the damage that go_on() found in the middle of the file; an empty text if there is
  /// none.
  const std::string& damage() const { return journal_->damage(); }
  std::filesystem::path path_of_damaged() const { return journal_->path_of_damaged(); }
  /// Number of valid outputs.
  std::size_t size() const { return outputs_.size(); }
  SeriesState state(std::size_t i) const;
  /// Like state(), but fields that equal those of the output before are empty.
  SeriesState stored_state(std::size_t i) const;
  /// Whether each output stores a field (first index). If not, the field equals that of the previous output.
  const std::vector<std::vector<bool>>& stored() const { return stored_; }
  /// The checkpoint of the last output that has one.
  const std::string& checkpoint() const { return checkpoint_; }

  /// Writes an output. Once this returns, the output survives a kill of the program.
  void write(const SeriesState& state, const std::string& checkpoint);
  /// Throws FileError unless the layout of the continued run has the same fields as the layout in the
  /// journal.
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
  std::vector<std::vector<double>> last_fields_;  // fields of the last output
  Journal::Record last_;
  std::size_t resumable_ = 0;  // number of outputs up to the last one with a checkpoint
  bool is_to_rewind_ = false;  // whether a continued run still has to write its rewind record
  ByteWriter buffer_;
};

}  // namespace netloft::formats
