# SPDX-License-Identifier: GPL-3.0-or-later
"""Which files of the tree are ours to check."""

import os
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = ("reference", "checked", "properties", "tests", "docs", ".ci", ".github")


def files(root):
    """Yields every file below the folders of the design, and those beside them, sorted."""
    found = [path for path in root.iterdir() if path.is_file()]
    for folder in FOLDERS:
        for directory, names, of_directory in os.walk(root / folder):
            names[:] = [name for name in names if name not in ("__pycache__", "_skbuild")]
            found += [Path(directory) / name for name in of_directory]
    return sorted(found)


def cpp(root):
    return [path for path in files(root) if path.suffix in (".cpp", ".hpp")]


def report(what, checked, violations):
    """Prints each violation; a check that looked at nothing fails too."""
    for violation in violations:
        print(violation)
    print(f"{what}: {checked} checked, {len(violations)} wrong")
    sys.exit(1 if violations or checked == 0 else 0)
