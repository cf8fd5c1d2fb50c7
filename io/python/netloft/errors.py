# SPDX-License-Identifier: BSD-3-Clause
"""Exceptions of the package. What went wrong, where, and the cure are in their text."""

from __future__ import annotations

from typing import Any


class NetloftError(Exception):
    """Any error of Netloft."""


class WrongInput(NetloftError, ValueError):
    """A scene that cannot be solved as it is written.

    `messages` has a dict for each message: severity, where ("trawl.toml:12:8"), line, column, message, hint.
    """

    def __init__(self, text: str, messages: list[dict[str, Any]]) -> None:
        super().__init__(text)
        self.messages = messages

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (str(self), self.messages)


class Refused(WrongInput):
    """A plugin that is missing or was rejected."""


class NotConverged(NetloftError):
    """A search that ended without a valid equilibrium. `result` is the shape it reached, `part` what is at fault."""

    def __init__(self, result: Any) -> None:
        self.result = result
        self.part = result.at_fault
        super().__init__(f"{result.status}: {result.reason}" + (f" (at {self.part})" if self.part else ""))

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.result,)


class Interrupted(KeyboardInterrupt):
    """A search that the user interrupted. `result` is the shape it had reached; None: there was none yet. On large meshes,
    asking for it waits until the step ends that the search was in."""

    def __init__(self, result: Any) -> None:
        super().__init__("interrupted" + ("" if result is None else "; .result has the shape so far"))
        self._result = result  # or a function that waits for it

    @property
    def result(self) -> Any:
        """The shape so far, or None."""
        if callable(self._result):
            self._result = self._result()
        return self._result

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.result,)
