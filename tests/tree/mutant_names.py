#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""mutant_names.py absent|present BINARY...: fails on a binary that contains the name of a mutant, or
on a mutant whose name no binary contains. Names are those of OPLUS_MUTANT("name") in the sources."""

import re
import sys
from pathlib import Path

from sources import ROOT, cpp, report

MUTANT = re.compile(r'\bOPLUS_MUTANT\(\s*"([^"]+)"\s*\)')
CODE = ("reference", "checked", "properties")


def names(root):
    """Comments don't count: mutant.hpp explains the macro with a name that is none."""
    found = set()
    for path in cpp(root):
        if path.relative_to(root).parts[0] in CODE:
            code = re.sub(r"//.*", "", path.read_text(encoding="utf-8"))
            found.update(MUTANT.findall(code))
    return sorted(found)


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
    report(f"mutants {expected}", len(names(ROOT)), violations(expected, names(ROOT), binaries))
