#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails on a .cpp file of the tree that no target of these builds compiles: compiled.py COMPILE_COMMANDS..."""

import json
import sys
from pathlib import Path

from sources import ROOT, cpp, report


def sources(root):
    """All but the consumer, which is a project of its own, built by its own test, and findings on Clipper2, which their
    tests compile."""
    return [path for path in cpp(root) if path.suffix == ".cpp"
            and path.relative_to(root).parts[:2] != ("tests", "consumer")
            and not (path.parent.name == "findings" and path.name.startswith("clipper2_"))]


def violations(root, commands):
    compiled = {(Path(command["directory"]) / command["file"]).resolve() for command in commands}
    return [f"{path.relative_to(root)}: no target compiles it" for path in sources(root)
            if path.resolve() not in compiled]


if __name__ == "__main__":
    commands = [command for build in sys.argv[1:] for command in json.loads(Path(build).read_text(encoding="utf-8"))]
    report("compiled sources", len(sources(ROOT)), violations(ROOT, commands))
