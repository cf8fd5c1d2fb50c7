// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/plan/gear.hpp"
#include "io/gears/plan/net_plan.hpp"
#include "io/scenes/reading/element_choice.hpp"
#include "io/scenes/reading/gear_memory.hpp"
#include "io/scenes/reading/keys.hpp"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace netloft::scenes {

/// Reads `[elements]`: the element types of the parts of a net plan, and parameters that the scene adds for
/// all parts of a kind or for single parts.
class PlanElements {
 public:
  /// Reads the table `elements`. `plan`, `choice` and `memory` have to outlive this object.
  PlanElements(const gears::NetPlan& plan, const gears::Gear& gear, formats::TableReader& elements,
               const ElementChoice& choice, GearMemory& memory);

  /// The element type of a kind of parts, such as "netting"; nullptr after an error.
  const ElementType* type_of(std::string_view kind) const { return made(kind).type; }
  /// Reads the parameters of a part. `[elements.NAME]` overrides `[elements.KIND]`, which overrides the
  /// numbers of the plan. `path` names the part in messages. Returns false after an error.
  bool read_part(std::string_view kind, const std::string& path, formats::Value numbers, bool is_of_catalogue,
                 Part& part) const;

  /// Whether the scene has `[elements.contact]`, which lets parts that touch the bed rest on it.
  bool has_contact() const { return contact_.has_value(); }
  /// A contact part that keeps a rope or a body of the plan on the bed, as a table like those in `[parts]`.
  /// Its elements are at the points `on`.
  formats::Value contact_of(const std::string& name, std::vector<std::string> on, formats::Place place) const;

 private:
  /// The table `[elements.KIND]`, and the element type that it selects.
  struct Made {
    const GearElements* of = nullptr;
    formats::Value said;  // the table as read
    const ElementType* type = nullptr;
  };

  Made read_elements(formats::TableReader& elements, const GearElements& of) const;
  void read_exceptions(formats::TableReader& elements, const gears::Gear& gear);
  bool touches_bed(const std::string& name) const;
  /// Reads the parameters of a part. `said` has the sources of the scene, but no messages yet.
  std::shared_ptr<const PartTableRead> read_table(const PartTable& input, formats::Diagnostics said) const;
  const Made& made(std::string_view kind) const;

  const gears::NetPlan& plan_;
  const ElementChoice& choice_;
  GearMemory& memory_;
  formats::Diagnostics& diagnostics_;
  std::vector<Made> made_;
  std::optional<formats::Value> contact_;  // `[elements.contact]`, a table
  // The tables `[elements.NAME]` by name. The first map has those for parts of the gear, the second one those
  // for which NAME is a pair.
  std::map<std::string, formats::Value> exceptions_, exceptions_of_pairs_;
};

}  // namespace netloft::scenes
