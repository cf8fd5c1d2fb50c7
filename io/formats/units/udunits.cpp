// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/units/udunits.hpp"

#include <udunits2.h>

#include <cstdlib>
#include <mutex>

#include "io/formats/units/known_words.hpp"

namespace netloft::formats {
namespace {

// The parser of UDUNITS keeps its state in global variables, so only one thread may call it.
std::mutex& library_lock() {
  static std::mutex lock;
  return lock;
}

/// Symbols added to the database. UDUNITS distinguishes upper and lower case in symbols, but not in names.
/// "kn" must be a symbol, because otherwise kN would be a knot.
constexpr struct {
  const char* symbol;
  const char* definition;
} kSymbols[] = {
    {"deg", "degree"},   {"kn", "knot"},        {"nmi", "nautical_mile"}, {"ftm", "1.8288 m"},
    {"tf", "9806.65 N"}, {"tonf", "9806.65 N"}, {"kp", "9.80665 N"},      {"lbs", "pound"},
    {"Rtex", "tex"},     {"rtex", "tex"},
};

/// Names added to the database. The fathom of UDUNITS is 6 US survey feet, which is 2 ppm longer than the
/// fathom of charts and warps, 6 international feet.
constexpr struct {
  const char* name;
  const char* definition;
} kNames[] = {{"fathom", "1.8288 m"}, {"fathoms", "1.8288 m"}};

void add_symbol(ut_system* system, const char* symbol, const char* definition) {
  ut_unit* unit = ut_parse(system, definition, UT_ASCII);
  ut_unmap_symbol_to_unit(system, symbol, UT_ASCII);
  ut_map_symbol_to_unit(symbol, UT_ASCII, unit);
  ut_free(unit);
}

void add_name(ut_system* system, const char* name, const char* definition) {
  ut_unit* unit = ut_parse(system, definition, UT_ASCII);
  ut_unmap_name_to_unit(system, name, UT_ASCII);
  ut_map_name_to_unit(name, UT_ASCII, unit);
  ut_free(unit);
}

std::string describe_trouble(ut_status status, const std::string& database) {
  const char* variable = std::getenv("UDUNITS2_XML_PATH");
  if (status == UT_OPEN_ARG) return "the unit database " + database + " of UDUNITS-2 cannot be opened";
  if (status == UT_OPEN_ENV)
    return std::string("the unit database ") + (variable ? variable : "") +
           " of UDUNITS-2, named by UDUNITS2_XML_PATH, cannot be opened";
  if (status == UT_OPEN_DEFAULT)
    return "the unit database udunits2.xml of UDUNITS-2 is not installed where the library looks for it; "
           "UDUNITS2_XML_PATH can name it";
  return "the unit database of UDUNITS-2 cannot be read";
}

void add_powers(Dimension& dimension, const ut_unit* base, int power) {
  const char* symbol = ut_get_symbol(base, UT_ASCII);
  if (!symbol) symbol = ut_get_name(base, UT_ASCII);
  dimension[symbol ? symbol : "?"] += power;
}

ut_status visit_basic(const ut_unit* unit, void* out) {
  add_powers(static_cast<Unit*>(out)->dimension, unit, 1);
  return UT_SUCCESS;
}

ut_status visit_product(const ut_unit*, int count, const ut_unit* const* bases, const int* powers,
                        void* out) {
  for (int i = 0; i < count; ++i) add_powers(static_cast<Unit*>(out)->dimension, bases[i], powers[i]);
  return UT_SUCCESS;
}

ut_status visit_galilean(const ut_unit*, double scale, const ut_unit* underlying, double offset, void* out);
ut_status visit_timestamp(const ut_unit*, const ut_unit*, double, void*) { return UT_MEANINGLESS; }
ut_status visit_logarithmic(const ut_unit*, double, const ut_unit*, void*) { return UT_MEANINGLESS; }

constexpr ut_visitor kVisitor = {visit_basic, visit_product, visit_galilean, visit_timestamp,
                                 visit_logarithmic};

ut_status visit_galilean(const ut_unit*, double scale, const ut_unit* underlying, double offset, void* out) {
  auto* unit = static_cast<Unit*>(out);
  unit->scale *= scale;
  unit->offset = offset;
  return ut_accept_visitor(underlying, &kVisitor, out);
}

}  // namespace

UnitSystem::UnitSystem(const std::string& database) {
  const std::lock_guard guard(library_lock());
  read(database);
}

void UnitSystem::read(const std::string& database) const {
  was_read_ = true;
  ut_set_error_message_handler(ut_ignore);
  system_ = ut_read_xml(database.empty() ? nullptr : database.c_str());
  if (!system_) {
    trouble_ = describe_trouble(ut_get_status(), database);
    return;
  }
  for (const auto& [symbol, definition] : kSymbols) add_symbol(system_, symbol, definition);
  for (const auto& [name, definition] : kNames) add_name(system_, name, definition);
}

UnitSystem::~UnitSystem() {
  const std::lock_guard guard(library_lock());
  ut_free_system(system_);
}

const UnitSystem& UnitSystem::shared() {
  // Never destroyed, because freeing its thousands of units takes longer than reading them.
  static const UnitSystem& system =
      std::getenv("UDUNITS2_XML_PATH") ? *new UnitSystem : *new UnitSystem(WhenNeeded{});
  return system;
}

std::optional<Unit> UnitSystem::parse(const std::string& word) const {
  const std::lock_guard guard(library_lock());
  if (!was_read_) {
    const auto known = known_words().find(word);
    if (known != known_words().end()) return known->second;
    read({});
  }
  ut_unit* parsed = system_ ? ut_parse(system_, word.c_str(), UT_ASCII) : nullptr;
  if (!parsed) return std::nullopt;
  Unit unit;
  const ut_status status = ut_accept_visitor(parsed, &kVisitor, &unit);
  ut_free(parsed);
  if (status != UT_SUCCESS) return std::nullopt;
  std::erase_if(unit.dimension, [](const auto& entry) { return entry.second == 0; });
  return unit;
}

}  // namespace netloft::formats
