// SPDX-License-Identifier: BSD-3-Clause
#include "framework/registry/descriptors.hpp"

#include "framework/parameters/parameter_values.hpp"
#include "framework/parameters/whole_number.hpp"
#include "framework/registry/element_data.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

namespace netloft {

namespace {

/// Collects the faults of one plugin, so that its author sees all of them at once.
class Faults {
 public:
  explicit Faults(std::string file) : file_(std::move(file)) {}
  void add(const std::string& fault) { text_ += (text_.empty() ? "" : "\n") + file_ + ": " + fault; }
  void require(bool holds, const std::string& fault) {
    if (!holds) add(fault);
  }
  void raise() const {
    if (!text_.empty()) throw PluginRefused(text_);
  }

 private:
  std::string file_, text_;
};

/// Returns the size that a struct states. Throws std::length_error if the size is impossible: all sizes are
/// multiples of the alignment of pointers.
template <class T>
std::uint32_t check_size(const T* from) {
  std::uint32_t size = 0;
  std::memcpy(&size, from, sizeof size);
  if (size < kLeastRow || size % alignof(T) != 0)
    throw std::length_error("has a table whose rows are " + std::to_string(size) + " bytes long");
  return size;
}

/// Reads consecutive rows, which all have the size of the first row.
template <class T>
std::vector<T> read_rows(const T* from, std::uint32_t count) {
  if (!from || count == 0 || count > kMostRows) return read_array(from, count);
  const std::uint32_t size = check_size(from);
  const char* at = reinterpret_cast<const char*>(from);
  for (std::uint32_t i = 1; i < count; ++i)
    if (check_size(reinterpret_cast<const T*>(at + std::size_t{i} * size)) != size)
      throw std::length_error("has a table whose rows are not equally long");
  return read_array(from, count);
}

bool named(const char* text) { return text && *text; }
std::string shown(const char* text) { return named(text) ? text : "(no name)"; }

std::string plural(std::string noun) {
  if (!noun.ends_with('y')) return noun + "s";
  noun.pop_back();
  return noun + "ies";
}

template <class Rows>
void check_names(const Rows& rows, const std::string& owner, const char* what, Faults& faults) {
  std::set<std::string> seen;
  for (const auto& row : rows) {
    faults.require(named(row.name), owner + ": a " + what + " has no name");
    faults.require(named(row.doc),
                   owner + ": " + what + " \"" + shown(row.name) + "\" has no sentence that says what it is");
    if (named(row.name) && !seen.insert(row.name).second)
      faults.add(owner + ": two " + plural(what) + " are called \"" + row.name + "\"; names must be unique");
  }
}

double count_words(const netloft_parameter& p) {
  double count = 0;
  for (auto word = p.choices; word && *word; ++word) ++count;
  return count;
}

bool has_earlier_real(const std::vector<netloft_parameter>& rows, std::size_t before,
                      const std::string& name) {
  for (std::size_t i = 0; i < before; ++i)
    if (rows[i].kind == NETLOFT_REAL && named(rows[i].name) && name == rows[i].name) return true;
  return false;
}

/// Checks that both ends of the range of an integer parameter and its default are whole numbers. (`netloft
/// test` checks that the default is in the range.)
void check_integer(const netloft_parameter& p, const std::string& who, Faults& faults) {
  if (!whole_number(p.lo) || !whole_number(p.hi))
    return faults.add(who + " is a whole number in " + allowed(p) +
                      "; both ends of its range must be whole numbers from -2^53 to 2^53");
  faults.require(whole_number(p.fallback).has_value(),
                 who + " has the default " + default_of(p) + "; it must be a whole number in " + allowed(p));
}

void check_columns(const netloft_parameter& p, const std::string& who, Faults& faults) {
  if (!p.columns || !p.columns[0] || !p.column_units) return faults.add(who + " is a table without columns");
  for (std::size_t i = 0; p.columns[i]; ++i)
    if (!p.column_units[i])  // the list of units ends here, so that reading must stop
      return faults.add(who + " has no unit for its column \"" + p.columns[i] + "\"");
  faults.require(p.arguments <= 2 && (p.arguments < 2 || (p.columns[1] && p.columns[2])),
                 who + " is a table over " + std::to_string(p.arguments) +
                     " arguments; it needs one or two, and at least one more column");
}

void check_parameter(const netloft_parameter& p, std::uint32_t struct_bytes, const std::string& owner,
                     Faults& faults) {
  const std::string who = owner + ": parameter \"" + shown(p.name) + "\"";
  const std::size_t bytes = bytes_of(p.kind);
  faults.require(bytes > 0,
                 who + " is of kind " + std::to_string(p.kind) + ", which this program does not know");
  if (bytes && p.offset + bytes > struct_bytes)
    faults.add(who + " lies at bytes " + std::to_string(p.offset) + " to " +
               std::to_string(p.offset + bytes) + ", outside its struct of " + std::to_string(struct_bytes) +
               " bytes");
  faults.require(!bytes || p.offset % std::min<std::size_t>(bytes, 8) == 0,
                 who + " is not aligned in its struct");
  faults.require(named(p.unit), who + " has no unit (\"1\" is the unit of a pure number)");
  faults.require(p.kind == NETLOFT_TEXT || p.kind == NETLOFT_TABLE || p.lo <= p.hi,
                 who + " has an empty range");
  if (p.kind == NETLOFT_INTEGER && named(p.unit)) check_integer(p, who, faults);
  if (p.kind == NETLOFT_TABLE) check_columns(p, who, faults);
  if (p.kind != NETLOFT_CHOICE) return;
  faults.require(count_words(p) > 0, who + " is a choice without words");
  faults.require(p.fallback >= 0 && p.fallback < count_words(p),
                 who + " has a default that is none of its words");
}

void check_parameters(const std::vector<netloft_parameter>& rows, std::uint32_t struct_bytes,
                      const std::string& owner, Faults& faults) {
  constexpr std::uint32_t kMostBytes = 1u << 20;  // a limit far above any plausible size, and far below the
                                                  // memory of a computer
  faults.require(struct_bytes <= kMostBytes, owner + ": its parameters take " + std::to_string(struct_bytes) +
                                                 " bytes, more than " + std::to_string(kMostBytes));
  check_names(rows, owner, "parameter", faults);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    check_parameter(rows[i], struct_bytes, owner, faults);
    if (rows[i].fallback_of && !has_earlier_real(rows, i, rows[i].fallback_of))
      faults.add(owner + ": the default of \"" + shown(rows[i].name) + "\" is a factor on \"" +
                 rows[i].fallback_of + "\", which is no real parameter above it in the table");
  }
}

bool is_stencil(std::uint32_t s) {
  return s == NETLOFT_NODE || s == NETLOFT_BAR || s == NETLOFT_TRIANGLE || s == NETLOFT_BAR_PAIR ||
         s == NETLOFT_TRIANGLE_PAIR || s == NETLOFT_BODY;
}

/// A number of values in words: "1 number in m", "3 pure numbers".
std::string numbers_in(std::uint32_t width, const std::string& unit) {
  const std::string noun = width == 1 ? "number" : "numbers";
  return std::to_string(width) + (unit == "1" ? " pure " + noun : " " + noun + " in " + unit);
}

/// Checks the width and unit of data that the host provides (element_data.hpp lists their names).
void check_data(const ElementType& e, const std::string& owner, Faults& faults) {
  check_names(e.data, owner, "datum", faults);
  for (const auto& d : e.data)
    if (const HostDatum* given = find_datum_on(e.element.stencil, shown(d.name)))
      faults.require(d.width == given->width && (!named(d.unit) || std::string_view(d.unit) == given->unit),
                     owner + ": datum \"" + given->name + "\" is " + numbers_in(d.width, shown(d.unit)) +
                         "; under this name the host gives " + numbers_in(given->width, given->unit) + " (" +
                         given->doc + ")");
}

void check_laws(const ElementType& e, const std::string& owner, Faults& faults) {
  check_names(e.laws, owner, "law slot", faults);
  for (const auto& slot : e.laws)
    faults.require(named(slot.fallback),
                   owner + ": law slot \"" + shown(slot.name) + "\" has no default law");
}

void check_terms(const ElementType& e, const std::string& owner, Faults& faults) {
  check_names(e.terms, owner, "term", faults);
  faults.require(!e.terms.empty(), owner + " has no term");
  for (const auto& t : e.terms) {
    const std::string who = owner + ": term \"" + shown(t.name) + "\"";
    faults.require(t.evaluate != nullptr, who + " has no function");
    faults.require(!(t.traits & NETLOFT_CONSERVATIVE) || (t.traits & NETLOFT_SYMMETRIC),
                   who + " is declared conservative but not symmetric, which is impossible");
    faults.require(!(t.traits & (NETLOFT_HAS_CONVEX | NETLOFT_HAS_METRIC)) || (t.traits & NETLOFT_SYMMETRIC),
                   who + " offers a convex part or a metric, but is not declared symmetric");
    faults.require(!(t.traits & NETLOFT_READS_STATE) || e.state_width > 0,
                   who + " reads a state, but the element remembers nothing");
    faults.require(!(t.traits & NETLOFT_IS_DRAG) || !(t.traits & NETLOFT_READS_CURRENT) ||
                       (t.traits & NETLOFT_READS_VELOCITY),
                   who +
                       " is drag that reads the current but not the velocity of the nodes, so it would be "
                       "wrong in a motion: declare reads_velocity, and use the current minus the velocity");
    for (const auto& name : names_needed_by(t))
      faults.require(has_earlier_real(e.parameters, e.parameters.size(), name),
                     who + " needs the parameter \"" + name + "\", which the element does not have");
  }
}

// Shared unknowns are coordinates of one node, which has three. The widest stencil has four nodes.
constexpr std::size_t kMostGlobals = 3;
constexpr int kMostDofs = 12;

void check_globals(const ElementType& e, const std::string& owner, Faults& faults) {
  check_names(e.globals, owner, "global", faults);
  faults.require(e.globals.size() <= kMostGlobals && e.dofs() <= kMostDofs,
                 owner + " shares " + std::to_string(e.globals.size()) +
                     " numbers; three are allowed, on a stencil of three nodes at most");
  for (const auto& g : e.globals) {
    const std::string who = owner + ": global \"" + shown(g.name) + "\"";
    faults.require(named(g.unit), who + " has no unit (\"1\" is the unit of a pure number)");
    faults.require(!g.needs || has_earlier_real(e.parameters, e.parameters.size(), g.needs),
                   who + " needs the parameter \"" + shown(g.needs) + "\", which the element does not have");
  }
}

void check_flow(const ElementType& e, const std::string& owner, Faults& faults) {
  faults.require(!e.is_flow() || !e.globals.empty(),
                 owner +
                     " is a flow without shared unknowns; the host could not find how much it changes the "
                     "water");
}

/// Whether elements on a stencil may have members. netloft_member has coefficients for at most three nodes.
bool bears_along_lines(std::uint32_t stencil) {
  return stencil == NETLOFT_BAR || stencil == NETLOFT_TRIANGLE || stencil == NETLOFT_BAR_PAIR;
}

void check_members(const ElementType& e, const std::string& owner, Faults& faults) {
  bool has_term = false;
  for (const auto& t : e.terms) {
    if (!(t.traits & NETLOFT_OF_MEMBERS)) continue;
    has_term = true;
    faults.require(
        t.traits & NETLOFT_CONSERVATIVE,
        owner + ": term \"" + shown(t.name) + "\" is the force of members, but is not declared conservative");
  }
  const bool has_members = e.members.count > 0;
  faults.require(has_members == has_term,
                 owner + (has_term ? " has a term of members but declares none"
                                   : " declares members but has no term that is their force"));
  if (!has_members) return;
  faults.require(e.members.write != nullptr, owner + " has members but no function for them");
  faults.require(bears_along_lines(e.element.stencil),
                 owner + " declares members on a stencil that has neither two nor three nodes");
}

/// Returns the struct that a plugin or an element offers for an extension; all zeros if it offers none.
template <class Offer>
Offer read_offer(const void* (*extension)(const char* id), const char* id, const std::string& owner,
                 Faults& faults) {
  const void* offer = nullptr;
  try {
    if (extension) offer = extension(id);
  } catch (...) {
    faults.add(owner + ": its function `extension` throws; no exception may leave a plugin");
  }
  if (!offer) return {};
  check_size(static_cast<const Offer*>(offer));
  return read_struct(static_cast<const Offer*>(offer));
}

void read_offers(ElementType& e, Faults& faults) {
  const auto extension = e.element.extension;
  const auto slots = read_offer<netloft_law_slots>(extension, NETLOFT_EXT_LAWS, e.type, faults);
  const auto globals = read_offer<netloft_globals>(extension, NETLOFT_EXT_SHARED_UNKNOWNS, e.type, faults);
  e.laws = read_rows(slots.rows, slots.count);
  e.globals = read_rows(globals.rows, globals.count);
  e.members = read_offer<netloft_element_members>(extension, NETLOFT_EXT_MEMBERS, e.type, faults);
  e.state_width = read_offer<netloft_memory>(extension, NETLOFT_EXT_MEMORY, e.type, faults).width;
  e.flow = read_offer<netloft_flow>(extension, NETLOFT_EXT_FLOW, e.type, faults);
  e.rides_on = read_offer<netloft_rider>(extension, NETLOFT_EXT_PAIRS, e.type, faults).rides_on;
}

/// Reads the list of inputs of an element. An input of an unknown extension keeps its place in the list;
/// tiles have nullptr at this place.
void read_inputs(ElementType& e) {
  for (auto id = e.element.inputs; id && *id; ++id) e.inputs.push_back(find_extension_input(*id));
}

/// Checks that the element lists the inputs that its terms read. The host provides only listed inputs.
void check_inputs(const ElementType& e, const std::string& owner, Faults& faults) {
  for (const auto& t : e.terms)
    for (std::uint32_t trait = 1; trait != 0; trait <<= 1) {
      const char* id = t.traits & trait ? input_of_trait(trait) : nullptr;
      const bool is_listed = !id || std::ranges::find(e.inputs, find_extension_input(id)) != e.inputs.end();
      if (!is_listed)
        faults.add(owner + ": term \"" + shown(t.name) + "\" reads data of the extension \"" + id +
                   "\", which the element does not list among its inputs");
    }
}

ElementType read_element(const netloft_element& raw, const std::string& plugin, Faults& faults) {
  ElementType e;
  e.element = raw;
  e.type = plugin + "/" + shown(raw.name);
  e.parameters = read_rows(raw.parameters, raw.parameter_count);
  e.data = read_rows(raw.data, raw.datum_count);
  e.terms = read_rows(raw.terms, raw.term_count);
  e.outputs = read_rows(raw.outputs, raw.output_count);
  faults.require(is_stencil(raw.stencil), e.type + " uses a stencil that this program does not know (" +
                                              std::to_string(raw.stencil) + ")");
  faults.require(raw.create && raw.destroy, e.type + " has no create or no destroy");
  faults.require(!raw.output_count || raw.output, e.type + " declares outputs but has no function for them");
  check_parameters(e.parameters, raw.parameter_bytes, e.type, faults);
  check_data(e, e.type, faults);
  check_names(e.outputs, e.type, "output", faults);
  read_offers(e, faults);
  read_inputs(e);
  check_laws(e, e.type, faults);
  check_globals(e, e.type, faults);
  check_flow(e, e.type, faults);
  check_terms(e, e.type, faults);
  check_inputs(e, e.type, faults);
  check_members(e, e.type, faults);
  return e;
}

SolverType read_solver(const netloft_solver& raw, const std::string& plugin, Faults& faults) {
  SolverType s;
  s.solver = raw;
  s.type = plugin + "/" + shown(raw.name);
  s.parameters = read_rows(raw.parameters, raw.parameter_count);
  faults.require(raw.solve != nullptr, s.type + " has no solve");
  check_parameters(s.parameters, raw.parameter_bytes, s.type, faults);
  return s;
}

bool has_parameter(const LawType& law, const char* name) {
  return std::any_of(law.parameters.begin(), law.parameters.end(),
                     [&](const auto& p) { return named(p.name) && std::string_view(p.name) == name; });
}

void check_validity(const LawType& law, Faults& faults) {
  for (const auto& v : law.validity) {
    faults.require(v.quantity <= NETLOFT_ATTACK,
                   law.type + " has a range of a quantity this program does not know (" +
                       std::to_string(v.quantity) + ")");
    faults.require(v.lo <= v.hi, law.type + " has an empty range");
    faults.require(named(v.source), law.type + " has a range without a source");
    for (const char* name : {v.where, v.unless})
      faults.require(!name || has_parameter(law, name), law.type + " has a range that depends on \"" +
                                                            shown(name) + "\", which is no parameter of it");
  }
}

LawType read_law(const netloft_law& raw, const std::string& plugin, Faults& faults) {
  LawType l;
  l.law = raw;
  l.type = plugin + "/" + shown(raw.name);
  l.parameters = read_rows(raw.parameters, raw.parameter_count);
  faults.require(raw.evaluate != nullptr, l.type + " has no function");
  faults.require(raw.kind == NETLOFT_TWINE_LAW || raw.kind == NETLOFT_SCREEN_LAW,
                 l.type + " is a law of a kind this program does not know");
  l.validity = read_rows(raw.validity, raw.validity_count);
  check_validity(l, faults);
  check_parameters(l.parameters, raw.parameter_bytes, l.type, faults);
  return l;
}

IntegratorType read_integrator(const netloft_integrator& raw, const std::string& plugin, Faults& faults) {
  IntegratorType i;
  i.integrator = raw;
  i.type = plugin + "/" + shown(raw.name);
  i.parameters = read_rows(raw.parameters, raw.parameter_count);
  faults.require(raw.step && raw.order && raw.stable_step, i.type + " has no step, order or stable_step");
  check_parameters(i.parameters, raw.parameter_bytes, i.type, faults);
  return i;
}

StrategyType read_strategy(const netloft_strategy& raw, const std::string& plugin, Faults& faults) {
  StrategyType s;
  s.strategy = raw;
  s.type = plugin + "/" + shown(raw.name);
  s.parameters = read_rows(raw.parameters, raw.parameter_count);
  faults.require(raw.run != nullptr, s.type + " has no run");
  check_parameters(s.parameters, raw.parameter_bytes, s.type, faults);
  return s;
}

void check_version(const netloft_plugin& p, const std::string& file) {
  const std::string built = std::to_string(p.abi_major) + "." + std::to_string(p.abi_minor);
  const std::string here = std::to_string(NETLOFT_ABI_MAJOR) + "." + std::to_string(NETLOFT_ABI_MINOR);
  if (p.abi_major != NETLOFT_ABI_MAJOR)
    throw PluginRefused(file + ": built for plugin interface " + built + ", but this program has interface " +
                        here + "; build the plugin again with this program's headers");
  if (p.abi_minor > NETLOFT_ABI_MINOR)
    throw PluginRefused(file + ": built for the newer plugin interface " + built +
                        ", but this program has interface " + here + "; update the program");
  if (p.flags & NETLOFT_FAST_MATH)
    throw PluginRefused(file +
                        ": compiled with -ffast-math, which changes the arithmetic of the whole program; "
                        "build it without");
}

}  // namespace

