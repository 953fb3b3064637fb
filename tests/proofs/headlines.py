#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Asks Coq what the theorems in theorems.json rest on, and fails unless that is nothing at all.

theorems.json says for each which registered statement it backs, whether it is the whole of it or a
part (extent), its name and file, what it says in
plain words (gloss), what of the statement it covers and what not. Each is a Theorem, Lemma or
Corollary of its file with a comment right above it.
Usage: headlines.py SOURCES BUILD STATEMENTS, BUILD made by compiled.py, STATEMENTS the folder of
the registered statements."""

import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

KEYS = ["statement", "extent", "theorem", "file", "gloss", "covers", "not_covered"]
CLOSED = "Closed under the global context"


def registered(folder):
    """The ids of the statements that sources below the folder register."""
    return {found for path in folder.rglob("*.cpp")
            for found in re.findall(r'\.id = "([^"]+)"', path.read_text(encoding="utf-8"))}


def stated(text, theorem):
    """Whether the source states the theorem, a comment above it."""
    return re.search(rf"\*\)\n(?:Theorem|Lemma|Corollary) {re.escape(theorem)}\b", text) is not None


def violations(theorems, folder, statements):
    """What is wrong with the list itself."""
    found, seen = [], set()
    for entry in theorems:
        name = entry.get("theorem", "?")
        if list(entry) != KEYS or not all(isinstance(v, str) and v for v in entry.values()):
            found.append(f"{name}: needs texts for exactly {', '.join(KEYS)}, in this order")
            continue
        if (entry["statement"], name) in seen:
            found.append(f"{name}: listed twice for {entry['statement']}")
        seen.add((entry["statement"], name))
        if entry["statement"] not in statements:
            found.append(f"{name}: no statement {entry['statement']} is registered")
        source = folder / entry["file"]
        if not source.is_file() or not stated(source.read_text(encoding="utf-8"), name):
            found.append(f"{name}: not stated in {entry['file']} under a comment")
    return found


def assumptions(theorems, build):
    """What Coq says each theorem rests on, in their order."""
    with tempfile.TemporaryDirectory() as directory:
        lines = []
        for number, entry in enumerate(theorems):
            module = Path(entry["file"]).stem
            lines += [f"From Oplus Require {module}.",
                      f'Redirect "{number}" Print Assumptions Oplus.{module}.{entry["theorem"]}.']
        asked = Path(directory) / "asked.v"
        asked.write_text("\n".join(lines) + "\n", encoding="utf-8")
        done = subprocess.run(["coqc", "-R", build.resolve(), "Oplus", asked], cwd=directory)
        if done.returncode != 0:
            sys.exit("Coq does not know a theorem")
        return [(Path(directory) / f"{number}.out").read_text(encoding="utf-8").strip()
                for number in range(len(theorems))]


def main():
    folder, build, statements = map(Path, sys.argv[1:4])
    theorems = json.loads((folder / "theorems.json").read_text(encoding="utf-8"))
    found = violations(theorems, folder, registered(statements))
    if not found:
        found = [f"{entry['theorem']} rests on: {said}"
                 for entry, said in zip(theorems, assumptions(theorems, build)) if said != CLOSED]
    for violation in found:
        print(violation)
    print(f"{len(theorems)} theorems, {len(found)} wrong")
    sys.exit(1 if found or not theorems else 0)


if __name__ == "__main__":
    main()
