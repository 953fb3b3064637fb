#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Extracts the proved predicates to OCaml and builds the program that writes tables of them.

Fails where something is extracted that rests on an axiom, or is replaced by code of OCaml's.
Usage: extracted.py SOURCES COMPILED-PROOFS"""

import re
import shutil
import subprocess
import sys
from pathlib import Path

from sources import without_comments

REPLACED = re.compile(r"\bExtract\s+(Inlined\s+)?(Constant|Inductive)\b|\bExtrOcaml\w+")


def replaced(text):
    """What the source of the extraction replaces."""
    return [found.group(0) for found in REPLACED.finditer(without_comments(text))]


def run(command, folder):
    done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}")
    return done.stdout


def extract(sources, compiled):
    """Returns the program."""
    build = compiled / "extraction"
    build.mkdir(parents=True, exist_ok=True)
    for source in ("extraction.v", "tables.ml"):
        shutil.copyfile(sources / "extraction" / source, build / source)
    found = replaced((build / "extraction.v").read_text(encoding="utf-8"))
    if found:
        sys.exit(f"extraction.v replaces what was proved: {', '.join(found)}")
    said = run(["coqc", "-R", compiled.resolve(), "Oplus", "extraction.v"], build)
    if "axiom" in said.lower() or "AXIOM" in (build / "proved.ml").read_text(encoding="utf-8"):
        sys.exit(f"what is extracted rests on axioms\n{said}")
    run(["ocamlopt", "-w", "-a", "-o", "tables", "proved.mli", "proved.ml", "tables.ml"], build)
    return build / "tables"


if __name__ == "__main__":
    print(f"built {extract(*map(Path, sys.argv[1:3]))}")
