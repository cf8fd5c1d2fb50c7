// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/registry/registry.hpp"
#include "io/program/session/components.hpp"

namespace netloft::program::schema {

/// What a part may hold, by its type and by whether it stands on others, for two readers: `allOf` leads a
/// checker to the one description that holds, so that it can name the wrong key; `anyOf`, which is always
/// true, offers an editor all of them to complete from.
class PartSchema {
 public:
  void add(const ElementType& e, const PluginContent& plugin);
  /// The same of a rigid body.
  void add_body(const ElementType& e, const PluginContent& plugin);
  Json schema() const;
  Json definitions = Json::object();

 private:
  void check(const ElementType& e, const Json& then);

  Json types_ = Json::array(), checks_ = Json::array(), offers_ = {{{"type", "object"}}};
};

}  // namespace netloft::program::schema
