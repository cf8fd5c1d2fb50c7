// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/plan/plan_reader.hpp"
#include "io/gears/plan/table_in_time.hpp"

#include <algorithm>
#include <cmath>

namespace netloft::gears {

namespace {

using Follows = WinchStage::Follows;

constexpr const char* kKeys[] = {"length", "speed", "tension"};
constexpr const char* kOfTension[] = {"max_speed", "band", "dead_band"};
const formats::Range kTensions{0, 1e9, true};
constexpr const char* kOfBlock = "tension at the block, held by the winch";

/// Reads one table of `winch`; it may follow an earlier table in time.
class StageReader {
 public:
  StageReader(formats::TableReader table, const Rope& warp)
      : table_(std::move(table)), warp_(warp), before_(warp.winch.empty() ? nullptr : &warp.winch.back()) {}

  /// The stage that the table describes. It has no rows after an error, or if the table gives no tension
  /// other than that of the warp, which the winch holds.
  WinchStage read() {
    if (before_ && !table_.has("t"))
      table_.error("t", "is missing: it is the time at which this table replaces the previous one");
    else if (const auto follows = find_key())
      read_as(*follows);
    return stage_;
  }

 private:
  void read_as(Follows follows) {
    stage_.follows = follows;
    if (follows != Follows::tension) refuse_keys_of_tension();
    if (follows == Follows::tension)
      read_tension();
    else
      follows == Follows::speed ? read_speeds() : read_lengths();
    check_begin();
  }

  /// The quantity that the winch follows; nullopt after an error.
  std::optional<Follows> find_key() {
    std::vector<const char*> given;
    for (const char* key : kKeys)
      if (table_.has(key)) given.push_back(key);
    if (given.size() > 1)
      table_.error(given.back(), std::string("is given beside ") + given.front() +
                                     ", and both determine how the winch runs; give one of them");
    else if (given.empty() && (before_ || !warp_.tension))
      table_.error("length",
                   "is missing, and so are speed and tension: one of them must determine how the winch runs");
    else if (given.empty() || given[0] == std::string("tension"))
      return Follows::tension;
    else
      return given[0] == std::string("speed") ? Follows::speed : Follows::length;
    return {};
  }

  std::vector<double> read_stage_times() { return before_ ? read_later_times(table_) : read_times(table_); }

  void read_column_of(const char* key, const char* unit, const char* doc, formats::Range range,
                      double less = 0) {
    const auto t = read_stage_times();
    const auto values =
        table_.reals(key, {.unit = unit, .doc = doc, .range = range, .count = formats::exactly(t.size())});
    for (std::size_t i = 0; i < std::min(t.size(), values.size()); ++i)
      stage_.rows.push_back({t[i], values[i] - less});
  }

  /// Reads one tension, or a row of tensions for the times `t`. The first table must begin with the tension
  /// of the warp, if the warp has one.
  void read_tension() {
    if (table_.has("t"))
      read_column_of("tension", "N", kOfBlock, kTensions);
    else if (table_.has("tension"))
      stage_.rows.push_back({0, table_.real("tension", {.unit = "N", .doc = kOfBlock, .range = kTensions})});
    if (!before_) check_tension_of_start();
    const double first = stage_.rows.empty() ? warp_.tension.value_or(0) : stage_.rows[0][1];
    stage_.max_speed =
        table_.real("max_speed", {.unit = "m/s",
                                  .doc = "largest speed at which the winch can pay out and haul",
                                  .range = {0, 50, true},
                                  .fallback = kWinchSpeed});
    stage_.band =
        table_.real("band", {.unit = "N",
                             .doc = "deviation of the tension above which the winch runs at max_speed",
                             .range = {0, 1e9, true},
                             .fallback = kWinchBand * first});
    stage_.dead_band =
        table_.real("dead_band", {.unit = "N",
                                  .doc = "deviation of the tension up to which the winch does not run",
                                  .range = {0, 1e9},
                                  .fallback = 0.0});
  }
  void check_tension_of_start() {
    if (stage_.rows.empty() || !warp_.tension) return;
    if (std::abs(stage_.rows[0][1] - *warp_.tension) > 1e-9 * *warp_.tension)
      table_.error("tension",
                   "begins with another value than warp.tension, from which the initial length follows");
    else if (warp_.tension_port && stage_.rows.size() > 1)
      table_.error("tension", "is for both warps, but warp.tension_port differs from warp.tension",
                   "leave out tension_port, or the row of tensions");
  }

  void read_speeds() {
    read_column_of("speed", "m/s", "speed of paying out; negative: hauling", formats::between(-50, 50));
    double out = 0;
    for (std::size_t i = 1; i < stage_.rows.size(); ++i) {
      const auto &before = stage_.rows[i - 1], &here = stage_.rows[i];
      out += 0.5 * (here[0] - before[0]) * (before[1] + here[1]);
      if (!before_ && !(shortest() + out > 0)) return table_.error("speed", kTooShort);
    }
  }

  void read_lengths() {
    if (before_)
      return table_.error(
          "length",
          "cannot be given in a second or later table, because the length at its beginning is not known",
          "give speed, or one table for all lengths");
    if (warp_.tension)
      return table_.error("length", "is given beside warp.tension, which determines the initial length",
                          "run the scene with the tension once, and write the length that was found");
    read_column_of("length", "m", "length of warp that is paid out", {0, 1e5, true}, warp_.length);
    if (!stage_.rows.empty() && std::abs(stage_.rows[0][1]) > 1e-9 * warp_.length)
      table_.error("length", "begins with another value than warp.length, the length paid out at the start");
    for (const auto& [t, more] : stage_.rows)
      if (!(shortest() + more > 0)) return table_.error("length", kTooShort);
  }

  void refuse_keys_of_tension() {
    for (const char* key : kOfTension)
      if (table_.has(key)) {
        table_.raw(key);
        table_.error(
            key,
            "belongs to a winch that holds a tension, but this winch follows a table of speeds or lengths");
      }
  }

  void check_begin() {
    if (!before_ || stage_.rows.empty()) return;
    stage_.from = stage_.rows[0][0];
    const double earliest = before_->rows.empty() ? before_->from : before_->rows.back()[0];
    if (!(stage_.from > earliest) && !(stage_.from == earliest && before_->rows.size() > 1))
      table_.error("t", "begins before the end of the previous table");
  }

  double shortest() const { return std::min(warp_.length, warp_.length_port.value_or(warp_.length)); }

  static constexpr const char* kTooShort = "hauls more warp than there is";

  formats::TableReader table_;
  const Rope& warp_;
  const WinchStage* before_;  // the stage of the previous table; nullptr in the first table
  WinchStage stage_;
};

}  // namespace

void read_winch(formats::TableReader& warp, Rope& rope) {
  rope.winch_place = warp.place("winch");
  std::vector<formats::TableReader> tables;
  const formats::Value* value = warp.raw("winch");
  const formats::Array* list = value ? value->as<formats::Array>() : nullptr;
  if (list && list->items.empty()) warp.error("winch", "is an empty list", "leave it out");
  if (list)
    tables = warp.tables("winch");
  else
    tables.push_back(warp.table("winch"));
  for (const formats::TableReader& table : tables) {
    WinchStage stage = StageReader(table, rope).read();
    rope.winch.push_back(std::move(stage));
  }
}

}  // namespace netloft::gears
