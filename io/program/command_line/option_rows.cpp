// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/command_line/option_rows.hpp"

namespace netloft::program {

namespace {

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> words;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(at, from), text.size());
    words.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  return words;
}

/// Reads the type of a value as the tables of options write it: "FILE.svg|FILE.png", "FOLDER",
/// "TEXT:{side,top}".
void read_type(const std::string& type, OptionRow& row) {
  if (const auto open = type.find('{'); open != std::string::npos) {
    row.choices = split(type.substr(open + 1, type.find('}') - open - 1), ',');
    row.value = type.substr(open);
    return;
  }
  row.value = type.substr(0, type.find(':'));
  for (const std::string& one : split(row.value, '|')) {
    row.is_any_file |= one == "FILE";
    row.is_folder |= one == "FOLDER" || one == "DIR";
    if (one.starts_with("FILE.")) row.endings.push_back(one.substr(5));
  }
}

OptionRow row_of(const CLI::Option& option) {
  constexpr int kMany = 2;  // values of options that may be repeated
  OptionRow row;
  row.doc = option.get_description();
  row.group = option.get_group();
  row.is_required = option.get_required();
  row.is_repeated = option.get_items_expected_max() >= kMany;
  if (option.get_items_expected_max() > 0) read_type(option.get_type_name(), row);
  return row;
}

}  // namespace

std::vector<OptionRow> rows_of(const CLI::App& command) {
  std::vector<OptionRow> rows;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group().empty()) continue;
    OptionRow row = row_of(*option);
    if (option->get_positional()) {
      rows.push_back(row);
      rows.back().argument = option->get_name(true);
      row.is_required = false;
    }
    for (const auto& name : option->get_snames()) row.flags.push_back("-" + name);
    for (const auto& name : option->get_lnames()) row.flags.push_back("--" + name);
    if (!row.flags.empty()) rows.push_back(row);
  }
  return rows;
}

std::string full_name(const CLI::App& command) {
  return command.get_parent() ? full_name(*command.get_parent()) + " " + command.get_name()
                              : command.get_name();
}

}  // namespace netloft::program
