# SPDX-License-Identifier: BSD-3-Clause
"""Makes the wheel of the package out of a build folder, without a network: a zip file with the package, its plugins, the
library of gears, and the shared libraries that systems may lack."""
import argparse
import base64
import hashlib
import re
import shutil
import subprocess
import sysconfig
import tempfile
import zipfile
from pathlib import Path

# By the rules for wheels (PEP 513, PEP 600), every Linux with glibc has these libraries.
OF_THE_SYSTEM = re.compile(r"(ld-linux.*|libc|libm|libdl|librt|libpthread|libstdc\+\+|libgcc_s|libz)\.so(\..*)?")
METADATA = """\
Metadata-Version: 2.1
Name: netloft
Version: {version}
Summary: Shapes and forces of trawl gears
License: {licence}
Requires-Python: =={python}.*
Requires-Dist: numpy
Provides-Extra: all
Requires-Dist: scipy; extra == "all"
Requires-Dist: xarray; extra == "all"
Requires-Dist: matplotlib; extra == "all"

"""
LICENCE = "BSD-3-Clause (with MUMPS and Scotch under CeCILL-C, METIS under Apache-2.0 and others under similar licences inside)"


def libraries_of(module):
    """The shared libraries that a module needs and systems may lack, by their names."""
    lines = subprocess.run(["ldd", module], check=True, capture_output=True, text=True).stdout
    found = dict(re.findall(r"^\s*(\S+) => (/\S+)", lines, re.M))
    return {name: Path(path) for name, path in found.items() if not OF_THE_SYSTEM.fullmatch(name)}


def notice_of(library):
    """The package of Debian that a library belongs to, and the file with its licence."""
    for path in (library, Path("/") / library.relative_to("/usr")):  # the packages of an older layout have it in /lib
        found = subprocess.run(["dpkg", "-S", path], capture_output=True, text=True).stdout
        if found:
            owner = found.split(":")[0]
            return owner, Path("/usr/share/doc") / owner / "copyright"
    raise SystemExit(f"{library}: it would be in the wheel, and no package says its licence")


def stage(options, folder):
    """Writes the package into a folder, and returns the folder of the package."""
    subprocess.run([options.cmake, "--install", options.build, "--prefix", folder / "all", "--component", "python"],
                   check=True, stdout=subprocess.DEVNULL)
    package = folder / "netloft"
    shutil.move(folder / "all/lib/python3/dist-packages/netloft", package)
    module = next(package.glob("_netloft*.so"))
    (package / "libs").mkdir()
    for name, path in libraries_of(module).items():
        shutil.copy(path.resolve(), package / "libs" / name)
        owner, notice = notice_of(path.resolve())
        shutil.copy(notice, package / "licences" / f"copyright-of-{owner}")
    subprocess.run(["strip", "--strip-unneeded", module, *(package / "libs").iterdir()], check=True)
    shutil.copytree(options.build / "lib/netloft", package / "lib/netloft", ignore=shutil.ignore_patterns("kinsol.so", "arkode.so"))
    shutil.copytree(options.source / "gear-library", package / "share/netloft/gear-library", ignore=shutil.ignore_patterns("*.png"))
    return package


def record_of(path, content):
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
    return f"{path},sha256={digest},{len(content)}"


def write_wheel(options, package):
    python = f"{sysconfig.get_python_version()}"
    tag = f"cp{python.replace('.', '')}"
    tag = f"{tag}-{tag}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"
    info = f"netloft-{options.version}.dist-info"
    files = {f"netloft/{path.relative_to(package)}": path.read_bytes() for path in sorted(package.rglob("*")) if path.is_file()}
    files[f"{info}/METADATA"] = (METADATA.format(version=options.version, python=python, licence=LICENCE).encode()
                                 + (options.source / "io/python/PYTHON.md").read_bytes())
    files[f"{info}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: netloft\nRoot-Is-Purelib: false\nTag: {tag}\n".encode()
    files[f"{info}/LICENSE"] = (options.source / "LICENSE").read_bytes()
    records = [record_of(path, content) for path, content in files.items()]
    files[f"{info}/RECORD"] = "\n".join([*records, f"{info}/RECORD,,", ""]).encode()
    wheel = options.output / f"netloft-{options.version}-{tag}.whl"
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, content in files.items():
            entry = zipfile.ZipInfo(path, (2020, 1, 1, 0, 0, 0))  # the same files make the same wheel
            entry.external_attr = (0o755 if path.endswith(".so") else 0o644) << 16
            archive.writestr(entry, content, zipfile.ZIP_DEFLATED)
    return wheel


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cmake", required=True)
    parser.add_argument("--version", required=True)
    for folder in ("build", "source", "output"):
        parser.add_argument(f"--{folder}", type=Path, required=True)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        print(write_wheel(options, stage(options, Path(folder))))


if __name__ == "__main__":
    main()
