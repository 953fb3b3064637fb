#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""mutant_names.py absent|present BINARY...: fails on a binary that contains the name of a mutant, or
on a mutant whose name no binary contains."""

import sys
from pathlib import Path

from sources import ROOT, report

sys.path.insert(0, str(ROOT / "properties/mutants"))
from list_mutants import mutants


def present(names, binaries):
    """The names that some binary contains, each with the first such binary."""
    contents = {binary: Path(binary).read_bytes() for binary in binaries}
    return {name: binary for name in names for binary in reversed(binaries)
            if name.encode() in contents[binary]}


def violations(expected, names, binaries):
    found = present(names, binaries)
    if expected == "absent":
        return [f"{found[name]} contains the mutant {name}" for name in found]
    return [f"no binary contains the mutant {name}" for name in names if name not in found]


if __name__ == "__main__":
    expected, binaries = sys.argv[1], sys.argv[2:]
    if expected not in ("absent", "present") or not binaries:
        sys.exit(__doc__)
    names = [name for name, what, file in mutants(ROOT)]
    report(f"mutants {expected}", len(names), violations(expected, names, binaries))
