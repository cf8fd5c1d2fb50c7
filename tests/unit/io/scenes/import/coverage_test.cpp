// SPDX-License-Identifier: BSD-3-Clause
//
// For every kind of record in files of FEMNET: a change of the record changes the scene or is reported.
// Records that have no effect in FEMNET, either, are listed. No record is ignored silently.
#include "tests/unit/io/scenes/import/samples.hpp"

namespace netloft::scenes::femnet {
namespace {

enum class Fate { carried, said, idle };

/// A change of a record. If the importer rejects the file, that counts as a change of the scene. `in_motion`:
/// the record acts only in a motion.
struct Record {
  const char *name, *old, *fresh;
  Fate fate;
  bool in_motion = false;
};

/// The gear of the tests, with requested outputs, a bed and waves.
std::string base() {
  std::string gear = sample("03_node_force_symmetry.don");
  gear = changed(gear, "Stiffness (N/m): 0", "Stiffness (N/m): 900");
  return changed(gear, "Wave height (m): 0", "Wave height (m): 1");
}

/// The scene without its comments and findings.
std::string without_comments(const std::string& scene) {
  std::istringstream in(scene);
  std::string out;
  for (std::string line; std::getline(in, line);)
    if (!line.starts_with("#")) out += line + "\n";
  return out;
}

struct Outcome {
  std::string scene, mesh, said;
};

Outcome outcome(const std::string& gear, bool moves) {
  const ImportedSample sample_(gear, sample("03_node_force_symmetry.mdg"),
                               moves ? Sought::motion : Sought::rest);
  Outcome out{without_comments(sample_.imported.scene), formats::mesh_text(sample_.imported.mesh, ""), {}};
  for (const auto& f : sample_.imported.findings) out.said += f.what + ": " + f.text + "\n";
  for (const auto& d : sample_.read.diagnostics.sorted()) out.said += d.message + "\n";
  return out;
}

class Records : public testing::TestWithParam<Record> {};

TEST_P(Records, AreCarriedOverOrSaid) {
  const Record& r = GetParam();
  const std::string gear = *r.old ? changed(base(), r.old, r.fresh) : base() + "\n" + r.fresh + "\n";
  const auto before = outcome(base(), r.in_motion), after = outcome(gear, r.in_motion);
  const bool is_changed = before.scene != after.scene || before.mesh != after.mesh,
             is_said = before.said != after.said;
  EXPECT_EQ(is_changed, r.fate == Fate::carried) << after.scene;
  EXPECT_TRUE(r.fate == Fate::carried || is_said == (r.fate == Fate::said)) << after.said;
}

const Record kFirstPart[] = {
    {"EaOfTwines", "Traction stiffness (N): 5000", "Traction stiffness (N): 4000", Fate::carried},
    {"EaOfSlackTwines", "Compression stiffness (N): 0", "Compression stiffness (N): 2", Fate::carried},
    {"OpeningStiffness", "(N.m/rad): 0", "(N.m/rad): 1", Fate::carried},
    {"MeshSide", "Unstretched length (m): 0.2", "Unstretched length (m): 0.3", Fate::carried},
    {"DensityOfTwines", "Volumic mass (kg/m3): 950", "Volumic mass (kg/m3): 951", Fate::carried},
    {"DiameterOfTwines", "diameter (m): 0.003", "diameter (m): 0.004", Fate::carried},
    {"KnotWithoutItsKeyword", "Knot size (m): 0", "Knot size (m): 0.01", Fate::idle},
    {"CdOfTwines", "Normal Cd: 1.2", "Normal Cd: 1.3", Fate::carried},
    {"FrictionOfTwines", "Tangential Cd: 0.08", "Tangential Cd: 0.09", Fate::carried},
    {"MeshingStepWhereThereIsAMesh", "Meshing step (m): 2", "Meshing step (m): 3", Fate::idle},
    {"InnerTypeWhereThereIsAMesh", "Type of internal nodes: 2\nMeshing", "Type of internal nodes: 1\nMeshing",
     Fate::idle},
    {"MeshingTypeWhereThereIsAMesh", "Meshing type: 1", "Meshing type: 2", Fate::idle},
    {"CornersWhereThereIsAMesh", "1 3 0 0 0 0 3 4", "1 3 1 0 0 0 3 4", Fate::idle},
    {"HexagonalPanels", "hexagonal panels number: 0", "hexagonal panels number: 1", Fate::carried},
    {"EaOfACable", "stiffness (N): 200000", "stiffness (N): 100000", Fate::carried},
    {"EaOfASlackCable", "stiffness (N): 1\n", "stiffness (N): 2\n", Fate::carried},
    {"LengthOfACable", "length (m): 3.1", "length (m): 3.2", Fate::carried},
    {"DensityOfACable", "(kg/m3): 1300", "(kg/m3): 1301", Fate::carried},
    {"DiameterOfACable", "diameter (m): 0.012", "diameter (m): 0.013", Fate::carried},
    {"CdOfACable", "0.012\nNormal Cd: 1.2", "0.012\nNormal Cd: 1.3", Fate::carried},
    {"FrictionOfACable", "0.012\nNormal Cd: 1.2\nTangential Cd: 0.08",
     "0.012\nNormal Cd: 1.2\nTangential Cd: 0.07", Fate::carried},
    {"BlankCd", "0.012\nNormal Cd: 1.2", "0.012\nNormal Cd:", Fate::carried},
    {"BarsWhereThereIsAMesh", "Bars number: 2", "Bars number: 3", Fate::idle},
    {"EndsWhereThereIsAMesh", "1 0 0 -5 1", "1 0 0 -6 1", Fate::idle},
    {"SlidingCables", "\nSliding cables number: 0", "\nSliding cables number: 1", Fate::carried},
    {"MeshingOrderThatIsShort", "pa: 1 el: 1", "pa: 1", Fate::said},
    {"MassOfAType", "Mass X,Y,Z (kg): 0  0  0", "Mass X,Y,Z (kg): 0  0  4", Fate::carried},
    {"AddedMassOfAType", "Added mass X,Y,Z (kg): 0  0  0", "Added mass X,Y,Z (kg): 4  4  4", Fate::carried,
     true},
    {"AddedMassAtRest", "Added mass X,Y,Z (kg): 0  0  0", "Added mass X,Y,Z (kg): 4  4  4", Fate::idle},
    {"BoxOfAType", "Length X,Y,Z (m): 0  0  0", "Length X,Y,Z (m): 1 1 1", Fate::carried},
    {"ForceOfAType", "External forces X,Y,Z (N): 0  0  0", "External forces X,Y,Z (N): 0 0 7", Fate::carried},
    {"FixedAxes", "Displacement X,Y,Z: 1  1  1", "Displacement X,Y,Z: 1  1  0", Fate::carried},
    {"Bed", "Limits sense X,Y,Z: 0  0  0", "Limits sense X,Y,Z: 0  0  1", Fate::carried},
    {"Ceiling", "Limits sense X,Y,Z: 0  0  0", "Limits sense X,Y,Z: 0  0  -1", Fate::said},
    {"Walls", "Limits sense X,Y,Z: 0  0  0", "Limits sense X,Y,Z: 1  0  0", Fate::said},
    {"Symmetry", "Limits sense X,Y,Z: 0  0  0\nSymmetry X,Y,Z: 0  0  0",
     "Limits sense X,Y,Z: 0  0  0\nSymmetry X,Y,Z: 1  0  0", Fate::carried},
    {"Divisor", "Divisor (s): 0.05", "Divisor (s): 0.06", Fate::idle},
    {"Tolerance", "0.000000001000", "0.00001", Fate::idle},
    {"DisplacementLimit", "limit (m): 10", "limit (m): 11", Fate::idle},
    {"Iterations", "iterations: 20000", "iterations: 20", Fate::idle},
    {"RecordStep", "Record time step (s): 0.5", "Record time step (s): 0.6", Fate::carried, true},
    {"BeginOfRecord", "Begining of record (s): 0", "Begining of record (s): 2", Fate::said, true},
    {"EndOfRecord", "End of record (s): 10", "End of record (s): 20", Fate::carried, true},
    {"TimesAtRest", "End of record (s): 10", "End of record (s): 20", Fate::idle},
    {"DirectionOfCurrent", "Current direction (deg.): 0", "Current direction (deg.): 10", Fate::carried},
    {"SpeedOfCurrent", "speed (m/s): 1.2", "speed (m/s): 1.3", Fate::carried},
    {"WavePeriod", "Wave period (s): 10", "Wave period (s): 9", Fate::carried, true},
    {"WaveHeight", "Wave height (m): 1", "Wave height (m): 2", Fate::carried, true},
    {"WaveDirection", "Wave direction (deg.): 0", "Wave direction (deg.): 10", Fate::carried, true},
    {"Depth", "Depth (m): 100", "Depth (m): 50", Fate::carried, true},
    {"WavesAtRest", "Wave height (m): 1", "Wave height (m): 0", Fate::said},
    {"VolumeOfTheCatch", "Volume (m3): 0", "Volume (m3): 2", Fate::carried},
    {"BedFrictionWithoutABed", "Friction coefficient: 0", "Friction coefficient: 0.5", Fate::idle},
    {"BedStiffnessWithoutABed", "Stiffness (N/m): 900", "Stiffness (N/m): 800", Fate::idle},
    {"WantedTension", "\nTensions number: 0",
     "\nTensions number: 1\nTension: 1 comment: #warp# element: 1 node: 1 decimal: 2", Fate::carried},
    {"WantedPosition", "Positions number: 0",
     "Positions number: 1\nPosition: 1 comment: #z# node: 2 axe: 3 decimal: 2", Fate::carried},
    {"ChoicesOfDisplay", "Speed display: 0", "Speed display: 1", Fate::idle}};

const Record kTail[] = {
    {"water_density", "", "input water_density 1000", Fate::carried},
    {"moving_bottomWithoutABed", "", "input moving_bottom", Fate::idle},
    {"sphere_element", "", "input sphere_element 1 6 0.1 3.5", Fate::carried},
    {"sphere_element2", "", "input sphere_element2 1 6 0.1 3.5 4", Fate::carried},
    {"EI_flexion_cable", "", "input EI_flexion_cable 2 80", Fate::carried},
    {"link_flexion_elem2", "",
     "input EI_flexion_cable 2 80\ninput EI_flexion_cable 3 80\ninput link_flexion_elem2 2 3 120",
     Fate::carried},
    {"link_flexion_elem2WithoutBending", "", "input link_flexion_elem2 2 3 120", Fate::said},
    {"netting2ropesWhereThereAreTriangles", "", "input netting2ropes 1 5 0 0 0 1", Fate::idle},
    {"netting2ropesOfAnOlderFemnet", "", "input netting2ropes 1 5 0 0 0", Fate::said},
    {"drag_forces_type3", "", "input drag_forces_type 3", Fate::carried},
    {"drag_forces_type2", "", "input drag_forces_type 2", Fate::said},
    {"spheric_knot", "", "input spheric_knot 1 0.01", Fate::carried},
    {"neutral_angle", "", "input neutral_angle 1 0.5", Fate::idle},
    {"EI_flexion", "", "input EI_flexion 1 0.5", Fate::idle},
    {"current_reduction", "", "input current_reduction 1 0.5", Fate::said},
    {"foil2", "", "input foil2 2 1 1 1 1", Fate::carried},
    {"spheric_limit", "", "input spheric_limit 0 0 0 1 1 1", Fate::said},
    {"water_speed_depth", "", "input water_speed_depth 0 1 0 -10 2 0", Fate::said},
    {"wind", "", "input wind 10 0", Fate::said},
    {"cable_tension_constant", "", "input cable_tension_constant 1 100", Fate::carried},
    {"catch_gravity", "", "input catch_gravity 1", Fate::said},
    {"catch2_volume", "", "input catch2_volume 1", Fate::said},
    {"catch", "", "input catch 1", Fate::said},
    {"tarp", "", "input tarp 1", Fate::said},
    {"slider", "", "input slider 1", Fate::said},
    {"cable_contact", "", "input cable_contact 1", Fate::said},
    {"deck", "", "input deck 1", Fate::said},
    {"ballast2", "", "input ballast2 1", Fate::said},
    {"foil", "", "input foil 1", Fate::said},
    {"openfoam", "", "input openfoam 1", Fate::said},
    {"tab_drag_filt", "", "input tab_drag_filt 1", Fate::said},
    {"elem_noeud", "", "input elem_noeud 1", Fate::said},
    {"hauling_cable4", "", "input hauling_cable4 2 0.5 4 2\n0 9\n0.1 0.1\n1 1", Fate::carried, true},
    {"hauling_cable4AtRest", "", "input hauling_cable4 2 0.5 4 2\n0 9\n0.1 0.1\n1 1", Fate::said},
    {"speed_type_node2", "", "input speed_type_node2 1 2 0 9 1 1 0 0 0 0", Fate::carried, true},
    {"speed_type_node2AtRest", "", "input speed_type_node2 1 2 0 9 1 1 0 0 0 0", Fate::said},
    {"wave_model2", "", "input wave_model 2", Fate::said, true},
    {"winch_speed", "", "input winch_speed 1 2", Fate::said, true},
    {"Auto_convergence", "", "input Auto_convergence", Fate::idle},
    {"convergence_parameters", "", "input convergence_parameters 1 2 3", Fate::idle},
    {"linkWhereThereIsAMesh", "", "input link 0.1", Fate::idle},
    {"type_noeud_XYZ_SUPINFWhereThereIsAMesh", "", "input type_noeud_XYZ_SUPINF 13 0 1 0 1 0 1 2",
     Fate::idle},
    {"Meshing_UVWhereThereIsAMesh", "", "input Meshing_UV 1 2 3", Fate::idle},
    {"rot_XWhereThereIsAMesh", "", "input rot_X 90", Fate::idle},
    {"color_panel", "", "input color_panel 1 2", Fate::idle},
    {"no_visible_panel", "", "input no_visible_panel 1", Fate::idle},
    {"plan_cable", "", "input plan_cable 1", Fate::idle},
    {"panel_cutting", "", "input panel_cutting 1", Fate::idle},
    {"output_paraview", "", "output paraview", Fate::idle},
    {"AnUnknownKeyword", "", "input sphere_elemnt 1 6 0.1 3.5", Fate::said},
    {"ASeparatorTooMany", "", "input  water_density 1000", Fate::said}};

std::string name_of_record(const testing::TestParamInfo<Record>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(FirstPart, Records, testing::ValuesIn(kFirstPart), name_of_record);
INSTANTIATE_TEST_SUITE_P(Tail, Records, testing::ValuesIn(kTail), name_of_record);

}  // namespace
}  // namespace netloft::scenes::femnet
