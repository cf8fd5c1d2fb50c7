#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Reads the journal NAME.hdf.part of a motion as io/formats/hdf5/LAYOUT.md describes it, independently of the program.

    journal.py FILE...      prints the number of outputs in each file and the status of its motion
"""
import struct
import sys
import zlib

import numpy as np

MAGIC = b"\x89NLJ\r\n\x1a\n"
LAYOUT, OUTPUT, REWIND, STATUS = 1, 2, 3, 4


class Damaged(Exception):
    pass


def is_whole_head(head):
    return struct.unpack("<I", head[12:])[0] == zlib.crc32(head[:12])


def records_of(data):
    """Yields kind and content of every complete record; an incomplete record at the end is left out."""
    if len(data) < 16 or not data.startswith(MAGIC) or not is_whole_head(data[:16]):
        raise Damaged("no journal")
    at = 16
    while len(data) - at >= 16:
        if not is_whole_head(data[at:at + 16]):
            if not any(data[at:]):
                return
            raise Damaged(f"head at {at}")
        length, kind = struct.unpack("<QI", data[at:at + 12])
        if at + 20 + length > len(data):
            return
        content = data[at + 16:at + 16 + length]
        if struct.unpack("<I", data[at + 16 + length:at + 20 + length])[0] != zlib.crc32(content):
            raise Damaged(f"record at {at}")
        yield kind, content
        at += 20 + length


class Content:
    """Reads plain data one after the other from the content of a record."""

    def __init__(self, data):
        self.data, self.at = data, 0

    def take(self, size):
        self.at += size
        return self.data[self.at - size:self.at]

    def integer(self):
        return struct.unpack("<Q", self.take(8))[0]

    def real(self):
        return struct.unpack("<d", self.take(8))[0]

    def bytes(self):
        return self.take(self.integer())

    def text(self):
        return self.bytes().decode()

    def array(self, kind="<f8"):
        kind = np.dtype(kind)
        return np.frombuffer(self.take(self.integer() * kind.itemsize), kind)

    def spec(self):
        name, unit, doc = self.text(), self.text(), self.text()
        return {"name": name, "unit": unit, "doc": doc, "group": ("PointData", "CellData")[self.integer()],
                "components": self.integer(), "is_integer": self.integer() != 0}


class Journal:
    """outputs: dictionaries from names as in NAME.hdf to arrays; status: outcome and sentence."""

    def __init__(self, file):
        self.outputs, self.status, self.changing, self.columns, self.resumable = [], ("", ""), [], [], 0
        with open(file, "rb") as f:
            data = f.read()
        for kind, content in records_of(data):
            {LAYOUT: self.read_layout, OUTPUT: self.read_output, REWIND: self.rewind, STATUS: self.read_status}[kind](Content(content))

    def read_layout(self, c):
        self.identity, _ = c.bytes(), c.bytes()
        self.points = c.integer()
        self.connectivity, self.offsets, self.types = c.array("<i8"), c.array("<i8"), c.array("u1")
        self.changing = [c.spec() for _ in range(c.integer())]
        self.fixed = [(c.spec(), c.array()) for _ in range(c.integer())]
        self.columns = [(c.text(), c.text(), c.text()) for _ in range(c.integer())]

    def read_output(self, c):
        checkpoint = c.bytes()
        out = {"time": np.array(c.real()), "points": c.array().reshape(-1, 3)}
        for spec in self.changing:
            values, name = c.array(), f"{spec['group']}/{spec['name']}"
            if len(values) == 0 and self.outputs:
                out[name] = self.outputs[-1][name]
                continue
            out[name] = values if spec["components"] == 1 else values.reshape(-1, spec["components"])
        row = c.array()
        out.update({"series/" + column[0]: value for column, value in zip(self.columns, row)})
        self.outputs.append(out)
        if checkpoint:
            self.resumable = len(self.outputs)

    def rewind(self, c):
        del self.outputs[c.integer():]

    def read_status(self, c):
        self.status = (c.text(), c.text())

    def series(self):
        """Returns arrays [state, ...] by name."""
        return {name: np.array([out[name] for out in self.outputs]) for name in (self.outputs[0] if self.outputs else {})}


if __name__ == "__main__":
    for name in sys.argv[1:]:
        journal = Journal(name)
        print(f"{name}: {len(journal.outputs)} outputs, {journal.status[0]}: {journal.status[1]}")
