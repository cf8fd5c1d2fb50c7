# SPDX-License-Identifier: BSD-3-Clause
"""A scene a person gets wrong, with the place and the words of the answer.

`change` is made to program.GOOD, or `content` replaces it; `files` lie beside it; `args` follow on the command line.
`where` and `says` stand in one error; `hint` in its hint. Every other error must be listed in `also`, as (where, words):
an error that only follows from another helps nobody.
"""
from dataclasses import dataclass, field

from program import GOOD, changed


@dataclass
class Wrong:
    name: str
    where: str
    says: str
    hint: str = ""
    change: list = field(default_factory=list)
    content: object = None
    files: dict = field(default_factory=dict)
    args: list = field(default_factory=list)
    also: list = field(default_factory=list)
    code: int = 2

    def scene(self):
        return changed(GOOD, *self.change) if self.content is None else self.content


def edit(name, old, new, where, says, hint="", **more):
    return Wrong(name, where and "scene.toml:" + where, says, hint, change=[(old, new)], **more)


def set_to(name, setting, says, hint="", **more):
    return Wrong(name, "--set " + setting.split("=")[0], says, hint, args=["--set", setting], **more)
