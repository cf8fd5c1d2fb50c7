// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/result_reader.hpp"

#include "io/formats/text/name_fault.hpp"
#include "io/formats/units/in_quotes.hpp"
#include "io/formats/work/long_work.hpp"
#include "io/scenes/reading/element_choice.hpp"
#include "io/scenes/reading/part_names.hpp"
#include "io/scenes/reading/result_request.hpp"

#include <algorithm>

namespace netloft::scenes {

void ResultReader::read() {
  const bool holds_are_known = diagnostics_.errors() == 0;
  formats::TableReader results = root_.table("results", formats::Presence::optional);
  for (const auto& name : results.keys()) {
    if (const std::string fault = formats::name_fault(name); !fault.empty())
      diagnostics_.error(results.place(name),
                         "the name of a result, " + formats::in_quotes(name) + ", " + fault);
    formats::TableReader entry =
        results.table(name, formats::Presence::required, "such as { of = \"net\", take = \"min z\" }");
    read_result(name, entry, holds_are_known);
  }
}

void ResultReader::read_result(const std::string& name, formats::TableReader& entry, bool holds_are_known) {
  formats::hear_interruption();
  ResultRequest request;
  request.name = name;
  request.of = read_name(entry, "of", "a part, an edge or a point");
  request.take = read_name(entry, "take", "what is taken of it, such as \"min z\" or \"max tension\"");
  if (request.of.empty() || request.take.empty()) return;
  const auto set = draft_.find_set(mention(request.of, entry, "of"));
  if (!set || !draft_.types[set->part]) return;
  request.part = static_cast<std::uint32_t>(set->part);
  request.nodes = draft_.scene_nodes(*set);
  if (draft_.geometries[set->part].body && request.of.find('.') == std::string::npos) {
    request.nodes.resize(1);  // the name of a body means its origin
    request.body = static_cast<std::uint32_t>(out_.scene.body_at(request.nodes[0]).value_or(0));
  }
  drop_repeats(request.nodes);  // a part that is joined to itself has some nodes twice
  if (!understand(request, *draft_.types[set->part], entry)) return;
  if (request.nodes.empty() && draft_.is_sound[set->part] && request.source != ResultRequest::Source::output)
    draft_.refuse_rider(mention("", entry, "take"), request.of);
  if (holds_are_known) check_reaction(request, entry);
  out_.results.push_back(std::move(request));
}

void ResultReader::check_reaction(const ResultRequest& request, formats::TableReader& entry) {
  const int axes = request.axis == 3 ? kAllAxes : 1 << request.axis;
  const bool has_one = std::any_of(request.nodes.begin(), request.nodes.end(),
                                   [&](auto node) { return out_.scene.held[node] & axes; });
  if (request.source == ResultRequest::Source::reaction && !has_one)
    entry.error(
        "take",
        "nothing of " + formats::in_quotes(request.of) + " is held, so that there is no " + request.quantity,
        "take reactions of a part, edge or point that a [[hold]] holds");
}

}  // namespace netloft::scenes
