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
  double offset = 0;  // degC, degF
};

/// The UDUNITS-2 database, with words of the trade that it lacks or defines differently.
class UnitSystem {
 public:
  /// Reads the database at the path `database` of udunits2.xml; empty: UDUNITS2_XML_PATH, then the installed
  /// one.
  explicit UnitSystem(const std::string& database = {});
  ~UnitSystem();
  UnitSystem(const UnitSystem&) = delete;
  UnitSystem& operator=(const UnitSystem&) = delete;

  /// The instance that all callers use. It reads its database when the first word is met that is no common
  /// one (known_words.hpp); at once, if UDUNITS2_XML_PATH names another than the installed one.
  static const UnitSystem& shared();

  /// A sentence about the error if the database could not be read; empty if it was, or has not been needed.
  const std::string& trouble() const { return trouble_; }

  /// One word with its prefix, such as "mm". None: UDUNITS does not know it, or it is a logarithm.
  std::optional<Unit> parse(const std::string& word) const;

 private:
  struct WhenNeeded {};
  explicit UnitSystem(WhenNeeded) {}
  void read(const std::string& database) const;

  // Written under the lock of the library.
  mutable bool was_read_ = false;
  mutable ut_system* system_ = nullptr;
  mutable std::string trouble_;
};

}  // namespace netloft::formats
