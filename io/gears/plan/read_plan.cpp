// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/plan/read_plan.hpp"

#include "io/formats/text/name_fault.hpp"
#include "io/formats/units/in_quotes.hpp"
#include "io/formats/work/long_work.hpp"
#include "io/gears/catalogue/folders.hpp"
#include "io/gears/catalogue/part_choice.hpp"
#include "io/gears/plan/outline.hpp"
#include "io/gears/plan/plan_reader.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <span>

namespace netloft::gears {

namespace {

// Keys that tell plans and scenes apart: tables of scenes, keys of [gear] for the division into elements, and
// tables of plans.
constexpr const char* kOfScenes[] = {"water",    "tow",     "bed",      "parts", "hold",
                                     "analysis", "results", "elements", "flow"};
constexpr const char* kOfModels[] = {"extent", "nodes", "size", "finer"};
constexpr const char* kOfPlans[] = {"gear", "panels", "ropes",
                                    "hang", "floats", "points"};  // a ship or bodies alone are not a plan

/// Whether a [[join]] connects parts of a scene rather than edges.
bool joins_parts(formats::TableReader& join) {
  const bool joins = join.has("points");
  if (joins) join.has("together");
  return joins && !join.has("edges");
}

/// Reads one plan; the member functions are steps in the order of execution.
class PlanReader {
 public:
  PlanReader(const formats::Value& root, const Catalogue& catalogue, PlanMemory& memory,
             formats::Diagnostics& diagnostics)
      : root_(root, diagnostics), diagnostics_(diagnostics), catalogue_(catalogue), memory_(memory) {
    for (const char* key : {"catalogue", "accept"}) root_.has(key);  // the caller reads these keys
  }

  NetPlan read() {
    if (root_.has("parts") && !root_.has("panels")) {
      root_.error("parts", "this scene is made of parts; a net plan has its pieces of netting in [panels]",
                  "`netloft plan` says what a scene needs, and what is wrong with it");
      return std::move(plan_);
    }
    read_head();
    read_tables(
        "panels", "the pieces of netting, a table each", formats::Presence::required, memory_.panels,
        [&](const std::string& name, formats::TableReader& t) {
          Panel panel = read_panel(name, t, catalogue_);
          complete(panel);
          return panel;
        },
        plan_.panels);
    read_tables(
        "ropes", "ropes, wires and chains", formats::Presence::optional, memory_.ropes,
        [&](const auto& name, auto& t) { return read_rope(name, t, catalogue_); }, plan_.ropes);
    read_named("floats", "floats and weights", formats::Presence::optional,
               [&](const auto& name, auto& t) { plan_.pieces.push_back(read_pieces(name, t, catalogue_)); });
    read_named("points", "points that ropes lead to", formats::Presence::optional,
               [&](const auto& name, auto& t) { plan_.points.push_back(read_point(name, t)); });
    read_named("bodies", "rigid bodies", formats::Presence::optional,
               [&](const auto& name, auto& t) { add_body(read_plan_body(name, t, catalogue_)); });
    if (root_.has("ship")) read_ship();
    for (auto& table : root_.tables("hang")) plan_.hangings.push_back(read_hanging(table));
    for (auto& table : root_.tables("join"))
      if (!joins_parts(table)) plan_.joins.push_back(read_join(table));
    for (const auto& panel : plan_.panels) close_tube(panel);
    if (diagnostics_.errors() == 0) add_selvedges(plan_, diagnostics_);
    for (const char* key : kOfScenes) root_.has(key);
    root_.finish();
    return std::move(plan_);
  }

 private:
  void read_head() {
    formats::TableReader gear = root_.table("gear", formats::Presence::optional);
    plan_.title = gear.text("title", {.doc = "title of the gear", .fallback = ""});
    plan_.source = gear.text("source", {.doc = "where the plan comes from", .fallback = ""});
    for (const char* key : kOfModels) gear.has(key);
  }

  /// Adds a body and its points, which are points of the plan.
  void add_body(PlanBody body) {
    for (const auto& point : body.points)
      plan_.points.push_back({body.name + "." + point.name, body.stands, {}, body.place});
    plan_.bodies.push_back(std::move(body));
  }

