# SPDX-License-Identifier: BSD-3-Clause
"""Netloft: shapes and forces of trawl gears.

    import netloft
    gear = netloft.load("83-112-flume-3.0kn.toml")     # of the library, or a file of your own
    r = gear.with_({"tow.speed": "3.5 kn"}).solve()
    r.report["mouth/headline_height"]
"""

from __future__ import annotations

from pathlib import Path as _Path

from . import _netloft
from .elements import Parameter, check, element
from .errors import Interrupted, NetloftError, NotConverged, Refused, WrongInput
from .motion import Stored, read, simulate
from .quantity import Quantity
from .result import Equilibrium
from .scene import Scene, library, load
from .searches import Calibration, Optimum, calibrate, optimise
from .solvers import Problem, Search, compare, solver, strategy
from .study import Study, points, study

__version__: str = _netloft.__version__


def add_plugins(folder: _Path | str) -> None:
    """Adds a folder of plugins to those that are searched."""
    if not _Path(folder).is_dir():
        raise NotADirectoryError(f"{folder}: there is no such folder of plugins")
    _netloft.add_plugins(str(_Path(folder).resolve()))


__all__ = ["Calibration", "Equilibrium", "Interrupted", "NetloftError", "NotConverged", "Optimum", "Parameter", "Problem", "Quantity", "Refused",
           "Scene", "Search", "Stored", "Study", "WrongInput", "add_plugins", "calibrate", "check", "compare", "element", "library", "load",
           "optimise", "points", "read", "simulate", "solver", "strategy", "study"]