namespace {

template <class Raw, class Read, class Type>
void read_all(const Raw* raw, std::uint32_t count, const std::string& stem, const char* what, Read&& read,
              std::vector<Type>& to, Faults& faults) {
  const auto rows = read_rows(raw, count);
  check_names(rows, stem, what, faults);
  for (const auto& row : rows) to.push_back(read(row, stem, faults));
}

void read_components(const netloft_plugin& p, const std::string& stem, PluginContent& content,
                     Faults& faults) {
  const auto solvers = read_offer<netloft_solvers>(p.extension, NETLOFT_EXT_SOLVER, stem, faults);
  const auto laws = read_offer<netloft_laws>(p.extension, NETLOFT_EXT_LAWS, stem, faults);
  const auto integrators = read_offer<netloft_integrators>(p.extension, NETLOFT_EXT_INTEGRATOR, stem, faults);
  const auto strategies = read_offer<netloft_strategies>(p.extension, NETLOFT_EXT_STRATEGY, stem, faults);
  read_all(p.elements, p.element_count, stem, "element", read_element, content.elements, faults);
  read_all(solvers.rows, solvers.count, stem, "solver", read_solver, content.solvers, faults);
  read_all(laws.rows, laws.count, stem, "law", read_law, content.laws, faults);
  read_all(integrators.rows, integrators.count, stem, "integrator", read_integrator, content.integrators,
           faults);
  read_all(strategies.rows, strategies.count, stem, "strategy", read_strategy, content.strategies, faults);
  faults.require(!content.elements.empty() || !content.solvers.empty() || !content.laws.empty() ||
                     !content.integrators.empty() || !content.strategies.empty(),
                 "holds no element, no solver, no law, no integrator and no strategy");
}

}  // namespace