  void read_ship() {
    formats::TableReader ship = root_.table("ship");
    for (const char* name : {kBlock, kWarp})
      if (!names_.insert(name).second)
        ship.error(name, "there is something named \"" + std::string(name) + "\" already",
                   "give your own point or rope another name: [ship] makes the points \"block\" and the "
                   "ropes \"warp\"");
    add_ship(plan_, ship, catalogue_);
  }

  template <class Read>
  void read_named(const char* key, const char* doc, formats::Presence presence, const Read& read) {
    formats::TableReader tables = root_.table(key, presence, doc);
    for_names(tables, [&](const std::string& name) {
      formats::TableReader table = tables.table(name);
      read(name, table);
    });
  }

  /// Calls visit(name) for all tables in `tables`.
  template <class Visit>
  void for_names(formats::TableReader& tables, const Visit& visit) {
    for (const auto& name : tables.keys()) {
      check_name(name, tables);
      formats::report({"reading", name});
      if (tables.kind(name) == formats::Kind::table)
        visit(name);
      else
        tables.table(name);  // reports that it is no table
    }
  }

  /// Reads the parts of one kind. Parts whose table has been read before are taken from memory.
  template <class T, class Read>
  void read_tables(const char* key, const char* doc, formats::Presence presence, TablesRead<T>& stored,
                   const Read& read, std::vector<T>& parts) {
    formats::TableReader tables = root_.table(key, presence, doc);
    for_names(tables, [&](const std::string& name) {
      auto& recent = stored.try_emplace(name, 1).first->second;
      const auto part = recent.of(*tables.raw(name), [&](const formats::Value& table) {
        auto one = std::make_shared<TableRead<T>>();
        formats::Diagnostics said = diagnostics_.without_messages();
        formats::TableReader reader(table, said, tables.path(name));
        one->part = read(name, reader);
        reader.finish();
        one->messages = said.messages();
        return one;
      });
      diagnostics_.take_messages(part->messages);
      parts.push_back(part->part);
    });
  }

  /// Checks that a name has no dot and is used only once. A dot separates the name of a part from those of
  /// its edges and points.
  void check_name(const std::string& name, formats::TableReader& tables) {
    const bool has_dot = name.find('.') != std::string::npos;
    const std::string fault = has_dot
                                  ? "must not contain a dot, which separates a part from its edges (bag.fore)"
                                  : formats::name_fault(name);
    if (!fault.empty())
      diagnostics_.error(tables.place(name), "the name " + formats::in_quotes(name) + " " + fault);
    if (!names_.insert(name).second)
      diagnostics_.error(tables.place(name), "there is something named \"" + name + "\" already",
                         "names of panels, ropes, floats and points must all be different");
  }

  /// Computes the aft edge of a panel from its cuttings if the plan does not state it, and draws the outline.
  void complete(Panel& panel) {
    if (!panel.states_aft) panel.aft = {{"aft", std::max(0.0, aft_by_cuttings(panel)), panel.place}};
    panel.outline = outline_of(panel);
  }

  void close_tube(const Panel& panel) {
    const std::vector<std::string> sides = {panel.name + ".sides"};
    if (panel.is_round)
      plan_.joins.push_back({{sides, sides}, {}, 0, {panel.place, panel.place}, panel.place});
  }

