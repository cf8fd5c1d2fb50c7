# SPDX-License-Identifier: BSD-3-Clause
"""Writes _tables.pyi: the names of a scene with units and descriptions, for type checkers and editors.

    make_stub.py PROGRAM OUTPUT

It comes from the tables of parameters, as `netloft schema` and `netloft describe` print them, and from the numbers in the scenes of the library. PYTHONPATH must contain the package.
"""
import json
import keyword
import re
import subprocess
import sys
from pathlib import Path

HEAD = '''\
# Written by make_stub.py out of the tables of parameters.
from typing import Any, Literal, TypedDict, overload

import numpy
from numpy.typing import NDArray

from .quantity import Quantity
from .scene import Part
'''
OF_PARTS = ("panels", "ropes", "floats", "points", "bodies", "parts", "elements")  # their tables have names of the user


def asked(program, *words):
    return json.loads(subprocess.run([program, *words], check=True, capture_output=True, text=True).stdout)


class Names:
    """A tree of names: the description of each name, and the names below it."""

    def __init__(self):
        self.known, self.below, self.kinds = {}, {}, set()

    def add(self, steps, sentence, where):
        kind = "number" if not steps else "array" if steps[0].startswith("[") else "table"
        self.kinds.add(kind)
        if kind == "table":
            self.below.setdefault(steps[0], Names()).add(steps[1:], sentence, where)
        else:
            self.known.setdefault(sentence, []).append(where)

    def doc(self):
        return "\n".join(f"{sentence} ({', '.join(dict.fromkeys(where))})" for sentence, where in self.known.items())


def sentence_of(doc, unit):
    return doc if unit in ("", "1") else f"{doc} [{unit}]"


def keys_of(schema, path=()):
    """The keys of a schema and their descriptions, without those below names of a user."""
    for name, below in schema.get("properties", {}).items():
        if "properties" in below:
            yield from keys_of(below, (*path, name))
        elif below.get("type") not in ("object", "array"):
            yield (*path, name), re.sub("; a number in SI or a text.*", "", below.get("description", ""))


def names_of_library(netloft, tables, part):
    """Adds the numbers that scenes of the library state, with their units."""
    from netloft.scene import steps_of

    for name in netloft.library():
        scene = netloft.load(name)
        words = scene._opened.words()
        for path, number in scene.numbers.items():
            steps = steps_of(path)
            if steps[0] == "elements" and steps[1] in tables.below["elements"].below:  # of all panels, of all ropes
                tables.add(steps, "", "")
            if not number.doc:
                continue
            sentence = sentence_of(number.doc, words[path][0] if path in words else number.unit)
            if steps[0] not in OF_PARTS:
                tables.add(steps, sentence, steps[0])
            elif len(steps) > 2:  # points of bodies have names of the user, too
                part.add(["points", "[]"] if steps[2] == "points" else steps[2:], sentence, steps[0])


def names_of_components(program, part, outputs):
    """Adds the parameters of elements and of their laws, and the outputs of elements."""
    components = {c["type"]: asked(program, "describe", c["type"], "--json") for c in asked(program, "list", "--json")["components"]}
    laws = [c for c in components.values() if c["kind"] == "law"]
    for component in (c for c in components.values() if c["kind"] == "element"):
        for row in component["parameters"]:
            if row["kind"] == "real":
                part.add(row["name"].split("."), sentence_of(row["doc"], row["unit"]), component["type"])
        for row in component["outputs"]:
            outputs.add([row["name"]], sentence_of(row["doc"], row["unit"]), component["type"])
        for slot in component["laws"]:
            family = slot["default"].split("/")[0]
            for law in (law for law in laws if law["type"].split("/")[0] == family):
                for row in law["parameters"]:
                    if row["kind"] == "real":
                        part.add([slot["name"], *row["name"].split(".")], sentence_of(row["doc"], row["unit"]), law["type"])


def class_of(name, names, leaf, written):
    """Appends the class of a table, after those of the tables in it."""
    lines = [f"class {name}:"]
    for key, below in names.below.items():
        if not key.isidentifier() or keyword.iskeyword(key):
            continue
        kind = "Any" if len(below.kinds) > 1 else leaf if "number" in below.kinds else "Part"
        if below.kinds == {"table"}:
            kind = f"{name}_{key}"
            class_of(kind, below, leaf, written)
        lines += ["    @property", f"    def {key}(self) -> {kind}:", f"        {below.doc()!r}" if below.known else "        ..."]
    written.append("\n".join(lines))


def main():
    import netloft

    program, output = sys.argv[1], Path(sys.argv[2])
    tables, part, outputs = Names(), Names(), Names()
    schema = asked(program, "schema")
    for steps, description in keys_of(schema):
        tables.add(steps, description, steps[0])
    names_of_library(netloft, tables, part)
    names_of_components(program, part, outputs)
    paths = sorted({".".join(steps) for steps, _ in leaves(tables)})
    # numbers of analysis say how a scene is solved and are none of its numbers; elements have parts
    stated = [name for name, below in tables.below.items() if below.below and name.isidentifier() and name not in ("analysis", "elements")]
    written = [HEAD]
    class_of("Numbers", part, "Quantity", written)
    class_of("Outputs", outputs, "NDArray[numpy.float64]", written)
    written.append("Changes = TypedDict(\"Changes\", {\n" + "".join(f"    {path!r}: Any,\n" for path in paths) + "}, total=False)")
    of_scene = ["class Tables:"]
    for name in stated:
        class_of(f"Table_{name}", tables.below[name], "Quantity", written)
        of_scene += ["    @overload", f"    def __getitem__(self, part: Literal[{name!r}]) -> Table_{name}: ...  # type: ignore"]
    written.append("\n".join([*of_scene, "    @overload", "    def __getitem__(self, part: str) -> Part: ..."]))
    output.write_text("\n\n".join(written) + "\n", encoding="utf-8")


def leaves(names, path=()):
    """The paths of the names with nothing below them."""
    for key, below in names.below.items():
        if below.below:
            yield from leaves(below, (*path, key))
        else:
            yield (*path, key), below


if __name__ == "__main__":
    main()