namespace {

void check_required(const netloft_plugin& p, const std::string& file) {
  for (auto id = p.required; id && *id; ++id)
    if (!has_extension(*id))
      throw PluginRefused(file + ": needs the extension \"" + *id +
                          "\" of the plugin interface, which this program does not have; update the program");
}

constexpr const char* kCure = "; build the plugin again, or look for what wrote over its tables";

netloft_plugin read_head(const netloft_plugin* plugin, const std::string& file) {
  try {
    check_size(plugin);
    return read_struct(plugin);
  } catch (const std::length_error& e) {
    throw PluginRefused(file + ": " + e.what() + kCure);
  }
}

}  // namespace

PluginContent read_plugin(const netloft_plugin* plugin, const std::string& file, const std::string& stem) {
  if (!plugin)
    throw PluginRefused(file + ": the plugin could not describe itself (netloft_plugin_v1 returned null)");
  const netloft_plugin p = read_head(plugin, file);
  check_version(p, file);
  check_required(p, file);

  Faults faults(file);
  faults.require(shown(p.name) == stem, "calls itself \"" + shown(p.name) + "\"; the file " + stem +
                                            ".so must hold the plugin \"" + stem + "\"");
  PluginContent content;
  content.origin = {
      shown(p.name), p.version ? p.version : "", p.doc ? p.doc : "", p.compiler ? p.compiler : "", file, ""};
  try {
    read_components(p, stem, content, faults);
  } catch (const std::length_error& e) {
    faults.add(e.what() + std::string(kCure));
  }
  faults.raise();
  return content;
}

std::vector<std::string> names_needed_by(const netloft_term& term) {
  std::vector<std::string> names;
  for (std::string_view rest = term.needs ? term.needs : ""; !rest.empty();) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    if (end > 0) names.emplace_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return names;
}

}  // namespace netloft
