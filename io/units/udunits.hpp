// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "io/units/dimension.hpp"

struct ut_system;

namespace netloft::io {

/// A unit as plain data: SI value = scale (x + offset).
struct Unit {
  Dimension dimension;
  double scale = 1;
  double offset = 0;  // degC, degF
};

/// The UDUNITS-2 database, with words of the trade that it lacks or defines differently.
class UnitSystem {
 public:
  /// `database` is the path of udunits2.xml; empty: UDUNITS2_XML_PATH, then the installed one.
  explicit UnitSystem(const std::string& database = {});
  ~UnitSystem();
  UnitSystem(const UnitSystem&) = delete;
  UnitSystem& operator=(const UnitSystem&) = delete;

  /// The instance that all callers use.
  static const UnitSystem& shared();

  /// Empty if the database was read; otherwise a sentence about the error.
  const std::string& trouble() const { return trouble_; }

  /// One word with its prefix, such as "mm". None: UDUNITS does not know it, or it is a logarithm.
  std::optional<Unit> parse(const std::string& word) const;

 private:
  ut_system* system_ = nullptr;
  std::string trouble_;
};

}  // namespace netloft::io
