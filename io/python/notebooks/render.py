# SPDX-License-Identifier: BSD-3-Clause
"""Runs the notebooks of this folder and writes each as a page beside it, with its outputs and pictures.

    PYTHONPATH=build/release/python /usr/bin/python3 io/python/notebooks/render.py [FOLDER]
"""
import ast
import contextlib
import io
import json
import os
import sys
import tempfile
from pathlib import Path

NOTEBOOKS = Path(__file__).parent
WIDTH = 480  # of pictures [pixels], so that they take 60 kB each


def cells_of(notebook):
    """(kind, text) of each cell."""
    return [(cell["cell_type"], "".join(cell["source"])) for cell in json.loads(notebook.read_text(encoding="utf-8"))["cells"]]


def run_cell(text, names):
    """What a cell printed, and the value of its last line; None: it is no expression."""
    tree, printed = ast.parse(text), io.StringIO()
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    with contextlib.redirect_stdout(printed):
        exec(compile(tree, "<cell>", "exec"), names)
        value = eval(compile(ast.Expression(last.value), "<cell>", "eval"), names) if last else None
    return printed.getvalue(), value


def render(notebook, pictures):
    """The page of a notebook, and the names after its last cell. Pictures are written into a folder. The cells run in an empty one."""
    page, names, here, drawn = [], {}, os.getcwd(), []
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            for kind, text in cells_of(notebook):
                if kind == "markdown":
                    page.append(text)
                    continue
                printed, value = run_cell(text, names)
                page.append(f"```python\n{text}\n```")
                shown = printed + ("" if value is None else f"{value!r}\n")
                if shown:
                    page.append(f"```\n{shown}```")
                if hasattr(value, "draw") and value not in drawn:
                    drawn.append(value)
                    picture = pictures / f"{notebook.stem}-{len(drawn)}.png"
                    value.draw(picture, width=WIDTH)
                    page.append(f"![{notebook.stem}, picture {len(drawn)}]({picture.name})")
        finally:
            os.chdir(here)
    page.append(f"Made of [{notebook.name}]({notebook.name}) by [render.py](render.py).")
    return "\n\n".join(page) + "\n", names


def main():
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else NOTEBOOKS).resolve()
    for notebook in sorted(NOTEBOOKS.glob("*.ipynb")):
        page, _ = render(notebook, folder)
        (folder / f"{notebook.stem}.md").write_text(page, encoding="utf-8")


if __name__ == "__main__":
    main()
