# SPDX-License-Identifier: BSD-3-Clause
"""Makes results, journals and studies as an attacker would, each from a good one, and the files to which they may refer."""
import json
import os
import re
import struct
import zlib

import h5py
import numpy as np

import journal

SECRET = "TOP SECRET: the password is hunter2; "
SECRET_WORD = "hunter2"
UNSEEN = 987654.3125  # in files that nobody was given
ESCAPES = "\x1b]0;owned\x07\x1b[31mred\x9b31m\x7f"
CONTROL = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f]")


def lay_out(outer):
    """Files beside the folder of the user, which must not be read, shown or changed: secret.txt, other.h5, and a pipe."""
    (outer / "secret.txt").write_text(SECRET * 400)
    os.mkfifo(outer / "pipe")
    with h5py.File(outer / "other.h5", "w") as f:
        f["points"] = f["x"] = np.full((1000, 3), UNSEEN)


def shows_what_is_foreign(content):
    """Whether bytes or a text that the program wrote contain data of those files."""
    content = content if isinstance(content, bytes) else content.encode()
    return SECRET_WORD.encode() in content or str(UNSEEN)[:6].encode() in content or struct.pack("<d", UNSEEN) in content \
        or struct.pack("<f", UNSEEN) in content


def replaced(path, make):
    """A change: another dataset of the same extents, with the same attributes."""
    def change(f):
        old = f[path]
        shape, dtype, attributes = old.shape, old.dtype, dict(old.attrs)
        del f[path]
        make(f, path, shape, dtype)
        if isinstance(f.get(path, getlink=True), h5py.HardLink):
            f[path].attrs.update(attributes)
    return change


def external(file):
    return replaced("VTKHDF/Points", lambda f, path, shape, dtype: f.create_dataset(
        path, shape=shape, dtype="f8", external=[(file, 0, h5py.h5f.UNLIMITED)]))


def virtual(file):
    def make(f, path, shape, dtype):
        layout = h5py.VirtualLayout(shape=shape, dtype="f8")
        layout[...] = h5py.VirtualSource(file, "x", shape=shape)
        f.create_virtual_dataset(path, layout)
    return replaced("VTKHDF/Points", make)


def link(target):
    def change(f):
        del f["VTKHDF/Points"]
        f["VTKHDF/Points"] = target
    return change


def texts(path, text):
    return replaced(path, lambda f, path, shape, dtype: f.create_dataset(
        path, data=np.array([text + str(i) for i in range(shape[0])], dtype=object), dtype=h5py.string_dtype()))


def nested(f):
    group = f["netloft"].create_group("gear")
    for _ in range(3000):
        group = group.create_group("a")


def names(f):
    f.create_dataset("netloft/scalars/" + ESCAPES, data=1.0).attrs["unit"] = "m"


def many_figures(f):
    for i in range(5000):
        f.create_dataset(f"netloft/gear/x{i}", data=1.0).attrs["unit"] = "m"


def escapes_in_texts(f):
    for path in ("netloft/provenance/files/path", "netloft/provenance/files/text", "netloft/provenance/plugins/name"):
        texts(path, ESCAPES)(f)
    f.create_dataset("netloft/diagnostics", data=np.array([ESCAPES], dtype=object), dtype=h5py.string_dtype())
    f["netloft/status"].attrs["outcome"] = ESCAPES
    f["netloft/status"].attrs["sentence"] = ESCAPES
    for dataset in f["netloft/scalars"].values():
        dataset.attrs["unit"] = dataset.attrs["doc"] = ESCAPES


# Files that refer to other files, and the reason for which the program refuses each of them.
OUTSIDE = {
    "external-text": (external("../secret.txt"), r"/VTKHDF/Points has its numbers in another file, \.\./secret\.txt \(external storage\)"),
    "external-pipe": (external("../pipe"), r"/VTKHDF/Points has its numbers in another file, \.\./pipe \(external storage\)"),
    "virtual": (virtual("../other.h5"), r"/VTKHDF/Points is made of datasets of other files \(a virtual dataset\)"),
    "virtual-pipe": (virtual("../pipe"), r"/VTKHDF/Points is made of datasets of other files \(a virtual dataset\)"),
    "external-link": (link(h5py.ExternalLink("../other.h5", "/points")), r"/VTKHDF/Points is an external link"),
    "link-to-a-pipe": (link(h5py.ExternalLink("../pipe", "/points")), r"/VTKHDF/Points is an external link"),
    "soft-link": (link(h5py.SoftLink("/VTKHDF/Types")), r"/VTKHDF/Points is a soft link")}
