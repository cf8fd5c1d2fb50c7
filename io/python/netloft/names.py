# SPDX-License-Identifier: BSD-3-Clause
"""Look-up of names; for an unknown name, the message suggests a similar one."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Iterator, Mapping
from typing import Any, TypeVar

V = TypeVar("V")


def unknown(what: str, name: object, known: Iterable[str]) -> str:
    """The sentence about a name that is not among the known ones."""
    known = list(known)
    near = difflib.get_close_matches(str(name), known, n=3, cutoff=0.5)
    near += [k for k in known if str(name).lower() in k.lower() and k not in near][: 3 - len(near)]
    if near:
        return f"no {what} {name!r}; did you mean {', '.join(map(repr, near))}?"
    some = ", ".join(map(repr, known[:8]))
    return f"no {what} {name!r}; there are {some}{' and others' if len(known) > 8 else ''}"


class Named(Mapping[str, V]):
    """A mapping that is shown as a table, completes its names, and suggests the nearest name for a wrong one."""

    def __init__(self, what: str, values: dict[str, V]) -> None:
        self._what, self._values = what, values

    def __getitem__(self, name: str) -> V:
        try:
            return self._values[name]
        except (KeyError, TypeError):
            raise KeyError(unknown(self._what, name, list(self._values))) from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def _ipython_key_completions_(self) -> list[str]:
        return list(self._values)

    def __repr__(self) -> str:
        width = max((len(name) for name in self._values), default=0)
        return "\n".join(f"{name:<{width}}  {_in_a_line(value)}" for name, value in self._values.items())


def _in_a_line(value: Any) -> str:
    if getattr(value, "ndim", 0):
        return f"{value.size} numbers, {value.min():.6g} to {value.max():.6g}" if value.size else "no numbers"
    return repr(value)
