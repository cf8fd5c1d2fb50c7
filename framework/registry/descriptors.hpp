// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/ext/bodies.h>
#include <netloft/ext/flow.h>
#include <netloft/ext/integrator.h>
#include <netloft/ext/laws.h>
#include <netloft/ext/members.h>
#include <netloft/ext/pairs.h>
#include <netloft/ext/shared_unknowns.h>
#include <netloft/ext/strategy.h>

#include "framework/registry/extensions.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace netloft {

/// Thrown if a plugin must not be used. The message gives the file and the reason.
struct PluginRefused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The origin of a component, which is stored in results.
struct PluginOrigin {
  std::string name, version, doc, compiler;
  std::string file;         // empty when compiled into the program
  std::string fingerprint;  // FNV-1a 64 of the words of the file, hexadecimal
};

/// Copies the first `size` bytes of a struct from a plugin; fields beyond that size are zero.
template <class T>
T read_struct(const T* from) {
  T to{};
  std::uint32_t size = 0;
  std::memcpy(&size, from, sizeof size);
  std::memcpy(&to, from, std::min<std::size_t>(size, sizeof to));
  return to;
}

/// Limits of a plausible table: at most kMostRows rows of at least kLeastRow bytes each, which hold the size
/// of the row and one more 32-bit number.
inline constexpr std::uint32_t kMostRows = 4096, kLeastRow = 8;

/// Copies the rows of a table. Throws std::length_error if count or row length are not plausible.
template <class T>
std::vector<T> read_array(const T* from, std::uint32_t count) {
  std::vector<T> to;
  if (count && !from)
    throw std::length_error("has a table of " + std::to_string(count) + " rows that is null");
  if (count > kMostRows) throw std::length_error("has a table of " + std::to_string(count) + " rows");
  const char* at = reinterpret_cast<const char*>(from);
  std::uint32_t stride = 0;
  if (count) std::memcpy(&stride, from, sizeof stride);
  if (count && stride < kLeastRow)
    throw std::length_error("has a table whose rows are " + std::to_string(stride) + " bytes long");
  for (std::uint32_t i = 0; i < count; ++i)
    to.push_back(read_struct(reinterpret_cast<const T*>(at + std::size_t{i} * stride)));
  return to;
}

/// An element type: the plugin's description, checked and copied to the layout of this program.
struct ElementType {
  std::string type;  // name of the type, such as "rope/bar"
  netloft_element element{};
  std::vector<netloft_parameter> parameters;
  std::vector<netloft_datum> data;
  std::vector<netloft_term> terms;
  std::vector<netloft_output> outputs;
  std::vector<netloft_law_slot> laws;
  std::vector<netloft_global> globals;
  netloft_element_members members{};   // all zeros: the element has no members
  netloft_flow flow{};                 // all zeros: the element does not change the water
  std::uint32_t state_width = 0;       // numbers that each element remembers
  const char* rides_on = nullptr;      // the host makes this element on pairs of that one; nullptr: users do
  std::vector<ExtensionInput> inputs;  // inputs of tiles, in the order that the element lists
  const PluginOrigin* origin = nullptr;

  /// Number of nodes of the scene that an element has. In a tile, an element has one more node for the
  /// rotation of a body, and one more for unknowns that its part shares.
  int nodes() const { return static_cast<int>(element.stencil & 0xff); }
  int dofs() const { return 3 * (nodes() + (is_on_body() ? 1 : 0) + (globals.empty() ? 0 : 1)); }
  bool is_on_body() const { return element.stencil == NETLOFT_BODY; }
  bool is_flow() const { return flow.evaluate != nullptr; }
};

/// A solver type: the plugin's description, checked.
struct SolverType {
  std::string type;  // such as "newton/newton"
  netloft_solver solver{};
  std::vector<netloft_parameter> parameters;
  const PluginOrigin* origin = nullptr;
};

/// A type of time integrator: the plugin's description, checked.
struct IntegratorType {
  std::string type;  // such as "newmark/newmark"
  netloft_integrator integrator{};
  std::vector<netloft_parameter> parameters;
  const PluginOrigin* origin = nullptr;

  bool is_explicit() const { return integrator.traits & NETLOFT_EXPLICIT; }
  bool asks_mean_forces() const { return integrator.traits & NETLOFT_BETWEEN; }
};

/// A strategy type: the plugin's description, checked.
struct StrategyType {
  std::string type;  // such as "auto/auto"
  netloft_strategy strategy{};
  std::vector<netloft_parameter> parameters;
  const PluginOrigin* origin = nullptr;
};

/// A type of hydrodynamic law: the plugin's description, checked.
struct LawType {
  std::string type;  // such as "hydro/morison"
  netloft_law law{};
  std::vector<netloft_parameter> parameters;
  std::vector<netloft_validity> validity;
  const PluginOrigin* origin = nullptr;
};

/// Everything in one plugin.
struct PluginContent {
  PluginOrigin origin;
  std::vector<ElementType> elements;
  std::vector<SolverType> solvers;
  std::vector<LawType> laws;
  std::vector<IntegratorType> integrators;
  std::vector<StrategyType> strategies;
};

/// Reads and checks the description of a plugin. The plugin must have the name `stem` of its file. Throws
/// PluginRefused with a sentence for each fault.
PluginContent read_plugin(const netloft_plugin* plugin, const std::string& file, const std::string& stem);

/// Names of the parameters that a term needs: it acts only if at least one of them is not zero. Empty if the
/// term always acts.
std::vector<std::string> names_needed_by(const netloft_term& term);

}  // namespace netloft
