#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the notebooks of docs/examples/notebooks, which are kept without what they print. Their assertions hold, and each
shows a set as a picture and draws one by matplotlib."""

import sys
from pathlib import Path

import nbclient
import nbformat

FOLDER = Path(__file__).resolve().parents[4] / "docs/examples/notebooks"


def main():
    notebooks = sorted(FOLDER.glob("*.ipynb"))
    assert [file.stem for file in notebooks] == ["nesting", "offsets", "robot"]
    for file in notebooks:
        notebook = nbformat.read(file, as_version=4)
        nbformat.validate(notebook)
        code = [cell for cell in notebook.cells if cell.cell_type == "code"]
        if any(cell.outputs or cell.execution_count for cell in code):
            sys.exit(f"{file.name}: it has outputs")
        nbclient.NotebookClient(notebook, timeout=120, kernel_name="python3", resources={"metadata": {"path": str(FOLDER)}}).execute()
        shown = {kind for cell in code for output in cell.outputs for kind in output.get("data", {})}
        assert {"image/svg+xml", "image/png"} <= shown, f"{file.name}: {shown}"
        print(f"{file.name}: {len(code)} cells")


if __name__ == "__main__":
    sys.exit(main())
