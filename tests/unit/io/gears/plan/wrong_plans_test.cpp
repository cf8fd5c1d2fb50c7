// SPDX-License-Identifier: BSD-3-Clause
// Plans with a common error, each with the text and the place of the message. `count` is the number of errors
// and warnings, because messages that only follow from others should not be reported.
#include "tests/unit/io/gears/catalogue/folder.hpp"
#include "tests/unit/io/gears/plan/plans.hpp"

namespace netloft::gears {
namespace {

struct Wrong {
  const char* name;
  const char* old;
  const char* now;
  const char* says;
  int count = 1;
};

void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.now; }

class WrongPlans : public testing::TestWithParam<Wrong> {};

TEST_P(WrongPlans, AreAnsweredWithPlaceAndCure) {
  const auto checked = check_text(changed_plan(GetParam().old, GetParam().now));
  const std::string said = checked.said();
  EXPECT_NE(said.find(GetParam().says), std::string::npos) << said;
  EXPECT_EQ(checked.diagnostics.errors() + checked.diagnostics.warnings(), GetParam().count) << said;
  for (const auto& finding : checked.diagnostics.sorted())
    EXPECT_GT(finding.place.line, 0) << finding.message;
}

const Wrong kWriting[] = {
    {"NoMesh", "mesh = \"80 mm\"\n", "", "missing key \"mesh\" in panels.bag"},
    {"MeshOfAnotherUnit", "mesh = \"80 mm\"", "mesh = \"80 kg\"", "panels.bag.mesh"},
    {"NoTwine", "mesh = \"80 mm\"\ntwine = { diameter = \"2 mm\", EA = \"3 kN\", density = 960 }",
     "mesh = \"80 mm\"", "missing key \"twine\" in panels.bag"},
    {"TwineThatIsNotThere", "mesh = \"80 mm\"\ntwine = { diameter = \"2 mm\", EA = \"3 kN\", density = 960 }",
     "mesh = \"80 mm\"\ntwine = \"pe-braided-4m\"", "did you mean \"pe-braided-4mm\"?"},
    {"TwineThatIsNoPart", "mesh = \"80 mm\"\ntwine = { diameter = \"2 mm\", EA = \"3 kN\", density = 960 }",
     "mesh = \"80 mm\"\ntwine = 3", "panels.bag.twine"},
    {"NettingThatNamesNothing", "mesh = \"80 mm\"", "netting = {}\nmesh = \"80 mm\"",
     "panels.bag.netting: the name of a part is a text"},
    {"NettingThatIsNotThere", "mesh = \"80 mm\"", "netting = \"83-112-for\"\nmesh = \"80 mm\"",
     "did you mean \"83-112-fore\"?"},
    {"NoDepth", "depth = 50\n", "", "missing key \"depth\" in panels.bag"},
    {"DepthOfNothing", "depth = 50", "depth = 0", "panels.bag.depth"},
    {"NoFore", "fore = 20\ndepth = 50", "depth = 50", "missing key \"fore\" in panels.bag"},
    {"NegativeFore", "fore = 20\ndepth = 50", "fore = -20\ndepth = 50", "panels.bag.fore"},
    {"NoSides", "depth = 50\nsides = \"AN\"", "depth = 50", "missing key \"sides\" in panels.bag"},
    {"SideOfTheWrongName", "depth = 50\nsides = \"AN\"", "depth = 50\nside = \"AN\"", "unknown key \"side\"",
     2},
    {"OuterOfAMiddlePanel", "depth = 50\nsides = \"AN\"", "depth = 50\nsides = \"AN\"\nouter = \"AN\"",
     "unknown key \"outer\" in panels.bag"},
    {"NoDirection", "sides = \"5B1P in\"", "sides = \"5B1P\"",
     "does not contain the direction of \"5B1P\", in or out"},
    {"NoSuchDirection", "sides = \"5B1P in\"", "sides = \"5B1P inwards\"", "\"inwards\" is not a direction"},
    {"StandsNowhere", "stands = \"middle\"", "stands = \"centre\"", "ropes.headline.stands"},
    {"OrientationUnknown", "mesh = \"80 mm\"", "orientation = \"t45\"\nmesh = \"80 mm\"",
     "panels.bag.orientation"},
    {"CutWithoutExtent", "sides = \"5B1P in\"", "sides = [{ cut = \"5B1P in\" }, { cut = \"AN\" }]",
     "more than one of its cuts has neither meshes nor depth"},
    {"CutThatSaysTwoThings", "sides = \"5B1P in\"",
     "sides = [{ cut = \"5B1P in\", depth = 42, meshes = 20 }]",
     "is not the number that 5B1P gives over this depth"},
    {"StraightCutSideways", "sides = \"5B1P in\"", "sides = [{ cut = \"AN\", meshes = 3 }]",
     "AN does not go sideways"},
    {"MeshCutWithoutMeshes", "sides = \"5B1P in\"", "sides = [{ cut = \"AM in\" }, { cut = \"5B1P in\" }]",
     "AM has no depth"},
    {"MeshCutAlone", "sides = \"5B1P in\"", "sides = \"AM in\"", "so that the side has no depth"},
    {"EmptySide", "sides = \"5B1P in\"", "sides = []", "panels.body.sides"},
    {"NoPanels", "[panels.wing]", "[panel.wing]", "unknown key \"panel\""},
    {"NameWithADot", "[panels.bag]", "[panels.\"b.ag\"]",
     "must not contain a dot, which separates a part from its edges"},
    {"NameWithASlash", "[panels.bag]", "[panels.\"b/ag\"]", "must not contain a slash"},
    {"NameOfControlCharacters", "[panels.bag]", "[panels.\"b\\u009bag\"]",
     "must not contain control characters"},
    {"NameTwice", "[points.door]", "[points.bag]", "there is something named \"bag\" already"},
    {"RopeWithoutLength", "length = \"6 m\"\n", "", "missing key \"length\" in ropes.headline"},
    {"RopeOfOneEnd", "between = [\"door\", \"headline.end\"]", "between = [\"door\"]",
     "ropes.bridle.between"},
    {"RopeOfATwine", "rope = { diameter = \"12 mm\", EA = \"100 kN\", density = 1000 }\nlength = \"6 m\"",
     "rope = \"pe-braided-4mm\"\nlength = \"6 m\"", "\"pe-braided-4mm\" is a twine"},
    {"SpreadNotUnderstood", "\"11 along headline\"", "\"eleven along headline\"", "is not understood"},
    {"AngleInTheMiddle", "sides = \"5B1P in\"", "sides = \"5B1P in\"\nangle = \"30 deg\"",
     "would differ to port and to starboard"},
    {"AngleWithoutEnd", "outer = \"AN\"", "outer = \"AN\"\nangle = \"400 deg\"", "panels.wing.angle"},
    {"RoundAndFore", "fore = 20\ndepth = 50", "fore = 20\nround = 20\ndepth = 50",
     "cannot be combined with round"},
    {"RoundPair", "fore = 10\n", "round = 10\n", "a tube is always across the plane of symmetry"},
    {"PiecesThatTaper", "depth = 42\n", "depth = 21\npieces = 2\n", "so their sides are straight"},
    {"NoPieces", "depth = 50\n", "depth = 50\npieces = 0\n", "panels.bag.pieces"},
    {"SelvedgeOfAForeEdge", "edges = [\"body.aft\", \"bag.fore\"]",
     "edges = [\"body.aft\", \"bag.fore\"]\nselvedge = 3", "body.aft is not a side", 2},
    {"NameOfASelvedge", "[points.door]",
     "[[join]]\nedges = [\"bag.sides\", \"bag.sides\"]\nselvedge = "
     "1\n[points.bag-sides-selvedge]\n[points.door]",
     "there is something named \"bag-sides-selvedge\" already"},
    {"SelvedgeOfLessThanNothing", "edges = [\"body.aft\", \"bag.fore\"]",
     "edges = [\"body.aft\", \"bag.fore\"]\nselvedge = -3", "selvedge"},
    {"SpreadNowhere", "\"11 along headline\"", "\"11 at \"", "or \"2 at footrope.end\""},
    {"SpreadOfNothing", "\"11 along headline\"", "\"\"", "is not understood"},
    {"PointToPort", "[points.door]", "[points.door]\nat = [0, -5, 0]", "is to port, y < 0"},
    {"PointBesideThePlane", "[points.door]", "[points.door]\nstands = \"middle\"\nat = [0, 5, 0]",
     "is not on the plane of symmetry"},
    {"SketchOfThreeCorners", "sides = \"5B1P in\"",
     "sides = \"5B1P in\"\nsketch = [[0, 0, 2], [0, 3, 2], [4, 1, 1]]", "panels.body.sketch"},
    {"SpreadWithoutRope", "\"11 along headline\"", "\"11\"", "such as \"47 along headrope\""},
    {"JoinOfOneEdge", "edges = [\"body.aft\", \"bag.fore\"]", "edges = [\"body.aft\"]",
     "two edges that are sewn together"},
    {"JoinOfNumbers", "edges = [\"body.aft\", \"bag.fore\"]", "edges = [\"body.aft\", 3]",
     "give the name of an edge"},
    {"TakeUpOfNothing", "edges = [\"body.aft\", \"bag.fore\"]",
     "edges = [\"body.aft\", \"bag.fore\"]\ntake_up = 0", "take_up"},
    {"HangingSaidTwice", "ratio = 0.5", "ratio = 0.5\nlength = 1", "cannot be combined with length"},
    {"HangingWithoutLength", "ratio = 0.5\n", "", "missing key \"length\""},
};

const Wrong kSewing[] = {
    {"NoRate", "sides = \"5B1P in\"", "sides = \"SB1P in\"",
     "body.sides: cutting \"SB1P\" is not a rate; 5B1P, 30 M over 42 M, fits"},
    {"NoRateAtAll", "sides = \"5B1P in\"", "sides = \"straight in\"",
     "body.sides: cutting \"straight\" is not a rate"},
    {"DoesNotCloseByALittle", "aft = 30\n", "aft = 28.6\n",
     "warning: wing.aft: the cuttings give 30 meshes, but the plan says 28.6, +4.9 %"},
    {"DoesNotClose", "aft = 20\n", "aft = 30\n",
     "error: body.aft: the cuttings give 20 meshes, but the plan says 30, -33.3 %", 2},
    {"WrongDirection", "inner = \"AB out\"", "inner = \"AB in\"", "wing: its sides meet before the aft edge"},
    {"SidesThatMeetHalfway", "depth = 50\nsides = \"AN\"",
     "depth = 50\nsides = [{ cut = \"AB in\", depth = 10 }, { cut = \"AB out\", depth = 10 }, { cut = \"AN\" "
     "}]",
     "bag: its sides meet 10 meshes aft of its fore end: no netting is left between them"},
    {"SideTooDeep", "outer = \"AN\"", "outer = [{ name = \"o\", cut = \"AN\", depth = 30 }]",
     "wing.outer: its cuttings go 30 meshes deep, but the panel 20, +50.0 %"},
    {"SideTooShallow", "outer = \"AN\"", "outer = [{ name = \"o\", cut = \"AN\", depth = 18.9 }]",
     "wing.outer: its cuttings go 18.9 meshes deep"},
    {"TwoEdgesOfOneName", "{ name = \"bosom\", meshes = 20 }", "{ name = \"wing\", meshes = 20 }",
     "two of its edges are named \"wing\"", 3},
    {"TwineFillsTheMesh", "diameter = \"2 mm\"", "diameter = \"50 mm\"",
     "leave no opening in meshes of 100 mm"},
    {"NoMeshesAtAll", "fore = 20\ndepth = 50", "fore = 0\ndepth = 50",
     "bag: has meshes neither along its fore nor"},
    {"JoinOfUnequalEdges", "fore = 20\ndepth = 50", "fore = 24\ndepth = 50",
     "body.aft has 20 meshes, but bag.fore has 24"},
    {"JoinOfAPanelThatIsNotThere", "\"bag.fore\"", "\"bog.fore\"", "there is no panel \"bog\""},
    {"JoinOfAnEdgeThatIsNotThere", "\"bag.fore\"", "\"bag.front\"", "the panel bag has no edge \"front\""},
    {"JoinOfARope", "\"bag.fore\"", "\"headline\"", "\"headline\" is a rope"},
    {"SewnTwice", "edges = [\"body.aft\", \"bag.fore\"]",
     "edges = [\"body.aft\", \"bag.fore\"]\n[[join]]\nedges = [\"bag.fore\", \"bag.aft\"]",
     "\"bag.fore\" is sewn twice, also at plan.toml:"},
    {"RimOfAnEdgeThatIsNotThere", "[points.door]",
     "[bodies.hoop]\nstands = \"middle\"\nrim = { edge = \"bag.front\", width = 1 }\n[points.door]",
     "bodies.hoop.rim.edge: the panel bag has no edge \"front\""},
    {"RimsOfAPairOnOneEdge", "[points.door]",
     "[bodies.hoop]\nrim = { edge = \"bag.aft\", width = 1 }\n[points.door]",
     "bag.aft exists once, but hoop to port and to starboard"},
    {"ThirdEdgeInASeamTwice", "edges = [\"body.aft\", \"bag.fore\"]",
     "edges = [\"body.aft\", \"bag.fore\", \"bag.fore\"]", "\"bag.fore\" is sewn twice"},
    {"LayerOfUnequalMeshes", "edges = [\"body.aft\", \"bag.fore\"]",
     "edges = [\"body.aft\", \"bag.fore\", \"liner.fore\"]\n[panels.liner]\nmesh = \"100 mm\"\n"
     "twine = \"pe-braided-3mm\"\nfore = 12\ndepth = 20\nsides = \"AN\"\nopen = [\"sides\", \"aft\"]",
     "body.aft has 20 meshes, but liner.fore has 12"},
    {"TakeUpOfOneLayerOnly", "edges = [\"body.aft\", \"bag.fore\"]",
     "edges = [\"body.aft\", \"bag.fore\", \"liner.fore\"]\ntake_up = 0.6\n[panels.liner]\nmesh = \"100 "
     "mm\"\n"
     "twine = \"pe-braided-3mm\"\nfore = 12\ndepth = 20\nsides = \"AN\"\nopen = [\"sides\", \"aft\"]",
     "take_up"},
    {"StretchOfAnEdgeSewnTwice", "edges = [\"body.aft\", \"bag.fore\"]",
     "edges = [\"body.aft\", \"bag.fore\"]\n[[join]]\nedges = [[\"body.fore\"], [\"wing.fore\", "
     "\"wing.outer\"]]",
     "\"body.wing\" is sewn twice, also at plan.toml:", 2},
    {"StretchOfAnEdgeHungTwice", "edge = \"wing.inner\"", "edge = \"body.fore\"",
     "\"body.bosom\" is hung twice"},
    {"ThreeEdgesAcrossTheMiddleInARow", "edges = [\"body.aft\", \"bag.fore\"]",
     "edges = [[\"body.aft\", \"body.fore\", \"bag.aft\"], \"bag.fore\"]",
     "3 edges of a row lie across the middle", 4},
    {"SewnToItselfAlone", "edges = [\"body.aft\", \"bag.fore\"]",
     "edges = [\"body.aft\", \"bag.fore\"]\n[[join]]\nedges = [\"patch.outer\", \"patch.outer\"]\n"
     "[panels.patch]\nstands = \"alone\"\nmesh = \"100 mm\"\ntwine = \"pe-braided-3mm\"\nfore = 9\ndepth = "
     "9\n"
     "outer = \"AN\"\ninner = \"AN\"\nopen = [\"fore\", \"aft\", \"inner\"]",
     "exists once and cannot be sewn to itself"},
    {"PairHungOnALoneRope", "[ropes.headline]\nstands = \"middle\"", "[ropes.headline]\nstands = \"alone\"",
     "wing.inner exists to port and to starboard, but headline only once"},
    {"MiddleHungOnAPairOfRopes", "[ropes.headline]\nstands = \"middle\"",
     "[ropes.headline]\nstands = \"pair\"",
     "body.bosom exists only once, but headline to port and to starboard"},
    {"SelvedgeOfAllMeshes", "edges = [\"body.aft\", \"bag.fore\"]",
     "edges = [\"body.aft\", \"bag.fore\"]\n[[join]]\nedges = [\"bag.sides\", \"bag.sides\"]\nselvedge = 10",
     "bag: its seams gather 20 meshes of 20"},
    {"PointsTooFarApart", "[points.door]", "[points.door]\nat = [0, 25, 0]",
     "starboard-door and port-door are 50 m apart, but the ropes between them are only 46 m long"},
    {"LoneRopeToAPair", "[ropes.bridle]\nstands = \"pair\"", "[ropes.bridle]\nstands = \"alone\"",
     "ropes.bridle.between: door exists to port and to starboard, but the rope only once", 2},
    {"MiddleOfARopeToAPair", "[ropes.headline]\nstands = \"middle\"",
     "[ropes.headline]\nstands = \"middle\"\nbetween = [\"door\", \"wing.fore-inner\"]",
     "door exists to port and to starboard, but the middle of the rope only once"},
    {"TakeUpThatIsNot", "edges = [\"body.aft\", \"bag.fore\"]",
     "edges = [\"body.aft\", \"bag.fore\"]\ntake_up = 1.5", "of the take-up 1.5"},
    {"JoinOfMeshesTooSmall", "mesh = \"80 mm\"", "mesh = \"15 mm\"",
     "body.aft is 2 m wide when stretched, but bag.fore 0.3 m: the wider netting would be bunched, ratio "
     "0.15"},
    {"HungOnNothing", "on = \"headline\"\nratio", "on = \"headlin\"\nratio", "did you mean \"headline\"?"},
    {"HungOnAPanel", "on = \"headline\"\nratio", "on = \"body\"\nratio", "\"body\" is a panel"},
    {"EdgeHungTwice", "edge = \"wing.inner\"", "edge = \"body.bosom\"", "\"body.bosom\" is hung twice"},
    {"HungTooLong", "ratio = 0.5", "ratio = 1.05", "the netting would have to be stretched, +5.0 %"},
    {"HungTooShort", "ratio = 0.5", "ratio = 0.1", "its meshes would be bunched, ratio 0.1"},
    {"RopeTooShort", "length = \"6 m\"", "length = \"4.2 m\"",
     "headline is 4.2 m long, but edges take 4.8 m of it: it is 0.6 m too short"},
    {"RopeALittleTooShort", "length = \"6 m\"", "length = \"4.75 m\"", "warning: headline is 4.75 m long"},
    {"RopeToAPointThatIsNotThere", "[\"door\", ", "[\"dor\", ",
     "ropes.bridle.between: there is no point \"dor\""},
    {"RopeToNoEnd", "\"headline.end\"", "\"headline.tip\"", "there is no point \"headline.tip\""},
    {"RopeToNoCorner", "\"headline.end\"", "\"wing.fore-outr\"", "did you mean \"wing.fore-outer\"?"},
    {"PiecesAlongNothing", "\"11 along headline\"", "\"11 along hedline\"", "did you mean \"headline\"?"},
    {"PiecesAlongNoEdge", "\"11 along headline\"", "\"11 along wing.iner\"", "did you mean \"wing.inner\"?"},
    {"PiecesAtNoPoint", "\"11 along headline\"", "\"2 at headline.tip\"",
     "floats.top.spread: there is no point \"headline.tip\""},
    {"PanelJoinedToNothing", "[[join]]\nedges = [\"body.aft\", \"bag.fore\"]\n", "",
     "bag is joined to nothing"},
    {"RopeJoinedToNothing", "between = [\"door\", \"headline.end\"]\n", "", "bridle is joined to nothing", 2},
    {"EdgeThatNobodySews", "open = \"sides\"\n", "",
     "warning: body.sides is neither sewn nor hung: the net is open there"},
    {"EdgesThatNobodySews", "open = [\"sides\", \"aft\"]", "open = []", "open = [\"aft\"]", 2},
    {"HangingForgotten", "[[hang]]\nedge = \"body.bosom\"\non = \"headline\"\nratio = 0.5\n", "",
     "plan.toml:16:18: warning: body.bosom is neither sewn nor hung"},
    {"OpenAndSewn", "open = \"sides\"", "open = [\"sides\", \"wing\"]",
     "error: panels.body.open: body.wing is declared open, but is sewn at plan.toml:"},
    {"OpenAndHung", "open = \"sides\"", "open = [\"sides\", \"bosom\"]",
     "error: panels.body.open: body.bosom is declared open, but is hung at plan.toml:"},
    {"OpenWhereNoEdgeIs", "open = \"sides\"", "open = [\"sides\", \"left\"]",
     "the panel body has no edge \"left\""},
    {"OpenIsNoName", "open = \"sides\"", "open = true", "panels.body.open: give the name of an edge"},
    {"RopeFromAPointToItself", "[points.door]",
     "[ropes.strop]\nrope = { diameter = \"12 mm\", EA = \"100 kN\", density = 1000 }\nlength = \"2 m\"\n"
     "between = [\"door\", \"door\"]\n[points.door]",
     "ropes.strop.between: both ends of the rope are one point"},
    {"RopeFromAPointToItselfByAnotherName", "[points.door]",
     "[ropes.strop]\nrope = { diameter = \"12 mm\", EA = \"100 kN\", density = 1000 }\nlength = \"2 m\"\n"
     "between = [\"bridle.end\", \"headline.end\"]\n[points.door]",
     "ropes.strop.between: both ends of the rope are one point"},
    {"HeadlineOfMillimetres", "length = \"6 m\"", "length = \"60 m\"",
     "warning: headline is 60 m long, but edges take only 4.8 m of it: 55.2 m carry no netting"},
    {"RopeThickerThanLong", "density = 1000 }\nlength = \"6 m\"", "density = 1000 }\nlength = \"12 mm\"",
     "headline is 0.012 m thick and only 0.012 m long", 2},
    {"RoleUnknown", "length = \"6 m\"", "length = \"6 m\"\nrole = \"headrope\"", "ropes.headline.role"},
    {"RoleOfOneSide", "length = \"20 m\"", "length = \"20 m\"\nrole = \"footrope\"",
     "ropes.bridle.role: a footrope runs from one side of the mouth to the other"},
    {"TwoHeadlines", "[points.door]",
     "[ropes.second]\nstands = \"middle\"\nrole = \"headline\"\nlength = \"2 m\"\n"
     "rope = { diameter = \"12 mm\", EA = \"100 kN\", density = 1000 }\n"
     "between = [\"headline.middle\", \"door\"]\n[points.door]",
     "error: second: headline is the headline already, at plan.toml:"},
    {"StartOfARopeInTheMiddle", "[\"door\", \"headline.end\"]", "[\"door\", \"headline.start\"]",
     "there is no point \"headline.start\""},
    {"HalfAFloat", "\"11 along headline\"", "\"11.5 along headline\"",
     "error: floats.top.spread: 11.5 pieces"},
    {"OddNumberOnTwoSides", "\"11 along headline\"", "\"3 at headline.end\"",
     "warning: floats.top.spread: 3 pieces on both sides together, 1.5 on each side"},
    {"FloatsInABunch", "{ buoyancy = \"25 N\" }", "{ buoyancy = \"25 N\", diameter = \"0.6 m\" }",
     "warning: floats.top.spread: 11 floats of 0.6 m side by side are 6.6 m long, but headline is only 6 m"},
    {"MoreFloatsThanPlaces", "{ buoyancy = \"25 N\" }", "{ buoyancy = \"25 N\", diameter = \"2.2 m\" }",
     "error: floats.top.spread: 11 floats of 2.2 m side by side are 24.2 m long, but headline is only 6 m"},
    {"PartsJoinedToOneAnotherOnly", "\"headline.end\"", "\"bridle.end\"", "are joined to each other only"},
};

/// A catalogue of the user that the plan names, and the error that it causes.
struct WrongCatalogue {
  const char* name;
  const char* text;
  const char* says;
};

void PrintTo(const WrongCatalogue& wrong, std::ostream* out) { *out << wrong.text; }

class WrongCatalogues : public testing::TestWithParam<WrongCatalogue> {};

TEST_P(WrongCatalogues, AreAnsweredWithFileAndLine) {
  TestFolder folder, own;
  own.write("own.toml", GetParam().text);
  folder.write("plan.toml", "catalogue = [\"" + own.path().string() + "\"]\n" + kGoodPlan);
  formats::Diagnostics diagnostics;
  read_plan(folder.path() / "plan.toml", {}, diagnostics);
  const std::string said = diagnostics.render(false);
  EXPECT_NE(said.find(GetParam().says), std::string::npos) << said;
  EXPECT_NE(said.find("own.toml:"), std::string::npos) << said;
  EXPECT_EQ(diagnostics.errors(), 1) << said;
}

const WrongCatalogue kCatalogues[] = {
    {"NoDiameter", "[twine.own]\nEA = \"3 kN\"\ndensity = 960\nsource = \"x\"\nuncertainty = \"x\"\n",
     "missing key \"diameter\" in twine.own"},
    {"UnitOfAnotherKind",
     "[twine.own]\ndiameter = \"2 kg\"\nEA = \"3 kN\"\ndensity = 960\nsource = \"x\"\nuncertainty = \"x\"\n",
     "twine.own.diameter"},
    {"TooThick",
     "[twine.own]\ndiameter = \"2 m\"\nEA = \"3 kN\"\ndensity = 960\nsource = \"x\"\nuncertainty = \"x\"\n",
     "twine.own.diameter"},
    {"StiffnessBelowZero",
     "[rope.own]\ndiameter = \"2 mm\"\nEA = \"-3 kN\"\ndensity = 960\nsource = \"x\"\nuncertainty = \"x\"\n",
     "rope.own.EA"},
    {"NoMass", "[twine.own]\ndiameter = \"2 mm\"\nEA = \"3 kN\"\nsource = \"x\"\nuncertainty = \"x\"\n",
     "must be given, or mass and material_density"},
    {"NoSource", "[twine.own]\ndiameter = \"2 mm\"\nEA = \"3 kN\"\ndensity = 960\nuncertainty = \"x\"\n",
     "source"},
    {"KeyUnknown",
     "[twine.own]\ndiameter = \"2 mm\"\nEA = \"3 kN\"\ndensity = 960\ncolour = 1\nsource = "
     "\"x\"\nuncertainty = "
     "\"x\"\n",
     "unknown key \"colour\""},
    {"KindUnknown", "[twin.own]\ndiameter = \"2 mm\"\n", "\"twin\""},
    {"NettingWithoutTwine", "[netting.own]\nmesh = \"80 mm\"\nsource = \"x\"\nuncertainty = \"x\"\n",
     "missing key \"twine\" in netting.own"},
    {"NoToml", "[twine.own\n", "own.toml:1"},
    {"PieceWithoutBuoyancy", "[float.own]\ndiameter = \"0.2 m\"\nsource = \"x\"\nuncertainty = \"x\"\n",
     "must be given, or mass with volume or material_density"},
};

std::string name_of_catalogue(const testing::TestParamInfo<WrongCatalogue>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(OfAUser, WrongCatalogues, testing::ValuesIn(kCatalogues), name_of_catalogue);

std::string name_of(const testing::TestParamInfo<Wrong>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(InWriting, WrongPlans, testing::ValuesIn(kWriting), name_of);
INSTANTIATE_TEST_SUITE_P(InSewing, WrongPlans, testing::ValuesIn(kSewing), name_of);

}  // namespace
}  // namespace netloft::gears
