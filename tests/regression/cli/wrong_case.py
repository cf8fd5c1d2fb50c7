# SPDX-License-Identifier: BSD-3-Clause
"""A scene with a mistake, and the place and words of the message. `change` is made to program.GOOD, or `content` replaces it; `files` are beside it; `args` follow on the command line.
`where` and `says` are those of one error, `hint` its hint. Every other error must be listed in `also`, as (where, words):
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
