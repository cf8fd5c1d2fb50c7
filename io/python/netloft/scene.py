# SPDX-License-Identifier: BSD-3-Clause
"""Scenes: a file with changes, solved as often as wanted."""

import json
import os
import re
import tomllib
from pathlib import Path

from . import _netloft
from .errors import Interrupted, NotConverged
from .names import Named, unknown
from .quantity import Quantity
from .result import Equilibrium

LIBRARY = Path(_netloft.installed_folder()) / "share" / "netloft" / "gear-library"
_STEP = re.compile(r'"(?:[^"\\]|\\.)*"|[^."\[\]]+|\[\d+\]')


def toml(value):
    """A value as TOML, for a change of a scene. A quantity keeps its unit."""
    if isinstance(value, Quantity) and value.unit:
        return json.dumps(f"{float(value)!r} {value.unit}")
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (str, os.PathLike)):
        return json.dumps(os.fspath(value), ensure_ascii=False)
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(str(k))} = {toml(v)}" for k, v in value.items()) + "}"
    if hasattr(value, "tolist"):  # arrays and numbers of numpy
        return toml(value.tolist())
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(toml, value)) + "]"
    if isinstance(value, (int, float)):
        return repr(float(value)) if isinstance(value, float) else repr(int(value))
    raise TypeError(f"{value!r} is no value of a scene; numbers, texts, booleans, lists and dicts are")


def steps_of(path):
    """The keys of a path: ["ropes", "headrope", "length"]."""
    return [step.strip('"') for step in _STEP.findall(path)]


class Part(Named):
    """The numbers of one part of a scene: gear["headrope"].length, gear["headrope"].rope.density."""

    def __init__(self, name, values):
        super().__init__(f"number of {name}", values)
        self._name = name

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        if name in self._values:
            return self._values[name]
        below = {path[len(name) + 1 :]: v for path, v in self._values.items() if path.startswith((name + ".", name + "["))}
        if below:
            return Part(f"{self._name}.{name}", below)
        raise AttributeError(unknown(self._what, name, list(self._values)))

    def __dir__(self):
        return sorted({re.split(r"[.\[]", path)[0] for path in self._values})


