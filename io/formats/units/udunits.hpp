// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "io/formats/units/dimension.hpp"

struct ut_system;

namespace netloft::formats {

/// A unit as plain data: SI value = scale (x + offset).
struct Unit {
  Dimension dimension;
  double scale = 1;
  double offset = 0;  // nonzero for degC and degF
};

/// The UDUNITS-2 database, with words of fishing and shipping that it lacks or defines differently.
class UnitSystem {
 public:
  /// Reads the database udunits2.xml at the path `database`. If this path is empty, the path in the variable
  /// UDUNITS2_XML_PATH is used; without this variable, the installed database is read.
  explicit UnitSystem(const std::string& database = {});
  ~UnitSystem();
  UnitSystem(const UnitSystem&) = delete;
  UnitSystem& operator=(const UnitSystem&) = delete;

  /// The instance that all callers use. It reads the database when a word is not a common word
  /// (known_words.hpp). If UDUNITS2_XML_PATH is set, it reads that database immediately.
  static const UnitSystem& shared();

  /// The reason why the database could not be read, as a sentence; an empty text if it was read, or was not
  /// needed yet.
  const std::string& trouble() const { return trouble_; }

  /// The unit of one word with its prefix, such as "mm". nullopt if UDUNITS does not know the word, or if the
  /// unit is logarithmic.
  std::optional<Unit> parse(const std::string& word) const;

 private:
  struct WhenNeeded {};
  explicit UnitSystem(WhenNeeded) {}
  void read(const std::string& database) const;

  // These members must be changed only while the lock of the parser is held.
  mutable bool was_read_ = false;
  mutable ut_system* system_ = nullptr;
  mutable std::string trouble_;
};

}  // namespace netloft::formats
