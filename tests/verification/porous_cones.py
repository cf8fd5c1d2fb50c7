#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Cones and discs of netting in a current: the water that flow/momentum slows, beside that of OpenFOAM.

    porous_cones.py NETLOFT                      compares, and prints the table of README.md
    porous_cones.py NETLOFT --check              exit 1 if a cone differs by more than LIMITS
    porous_cones.py NETLOFT --openfoam FOLDER    computes data/porous-cones.txt anew, with simpleFoam and blockMesh, in FOLDER

The mouth has a radius of 1 m, the aft end, which is open, 0.1 m. The force on a square metre of netting is that of Løland's screen, which is
written down here once more. A disc has the drag coefficient of its screen instead of an angle.
"""
import argparse
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile

DATA = pathlib.Path(__file__).parent / "data/porous-cones.txt"
CONES = [(angle, S) for angle in (10, 20, 30, 45) for S in (0.1, 0.2, 0.3, 0.4)]
DISCS = (0.1, 0.25, 0.5, 1.0, 2.0)
END = 0.1  # [m], radius of the aft end
LIMITS = {"drag": 0.05, "speed": 0.02}  # relative; of the undisturbed speed


def screen(cosine, S):
    """Løland's drag coefficient, and lift coefficient over sin θ cos θ. Beyond solidities of 0.13 and 0.35 they go on as in Netloft."""
    few, S = min(1, S / 0.13), min(max(S, 0.13), 0.35)
    return few * (0.04 + (S * (0.33 + S * (6.54 - 4.88 * S)) - 0.04) * cosine), few * 2 * S * (-0.05 + S * (2.3 - 1.76 * S))


# --- Netloft ---

FACETS, BAR = 24, 0.01  # facets of the whole cone; [m]


def corners_of_facet(k, angle):
    """Corners of the starboard part of facet k, from the top: fore inner, fore outer, aft outer, aft inner."""
    radius = math.sqrt(math.pi / (FACETS / 2 * math.sin(2 * math.pi / FACETS)))  # so that the mouth has the area of a circle
    half, middle = math.pi / FACETS, math.pi / 2 - 2 * math.pi / FACETS * k
    length = (1 - END) / math.tan(math.radians(angle))

    def corner(share, at, x):
        if abs(abs(at) - math.pi / 2) < 1e-9:  # in the middle of a facet
            return [x, 0, math.copysign(share * radius * math.cos(half), at) - 50]
        return [x, share * radius * math.cos(at), share * radius * math.sin(at) - 50]

    inner, outer = min(middle + half, math.pi / 2), max(middle - half, -math.pi / 2)
    if middle < -math.pi / 2 + 1e-9:
        inner, outer = outer, inner
    return [corner(1, inner, 0), corner(1, outer, 0), corner(END, outer, length), corner(END, inner, length)]


