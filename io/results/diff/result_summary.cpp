// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/diff/result_summary.hpp"

#include "io/formats/hdf5/read.hpp"
#include "io/results/file/groups.hpp"

namespace netloft::results {

namespace {

constexpr const char* kAxes[] = {"x", "y", "z"};

/// Reads one file; each member function reads one group of it.
class SummaryReader {
 public:
  explicit SummaryReader(const std::filesystem::path& path) : reader_(path) {
    summary_.path = path.string();
    if (reader_.has("/netloft")) reader_.require_known_format();
    if (!reader_.has("/netloft/provenance") && !reader_.has("/netloft/checkpoint"))
      throw formats::FileError(summary_.path + " is not a result of netloft: it has no /netloft/provenance");
  }

  ResultSummary read() {
    read_status();
    add_scalars("results/", "scalars/", "");
    summary_.has_gear = reader_.has(kRoot + "gear");
    add_scalars("gear/", "gear/", "gear/");
    if (reader_.has(kRoot + "energy"))
      summary_.numbers["energy"] = {unit(kRoot + "energy"), reader_.real(kRoot + "energy")};
    add_forces();
    read_provenance();
    return std::move(summary_);
  }

 private:
  std::string unit(const std::string& path) const {
    return reader_.has_attribute(path, "unit") ? reader_.text_attribute(path, "unit") : "1";
  }
  double known(const std::string& path) const {
    return reader_.has(path) && !reader_.is_group(path) ? reader_.real(path) : ResultNumber::kUnknown;
  }

  void read_status() {
    const std::string at = kRoot + "status";
    if (!reader_.has(at) || !reader_.has_attribute(at, "outcome")) return;
    summary_.outcome = reader_.text_attribute(at, "outcome");
    if (reader_.has_attribute(at, "sentence")) summary_.sentence = reader_.text_attribute(at, "sentence");
  }

  /// Adds all scalars below a group, at any depth; `errors` is the group that holds their errors.
  void add_scalars(const std::string& name, const std::string& group, const std::string& errors,
                   const std::string& below = "") {
    if (!reader_.has(kRoot + group + below)) return;
    for (const auto& member : reader_.list(kRoot + group + below)) {
      const std::string path = below + member;
      if (reader_.is_group(kRoot + group + path)) {
        add_scalars(name, group, errors, path + "/");
        continue;
      }
      summary_.numbers[name + path] = {unit(kRoot + group + path), reader_.real(kRoot + group + path),
                                       known(kErrors + errors + "solver/" + path),
                                       known(kErrors + errors + "mesh/" + path)};
    }
  }

  void add_rows(const std::string& name, const std::vector<std::string>& rows, const std::string& path) {
    const auto values = reader_.reals(path);
    for (std::size_t row = 0; row < rows.size() && 3 * row + 2 < values.size(); ++row)
      for (std::size_t axis = 0; axis < 3; ++axis)
        summary_.numbers[name + rows[row] + "/" + kAxes[axis]] = {"N", values[3 * row + axis]};
  }

  void add_forces() {
    const std::string at = kRoot + "forces/";
    if (reader_.has(at + "held") && reader_.has(at + "held_name"))
      add_rows("held/", reader_.strings(at + "held_name"), at + "held");
    if (!reader_.has(at) || !reader_.has(kRoot + "parts/name")) return;
    const auto parts = reader_.strings(kRoot + "parts/name");
    for (const auto& load : reader_.list(at))
      if (load != "held" && load != "held_name" && load != "balance")
        add_rows("forces/" + load + "/", parts, at + load);
  }

  void read_provenance() {
    const std::string at = kRoot + "provenance/";
    if (!reader_.has(at + "version")) return;
    summary_.version = reader_.text(at + "version");
    summary_.command = reader_.strings(at + "command");
    const auto paths = reader_.strings(at + "files/path"), texts = reader_.strings(at + "files/text");
    for (std::size_t i = 0; i < paths.size() && i < texts.size(); ++i)
      summary_.files.push_back({paths[i], texts[i]});
    const auto names = reader_.strings(at + "plugins/name"), hashes = reader_.strings(at + "plugins/hash");
    for (std::size_t i = 0; i < names.size() && i < hashes.size(); ++i)
      summary_.plugins[names[i]] = hashes[i];
  }

  formats::Reader reader_;
  ResultSummary summary_;
};

}  // namespace

ResultSummary read_summary(const std::filesystem::path& path) { return SummaryReader(path).read(); }

}  // namespace netloft::results
