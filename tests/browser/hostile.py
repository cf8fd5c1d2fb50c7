# SPDX-License-Identifier: BSD-3-Clause
"""hostile.py RESULT COPY: makes a copy of a result, with names and texts that a careless page would execute as scripts."""
import shutil
import sys

import h5py

MARKUP = "</script><img src=x onerror=alert(1)>\"'\n& {{x}} " + 10000 * "w"
NAME = MARKUP.replace("\n", " ")  # a result with control characters in its names is refused whole

shutil.copy(*sys.argv[1:3])
with h5py.File(sys.argv[2], "r+") as f:
    names = f["netloft/parts/name"]
    for i in range(len(names)):
        names[i] = NAME[:40 + i]
    names[0] = NAME
    f["netloft/status"].attrs["sentence"] = MARKUP
    f["netloft/provenance/files/path"][0] = NAME + ".toml"
    f["netloft/provenance/files/text"][0] = MARKUP
    for group in ("CellData", "Steps/CellDataOffsets"):
        f["VTKHDF/" + group].move("strain", NAME[:60].replace("/", "|"))
