// SPDX-License-Identifier: BSD-3-Clause
//
// Tables of nodes and bars: the scenes made of them, and the messages about wrong ones.
#include "io/scenes/import/bar_table.hpp"
#include "io/scenes/import/csv_rows.hpp"
#include "tests/folders.hpp"
#include "tests/unit/io/scenes/import/samples.hpp"

#include <numeric>

namespace netloft::scenes {
namespace {

using femnet::changed;

const std::string kTable =
    "node,x,y,z,hold,mass,fx\n"
    "left,0,0,0,xyz,,\n"
    "low,2,0,-0.4,,5,\n"
    "right,4,0,0,yz,,2\n"
    "\n"
    "bar,from,to,length,diameter,EA,density,normal_drag,tangential_drag\n"
    "rope,left,low,2.1,0.012,6e4,1025,1.2,0.08\n"
    "rope,low,right,1.4,0.012,6e4,1025,1.2,0.08\n"
    "stay,left,right,,0.02,1e5,7850,,\n";

struct Read {
  explicit Read(const std::string& text)
      : table(read_bar_table(text, diagnostics.add_source("gear.csv", text), diagnostics)) {}
  std::string said() const { return diagnostics.render(false); }
  formats::Diagnostics diagnostics;
  BarTable table;
};

TEST(BarTable, IsReadCellByCell) {
  const Read read(kTable);
  ASSERT_EQ(read.diagnostics.errors(), 0) << read.said();
  ASSERT_EQ(read.table.nodes.size(), 3u);
  EXPECT_EQ(read.table.nodes[1].at, (std::array<double, 3>{2, 0, -0.4}));
  EXPECT_EQ(read.table.nodes[1].mass, 5);
  EXPECT_EQ(read.table.nodes[2].hold, "yz");
  EXPECT_EQ(read.table.nodes[2].force[0], 2);
  ASSERT_EQ(read.table.ropes.size(), 2u);
  EXPECT_EQ(read.table.ropes[0].bars.size(), 2u);
  EXPECT_EQ(read.table.ropes[0].normal, 1.2);
  EXPECT_FALSE(read.table.ropes[1].normal.has_value());
  EXPECT_EQ(read.table.ropes[1].bars[0].length, 4);  // the distance of the nodes
}

TEST(BarTable, IsTheSameWithOtherSeparatorsLineEndsAndUnits) {
  const Read plain(kTable);
  std::string semicolons = kTable, tabs = kTable, windows;
  for (char& c : semicolons)
    if (c == ',') c = ';';
  for (char& c : tabs)
    if (c == ',') c = '\t';
  for (const char c : kTable) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const std::string units =
      changed(changed(kTable, ",EA,", " , EA [N] ,"), "node,x", "\xEF\xBB\xBF# a note\nnode,x [m]");
  for (const auto& text : {semicolons, tabs, windows, units}) {
    const Read read(text);
    ASSERT_EQ(read.diagnostics.errors(), 0) << read.said();
    EXPECT_EQ(scene_of(read.table, {}, "gear.mesh").scene, scene_of(plain.table, {}, "gear.mesh").scene);
  }
}

TEST(BarTable, BecomesPartsHoldsAndLoads) {
  const auto made = scene_of(Read(kTable).table, {"a note"}, "gear.mesh");
  const auto holds = [&](const std::string& words) { return made.scene.find(words) != std::string::npos; };
  EXPECT_TRUE(holds("# a note\n"));
  EXPECT_TRUE(holds("[parts.rope]\ntype = \"rope/bar\"\nmesh = \"gear.mesh\"\nlength = 3.5\n")) << made.scene;
  EXPECT_TRUE(holds("rope = { diameter = 0.02, EA = 1e+05, density = 7850 }"));
  EXPECT_TRUE(holds("drag = { law = \"hydro/morison\", normal = 1.2, tangential = 0.08 }"));
  EXPECT_TRUE(holds("float = { mass = 5 }"));
  EXPECT_TRUE(holds("force = { x = 2 }"));
  EXPECT_TRUE(holds("[[hold]]\non = \"*.held-1\"\nname = \"held-1\"\n\n"));
  EXPECT_TRUE(holds("[[hold]]\non = \"*.held-2\"\nname = \"held-2\"\naxes = \"yz\"\n"));
  ASSERT_EQ(made.mesh.regions.size(), 2u);
  EXPECT_NEAR(made.mesh.regions[0].numbers[1], 0.6, 1e-15);
  EXPECT_EQ(made.mesh.regions[0].numbers[3], 1);
}

struct Wrong {
  const char *old, *fresh, *says;
};

TEST(BarTable, AnswersWrongCellsWithTheirPlace) {
  const Wrong wrong[] = {
      {"node,x,y,z", "knot,x,y,z", "gear.csv:1:1: error: the first line names the columns"},
      {"node,x,y,z", "node,x,y,zz", "there is no column \"zz\""},
      {"node,x,y,z,hold", "node,x,y,x,hold", "the column x appears twice"},
      {"node,x,y,z,hold", "node,x,y,hold,z [ft]", "z must be in [m], not in [ft]"},
      {"hold,mass,fx\n", "hold,mass\n", "this is cell 7 of a row of 6"},
      {"low,2,0,-0.4,,5,", "low,2,0,-0.4,,5", "this row has 6 cells, but the line of names has 7"},
      {"low,2,0,-0.4,,5,", "low,2,0,,,5,", "gear.csv:3:1: error: z is blank"},
      {"right,4,0,0,yz,,2", "right,4,0,0,5,yz,,2", "this is cell 8 of a row of 7"},
      {"low,2,0,-0.4,,5,", "low,2,0,nan,,5,", "gear.csv:3:9: error: z = \"nan\" is no number"},
      {"low,2,0,-0.4,,5,", "low,2,0,1e9,,5,", "z = 1e+09 m is outside [-1e+06, 1e+06]"},
      {"low,2,0,-0.4,,5,", "low,2,0,0x10,,5,", "is no number"},
      {"low,2,0,-0.4,,5,", "low,2,0,-0.4,up,5,", "hold = \"up\" is not understood"},
      {"low,2,0,-0.4,,5,", "low,2,0,-0.4,,-5,", "mass = -5 kg is outside"},
      {"low,2,0,-0.4,,5,", "left,2,0,-0.4,,5,", "there is a node \"left\" already"},
      {"low,2,0,-0.4,,5,", "lo w,2,0,-0.4,,5,", "\"lo w\" is no name"},
      {"low,2,0,-0.4,,5,", "low,2,0,-0.4,,5,\nodd,1,1,1,,3,", "no bar ends at the node \"odd\""},
      {"low,2,0,-0.4,,5,", "low,2,0,-0.4,,5,\nodd,1,1,1,,,", "no bar ends at the node \"odd\""},
      {"rope,left,low", "rope,left,lo", "there is no node \"lo\" above this line"},
      {"rope,left,low", "rope,left,left", "begins and ends at the same node"},
      {"rope,left,low", "rope,,low", "from is blank"},
      {"rope,left,low,2.1", "rope,left,low,-2.1", "length = -2.1 m is outside"},
      {"rope,low,right,1.4,0.012", "rope,low,right,1.4,0.013",
       "has different properties here than in line 7"},
      {"0.012,6e4,1025,1.2,0.08\nrope,low", "0.012,,1025,1.2,0.08\nrope,low",
       "EA is blank (axial stiffness)"},
      {"1.2,0.08\nstay", "1.2,\nstay", "only one of normal_drag and tangential_drag is given"},
      {"length,diameter,EA", "length,diameter,mass", "there is no column \"mass\""},
      {"stay,left", "\"stay,left", "a quote is opened and not closed"}};
  for (const auto& w : wrong) {
    const Read read(changed(kTable, w.old, w.fresh));
    EXPECT_GE(read.diagnostics.errors(), 1) << w.fresh;
    EXPECT_NE(read.said().find(w.says), std::string::npos) << w.fresh << "\n" << read.said();
    for (const auto& d : read.diagnostics.sorted()) EXPECT_GT(d.place.line, 0) << d.message;
  }
}

TEST(BarTable, IsAnsweredWhereverItIsCutOff) {
  for (std::size_t end = 0; end + 40 < kTable.size(); end += 7) {
    const Read read(kTable.substr(0, end));
    EXPECT_TRUE(read.diagnostics.errors() > 0 || !read.table.ropes.empty()) << end;
  }
  EXPECT_NE(Read("").said().find("the table has no nodes"), std::string::npos);
  EXPECT_NE(Read("node,x,y,z\n1,0,0,0\n").said().find("the table has no bars"), std::string::npos);
}

TEST(CsvRows, TakesQuotesBlanksAndLines) {
  const std::string text = "# a comment\n\n a , \"b,\"\"c\"\"\" ,\r\n\"two\nlines\",é, d\n";
  CsvRows rows(text, 0);
  const auto first = rows.next();
  ASSERT_EQ(first.size(), 3u);
  EXPECT_EQ(first[0].text, "a");
  EXPECT_EQ(first[1].text, "b,\"c\"");
  EXPECT_EQ(first[2].text, "");
  const auto second = rows.next();
  ASSERT_EQ(second.size(), 3u);
  EXPECT_EQ(second[0].text, "two\nlines");
  EXPECT_EQ(second[2].text, "d");
  EXPECT_EQ(second[2].place.line, 5);
  EXPECT_EQ(second[2].place.column, 11);
  EXPECT_TRUE(rows.next().empty());
}

/// TABLE.md has every column with its unit.
TEST(BarTable, IsDescribedOnItsPage) {
  std::ifstream in(test::source_folder() + "/io/scenes/import/TABLE.md");
  std::ostringstream page;
  page << in.rdbuf();
  for (const char* head : {"node,nonsense", "bar,nonsense"}) {
    const std::string said = Read(head).said();
    const auto begin = said.find("there are node") != std::string::npos ? said.find("there are node") + 10
                                                                        : said.find("there are bar") + 10;
    std::istringstream names(said.substr(begin, said.find('\n', begin) - begin));
    for (std::string name; std::getline(names, name, ',');) {
      while (name.starts_with(' ')) name.erase(0, 1);
      EXPECT_NE(page.str().find("| `" + name + "` |"), std::string::npos) << name;
    }
  }
}

}  // namespace
}  // namespace netloft::scenes
