// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/element_choice.hpp"
#include "io/scenes/reading/gear_steps.hpp"

namespace netloft::scenes {

/// Reads `[flow]`, which describes how a net changes the water. The flow becomes a part of the scene on the
/// rim of the mouth, and its index is stored in the parts that it affects (Part::flow). Nodes must be
/// numbered.
class FlowReader {
 public:
  FlowReader(formats::TableReader& root, const ElementChoice& elements, Draft& draft, const GearSteps& gear)
      : root_(root), diagnostics_(root.diagnostics()), elements_(elements), draft_(draft), gear_(gear) {}

  void read();
  /// Reads and checks those keys of `[flow]` that need no mesh.
  void read_undivided();

 private:
  const ElementType* find_type(formats::TableReader& table) const;
  std::optional<Bag> find_bag(formats::TableReader& table) const;
  Bag read_bag(formats::TableReader& table) const;
  std::vector<std::uint32_t> read_rim(formats::TableReader& table) const;
  std::vector<std::uint32_t> read_parts(formats::TableReader& table, const char* key, const char* doc) const;
  bool turn_to_current(std::vector<std::uint32_t>& rim) const;
  std::set<std::string> find_openings(const Bag& bag) const;
  void warn_of_openings(const Bag& bag, const formats::Place& place) const;
  void warn_of_shielding(const Bag& bag, const formats::Place& place) const;
  void put_in_reach(const std::vector<std::uint32_t>& parts, double reach);

  formats::TableReader& root_;
  formats::Diagnostics& diagnostics_;
  const ElementChoice& elements_;
  Draft& draft_;
  const GearSteps& gear_;
};

}  // namespace netloft::scenes
