// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace netloft::design {

/// A value that a person chooses for a part. The word `of` says what can be chosen: a key of the catalogue
/// ("rope", "float", "board"), names of the plan ("ropes", "points", "edges"), "metres", or "count".
struct PartField {
  const char* name;  // {name} in the text of the template
  const char* of;
  const char* words;  // label
  const char* usual;  // value that is proposed; empty: the first choice, or what the gear suggests
};

/// A kind of parts that can be added to a gear: the tables that a plan gets, with {words} in the places of
/// choices.
struct PartTemplate {
  const char* kind;
  const char* doc;
  std::vector<PartField> fields;
  /// The tables, in several ways: that which causes no new message of the check is taken, the first ones
  /// first.
  std::vector<const char*> texts;
  /// The name that is replaced by another one, for example to lead ropes from a point to the new board;
  /// empty: nothing.
  const char *moves_from = "", *moves_to = "";
  std::vector<std::string> moves_in = {};  // tables in which names are replaced
};

const std::vector<PartTemplate>& part_templates();

}  // namespace netloft::design
