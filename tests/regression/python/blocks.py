# SPDX-License-Identifier: BSD-3-Clause
"""The code of pages and notebooks."""
import json
import os
import re
from pathlib import Path

FOLDER = Path(os.environ["NETLOFT_SOURCE_DIR"]) / "io/python"


def blocks(path):
    """The blocks of Python in a page, or the cells of code in a notebook."""
    text = path.read_text()
    if path.suffix == ".ipynb":
        return ["".join(cell["source"]) for cell in json.loads(text)["cells"] if cell["cell_type"] == "code"]
    return re.findall(r"^```python\n(.*?)^```", text, re.M | re.S)
