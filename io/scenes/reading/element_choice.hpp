// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "framework/scene/scene.hpp"
#include "io/formats/toml/table_reader.hpp"

#include <span>

namespace netloft::scenes {

/// Puts what a registry said when it refused a plugin at a key: its sentence is the first line; where it was
/// looked for stands below.
void report_refusal(formats::TableReader& table, const char* key, const std::string& what);

/// A text that must not be empty.
std::string read_name(formats::TableReader& table, const char* key, const char* doc);

/// The number of nodes of an element of each type; all types are known.
std::vector<int> nodes_per_element(std::span<const ElementType* const> types);

/// The elements, companion elements and laws of parts, from the plugins that a scene names.
class ElementChoice {
 public:
  ElementChoice(Registry& registry, bool& refused) : registry_(registry), refused_(refused) {}

  /// Null: there is none of this name, and it was said at `type`. An empty name says nothing.
  const ElementType* find(const std::string& name, formats::TableReader& table) const;
  /// Elements of the same plugin that ride on this one: bending on the bars of a rope.
  std::vector<const ElementType*> companions_of(const ElementType& type) const;
  /// Parameters, those of companions among them, and laws of a part.
  void read(const ElementType& type, formats::TableReader& table, Part& part) const;

 private:
  std::vector<netloft_parameter> parameters_with_companions(const ElementType& type) const;
  std::map<std::string, LawChoice> read_laws(const ElementType& type, formats::TableReader& table) const;
  const LawType* find_law(const std::string& name, formats::TableReader& table, const char* key) const;

  Registry& registry_;
  bool& refused_;
};

}  // namespace netloft::scenes
