// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "io/program/session/components.hpp"

namespace netloft::program::schema {

/// Schemas of parts, by type and by whether the part uses the nodes of other parts. These schemas serve two
/// readers: with `allOf`, a validator finds the one schema that applies, so that it can name the wrong key;
/// with `anyOf`, which always matches, an editor finds all schemas for completion.
class PartSchema {
 public:
  void add(const ElementType& e, const PluginContent& plugin);
  void add_body(const ElementType& e, const PluginContent& plugin);
  Json schema() const;
  Json definitions = Json::object();

 private:
  void check(const ElementType& e, const Json& then);

  Json types_ = Json::array(), checks_ = Json::array(), offers_ = {{{"type", "object"}}};
};

}  // namespace netloft::program::schema
