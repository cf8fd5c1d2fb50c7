# SPDX-License-Identifier: BSD-3-Clause
"""Scenes: a file with changes, solved as often as wanted."""

from __future__ import annotations

import json
import os
import re
import tomllib
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self

from . import _netloft
from .errors import Interrupted, NotConverged
from .names import Named, unknown
from .quantity import Quantity
from .result import Equilibrium

if TYPE_CHECKING:
    from ._tables import Changes, Numbers, Tables
    from .motion import Stored
    from .solvers import Problem, Search
else:

    class Numbers:
        """The numbers of a part, as known to editors (_tables.pyi)."""

    class Tables:
        """The tables of a scene, as known to editors (_tables.pyi)."""

        __slots__ = ()

LIBRARY = Path(_netloft.installed_folder()) / "share" / "netloft" / "gear-library"
_STEP = re.compile(r'"(?:[^"\\]|\\.)*"|[^."\[\]]+|\[\d+\]')


def toml(value: Any) -> str:
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


def steps_of(path: str) -> list[str]:
    """The keys of a path: ["ropes", "headrope", "length"]."""
    return [step.strip('"') for step in _STEP.findall(path)]


class Part(Numbers, Named[Quantity]):
    """The numbers of one part of a scene: gear["headrope"].length, gear["headrope"].rope.density."""

    def __init__(self, name: str, values: dict[str, Quantity]) -> None:
        super().__init__(f"number of {name}", values)
        self._name = name

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        if name in self._values:
            return self._values[name]
        below = {path[len(name) + 1 :]: v for path, v in self._values.items() if path.startswith((name + ".", name + "["))}
        if below:
            return Part(f"{self._name}.{name}", below)
        raise AttributeError(unknown(self._what, name, list(self._values)))

    def __dir__(self) -> list[str]:
        return sorted({re.split(r"[.\[]", path)[0] for path in self._values})