def panel(k, angle, S):
    fore_inner, fore_outer, aft_outer, aft_inner = corners = corners_of_facet(k, angle)
    middle = k in (0, FACETS // 2)
    mesh = math.sqrt(2) * BAR  # width and length of an open mesh
    fore, aft = math.dist(fore_inner, fore_outer) / mesh, math.dist(aft_outer, aft_inner) / mesh
    ahead, behind = ([(a + b) / 2 for a, b in zip(*ends)] for ends in ((fore_inner, fore_outer), (aft_inner, aft_outer)))
    deep = (math.dist(fore_inner, aft_inner) if middle else math.dist(ahead, behind)) / mesh
    counts = [[0, 0], [fore, 0], [aft, deep], [0, deep]] if middle else [[-fore / 2, 0], [fore / 2, 0], [aft / 2, deep], [-aft / 2, deep]]
    return (f'[panels.facet{k}]\nstands = "{"middle" if middle else "pair"}"\nmesh = {2 * BAR}\nopen = ["aft"]\n'
            f"twine = {{ diameter = {S * BAR / 2}, EA = 1000, density = 1140 }}\n"
            f"corners = {[[round(a, 6) for a in pair] for pair in counts]}\nsketch = {corners}\n"), math.dist(fore_inner, fore_outer)


def plan(angle, S):
    """Half a cone as a net plan, all of whose netting is held."""
    last = FACETS // 2
    panels, widths = zip(*(panel(k, angle, S) for k in range(last + 1)))
    text = ['[gear]\nextent = "half"\nsize = 0.1\n[water]\ndensity = 1000\ncurrent = [1, 0, 0]\n[flow]\ntype = "flow/momentum"\n'
            '[elements.netting]\ndrag = { law = "hydro/loland", shielding = 1 }\n', *panels]
    for k in range(last):
        text.append(f'[[join]]\nedges = ["facet{k}.{"outer" if k else "sides"}", "facet{k + 1}.{"inner" if k + 1 < last else "sides"}"]\n')
    for rope, facets in (("headline", range(last // 2)), ("footrope", range(last, last // 2 - 1, -1))):
        text.append(f'[ropes.{rope}]\nstands = "middle"\nlength = {2 * sum(widths[k] for k in facets):.9f}\n'
                    "rope = { diameter = 1e-6, EA = 1000, density = 1140 }\n")
        text += [f'[[hang]]\nedge = "facet{k}.fore"\non = "{rope}"\nlength = {widths[k]:.9f}\n' for k in facets]
    text.append(f"[[hold]]\non = {json.dumps([f'facet{k}' for k in range(last + 1)])}\n")
    return "".join(text)


def by_netloft(program, angle, S):
    """Drag coefficient over the mouth; speeds in the mouth, in the middle of the bag, and at the netting, over the undisturbed one."""
    with tempfile.TemporaryDirectory() as folder:
        scene = pathlib.Path(folder) / "cone.toml"
        scene.write_text(plan(angle, S))
        done = subprocess.run([program, "run", scene, "--json", "-o", folder + "/cone.hdf"], capture_output=True, text=True)
    figures = json.loads(done.stdout)["gear"]["figures"] if done.stdout else sys.exit(done.stderr)
    return (figures["drag/netting/x"] / (500 * figures["mouth/area"]), figures["mouth/water_speed"], figures["panels/facet1/water_speed"],
            1 - figures["mouth/induction"])


def disc_by_momentum(C):
    """The same of a disc whose drag coefficient is C in the water that passes through it, by the closed form of flow/momentum."""
    speed = 4 / (4 + C)
    return C * speed**2, speed, speed, speed


# --- OpenFOAM: a wedge of 5 degrees; the netting is a layer of porous cells ---

LAYER, UP, DOWN, OUT = 0.05, 10.0, 20.0, 10.0  # [m]: thickness of the layer; extent of the water
ZONES, ROUNDS, STEPS, VISCOSITY = 8, 3, 110, 1e-4
WEDGE = math.tan(math.radians(2.5))
ENVIRONMENT = dict(os.environ, WM_PROJECT_DIR="/usr/share/openfoam", FOAM_ETC="/usr/share/openfoam/etc")


def growth(length, cells, first):
    """Last over first cell of a row of cells that grow from `first`."""
    low, high = 1.0001, 2.0
    for _ in range(100):
        q = (low + high) / 2
        low, high = (q, high) if first * (q**cells - 1) / (q - 1) < length else (low, q)
    return low ** (cells - 1)


def rows_of_cone(angle):
    """Places along x, radii at a place, and per row of blocks along x and outwards: cells and growth; zone of a block."""
    slope, cosine = math.tan(math.radians(angle)), math.cos(math.radians(angle))
    length = (1 - END) / slope
    cells = max(4, round(length / 0.06 / ZONES))
    first = length / ZONES / cells

    def radii(x):
        middle = 1 - min(max(x, 0), length) * slope
        return [0, middle - LAYER / cosine / 2, middle + LAYER / cosine / 2, OUT]

    along = [-UP, *(length * i / ZONES for i in range(ZONES + 1)), length + DOWN]
    return (along, radii, [45, *[cells] * ZONES, 70], [1 / growth(UP, 45, first), *[1] * ZONES, growth(DOWN, 70, first)], [26, 6, 44],
            [0.35, 1, growth(OUT - 1, 44, LAYER / 4)], lambda i, j: f"zone{i - 1}" if j == 1 and 1 <= i <= ZONES else "")


def rows_of_disc():
    radii = [0, *(math.sqrt((i + 1) / ZONES) for i in range(ZONES)), OUT]
    cells = [max(3, round((radii[i + 1] - radii[i]) / 0.03)) for i in range(ZONES)]
    return ([-UP, -LAYER / 2, LAYER / 2, DOWN], lambda x: radii, [50, 6, 90], [1 / growth(UP, 50, LAYER / 6), 1, growth(DOWN, 90, LAYER / 6)],
            [*cells, 50], [*[1] * ZONES, growth(OUT - 1, 50, 0.03)], lambda i, j: f"zone{j}" if i == 1 and j < ZONES else "")


def dictionary(kind, name):
    return f"FoamFile {{ version 2.0; format ascii; class {kind}; object {name}; }}\n"


def block_mesh(along, radii, cells_along, grow_along, cells_out, grow_out, zone):
    numbers, points, blocks = {}, [], []
    faces = {name: [] for name in ("inlet", "outlet", "top", "front", "back", "axis")}

    def point(i, j, side):
        radius = radii(along[i])[j]
        key = (i, j, side if radius else 0)
        if key not in numbers:
            numbers[key] = len(points)
            points.append(f"({along[i]:.9g} {radius:.9g} {side * radius * WEDGE:.9g})")
        return numbers[key]

    for i in range(len(cells_along)):
        for j in range(len(cells_out)):
            at = [point(i + a, j + b, side) for side in (-1, 1) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
            blocks.append(f"hex ({' '.join(map(str, at))}) {zone(i, j)} ({cells_along[i]} {cells_out[j]} 1) "
                          f"simpleGrading ({grow_along[i]} {grow_out[j]} 1)")
            of_block = {"back": (0, 3, 2, 1), "front": (4, 5, 6, 7), "inlet": (0, 4, 7, 3) if i == 0 else None,
                        "outlet": (1, 2, 6, 5) if i == len(cells_along) - 1 else None, "top": (3, 7, 6, 2) if j == len(cells_out) - 1 else None,
                        "axis": (0, 1, 5, 4) if j == 0 else None}
            for name, corners in of_block.items():
                if corners:
                    faces[name].append("(" + " ".join(str(at[c]) for c in corners) + ")")
    kinds = {"front": "wedge", "back": "wedge", "axis": "empty"}
    patches = "".join(f"{name} {{ type {kinds.get(name, 'patch')}; faces ({' '.join(all_of)}); }}\n" for name, all_of in faces.items())
    return ("convertToMeters 1;\nvertices (\n" + "\n".join(points) + ");\nblocks (\n" +
            "\n".join(blocks) + ");\nedges ();\nboundary (\n" + patches + ");\nmergePatchPairs ();\n")


SCHEMES = """ddtSchemes { default steadyState; }
gradSchemes { default Gauss linear; }
divSchemes { default none; div(phi,U) bounded Gauss linearUpwind grad(U); div((nuEff*dev2(T(grad(U))))) Gauss linear; }
laplacianSchemes { default Gauss linear limited 0.5; }
interpolationSchemes { default linear; }
snGradSchemes { default limited 0.5; }
"""
SOLUTION = """solvers {
 p { solver GAMG; smoother GaussSeidel; tolerance 1e-9; relTol 0.02; }
 U { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-10; relTol 0.05; } }
SIMPLE { nNonOrthogonalCorrectors 1; consistent yes; }
relaxationFactors { equations { U 0.9; } fields { p 0.7; } }
"""
SIDES = "front { type wedge; } back { type wedge; } axis { type empty; } top { type slip; }"
VELOCITY = f"""dimensions [0 1 -1 0 0 0 0];
internalField uniform (1 0 0);
boundaryField {{ inlet {{ type fixedValue; value uniform (1 0 0); }} outlet {{ type inletOutlet; inletValue uniform (1 0 0); value uniform (1 0 0); }} {SIDES} }}
"""
PRESSURE = f"""dimensions [0 2 -2 0 0 0 0];
internalField uniform 0;
boundaryField {{ inlet {{ type zeroGradient; }} outlet {{ type fixedValue; value uniform 0; }} {SIDES} }}
"""


class Case:
    """A case of OpenFOAM in a folder. Forces, lengths and speeds refer to a density, a radius of the mouth and a speed of 1."""

    def __init__(self, folder, mesh, angle):
        self.folder, self.angle, self.time = folder, angle, 0
        self.normal = (math.sin(math.radians(angle)), math.cos(math.radians(angle)))
        write = self.write
        write("system", "blockMeshDict", "dictionary", mesh)
        write("system", "fvSchemes", "dictionary", SCHEMES)
        write("system", "fvSolution", "dictionary", SOLUTION)
        write("constant", "transportProperties", "dictionary", f"transportModel Newtonian; nu {VISCOSITY};\n")
        write("constant", "turbulenceProperties", "dictionary", "simulationType laminar;\n")
        write("0", "U", "volVectorField", VELOCITY)
        write("0", "p", "volScalarField", PRESSURE)
        self.run_until(0, "blockMesh")
        for function in ("writeCellVolumes", "writeCellCentres"):
            self.run_until(0, "postProcess", "-func", function, "-time", "0")
        self.volumes, self.centres = self.field("V"), self.field("C")
        for name in ("V", "C", "Cx", "Cy", "Cz"):
            (folder / "0" / name).unlink()
        zones = (folder / "constant/polyMesh/cellZones").read_text()
        self.zones = [[int(n) for n in re.search(rf"zone{k}\s*\{{.*?List<label>\s*\d*\s*\(([^)]*)\)", zones, re.S)[1].split()] for k in range(ZONES)]

    def write(self, place, name, kind, text):
        (self.folder / place).mkdir(parents=True, exist_ok=True)
        (self.folder / place / name).write_text(dictionary(kind, name) + text)

    def run_until(self, time, *words):
        self.write("system", "controlDict", "dictionary", "application simpleFoam; startFrom latestTime; startTime 0; stopAt endTime; "
                   f"endTime {time}; deltaT 1; writeControl timeStep; writeInterval {STEPS}; purgeWrite 1; writeFormat ascii; writePrecision 10;\n")
        with open(self.folder / f"log.{words[0]}", "a") as log:
            if subprocess.run([*words, "-case", self.folder], stdout=log, stderr=subprocess.STDOUT, env=ENVIRONMENT).returncode:
                sys.exit(f"{words[0]} fails: see {log.name}")
        self.time = time

    def field(self, name):
        text = (self.folder / str(self.time) / name).read_text()
        found = re.search(r"internalField\s+nonuniform List<(\w+)>\s*\d+\s*\((.*?)\n\)\s*;", text, re.S)
        if found[1] == "scalar":
            return [float(n) for n in found[2].split()]
        return [tuple(map(float, row.split())) for row in re.findall(r"\(([^()]*)\)", found[2])]

    def use(self, coefficients):
        """Resistance of the layer in each zone, across and along the netting."""
        (sine, cosine), text = self.normal, ""
        for k, (across, along) in enumerate(coefficients):
            text += (f"z{k} {{ type explicitPorositySource; explicitPorositySourceCoeffs {{ selectionMode cellZone; cellZone zone{k}; "
                     f"type DarcyForchheimer; d (0 0 0); f ({across / LAYER:.8g} {along / LAYER:.8g} {along / LAYER:.8g}); coordinateSystem {{ type "
                     f"cartesian; origin (0 0 0); rotation {{ type axes; e1 ({sine:.9f} {cosine:.9f} 0); e2 ({cosine:.9f} {-sine:.9f} 0); }} }} }} }}\n")
        self.write("system", "fvOptions", "dictionary", text)

    def mean_in(self, cells, values):
        return sum(values[c] * self.volumes[c] for c in cells) / sum(self.volumes[c] for c in cells)

    def flow_in_zones(self, U):
        """Mean velocity in the layer, a pair (axial, radial) for each zone."""
        return [tuple(self.mean_in(zone, [u[axis] for u in U]) for axis in (0, 1)) for zone in self.zones]

    def drag(self, U, coefficients):
        """Drag coefficient over the area of the mouth."""
        sine, cosine = self.normal
        force = 0
        for zone, (across, along) in zip(self.zones, coefficients):
            for c in zone:
                normal = U[c][0] * sine + U[c][1] * cosine
                force += self.volumes[c] * math.hypot(U[c][0], U[c][1]) * (across * normal * sine + along * (U[c][0] - normal * sine))
        return force / LAYER / WEDGE

    def speed_across(self, U, x):
        """Mean speed inside the cone in the rows of cells before and behind x, and speed on the axis there."""
        slope, cosine = math.tan(math.radians(self.angle)), math.cos(math.radians(self.angle))
        inside = [c for c, at in enumerate(self.centres) if at[1] < 1 - max(x, 0) * slope - LAYER / cosine / 2 and abs(at[0] - x) < 0.5]
        means, axis = [], []
        for side in (-1, 1):
            rows = {}
            for c in inside:
                if (self.centres[c][0] - x) * side > 0:
                    rows.setdefault(round(self.centres[c][0], 7), []).append(c)
            row = rows[min(rows, key=lambda place: abs(place - x))]
            means.append(self.mean_in(row, [u[0] for u in U]))
            axis.append(U[min(row, key=lambda c: self.centres[c][1])][0])
        return sum(means) / 2, sum(axis) / 2


def cone_by_openfoam(folder, angle, S):
    case = Case(folder, block_mesh(*rows_of_cone(angle)), angle)
    water = [(0.85, 0.025)] * ZONES
    for round_ in range(ROUNDS):
        coefficients = []
        for u in water:  # the coefficients that give the force of the screen in the present flow
            cosine = (u[0] * case.normal[0] + u[1] * case.normal[1]) / math.hypot(*u)
            drag, lift = screen(cosine, S)
            coefficients.append((drag - lift * cosine**2 + lift, drag - lift * cosine**2))
        case.use(coefficients)
        case.run_until((round_ + 1) * STEPS, "simpleFoam")
        U = case.field("U")
        water = case.flow_in_zones(U)
    areas = [sum(case.volumes[c] for c in zone) for zone in case.zones]
    middle = 0.5 * (1 - END) / math.tan(math.radians(angle))
    return (case.drag(U, coefficients), case.speed_across(U, 0)[0], case.speed_across(U, middle)[1],
            sum(u[0] * a for u, a in zip(water, areas)) / sum(areas))


def disc_by_openfoam(folder, C):
    case = Case(folder, block_mesh(*rows_of_disc()), 90)
    coefficients = [(C, C)] * ZONES
    case.use(coefficients)
    case.run_until(2 * STEPS, "simpleFoam")
    U = case.field("U")
    speed = case.mean_in([c for zone in case.zones for c in zone], [u[0] for u in U])
    return case.drag(U, coefficients), speed, speed, speed


# --- comparison ---


def compute_all(folder):
    folder.mkdir(parents=True)
    rows = []
    for kind, cases, solve in (("cone", CONES, cone_by_openfoam), ("disc", [(C,) for C in DISCS], disc_by_openfoam)):
        for case in cases:
            found = solve(folder / "-".join(map(str, (kind, *case))), *case)
            rows.append(f"{kind} {' '.join(map(str, case))} " + " ".join(f"{value:.4f}" for value in found))
            print(rows[-1], flush=True)
    head = [line for line in DATA.read_text().splitlines() if line.startswith("#")] if DATA.exists() else []
    DATA.write_text("\n".join(head + rows) + "\n")


def read_data():
    for line in DATA.read_text().splitlines():
        if not line.startswith("#"):
            kind, *numbers = line.split()
            yield kind, [float(n) for n in numbers[:-4]], [float(n) for n in numbers[-4:]]


def compare(program):
    missed = []
    print("| netting | drag coefficient | error | speed in the mouth | error | in the middle of the bag | error | at the netting | error |")
    print("|" + "---|" * 9)
    for kind, case, foam in read_data():
        found = by_netloft(program, *case) if kind == "cone" else disc_by_momentum(*case)
        name = f"cone, {case[0]:.0f}°, S = {case[1]}" if kind == "cone" else f"disc, C = {case[0]}"
        errors = [found[0] / foam[0] - 1, *(a - b for a, b in zip(found[1:], foam[1:]))]
        cells = [f"{found[0]:.3f} ({foam[0]:.3f}) | {100 * errors[0]:+.1f} %"]
        cells += [f"{a:.3f} ({b:.3f}) | {e:+.3f}" if kind == "cone" or k == 0 else " | "
                  for k, (a, b, e) in enumerate(zip(found[1:], foam[1:], errors[1:]))]
        print(f"| {name} | {' | '.join(cells)} |", flush=True)
        if abs(errors[0]) > LIMITS["drag"] or max(map(abs, errors[1:3])) > LIMITS["speed"]:
            missed.append(name)
    return missed


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("program")
    arguments.add_argument("--openfoam", type=pathlib.Path, metavar="FOLDER")
    arguments.add_argument("--check", action="store_true")
    options = arguments.parse_args()
    if options.openfoam:
        compute_all(options.openfoam)
    missed = compare(options.program)
    if options.check and missed:
        sys.exit(f"differ from OpenFOAM: {', '.join(missed)}")


if __name__ == "__main__":
    main()
