// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/optimum/optimum_file.hpp"

#include "io/formats/text/name_fault.hpp"
#include "io/formats/toml/document.hpp"
#include "io/formats/units/in_quotes.hpp"
#include "io/formats/units/units.hpp"
#include "io/studies/variables/read_variable.hpp"

#include <cmath>
#include <map>

namespace netloft::studies {

namespace {

constexpr std::int64_t kMostSolves = 10'000;

/// Reads one file. The member functions are the steps, in the order of execution.
class OptimumReader {
 public:
  OptimumReader(const formats::Value& root, formats::Diagnostics& diagnostics) : root_(root, diagnostics) {}

  OptimumFile read() {
    file_.scene = root_.text("scene", {.doc = "the scene that is optimised, relative to this file"});
    file_.scene_place = root_.place("scene");
    file_.set = root_.texts(
        "set", {.doc = "values of the scene, as --set takes them", .fallback = std::vector<std::string>{}});
    file_.set_place = root_.place("set");
    file_.solves = static_cast<int>(root_.integer(
        "solves", {.doc = "limit of the number of solves", .lo = 1, .hi = kMostSolves, .fallback = 60}));
    read_variables();
    read_objective();
    read_constraints();
    root_.finish();
    return std::move(file_);
  }

 private:
  void read_variables() {
    formats::TableReader variables =
        root_.table("variables", formats::Presence::required, "what may be changed, a table each");
    std::map<std::string, std::string> owners;
    for (const std::string& name : variables.keys()) {
      const int errors = root_.diagnostics().errors();
      formats::TableReader table = variables.table(name, formats::Presence::required, "key and range");
      OptimumVariable read{read_variable(name, table, VariedBy::interval)};
      const bool has_start = table.has("start"),
                 has_step = table.has("step");  // makes the keys known even after errors
      if (has_start && read.variable.interval) read_start(read, table);
      if (has_step && read.variable.interval) read_step(read, table);
      for (const FollowingKey& key : read.variable.keys)
        if (const auto [owner, is_new] = owners.emplace(key.path, name); !is_new)
          root_.diagnostics().error(table.place(), key.path + " is varied by " + owner->second + " already");
      if (root_.diagnostics().errors() == errors) file_.variables.push_back(std::move(read));
    }
    if (root_.has("variables") && variables.keys().empty())
      root_.error("variables", "is empty: there is nothing that may be changed",
                  "such as [variables.floats]");
  }

  static void read_start(OptimumVariable& read, formats::TableReader& table) {
    read.start = read_number_of(read.variable, table, "start", "where the search begins");
    if (read.start && !read.variable.interval->contains(*read.start))
      table.error("start", "lies outside the range");
  }

  static void read_step(OptimumVariable& read, formats::TableReader& table) {
    read.step = read_number_of(read.variable, table, "step", "the answer is a whole multiple of it");
    const auto [low, high] = *read.variable.interval;
    if (read.step && !(*read.step > 0 && *read.step * std::floor(high / *read.step) >= low))
      table.error("step", "must be above zero, and the range must contain a whole multiple of it");
  }

  void read_objective() {
    formats::TableReader table =
        root_.table("objective", formats::Presence::required,
                    "what is to be least or greatest: minimise or maximise, and unit");
    if (!root_.has("objective")) return;
    const bool minimises = table.has("minimise");
    file_.maximise = table.has("maximise");
    if (minimises == file_.maximise) {
      table.diagnostics().error(
          table.place(),
          minimises ? "objective has both minimise and maximise; there is only one objective"
                    : "objective has neither minimise nor maximise",
          minimises ? "limit the other figure by [[constraints]]" : "such as minimise = \"gear/drag/all/x\"");
    } else {
      const char* key = minimises ? "minimise" : "maximise";
      file_.objective = table.text(key, {.doc = "a figure, such as gear/drag/all/x"});
      file_.objective_place = table.place(key);
    }
    file_.unit = table.text("unit", {.doc = "unit of the objective, such as kN; 1 for a pure number"});
    file_.unit_place = table.place("unit");
  }

  void read_constraints() {
    for (formats::TableReader row : root_.tables("constraints", formats::Presence::optional,
                                                 "figures that have limits, a [[constraints]] each")) {
      FigureLimits read;
      read.figure = row.text("figure", {.doc = "a figure, such as gear/mouth/headline_height"});
      read.place = row.place("figure");
      if (!row.has("at_least") && !row.has("at_most"))
        row.diagnostics().error(row.place(), row.path() + " has neither at_least nor at_most",
                                "such as at_least = \"2 m\"");
      read.at_least = limit(row, "at_least", "least value of the figure");
      read.low_place = row.place("at_least");
      read.at_most = limit(row, "at_most", "greatest value of the figure");
      read.high_place = row.place("at_most");
      file_.constraints.push_back(std::move(read));
    }
  }

  /// The text of a number with or without a unit; empty if the key is missing.
  static std::string limit(formats::TableReader& row, const char* key, const std::string& doc) {
    const auto kind = row.kind(key);
    if (!kind) return "";
    return *kind == formats::Kind::text ? row.text(key, {.doc = doc})
                                        : formats::format(row.real(key, {.doc = doc}), "");
  }

  formats::TableReader root_;
  OptimumFile file_;
};

}  // namespace

OptimumFile read_optimum_file(const std::filesystem::path& path, formats::Diagnostics& diagnostics) {
  const formats::Document document = formats::Document::load(path, {}, diagnostics);
  if (diagnostics.errors()) return {};
  OptimumFile file = OptimumReader(document.root(), diagnostics).read();
  file.name = path.stem().string();
  if (const std::string fault = formats::name_fault(file.name); !fault.empty())
    diagnostics.error({0, 0, 0},
                      "the name of the file, " + formats::in_quotes(file.name) +
                          ", becomes the name of the folder of its answer, and " + fault,
                      "rename the file");
  return file;
}

}  // namespace netloft::studies
