#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""readme_program.py: fails unless the program in README and its output are those of
docs/examples/cpp/room_and_robot, which is compiled and run."""

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


if __name__ == "__main__":
    found = blocks((ROOT / "README.md").read_text(encoding="utf-8"))
    example = ROOT / "docs/examples/cpp/room_and_robot"
    # A reader of README needs neither the licence's line nor that which says what it shows.
    program = [line for line in example.with_suffix(".cpp").read_text(encoding="utf-8").splitlines(True)
               if not line.startswith("//")]
    wrong = 0
    for what, text in (("program", "".join(program)),
                       ("output", example.with_suffix(".txt").read_text(encoding="utf-8"))):
        if text not in found:
            wrong += 1
            print(f"README.md has no block that is the {what} of {example.name}:\n{text}")
    sys.exit(1 if wrong else 0)
