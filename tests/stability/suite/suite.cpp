// SPDX-License-Identifier: BSD-3-Clause
#include "tests/stability/suite/suite.hpp"

#include "io/formats/toml/document.hpp"
#include "tests/stability/suite/random_case.hpp"

#include <algorithm>
#include <set>

namespace netloft::hard_cases {

using namespace formats;
using namespace scenes;

namespace {

namespace fs = std::filesystem;

constexpr const char* kSolvers = "solvers.toml";
constexpr const char* kFlowDoc = "values by which the net slows the water, path=value";

std::vector<std::string> read_words(TableReader& table, const char* key, const char* doc) {
  return table.texts(key, {.doc = doc, .fallback = std::vector<std::string>{}});
}

/// Reads one file of the suite: a scene, its sizes, and the cases made of it.
class GroupReader {
 public:
  GroupReader(const fs::path& file, std::uint64_t number, formats::Diagnostics& diagnostics,
              std::vector<HardCase>& out)
      : file_(file),
        number_(number),
        diagnostics_(diagnostics),
        document_(formats::Document::load(file, {}, diagnostics)),
        out_(out) {}

  void read() {
    if (diagnostics_.errors()) return;
    TableReader root(document_.root(), diagnostics_);
    group_.scene = file_.parent_path() / root.text("scene", {.doc = "scene file, from here"});
    group_.overrides = read_words(root, "set", "values of the scene, path=value");
    group_.flow = read_words(root, "flow", kFlowDoc);
    read_sizes(root.table("sizes"), group_.sizes);
    const formats::Value* cases = root.raw("case");
    const formats::Array* array = cases ? cases->as<formats::Array>() : nullptr;
    if (!array) root.error("case", "is missing: [[case]] tables with a name and a start");
    if (array)
      for (const formats::Value& entry : array->items) read_entry(entry);
    root.finish();
  }

 private:
  static void read_sizes(TableReader table, std::map<std::string, std::vector<std::string>>& sizes) {
    for (const auto& size : kSizes)
      if (table.has(size)) sizes[size] = read_words(table, size.c_str(), "values of the scene, path=value");
    table.finish();
  }

  /// Reads a [[case]]. A random [[case]] stands for `count` cases.
  void read_entry(const formats::Value& entry) {
    TableReader plain(entry, diagnostics_, "case");
    if (!plain.has("vary")) return read_case(entry, "", 1, false);
    const auto count = plain.integer("count", {.doc = "random cases", .lo = 1, .hi = 1000});
    const std::string name = plain.text("name", {.doc = "of the case"});
    for (std::int64_t k = 1; k <= count; ++k) {
      const std::string suffix = "-" + std::to_string(k);
      scenes::Dice dice(file_.stem().string() + "/" + name + suffix, number_);
      formats::Value filled = entry;
      fill_in(filled, random_texts(plain.table("vary"), dice));
      read_case(filled, suffix, dice.next() >> 16, true);
    }
  }

  void read_case(const formats::Value& value, const std::string& suffix, std::uint64_t seed, bool is_random) {
    TableReader table(value, diagnostics_, "case");
    for (const char* key : {"vary", "count"}) table.raw(key);
    HardCase c = group_;
    c.name = file_.stem().string() + "/" + table.text("name", {.doc = "of the case"}) + suffix;
    c.about = table.text("about", {.doc = "what is hard about it", .fallback = ""});
    if (table.has("scene")) c.scene = file_.parent_path() / table.text("scene", {.doc = "scene file"});
    for (auto& word : read_words(table, "set", "values of the scene, path=value"))
      c.overrides.push_back(std::move(word));
    if (table.has("flow")) c.flow = read_words(table, "flow", kFlowDoc);
    if (table.has("sizes")) c.sizes.clear(), read_sizes(table.table("sizes"), c.sizes);
    c.start = read_start(table, seed);
    const std::string expected = table.choice(
        "expected", {.allowed = {"unique", "stable", "none"}, .doc = "what the right answer is"});
    c.expected = expected == "unique" ? Expected::unique
                 : expected == "none" ? Expected::none
                                      : Expected::stable;
    c.neutral = table.boolean("neutral", {.doc = "something may move without force", .fallback = false});
    c.is_random = is_random;
    c.reference = table.text("reference", {.doc = "name of its answer", .fallback = c.name});
    table.finish();
    if (std::any_of(out_.begin(), out_.end(), [&](const auto& other) { return other.name == c.name; }))
      table.error("name", "there is a case " + c.name + " already");
    out_.push_back(std::move(c));
  }

  fs::path file_;
  std::uint64_t number_;
  formats::Diagnostics& diagnostics_;
  formats::Document document_;
  HardCase group_;
  std::vector<HardCase>& out_;
};

Column read_column(TableReader& table) {
  const std::string solver = table.text("use", {.doc = "solver, as --solver takes it", .fallback = ""});
  Column column = column_of(solver);
  column.strategy =
      table.text("strategy", {.doc = "strategy, as --strategy takes it", .fallback = column.strategy});
  if (column.solver.empty() && column.strategy.empty())
    table.error("use", "is missing: a solver, or a strategy under the key strategy");
  column.overrides = read_words(table, "set", "values of the scene, path=value");
  column.sizes = read_words(table, "sizes", "sizes at which it runs; default: all");
  column.title = table.text(
      "title", {.doc = "heading of the column; default: the strategy and the solver", .fallback = ""});
  return column;
}

std::vector<Column> read_columns(const fs::path& file, formats::Diagnostics& diagnostics) {
  std::vector<Column> columns;
  const formats::Document document = formats::Document::load(file, {}, diagnostics);
  TableReader root(document.root(), diagnostics);
  for (auto& table : root.tables("solver", Presence::required, "the columns of the matrix"))
    columns.push_back(read_column(table));
  root.finish();
  return columns;
}

std::vector<fs::path> find_files(const fs::path& folder, formats::Diagnostics& diagnostics) {
  std::set<fs::path> files;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder, failed))
    if (entry.path().extension() == ".toml" && entry.path().filename() != kSolvers)
      files.insert(entry.path());
  if (files.empty())
    diagnostics.error({}, folder.string() + " holds no suite: a folder with TOML files of cases is expected");
  return {files.begin(), files.end()};
}

}  // namespace

Suite read_suite(const fs::path& folder, std::uint64_t number, formats::Diagnostics& diagnostics) {
  Suite suite{folder, {}, {}};
  for (const auto& file : find_files(folder, diagnostics))
    GroupReader(file, number, diagnostics, suite.cases).read();
  if (!diagnostics.errors()) suite.columns = read_columns(folder / kSolvers, diagnostics);
  return suite;
}

void keep_nets_in_current(Suite& suite, bool slowed) {
  std::erase_if(suite.cases, [](const HardCase& c) { return c.flow.empty(); });
  if (!slowed) return;
  for (HardCase& c : suite.cases) {
    c.overrides.insert(c.overrides.end(), c.flow.begin(), c.flow.end());
    c.is_random = true;
  }
}

const char* name_of(Expected expected) {
  switch (expected) {
    case Expected::unique:
      return "unique";
    case Expected::none:
      return "none";
    default:
      return "stable";
  }
}

}  // namespace netloft::hard_cases