  formats::TableReader root_;
  formats::Diagnostics& diagnostics_;
  const Catalogue& catalogue_;
  PlanMemory& memory_;
  NetPlan plan_;
  std::set<std::string> names_;
};

template <class T>
const T* find_named(const std::vector<T>& all, const std::string& name, formats::NameIndex& names) {
  const auto at = names.find(name, all, [](const T& one) { return one.name; });
  return at ? &all[*at] : nullptr;
}

}  // namespace

namespace {

std::vector<formats::SourceFile> joined(std::vector<formats::SourceFile> files,
                                        const std::vector<formats::SourceFile>& more) {
  files.insert(files.end(), more.begin(), more.end());
  return files;
}

/// Adds the catalogues of the user, of the library, and of the folders that the document names.
std::optional<PlanDocument> with_catalogue(formats::Value root, const std::vector<formats::SourceFile>& files,
                                           const std::filesystem::path& folder,
                                           formats::Diagnostics& diagnostics) {
  if (diagnostics.errors()) return std::nullopt;
  const auto own = named_folders(root, folder, diagnostics);
  PlanDocument plan{std::move(root), Catalogue::load(catalogue_folders(diagnostics, own), diagnostics), {}};
  plan.files = joined(files, plan.catalogue.files());
  return plan;
}

NetPlan read_document(const std::optional<PlanDocument>& document, formats::Diagnostics& diagnostics) {
  if (!document) return {};
  NetPlan plan = read_plan(document->root, document->catalogue, diagnostics);
  plan.files = document->files;
  return plan;
}

void drop(formats::Value& value, std::span<const char* const> keys) {
  if (formats::Table* table = value.as<formats::Table>())
    std::erase_if(table->members, [&](const formats::Member& m) {
      return std::ranges::any_of(keys, [&](const char* key) { return m.key == key; });
    });
}

}  // namespace

std::optional<PlanDocument> PlanDocument::load(const std::filesystem::path& file,
                                               const std::vector<std::string>& overrides,
                                               formats::Diagnostics& diagnostics) {
  const formats::Document document = formats::Document::load(file, {}, diagnostics);
  formats::Value root = document.root();
  for (const auto& change : formats::read_changes(overrides))
    formats::apply(root, change, diagnostics, keys_that_name_parts());
  return with_catalogue(std::move(root), document.files(), file.parent_path(), diagnostics);
}

std::optional<PlanDocument> PlanDocument::parse(const std::string& text, const std::string& name,
                                                formats::Diagnostics& diagnostics) {
  const formats::Document document = formats::Document::parse(text, name, {}, diagnostics);
  return with_catalogue(document.root(), document.files(), {}, diagnostics);
}

NetPlan read_plan(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                  formats::Diagnostics& diagnostics) {
  const formats::LongWork reading({"reading", file.native()});
  return read_document(PlanDocument::load(file, overrides, diagnostics), diagnostics);
}

bool holds_plan(const formats::Value& root) {
  const formats::Table* table = root.as<formats::Table>();
  if (!table || table->find("panels")) return table;
  return !table->find("parts") &&
         std::ranges::any_of(kOfPlans, [&](const char* key) { return table->find(key); });
}

formats::Value tables_of_plan(formats::Value scene) {
  drop(scene, kOfScenes);
  drop(scene, std::array{"catalogue"});
  if (formats::Member* gear = scene.as<formats::Table>()->find("gear")) drop(gear->value, kOfModels);
  return scene;
}

NetPlan read_plan(const formats::Value& tables, const Catalogue& catalogue,
                  formats::Diagnostics& diagnostics) {
  PlanMemory none;
  return PlanReader(tables, catalogue, none, diagnostics).read();
}

NetPlan read_plan(const formats::Value& tables, const Catalogue& catalogue, PlanMemory& memory,
                  formats::Diagnostics& diagnostics) {
  return PlanReader(tables, catalogue, memory, diagnostics).read();
}

NetPlan read_plan_text(const std::string& text, const std::string& name, formats::Diagnostics& diagnostics) {
  return read_document(PlanDocument::parse(text, name, diagnostics), diagnostics);
}

NetPlan read_plan_text(const std::string& text, const std::string& name, const Catalogue& catalogue,
                       formats::Diagnostics& diagnostics) {
  const formats::Document document = formats::Document::parse(text, name, {}, diagnostics);
  if (diagnostics.errors()) return {};
  NetPlan plan = read_plan(document.root(), catalogue, diagnostics);
  plan.files = joined(document.files(), catalogue.files());
  return plan;
}

const Panel* NetPlan::find_panel(const std::string& name) const {
  return find_named(panels, name, panel_names_);
}
const Rope* NetPlan::find_rope(const std::string& name) const { return find_named(ropes, name, rope_names_); }
const Point* NetPlan::find_point(const std::string& name) const {
  return find_named(points, name, point_names_);
}
const BodyPoint* PlanBody::find_point(const std::string& point) const {
  const auto found = std::ranges::find(points, point, &BodyPoint::name);
  return found == points.end() ? nullptr : &*found;
}
const PlanBody* NetPlan::find_body(const std::string& name) const {
  return find_named(bodies, name, body_names_);
}

}  // namespace netloft::gears
