// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "framework/scene/scene.hpp"
#include "io/formats/toml/table_reader.hpp"

#include <span>

namespace netloft::scenes {

/// Reports at `key` why the registry has no usable plugin with the name that is the value of this key. The
/// first line of `what` becomes the message; further lines, which list the places that were searched, become
/// the hint.
void report_refusal(formats::TableReader& table, const char* key, const std::string& what);

/// Reads a text that must not be empty; reports an empty one.
std::string read_name(formats::TableReader& table, const char* key, const char* doc);

/// The number of nodes of one element of each type. No type may be nullptr.
std::vector<int> nodes_per_element(std::span<const ElementType* const> types);

/// Finds the elements, companion elements and laws of parts in the plugins that a scene names.
class ElementChoice {
 public:
  ElementChoice(Registry& registry, bool& refused) : registry_(registry), refused_(refused) {}

  /// The element type with this name. If there is none, reports an error at the key `type` and returns
  /// nullptr; if the name is empty, returns nullptr without an error. find() rejects a flow (an element that
  /// changes the water), because a flow is not a part of a gear; find_flow() rejects all other elements.
  const ElementType* find(const std::string& name, formats::TableReader& table) const;
  const ElementType* find_flow(const std::string& name, formats::TableReader& table) const;
  /// The companions of an element type: other element types of its plugin that the program adds to every part
  /// of this type, on the same elements. For example, bending is added to the bars of a rope.
  std::vector<const ElementType*> companions_of(const ElementType& type) const;
  /// Reads the parameters of a part, including those of its companions, and its laws, such as a law of drag.
  void read(const ElementType& type, formats::TableReader& table, Part& part) const;

 private:
  const ElementType* look_up(const std::string& name, formats::TableReader& table) const;
  std::vector<netloft_parameter> parameters_with_companions(const ElementType& type) const;
  std::map<std::string, LawChoice> read_laws(const ElementType& type, formats::TableReader& table) const;
  const LawType* find_law(const std::string& name, formats::TableReader& table, const char* key) const;

  Registry& registry_;
  bool& refused_;
};

}  // namespace netloft::scenes
