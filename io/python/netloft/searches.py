# SPDX-License-Identifier: BSD-3-Clause
"""The searches of `netloft optimise` and `netloft calibrate`, with the same files."""

from __future__ import annotations

import json
import tempfile
import tomllib
from pathlib import Path
from typing import Any

from . import _netloft
from .errors import Interrupted, NotConverged
from .names import Named
from .quantity import Quantity
from .scene import Scene


class _Found:
    """The values that a search has found, with its report."""

    at_fault = ""

    def __init__(self, file: Path, numbers: dict[str, Any], text: str) -> None:
        self.file = file
        self.status: str = numbers["status"]
        self.reason: str = "; ".join(filter(None, (numbers["reason"], numbers["trouble"])))
        self._numbers, self._text = numbers, text

    def to_dict(self) -> dict[str, Any]:
        """All numbers of the report, as the option `--json` prints them."""
        return self._numbers

    def text(self) -> str:
        """The report as text."""
        return self._text

    def _scene(self, name: str, changes: list[str]) -> Scene:
        scene = Scene(self.file.parent / name)
        return scene._of(scene._opened.with_(changes))

    def __repr__(self) -> str:
        return self._text


class Optimum(_Found):
    """The best `values` of the variables, the `objective` there, and the `scene` with these values."""

    def __init__(self, file: Path, numbers: dict[str, Any], text: str) -> None:
        super().__init__(file, numbers, text)
        self.values = Named("variable", {v["name"]: Quantity(v["after"], v["unit"]) for v in numbers["variables"]})
        self.objective = Quantity(numbers["objective"]["after"], numbers["objective"]["unit"], numbers["objective"]["name"])
        self.scene = self._scene(tomllib.loads(file.read_text(encoding="utf-8"))["scene"], numbers["set"])


class Calibration(_Found):
    """The `values` of the unknowns with their standard `deviations`, and the `scenes` with these values."""

    def __init__(self, file: Path, numbers: dict[str, Any], text: str) -> None:
        super().__init__(file, numbers, text)
        self.values = Named("variable", {v["name"]: Quantity(v["mean"], v["unit"]) for v in numbers["variables"]})
        self.deviations = Named("variable", {v["name"]: Quantity(v["deviation"], v["unit"]) for v in numbers["variables"]})
        self.scenes = Named("scene", {name: self._scene(s["scene"], s["set"]) for name, s in numbers["scenes"].items()})


def optimise(file: Path | str, folder: Path | str | None = None, raises: bool = True) -> Optimum:
    """The values of numbers of a scene at which a figure is least or greatest, within limits of others (STUDY.md).

    folder: where points that were solved are kept, so that a search that was interrupted goes on there.
    raises: raise NotConverged, whose `result` is the best point, if the search ends without an optimum.
    Raises WrongInput, Refused, NotConverged, and Interrupted after Ctrl-C.
    """
    with tempfile.TemporaryDirectory() as own:
        place = Path(folder or own)
        place.mkdir(parents=True, exist_ok=True)
        return _ended(Optimum, "optimal", file, raises, *_netloft.optimise(_existing(file), place / "history.jsonl"))


def calibrate(file: Path | str, raises: bool = True) -> Calibration:
    """Unknown values of some scenes, found from measured figures (CALIBRATION.md).

    Raises WrongInput, Refused, NotConverged (unless raises=False), and Interrupted after Ctrl-C.
    """
    return _ended(Calibration, "converged", file, raises, *_netloft.calibrate(_existing(file)))


def _existing(file: Path | str) -> Path:
    if not Path(file).is_file():
        raise FileNotFoundError(f"{file}: there is no such file")
    return Path(file)


def _ended(kind: Any, good: str, file: Path | str, raises: bool, numbers: str, text: str, ended_by: BaseException | None) -> Any:
    known = json.loads(numbers) if numbers else None
    has_values = bool(known) and bool(known["variables"]) and known["variables"][0].get("after", 0) is not None
    found = kind(Path(file), known, text) if has_values else None
    if isinstance(ended_by, KeyboardInterrupt):
        raise Interrupted(found) from ended_by
    if ended_by is not None:
        raise ended_by
    if found is None:
        raise NotConverged(_Found(Path(file), known, text))
    if raises and found.status != good:
        raise NotConverged(found)
    return found
