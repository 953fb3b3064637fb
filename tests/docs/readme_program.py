#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""readme_program.py: fails unless the programs in README and on pages of docs/, and their outputs, are those of
docs/examples/cpp and of docs/examples/c, which are compiled and run."""

import sys
import textwrap
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def blocks(page):
    """The indented blocks of a page, without their indentation."""
    result, block = [], []
    for line in page.splitlines() + [""]:
        if line.startswith("    ") or (block and not line):
            block.append(line)
            continue
        if block:
            result.append(textwrap.dedent("\n".join(block)).strip("\n") + "\n")
        block = [line] if line.startswith("    ") else []
    return result + ([textwrap.dedent("\n".join(block)).strip("\n") + "\n"] if block else [])


def text_of(example):
    """The file without the licence's line and the one that says what the program shows."""
    return "".join(line for line in example.read_text(encoding="utf-8").splitlines(True)
                   if not line.startswith("//"))


if __name__ == "__main__":
    wrong = 0
    for page, name, endings in (("README.md", "cpp/room_and_robot", (".cpp", ".txt")),
                                ("docs/c.md", "c/room_and_robot", (".c", ".txt")),
                                ("docs/from_cgal.md", "cpp/from_cgal", (".cpp", ".txt")),
                                ("docs/from_clipper.md", "cpp/from_clipper", (".cpp", ".txt")),
                                ("docs/open.md", "cpp/open_sum", (".txt",))):
        found = blocks((ROOT / page).read_text(encoding="utf-8"))
        for ending in endings:
            text = text_of((ROOT / "docs/examples" / name).with_suffix(ending))
            if text not in found:
                wrong += 1
                print(f"{page} has no block that is {name}{ending}:\n{text}")
    sys.exit(1 if wrong else 0)