CURE = "; only data in the file itself are read, so ask for a file that holds all its data"
REFUSED = {
    **{name: (change, why + CURE) for name, (change, why) in OUTSIDE.items()},
    "nested-groups": (nested, "/netloft/gear(/a)+ is nested deeper than 16 groups"),
    "names-of-objects": (names, r"the name of /netloft/scalars/\\u001b\]0;owned\\u0007\\u001b\[31mred\\u009b31m\\u007f has control characters"),
    "names-of-holds": (texts("netloft/forces/held_name", ESCAPES), r"/netloft/forces/held_name has a name with control characters, \\u001b"),
    "names-of-parts": (texts("netloft/parts/name", ESCAPES), r"/netloft/parts/name has a name with control characters, \\u001b")}
SHOWN = {"escapes-in-texts": escapes_in_texts, "many-figures": many_figures}


def write_result(path, good, change):
    """A changed result without its checksums, as in an older version, because an attacker would leave them out."""
    path.write_bytes(good[:good.rindex(b"netloft checksums 1\n")])
    with h5py.File(path, "r+") as f:
        change(f)


def commands_on(name):
    """Commands, each with the files that it may write; scene.toml, mesh.toml on `name` and good.hdf are in the same folder."""
    return ([], "report", name), ([], "report", name, "--json"), ([], "report", name, "--csv"), (["o.html"], "report", name, "-o", "o.html"), \
        (["o.html"], "view", name, "-o", "o.html"), (["o.svg"], "draw", name, "-o", "o.svg"), (["o.png"], "draw", name, "-o", "o.png"), \
        (["o.csv"], "export", name, "o.csv"), (["o.csv"], "export", name, "o.csv", "--table", "elements"), (["o.glb"], "export", name, "o.glb"), \
        (["o.mesh"], "export", name, "o.mesh"), (["o.vtk"], "export", name, "o.vtk"), ([], "diff", name, "good.hdf"), ([], "diff", "good.hdf", name), \
        (["o.hdf"], "run", "scene.toml", "--start-from", name, "-o", "o.hdf"), ([], "plan", "mesh.toml"), (["o.hdf"], "run", "mesh.toml", "-o", "o.hdf")


def rewrite_journal(part, change):
    """Corrects the checksums of a journal after `change` has changed its record of the layout."""
    data = bytearray(part.read_bytes()[:16])
    for kind, content in journal.records_of(part.read_bytes()):
        content = change(content) if kind == journal.LAYOUT else content
        head = struct.pack("<QI", len(content), kind)
        data += head + struct.pack("<I", zlib.crc32(head)) + content + struct.pack("<I", zlib.crc32(content))
    part.write_bytes(data)


def in_image(change, scratch):
    """A change of the inputs that a journal holds as an HDF5 file."""
    def change_layout(content):
        c = journal.Content(content)
        identity, image = c.bytes(), c.bytes()
        scratch.write_bytes(image)
        with h5py.File(scratch, "r+") as f:
            change(f)
        image = scratch.read_bytes()
        return struct.pack("<Q", len(identity)) + identity + struct.pack("<Q", len(image)) + image + content[c.at:]
    return change_layout


def secret_outside(f):
    f.create_dataset("netloft/secret", shape=(5,), dtype="f8", external=[("../pipe", 0, h5py.h5f.UNLIMITED)])


def secret_linked(f):
    f["netloft/secret"] = h5py.ExternalLink("../pipe", "/x")


IN_JOURNALS = {"external-pipe": (secret_outside, r"/netloft/secret has its numbers in another file, \.\./pipe"),
               "link-to-a-pipe": (secret_linked, "/netloft/secret is an external link")}


def sealed_manifest(head, rest):
    """A manifest with the right checksum. `head`: its first line, an object; `rest`: the bytes of its other lines."""
    head = {key: value for key, value in head.items() if key != "crc32"}
    dump = lambda: json.dumps(head, separators=(",", ":"), ensure_ascii=False).encode() + b"\n"  # noqa: E731
    head["crc32"] = f"{zlib.crc32(rest, zlib.crc32(dump())):08x}"
    return dump() + rest


def change_manifest(place, change):
    """Changes the first line of a manifest, and gives it the right checksum."""
    first, rest = place.read_bytes().split(b"\n", 1)
    head = json.loads(first)
    change(head)
    place.write_bytes(sealed_manifest(head, rest))


def sealed_record(content):
    return content + f"crc32 {zlib.crc32(content):08x}\n".encode()


def actions_on(folder):
    return (["run", folder], ["missing", folder], ["submit", folder, "--engine", "parallel"], ["submit", folder, "--engine", "slurm"],
            ["collect", folder], ["show", folder])


# Names that a study or its variable must not have: names of files elsewhere, commands, and control
# characters.
NAMES_OF_STUDIES = {"outside": "../../pwned", "command": "x\ntouch EXECUTED; #", "escape": ESCAPES}
