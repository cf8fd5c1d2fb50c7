// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "framework/scene/scene.hpp"
#include "io/formats/toml/table_reader.hpp"

#include <span>

namespace netloft::scenes {

/// Reports at `key` why a registry refused a plugin. The first line of `what` is the message; the lines below
/// it, the places that were searched, become the hint.
void report_refusal(formats::TableReader& table, const char* key, const std::string& what);

/// Reads a text that must not be empty; reports an empty one.
std::string read_name(formats::TableReader& table, const char* key, const char* doc);

/// The number of nodes of an element, for each type. No type may be null.
std::vector<int> nodes_per_element(std::span<const ElementType* const> types);

/// Finds the elements, companion elements and laws of parts in the plugins that a scene names.
class ElementChoice {
 public:
  ElementChoice(Registry& registry, bool& refused) : registry_(registry), refused_(refused) {}

  /// The element type of this name. Null if there is none, which is reported at `type`, or if the name is
  /// empty, which is not reported.
  const ElementType* find(const std::string& name, formats::TableReader& table) const;
  /// Elements of the same plugin that ride on this one, such as bending on the bars of a rope.
  std::vector<const ElementType*> companions_of(const ElementType& type) const;
  /// Reads the laws of a part and its parameters, including those of companions.
  void read(const ElementType& type, formats::TableReader& table, Part& part) const;

 private:
  std::vector<netloft_parameter> parameters_with_companions(const ElementType& type) const;
  std::map<std::string, LawChoice> read_laws(const ElementType& type, formats::TableReader& table) const;
  const LawType* find_law(const std::string& name, formats::TableReader& table, const char* key) const;

  Registry& registry_;
  bool& refused_;
};

}  // namespace netloft::scenes