class Scene(Tables):
    """A scene file with changes. It never changes itself: with_() makes another one.

    Scenes that come from one file share what was read from it, so that many of them are cheap. They can be
    pickled, which stores the path of the file and the changes, not the text of the file.
    """

    __slots__ = ("_opened", "_numbers", "_parts", "_words", "__weakref__")

    def __init__(self, file: Path | str) -> None:
        path = Path(file)
        if not path.is_file():
            raise FileNotFoundError(f"{path}: there is no such scene file; load() also finds those of the library")
        self._opened = _netloft.OpenedScene(str(path.resolve()))
        self._numbers: Named[Quantity] | None = None
        self._parts: tuple[str, ...] | None = None
        self._words: dict[str, tuple[str, str, float, float]] = {}  # known of numbers; shared with scenes made of this one

    def _of(self, opened: _netloft.OpenedScene) -> Scene:
        scene = object.__new__(Scene)
        scene._opened, scene._numbers, scene._parts, scene._words = opened, None, None, self._words
        return scene

    @property
    def file(self) -> Path:
        """The path of the scene file."""
        return Path(self._opened.file)

    @property
    def changes(self) -> tuple[str, ...]:
        """The changes, each as the argument of `netloft run --set`."""
        return tuple(self._opened.changes)

    @property
    def tables(self) -> dict[str, Any]:
        """The tables of the file and of those it includes, with the changes, as dicts and lists."""
        return self._opened.tables()

    @property
    def numbers(self) -> Named[Quantity]:
        """All numbers of the scene by their path: those that its tables state, as written, and the parameters
        of its parts that come from the catalogue, in SI units. Their `doc` says what they are."""
        if self._numbers is None:
            rows = self._opened.numbers()
            if not self._words:
                self._words.update(self._opened.words())
            docs = {path: words[1] for path, words in self._words.items()}
            self._numbers = Named("number", {path: Quantity(v, unit, doc or docs.get(path, "")) for path, v, unit, doc in rows})
        return self._numbers

    @property
    def parts(self) -> tuple[str, ...]:
        """The names of the parts: panels, ropes, floats, boards."""
        if self._parts is None:
            self._parts = tuple(dict.fromkeys(self._opened.parts()))
        return self._parts

    if not TYPE_CHECKING:

        def __getitem__(self, part):
            """The numbers of a part, such as "headrope", or of a table, such as "tow"."""
            paths = [(path, steps_of(path)) for path in self.numbers]
            place = 1 if part in self.parts or any(len(steps) > 2 and steps[1] == part for _, steps in paths) else 0
            values = {}
            for path, steps in paths:
                if len(steps) > place + 1 and steps[place] == part:
                    values.setdefault(path[path.index(part) + len(part) :].lstrip('".'), self.numbers[path])
            if not values and part not in self.parts:
                raise KeyError(unknown("part", part, sorted({*self._ipython_key_completions_(), *(s[1] for _, s in paths if len(s) > 2)})))
            return Part(part, values)

    def _ipython_key_completions_(self) -> list[str]:
        return [*self.parts, *dict.fromkeys(steps[0] for steps in map(steps_of, self.numbers) if len(steps) == 2)]

    def with_(self, changes: Changes | Mapping[str, Any] | None = None, **more: Any) -> Scene:
        """Another scene with other values: with_({"tow.speed": "3 kn", "ropes.headrope.length": 26.0}).

        A path is that of `netloft run --set`. A number without a unit is in SI units; a text may have a unit.
        Wrong paths and values are reported by check() and solve().
        """
        texts = [f"{path}={toml(value)}" for path, value in {**(changes or {}), **more}.items()]
        return self._of(self._opened.with_(texts))

    def check(self) -> list[dict[str, Any]]:
        """All messages about the scene, errors and warnings, as a list of dicts (see errors.WrongInput)."""
        return self._opened.check()

    def by(self, solver: Callable[[Problem], object] | str | None = None, strategy: Callable[[Search], object] | str | None = None) -> Scene:
        """The same scene solved by another method: by(solver="newton:method=classic"), by(strategy="auto").
        A solver may also be a callable that netloft.solver() has made one."""
        opened = self._opened
        for key, value in (("strategy", strategy), ("solver", solver)):
            if value is not None:
                opened = opened.by(key, getattr(value, "netloft_name", value))
        return self._of(opened)

    def solve(self, start: Any = None, mesh_of: Equilibrium | None = None, error: bool = False,
              solver: Callable[[Problem], object] | str | None = None, strategy: Callable[[Search], object] | str | None = None,
              progress: Callable[[int, float, float], object] | None = None, raises: bool = True) -> Equilibrium:
        """The equilibrium.

        start: an Equilibrium, a result that was read(), or positions of all nodes [m], to search near.
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
        points = points() if callable(points) else points
        points = [] if points is None else [float(c) for row in points for c in row]
        answer, ended_by, wait = scene._opened.solve(points, mesh_of and mesh_of._answer, bool(error), progress)
        if isinstance(ended_by, KeyboardInterrupt):
            raise Interrupted(_later(scene, wait) if wait else answer and Equilibrium(scene, answer)) from ended_by
        if ended_by is not None:
            raise ended_by
        result = Equilibrium(scene, answer)
        if raises and result.status != "converged":
            raise NotConverged(result) from answer.raised
        return result

    def simulate(self, times: Iterable[float] | None = None, output: Path | str | None = None,
                 progress: Callable[[float, float], object] | None = None) -> Stored:
        """The motion of a scene with `analysis.kind = "dynamic"`; see netloft.simulate()."""
        from .motion import simulate

        return simulate(self, times, output, progress)

    def save(self, path: Path | str) -> Path:
        """Writes a scene file that includes this one, by its whole path, and states its changes: a file of one's own
        to go on from. Changes of items of arrays ("hold[0].at") cannot be stated in such a file."""
        lines = [f"include = [{toml(str(self.file))}]"]
        for change in self.changes:
            key, _, value = change.partition("=")
            if "[" in key:
                raise ValueError(f"{key} is an item of an array; a file that includes the scene can only replace the whole array")
            lines.append(f"{key} = {_as_toml(value)}")
        path = Path(path)
        if path.exists():
            raise FileExistsError(f"{path} exists already; a scene is not overwritten, because it cannot be computed again")
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")
        return path

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Scene) and (self.file, self.changes) == (other.file, other.changes)

    def __hash__(self) -> int:
        return hash((self.file, self.changes))

    def __reduce__(self) -> tuple[Any, ...]:
        return _restore, (str(self.file), self.changes)

    def __repr__(self) -> str:
        changes = "".join(f"\n  {change}" for change in self.changes)
        return f"<netloft.Scene {self.file}{changes}>"


def _as_toml(value: str) -> str:
    """The value of a change, read as TOML; if it is not TOML, it is a text without quotes, as for `--set`."""
    try:
        tomllib.loads(f"value = {value}")
    except tomllib.TOMLDecodeError:
        return toml(value)
    return value


def _later(scene: Scene, wait: Callable[[], Any]) -> Callable[[], Equilibrium | None]:
    def found() -> Equilibrium | None:
        answer = wait()
        return None if answer is None else Equilibrium(scene, answer)

    return found


def _restore(file: str, changes: tuple[str, ...]) -> Scene:
    scene = Scene(file)
    return scene._of(scene._opened.with_(list(changes))) if changes else scene


def library() -> list[str]:
    """The scenes of the library that comes with the package, by the names that load() takes."""
    scenes = LIBRARY / "scenes"
    tables = {file: tomllib.loads(file.read_text(encoding="utf-8")) for file in sorted(scenes.rglob("*.toml"))}
    included = {(file.parent / part).resolve() for file, table in tables.items() for part in table.get("include", [])}
    return [str(file.relative_to(scenes)) for file, table in tables.items()
            if file.resolve() not in included and not {"include", "parts", "gear"}.isdisjoint(table)]


def load(name: Path | str) -> Scene:
    """The scene in a file, or the one of that name in the library that comes with the package (library())."""
    path = Path(name)
    if not path.is_file() and (LIBRARY / "scenes" / path).is_file():
        path = LIBRARY / "scenes" / path
    if not path.is_file():
        raise FileNotFoundError(unknown("scene file", str(name), library()))
    return Scene(path)
