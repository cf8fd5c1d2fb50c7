# SPDX-License-Identifier: BSD-3-Clause
"""Commands for bash that once lost data, failed silently, crashed or hung, and the words of the correct answers.

Commands run in a folder with `gear-library` beside them, after `prepare`; in `says`, "…" stands for text that depends on the machine; `holds` is a command that succeeds if nothing was lost. Functions of PRELUDE simulate faults of the system.
"""
from dataclasses import dataclass

PRELUDE = r"""
set -u
panel="gear-library/scenes/dead-weight-panel.toml --set parts.net.cells=[8,8]"
rope="gear-library/scenes/dynamics/released-rope.toml --set analysis.output_interval=0.002 --set analysis.duration=1000"  # no machine ends it before it is killed
flume="gear-library/scenes/83-112-flume-3.0kn.toml"
plan="gear-library/gears/four-panel.toml"
sea="gear-library/scenes/83-112-at-sea-66m.toml --set gear.nodes=100 --set flow.type=none"  # some commands make it a motion
suite=tests/stability
full_disk() { LD_PRELOAD=$FULL_DISK NETLOFT_DISK_BYTES=$1 "${@:2}"; }
killed() {
  "$@" >/dev/null 2>&1 &
  until [[ -e r.hdf.part && $(stat -c %s r.hdf.part) -gt 500000 ]] || ! kill -0 $! 2>/dev/null; do sleep 0.001; done
  kill -9 $!; wait $! 2>/dev/null
  size=$(stat -c %s r.hdf.part)
}
limited() { (ulimit "$1" "$2"; "${@:3}"); }
interrupted() {  # when it says how far it is, or a plugin that it loops
  set -m  # or it would ignore the interrupt
  HOSTILE_TELLS=1 "$@" 2>words &
  until grep -q "^progress\|^hostile loops" words || ! kill -0 $! 2>/dev/null; do sleep 0.01; done
  kill -INT $!; wait $!; code=$?
  cat words >&2; return $code
}
flip() { python3 -c 'import sys; b = bytearray(open(sys.argv[1], "rb").read()); b[len(b) // 3] ^= 4; open(sys.argv[1], "wb").write(b)' "$1"; }
line() {
  printf '[parts.line]\ntype = "rope/bar"\nlength = "10 m"\ncells = 4\nsketch = [[%s, 0, 0], [%s, 0, -9]]\n' $1 $(($1 + 1))
  printf 'rope = { diameter = "20 mm", EA = "%s", density = 1150 }\n[[hold]]\non = "line.start"\n' "$2"
}
optimum() {
  printf 'scene = "gear-library/scenes/dead-weight-panel.toml"\nset = ["parts.net.cells=[8,8]"]\n[variables.d]\nkey = "parts.net.twine.density"\n'
  printf 'range = [1100, 3000]\n[objective]\nminimise = "%s"\nunit = "%s"\n' "$1" "$2"
}
evil() { line 0 "100 kN"; printf '[parts.evil]\ntype = "hostile/%s"\non = "line.end"\n' "$1"; }
"""


@dataclass
class Answer:
    group: str
    command: str
    code: int
    says: str
    prepare: str = ""
    holds: str = "true"
    needs: str = ""  # FULL_DISK, PLUGINS or MEMORY, which builds with sanitizers lack


def answers(group, *rows):
    return [Answer(group, *row[:3], **(row[3] if len(row) > 3 else {})) for row in rows]


KILLED = "killed netloft run $rope -o r.hdf"
GOES_ON = 'test "$(stat -c %s r.hdf.part)" -ge "$size"'
OLD = {"prepare": "echo old > out.svg", "holds": "grep -qx old out.svg", "needs": "FULL_DISK"}

