// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/own_data.hpp"

namespace netloft::scenes {

void read_own_datum(const ElementType& type, const netloft_datum& datum, std::size_t elements,
                    formats::TableReader& table, ElementData& data) {
  if (const HostDatum* meant = find_datum_meant(type.element.stencil, datum.name);
      meant && meant->name != std::string_view(datum.name) && !table.has(datum.name))
    return table.error(datum.name,
                       std::string("is missing: ") + type.type + " needs it, and netloft does not give it",
                       std::string("did its author mean \"") + meant->name + "\" (" + meant->doc + ")?");
  const auto values =
      table.reals(datum.name, {.unit = datum.unit, .doc = datum.doc, .count = formats::exactly(datum.width)});
  if (values.size() != datum.width) return;  // reported already
  auto& own = data[datum.name];
  for (std::size_t e = 0; e < elements; ++e) own.insert(own.end(), values.begin(), values.end());
}

}  // namespace netloft::scenes
