// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/commands/reference_page.hpp"

#include <fmt/format.h>

namespace netloft::program {

namespace {

/// Replaces every character that `escape` has something else for.
template <class Escape>
std::string escaped(const std::string& text, Escape&& escape) {
  std::string out;
  for (const char c : text) out += escape(c);
  return out;
}

std::string in_html(const std::string& text) {
  return escaped(text, [](char c) -> std::string {
    return c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  });
}

std::string in_markdown(const std::string& text) {
  return escaped(text, [](char c) {
    return std::string("|*_<[\\`").find(c) == std::string::npos ? std::string(1, c) : std::string("\\") + c;
  });
}

std::string code(const std::string& name) { return name.empty() ? "" : "`" + name + "`"; }

std::string markdown_row(const std::vector<std::string>& cells) {
  std::string row = "|";
  for (std::size_t i = 0; i < cells.size(); ++i)
    row += " " + (i == 0 ? code(cells[i]) : in_markdown(cells[i])) + " |";
  return row + "\n";
}

std::string markdown(const Page::Table& t) {
  std::string text = "\n## " + t.heading + "\n\n|";
  for (const auto& column : t.columns) text += " " + column + " |";
  text += "\n|";
  for (std::size_t i = 0; i < t.columns.size(); ++i) text += "---|";
  text += "\n";
  for (const auto& row : t.rows) text += markdown_row(row);
  return text;
}

std::string html_row(const std::vector<std::string>& cells) {
  std::string row = "<tr>";
  for (std::size_t i = 0; i < cells.size(); ++i)
    row += i == 0 ? "<td><code>" + in_html(cells[i]) + "</code></td>" : "<td>" + in_html(cells[i]) + "</td>";
  return row + "</tr>\n";
}

std::string html(const Page::Table& t) {
  std::string text = "<h2>" + in_html(t.heading) + "</h2>\n<table>\n<tr>";
  for (const auto& column : t.columns) text += "<th>" + in_html(column) + "</th>";
  text += "</tr>\n";
  for (const auto& row : t.rows) text += html_row(row);
  return text + "</table>\n";
}

constexpr const char* kStyle =
    "body{font:16px/1.5 sans-serif;max-width:60em;margin:2em auto;padding:0 1em}"
    "table{border-collapse:collapse}td,th{text-align:left;vertical-align:top;padding:.2em .8em .2em 0;"
    "border-bottom:1px solid #ccc}";

}  // namespace

std::string markdown(const Page& page) {
  std::string text = "# " + in_markdown(page.title) + "\n";
  for (const auto& p : page.paragraphs) text += "\n" + in_markdown(p) + "\n";
  if (!page.links.empty()) text += "\n";
  for (const auto& l : page.links)
    text += fmt::format("* [{}]({}.md): {}\n", in_markdown(l.text), l.file, in_markdown(l.doc));
  for (const auto& t : page.tables) text += markdown(t);
  return text;
}

std::string html(const Page& page) {
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title>\n"
      "<style>{1}</style></head><body>\n<h1>{0}</h1>\n",
      in_html(page.title), kStyle);
  for (const auto& p : page.paragraphs) text += "<p>" + in_html(p) + "</p>\n";
  if (!page.links.empty()) text += "<ul>\n";
  for (const auto& l : page.links)
    text += fmt::format("<li><a href=\"{}.html\">{}</a>: {}</li>\n", l.file, in_html(l.text), in_html(l.doc));
  if (!page.links.empty()) text += "</ul>\n";
  for (const auto& t : page.tables) text += html(t);
  return text + "</body></html>\n";
}

}  // namespace netloft::program