class Scene:
    """A scene file with changes. It never changes itself: with_() makes another one.

    Scenes that come from one file share what was read from it, so that many of them are cheap. They can be
    pickled, which stores the path of the file and the changes, not the text of the file.
    """

    def __init__(self, file):
        path = Path(file)
        if not path.is_file():
            raise FileNotFoundError(f"{path}: there is no such scene file")
        self._opened = _netloft.OpenedScene(str(path.resolve()))
        self._numbers = self._parts = None

    @classmethod
    def _of(cls, opened):
        scene = object.__new__(cls)
        scene._opened, scene._numbers, scene._parts = opened, None, None
        return scene

    @property
    def file(self):
        """The path of the scene file."""
        return Path(self._opened.file)

    @property
    def changes(self):
        """The changes, each as the argument of `netloft run --set`."""
        return tuple(self._opened.changes)

    @property
    def tables(self):
        """The tables of the file and of those it includes, with the changes, as dicts and lists."""
        return self._opened.tables()

    @property
    def numbers(self):
        """All numbers of the scene by their path: those that its tables state, as written, and the parameters
        of its parts that come from the catalogue, in SI units."""
        if self._numbers is None:
            self._numbers = Named("number", {path: Quantity(v, unit) for path, v, unit in self._opened.numbers()})
        return self._numbers

    @property
    def parts(self):
        """The names of the parts: panels, ropes, floats, boards."""
        if self._parts is None:
            self._parts = tuple(self._opened.parts())
        return self._parts

    def __getitem__(self, part):
        """The numbers of a part."""
        values = {}
        for path, value in self.numbers.items():
            steps = steps_of(path)
            if len(steps) > 2 and steps[1] == part:
                values.setdefault(path[path.index(part) + len(part) :].lstrip('".'), value)
        if not values and part not in self.parts:
            raise KeyError(unknown("part", part, sorted({*self.parts, *(s[1] for s in map(steps_of, self.numbers) if len(s) > 2)})))
        return Part(part, values)

    def _ipython_key_completions_(self):
        return list(self.parts)

    def with_(self, changes=None, **more):
        """Another scene with other values: with_({"tow.speed": "3 kn", "ropes.headrope.length": 26.0}).

        A path is that of `netloft run --set`. A number without a unit is in SI units; a text may have a unit.
        Wrong paths and values are reported by check() and solve().
        """
        texts = [f"{path}={toml(value)}" for path, value in {**(changes or {}), **more}.items()]
        return Scene._of(self._opened.with_(texts))

    def check(self):
        """All messages about the scene, errors and warnings, as a list of dicts (see errors.WrongInput)."""
        return self._opened.check()

    def by(self, solver=None, strategy=None):
        """The same scene solved by another method: by(solver="newton:method=classic"), by(strategy="auto").
        A solver may also be a callable that netloft.solver() has made one."""
        opened = self._opened
        for key, value in (("strategy", strategy), ("solver", solver)):
            if value is not None:
                opened = opened.by(key, getattr(value, "netloft_name", value))
        return Scene._of(opened)

    def solve(self, start=None, mesh_of=None, error=False, solver=None, strategy=None, progress=None, raises=True):
        """The equilibrium.

        start: an Equilibrium, or positions of all nodes [m], to search near.
        mesh_of: an Equilibrium of the same gear with other numbers, whose mesh is taken over: its triangles stay, and
            its nodes move with the numbers of the net plan. Figures are smooth functions of these numbers then.
        error: solve on two further meshes, for the error of the mesh in every figure.
        solver, strategy: as for by().
        progress: called after each iteration with its number, the largest residual and the largest load [N].
        raises: without an equilibrium raise NotConverged, whose `result` is the shape that was reached;
            otherwise return that.
        Raises WrongInput, Refused, NotConverged, and Interrupted after Ctrl-C.
        """
        if mesh_of is not None and not isinstance(mesh_of, Equilibrium):
            raise TypeError(f"mesh_of is an Equilibrium of the same gear, not {mesh_of!r}")
        scene = self.by(solver, strategy) if solver or strategy else self
        points = getattr(start, "points", start)
        points = [] if points is None else [float(c) for row in points for c in row]
        answer, ended_by = scene._opened.solve(points, mesh_of and mesh_of._answer, bool(error), progress)
        result = None if answer is None else Equilibrium(scene, answer)
        if isinstance(ended_by, KeyboardInterrupt):
            raise Interrupted(result) from ended_by
        if ended_by is not None:
            raise ended_by
        if raises and result.status != "converged":
            raise NotConverged(result)
        return result

    def simulate(self, times=None, output=None, progress=None):
        """The motion of a scene with `analysis.kind = "dynamic"`; see netloft.simulate()."""
        from .motion import simulate

        return simulate(self, times, output, progress)

    def __eq__(self, other):
        return isinstance(other, Scene) and (self.file, self.changes) == (other.file, other.changes)

    def __hash__(self):
        return hash((self.file, self.changes))

    def __reduce__(self):
        return _restore, (str(self.file), self.changes)

    def __repr__(self):
        changes = "".join(f"\n  {change}" for change in self.changes)
        return f"<netloft.Scene {self.file}{changes}>"


def _restore(file, changes):
    scene = Scene(file)
    return Scene._of(scene._opened.with_(list(changes))) if changes else scene


def library():
    """The scenes of the library that comes with the package, by the names that load() takes."""
    scenes = LIBRARY / "scenes"
    tables = {file: tomllib.loads(file.read_text(encoding="utf-8")) for file in sorted(scenes.rglob("*.toml"))}
    included = {(file.parent / part).resolve() for file, table in tables.items() for part in table.get("include", [])}
    return [str(file.relative_to(scenes)) for file, table in tables.items()
            if file.resolve() not in included and not {"include", "parts", "gear"}.isdisjoint(table)]


def load(name):
    """The scene in a file, or the one of that name in the library that comes with the package (library())."""
    path = Path(name)
    if not path.is_file() and (LIBRARY / "scenes" / path).is_file():
        path = LIBRARY / "scenes" / path
    if not path.is_file():
        raise FileNotFoundError(unknown("scene file", str(name), library()))
    return Scene(path)
