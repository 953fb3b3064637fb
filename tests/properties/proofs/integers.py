#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests properties/proofs/programs/integers.js: in JavaScript, integers.ml writes what it writes with Zarith, byte for byte.
Usage: integers.py INTEGERS, the file in JavaScript"""

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SOURCE = Path(__file__).with_suffix(".ml")


def output(folder, *command):
    return subprocess.run(command, cwd=folder, check=True, capture_output=True, text=True)


def main():
    integers = Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(SOURCE, folder)
        build = ("-package", "zarith", "-linkpkg", SOURCE.name)
        output(folder, "ocamlfind", "ocamlopt", "-o", "native", *build)
        output(folder, "ocamlfind", "ocamlc", "-o", "bytecode", *build)
        said = output(folder, "js_of_ocaml", "--target-env=browser", "-o", "integers.js", integers, "bytecode").stderr
        if said:
            sys.exit(f"js_of_ocaml: {said}")
        wanted, got = (output(folder, *command).stdout.splitlines() for command in (["./native"], ["node", "integers.js"]))
    wrong = [f"line {i + 1}: {b}; expected {a}" for i, (a, b) in enumerate(zip(wanted, got)) if a != b]
    if len(wanted) != len(got):
        wrong.append(f"{len(got)} lines; expected {len(wanted)}")
    print("\n".join([*wrong[:20], f"{len(wanted)} lines compared, {len(wrong)} differ"]))
    sys.exit(1 if wrong or len(wanted) < 10_000 else 0)


if __name__ == "__main__":
    main()
