// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/studies/sweep/manifest.hpp"

#include <cstdint>
#include <optional>

namespace netloft::studies {

/// A number that a point reports.
struct StudyFigure {
  std::string name, unit;  // names such as "gear/mouth/area", "results/pull", "held/warp/x"
  double value = 0;        // NaN: this point does not have the figure
};

/// The result at one point.
struct PointRecord {
  std::string status;     // outcome as in result files; "wrong input": the scene cannot be read at this point
  std::string stability;  // stability as in result files; empty if there is no result
  std::string reason;     // reason, as a sentence
  std::string start;      // "continued" from the point before, or "anew" by a search
  std::vector<std::string> events;  // folds and jumps between the point before and this one
  std::int64_t iterations = 0, factorisations = 0;
  double work = 0;  // work in the units of framework/balance/work.hpp
  std::vector<StudyFigure> figures;
};

/// The cost of an item. Tables of results leave it out, because it differs between machines and runs.
struct ItemCost {
  double wall_seconds = 0, cpu_seconds = 0;
  std::string host, started;
};

/// The results of one item.
struct ItemRecord {
  std::string hash, program;  // hash of the item's inputs; version of Netloft
  std::vector<PointRecord> points;
  ItemCost cost;
};

/// The content of a record's file: JSON, followed by a line with its CRC-32.
std::string record_text(const ItemRecord& record);

/// Reads a record back. Throws StudyError with a sentence if it is damaged or belongs to another item.
ItemRecord read_record(const std::string& text, const StudyItem& item);

/// Reads the record of an item from the folder of its study. Returns nullopt if there is no record, or if it
/// cannot be used; in the second case, `fault` says why.
std::optional<ItemRecord> find_record(const std::filesystem::path& folder, const StudyItem& item,
                                      std::string& fault);

}  // namespace netloft::studies
