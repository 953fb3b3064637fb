#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails on a source file or script whose first line, after a #! line, is not the SPDX line."""

from sources import ROOT, files, report

LINE = "SPDX-License-Identifier: GPL-3.0-or-later"
COMMENT = {".cpp": ("// ", ""), ".hpp": ("// ", ""), ".smt2": ("; ", ""),
           ".v": ("(* ", " *)"), ".ml": ("(* ", " *)"), ".mli": ("(* ", " *)")}
SCRIPTS = (".py", ".sh", ".cmake")


def is_source(path):
    if path.suffix in COMMENT or path.suffix in SCRIPTS or path.name == "CMakeLists.txt":
        return True
    with path.open("rb") as file:
        return file.read(2) == b"#!"


def violations(root, paths):
    found = []
    for path in paths:
        lines = path.read_text(encoding="utf-8").splitlines()
        if lines and lines[0].startswith("#!"):
            lines = lines[1:]
        opened, closed = COMMENT.get(path.suffix, ("# ", ""))
        expected = opened + LINE + closed
        if not lines or lines[0] != expected:
            found.append(f"{path.relative_to(root)}: does not start with `{expected}`")
    return found


def sources(root):
    return [path for path in files(root) if is_source(path)]


if __name__ == "__main__":
    report("licence lines", len(sources(ROOT)), violations(ROOT, sources(ROOT)))