ALL = [
    *answers(
        "1. A disk that is still full when a motion goes on",
        ("full_disk 100000 netloft run $rope -o r.hdf --resume", 1, "r.hdf.part: No space left on device",
         {"prepare": KILLED, "holds": GOES_ON, "needs": "FULL_DISK"})),
    *answers(
        "2. Files that are in the way, and writers on a full disk",
        ("netloft run $rope -o r.hdf", 2, "r.hdf.part holds … outputs of a run that did not end; --resume goes on from them; --overwrite "
         "replaces it, -o writes elsewhere", {"prepare": KILLED, "holds": GOES_ON}),
        ("netloft run $panel -o p.hdf --overwrite", 1, "p.hdf.part: it is a symbolic link",
         {"prepare": "echo mine > precious; ln -s precious p.hdf.part", "holds": "grep -qx mine precious"}),
        ("full_disk 100 netloft draw gear-library/gears/83-112-eastern.toml -o out.svg", 1,
         "out.svg cannot be written: No space left on device", OLD),
        ("full_disk 100 netloft compare $panel --solver newton --tolerance 1e-2:1e-2 --repeats 1 -o out.svg", 1,
         "out.svg cannot be written: No space left on device", OLD)),
    *answers(
        "3. A method that does not fit, and a result that is worse than the existing one",
        ("netloft run gear-library/scenes/verification/towed-line.toml -o p.hdf --solver lbfgs", 2, "lbfgs",
         {"prepare": "netloft run $panel -o p.hdf >/dev/null; cp p.hdf good.hdf", "holds": "cmp -s p.hdf good.hdf"}),
        ("netloft run $panel -o p.hdf --set analysis.max_iterations=3", 3,
         "p.hdf holds a better result and is kept; the new result is not converged and is written to p.not-converged.hdf",
         {"prepare": "netloft run $panel -o p.hdf >/dev/null; cp p.hdf good.hdf", "holds": "cmp -s p.hdf good.hdf"})),
    *answers(
        "4. A motion that was killed",
        ("netloft report r.hdf.part", 3, "running", {"prepare": KILLED, "holds": GOES_ON})),
    *answers(
        "5. Half a gear with a difference between port and starboard",
        ("netloft plan $flume --set 'water.current=[\"3 kn\", \"1 kn\", 0]'", 2, "water.current: flows across the plane y = 0"),
        ("netloft plan $flume --set 'water.current={ z = [0, -50], x = [1, 1], y = [0, 0.5] }'", 2, "flows across the plane y = 0"),
        ("netloft plan $flume --set parts.bed.seabed.slope_y=0.1", 2, "slope_y"),
        ("netloft plan gear-library/scenes/four-panel.toml --set 'hold[0].at=[0, -5, -30]'", 2,
         "upper-bridle and lower-bridle lie up to 5 m beyond the plane of symmetry, y = 0")),
    *answers(
        "6. A residual that is round-off as large as the load",
        ("netloft run line.toml", 3, "line: not converged … rounding of the elements' lengths alone causes forces of … the stiffness of the gear is too "
         "high for its load", {"prepare": 'line 0 "7e11 kN" > line.toml'}),
        ("netloft run line.toml --solver relaxation", 3, "line: not converged … rounding of the positions alone causes forces of … the stiffness of the gear is "
         "too high for its load", {"prepare": 'line 100000 "1e9 kN" > line.toml'})),
    *answers(
        "7. Plans and scenes with unlikely or impossible values",
        ("netloft check plan.toml", 0, "plan.toml:14:9: warning: top.sides is neither sewn nor hung: the net is open there",
         {"prepare": "sed '/top.sides/d' $plan > all; sed '0,/^\\[\\[join\\]\\]$/{/^\\[\\[join\\]\\]$/d}' all > plan.toml"}),
        ("netloft check $plan --set 'ropes.upper-bridle.between=[\"headline.end\", \"headline.end\"]'", 2,
         "ropes.upper-bridle.between: both ends of the rope are one point"),
        ("netloft check $plan --set 'floats.headline-floats.spread=\"400 along headline\"'", 2,
         "400 floats of 0.2 m side by side are 80 m long, but headline is only 6 m"),
        ("netloft check $plan --set 'floats.headline-floats.spread=\"11.5 along headline\"'", 2, "11.5 pieces, which is not a whole number"),
        ("netloft check $plan --set 'ropes.headline.length=\"60 m\"'", 0,
         "warning: headline is 60 m long, but edges take only 6 m of it: 54 m carry no netting"),
        ("netloft plan $flume --set parts.bed.type=seabedd/plane", 4, 'there is no plugin "seabedd"; did you mean "seabed"?'),
        ("netloft run $panel --set 'catalogue=[\"nowhere\"]'", 2, "there is no folder"),
        ("netloft run $panel --set 'parts.bed={ type = \"seabed/plane\", on = \"net\", seabed = { depth = -1 } }'", 2,
         "bed: the whole gear is below this bed, by 1 m or more"),
        ("netloft run $panel --set 'parts.bed={ type = \"seabed/plane\", on = \"net\", seabed = { depth = 50 } }' --set 'parts.sand={ type = "
         "\"seabed/plane\", on = \"net\", seabed = { depth = 60 } }'", 2, "sand and bed at … carry the same nodes, so that both push at them"),
        ("netloft run thin.toml", 0, "warning: rope carries … N and breaks at … N (6x19-fc-13mm)",
         {"prepare": "echo 'include = [\"gear-library/scenes/hanging-rope.toml\"]' > thin.toml; echo 'parts.rope.rope = \"6x19-fc-13mm\"' >> thin.toml; "
                     "echo 'parts.load = { type = \"float/float\", on = \"rope.node-100\", float = { mass = 2e4, volume = 0 } }' >> thin.toml"}),
        ("netloft run $panel --set 'parts.net.panel.bar=\"5 mm\"'", 2, "parts.net.twine: diameter = 0.01 m, and bars of 0.005 m: no mesh can open"),
        ("netloft plan $flume --set gear.size=0.1", 2, "is given beside nodes"),
        ("netloft run $panel --set 'hold[0].velocity={ t = [0, 1], x = [0, 1] }'", 2, "hold[0].velocity: nothing moves in a static analysis"),
        ("netloft run $panel --set 'parts.ball={ type = \"float/float\", on = \"net.aft\", float = {} }'", 2,
         "parts.ball.float: is an empty table, which says nothing")),
    *answers(
        "8. Streams that are full and results that are damaged",
        ("netloft schema > /dev/full", 1, "standard output cannot be written: No space left on device"),
        ("netloft run $panel --json > /dev/full", 1, "standard output cannot be written: No space left on device"),
        ("netloft diff a.hdf b.hdf", 2, "cannot read b.hdf: it is damaged: … checksum",
         {"prepare": "netloft run $panel -o a.hdf > /dev/null; cp a.hdf b.hdf; flip b.hdf"})),
    *answers(
        "9. A parameter that no table declares",
        ("netloft test escaping/undeclared --plugins $PLUGINS", 1, "reads-what-it-declares … which no row of its table declares and the host "
         "leaves zero", {"needs": "PLUGINS"})),
    *answers(
        "11. Plugins that crash, end the program or never come back",
        ("netloft run evil.toml --plugins $PLUGINS -o e.hdf", 1, "hostile/crashes crashed in term pull (Segmentation fault)",
         {"prepare": "evil crashes > evil.toml", "holds": "test ! -e e.hdf", "needs": "PLUGINS"}),
        ("netloft run evil.toml --plugins $PLUGINS -o e.hdf", 1, "hostile/overflows crashed in term pull (Segmentation fault): it used up its stack",
         {"prepare": "evil overflows > evil.toml", "holds": "test ! -e e.hdf", "needs": "PLUGINS"}),
        ("netloft run evil.toml --plugins $PLUGINS -o e.hdf", 1, "hostile/exits ended the program (exit) in term pull",
         {"prepare": "evil exits > evil.toml", "holds": "test ! -e e.hdf", "needs": "PLUGINS"}),
        ("netloft test hostile/exits --plugins $PLUGINS", 1, "hostile/exits ended the program (exit) in its construction or first evaluation",
         {"needs": "PLUGINS"}),
        ("netloft run evil.toml --plugins $PLUGINS -o e.hdf --set analysis.max_seconds=0.2", 3,
         "hostile/loops, term pull, did not return for … s after the limit of processor time (analysis.max_seconds)",
         {"prepare": "evil loops > evil.toml", "needs": "PLUGINS"}),
        ("interrupted netloft run gear-library/scenes/hanging-rope.toml --solver central-difference --set analysis.max_iterations=1000000 "
         "--set analysis.tolerance=1e-16 -o n.hdf", 130, "interrupted; largest residual"),
        ("interrupted netloft run line.toml --plugins $PLUGINS -o e.hdf --solver hostile/stalls", 130,
         "hostile/stalls, solve, did not return for … s after the interruption",
         {"prepare": 'line 0 "100 kN" > line.toml', "holds": "test -s e.hdf", "needs": "PLUGINS"})),
    *answers(
        "12. Limits, signals, pipes and unknown commands",
        ("limited -v 150000 netloft run $panel -o p.hdf", 1, "not enough memory: solving needs … ulimit -v",
         {"holds": "test ! -e p.hdf.part", "needs": "MEMORY"}),
        ("limited -f 50 netloft run $panel -o p.hdf", 1, "cannot write p.hdf.part … File too large", {"holds": "test ! -e p.hdf.part"}),
        ("netloft run pipe.toml", 2, "pipe.toml is", {"prepare": "mkfifo pipe.toml"}),
        ("netloft run $panel --solver central-difference --set analysis.max_iterations=3 -o p.hdf", 3,
         "the limit of 3 iterations was reached"),
        ("netloft shema", 2, 'there is no command "shema"; did you mean "schema"?'),
        ("netloft", 0, "Gears: … Scenes: … Results: … Studies: … Numerics: … Plugins:")),
    *answers(
        "13. Impossible options, and files that cannot be written",
        ("netloft scope $sea --depth 60:66:2 --warp 3:4:2 -o nowhere/x.svg", 2, "nowhere/x.svg cannot be written: there is no folder nowhere"),
        ("netloft scope $sea --depth 60:66:2 --warp 3:4:2 --set 'analysis.kind=\"dynamic\"' --set analysis.duration=2", 2,
         "scope compares equilibria, but this scene is a motion"),
        ("netloft sensitivity $sea --to ship.sped", 2, 'the scene states no number "ship.sped"; did you mean "ship.speed"?'),
        ("netloft sensitivity $panel --of hight", 2, 'there is no figure "hight"; `netloft report` lists them all'),
        ("netloft sensitivity $panel --solver central-difference --set analysis.max_iterations=3", 3,
         "there are no derivatives, because the scene ended not converged"),
        ("netloft sensitivity $sea --set 'analysis.kind=\"dynamic\"' --set analysis.duration=2", 2,
         "derivatives are those of an equilibrium, but this scene is a motion; add --set analysis.kind=static"),
        ("netloft sensitivity none.hdf", 2, "cannot read none.hdf: there is no such file"),
        ("netloft sensitivity r.hdf", 2, 'r.hdf is not the result of an equilibrium that was found, it ended "not converged"; give the scene file',
         {"prepare": "netloft run $panel --solver newton --set analysis.max_iterations=1 -o r.hdf >/dev/null 2>&1"}),
        ("netloft run $sea --sensitivities --set 'analysis.kind=\"dynamic\"' --set analysis.duration=2", 2,
         "--sensitivities: derivatives are those of an equilibrium, but this scene is a motion"),
        ("netloft optimise o.toml", 2, 'the scene does not report a figure "results/lowst_z" … did you mean "results/lowest_z"?',
         {"prepare": "optimum results/lowst_z m > o.toml", "holds": "test ! -e o.optimum"}),
        ("netloft optimise o.toml", 2, 'results/lowest_z is a length in m, which "N" cannot express',
         {"prepare": "optimum results/lowest_z N > o.toml"}),
        ("netloft optimise o.toml -o .", 2, "scene.toml cannot be written: the scene is read from it",
         {"prepare": "echo 'include = [\"gear-library/scenes/dead-weight-panel.toml\"]' > scene.toml; "
                     "optimum results/lowest_z m | sed '1s/\".*\"/\"scene.toml\"/' > o.toml", "holds": "test ! -e scene.toml~"}),
        ("netloft run $panel --strategy deflation:by=deflation -o x.hdf", 2,
         'analysis.deflation.by: by = "deflation" makes deflation/deflation call itself without end'),
        ("netloft plan $panel --strategy coarse-to-fine:by=coarse-to-fine", 2, "makes coarse-to-fine/coarse-to-fine call itself"),
        ("netloft plan gear-library/scenes/verification/towed-line.toml --solver lbfgs", 2, "lbfgs/lbfgs needs a problem that is conservative"),
        ("netloft plan $panel --solver auto", 2, '"auto" is a strategy, not a solver'),
        ("netloft run $panel --solver newmark --set analysis.work=10 -o x.hdf", 3, "the budget of work was spent at t = … without coming to rest"),
        ("netloft run $panel --solver newmark --set analysis.max_seconds=1e-6 -o x.hdf", 3,
         "the time limit was reached at t = … without coming to rest"),
        ("netloft run $panel --strategy auto --set analysis.coarse-to-fine.by=direct -o x.hdf", 0, "converged"),
        ("hard_cases $suite --size small --case rope/loose --strategy auto --set analysis.nonsense=1", 2,
         'unknown key "nonsense" in analysis'),
        ("hard_cases $suite --size small --case rope/taut --solver newton:damping=much", 2, "analysis.newton.damping … much"),
        ("hard_cases $suite --size small --case rope/taut --solver newton --set parts.rope.rope.EA=abc", 2,
         'parts.rope.rope.EA: "abc" does not begin with a number'),
        ("netloft run $panel --set parts.net.type=newton/newton", 2, 'parts.net.type: "newton/newton" is a solver, and no element'),
        ("hard_cases $suite --size small --case rope/taut --strategy coarse-to-fine:by=newton", 2, '"newton/newton" is a solver, and no strategy'),
        ("hard_cases $suite --size small --case rope/taut --plugins $PLUGINS --strategy wrong_strategies/throws_at_a_bound:stages=0 "
         "--strategy auto", 3, "not run … failed: no stages) … throws_at_a_bound:stages=0 … right 0 of 2 … auto … right 2 of 2", {"needs": "PLUGINS"}),
        ("hard_cases $suite --size small --case pressure-x-100 --strategy auto --work 1", 3, "late … right 0 of"),
        ("hard_cases $suite --update-references --set parts.rope.rope.EA=1e3", 2,
         "--update-references stores answers of unchanged cases only; leave out --set"),
        ("hard_cases $suite --seed -1", 2, "--seed: Value -1 not in range 0 to"),
        ("hard_cases $suite --seconds-per-case nan", 2, "--seconds-per-case: Value nan not in range 0.001 to 1000000"),
        ("hard_cases $suite -o nowhere/x.html", 2, "nowhere/x.html cannot be written: there is no folder nowhere"),
        ("full_disk 100 netloft compare $panel --solver newton --tolerance 1e-2:1e-2 --repeats 1 -o t.csv", 1,
         "newton … converged … t.csv cannot be written: No space left on device", {"needs": "FULL_DISK"})),
    *answers(
        "14. Strategies with wrong names or parameters, and strategies that fail",
        ("netloft run $panel --strategy relaxed:solver=newtn -o x.hdf", 4,
         'analysis.relaxed.solver: there is no plugin "newtn"; did you mean "newton"?', {"holds": "test ! -e x.hdf"}),
        ("netloft plan $panel --strategy coarse-to-fine:by=nonsense", 4, 'analysis.coarse-to-fine.by: there is no plugin "nonsense"'),
        ("netloft run $panel --strategy auto --set 'analysis.coarse-to-fine.then=\"direkt\"'", 4,
         'analysis.coarse-to-fine.then: there is no plugin "direkt"; did you mean "direct"?'),
        ("netloft plan $panel --strategy 'coarse-to-fine:by=auto:restrts=0'", 2,
         'analysis.coarse-to-fine.by: there is no parameter restrts; did you mean "restarts"?'),
        ("netloft plan $panel --strategy auto:without=restarts+directt", 2, '"directt" is not one of restarts, … did you mean "direct"?'),
        ("netloft run $panel --strategy deflation --set analysis.work=5 -o x.hdf", 3, "not converged … the budget of work was used up; largest residual",
         {"holds": "test $(grep -o 'budget of work' <(netloft run $panel --strategy deflation --set analysis.work=5 | head -3) | wc -l) = 1"}),
        ("netloft run $panel --strategy load-steps -o x.hdf", 3, "the strategy solved no stage of the scene itself: there is no current",
         {"holds": "test -s x.not-converged.hdf || test -s x.hdf"}),
        ("netloft run line.toml --strategy load-steps --set parts.line.cells=1 -o x.hdf", 0, "converged",
         {"prepare": "line 0 '100 kN' > line.toml; printf '[[hold]]\\non = \"line.end\"\\n' >> line.toml"}),
        ("netloft run $panel --strategy coarse-to-fine:by=load-steps -o x.hdf", 3, "solved no stage of the scene itself: a coarser mesh was not solved"),
        ("netloft run $panel --strategy auto:without=coarse-to-fine+tension-stages+direct+stiffness-steps+pseudo-time -o x.hdf", 3,
         "solved no stage of the scene itself: `without` leaves out every attempt"),
        ("netloft plan $panel --strategy tension/stages:ratio=0.5", 2, "analysis.tension.stages.ratio = 0.5 is outside [1.1, 1e9]"),
        ("netloft plan $panel --strategy coarse-to-fine:by=auto:restarts=many", 2, 'analysis.coarse-to-fine.by: restarts: "many" is no number'),
        ("netloft run $panel --strategy auto:restarts=1,restarts=2", 2, "restarts is given twice"),
        ("netloft plan $panel --strategy newton", 2, '"newton/newton" is a solver, and no strategy'),
        ("netloft plan $panel --solver newmark --strategy nam", 4, 'analysis.strategy: there is no plugin "nam"'),
        ("netloft plan $panel --solver newmark --strategy auto", 0, "warning: analysis.strategy has no effect: the integrator newmark"),
        ("netloft describe tension", 0, "parameters (in the table analysis.tension.only) … parameters (in the table analysis.tension.stages)"),
        ("netloft plan $panel --strategy auto:restarts=2", 0, "restarts: 2 from other shapes if a part of the first equilibrium bears load by compression or bending",
         {"holds": "! netloft plan $panel --strategy auto:without=restarts | grep restarts"}),
        ("hard_cases $suite --size small --case rope/taut --strategy auto:without=direct --without restarts", 0,
         "auto:without=restarts+direct … right 2 of 2"),
        ("netloft compare $panel --plugins $PLUGINS --strategy wrong_strategies/throws_at_a_bound:stages=0 --strategy auto --tolerance 1e-6:1e-6 "
         "--repeats 1", 3, "failed … converged … failed at 1e-06: the strategy wrong_strategies/throws_at_a_bound failed: no stages",
         {"needs": "PLUGINS"})),
]
