#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Asks Coq which axioms the theorems in theorems.json use, and fails if there are any.

theorems.json says for each which registered statement it backs, how much of it (extent, which
properties/pages/records.py checks), its name and file, what it says in plain words (gloss), what of the statement it covers
and what not. Each is a Theorem, Lemma or Corollary of its file with a comment right above it.
Usage: headlines.py SOURCES BUILD STATEMENTS, BUILD made by compiled.py, STATEMENTS the folder of
the registered statements."""

import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from sources import module

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
    """The axioms that Coq reports for each theorem, in their order."""
    together = asked([theorems], build)
    if together == [CLOSED]:
        return [CLOSED] * len(theorems)
    return asked([[entry] for entry in theorems], build)


def asked(groups, build, library="Oplus", required=()):
    """What Coq says the theorems of each group together rest on: it looks at all that they are made of,
    which many have in common. The library is compiled in BUILD, those that it requires in other folders."""
    with tempfile.TemporaryDirectory() as directory:
        lines = []
        for number, group in enumerate(groups):
            lines += [f"Require {one}." for one in sorted({module(entry["file"], library) for entry in group})]
            names = [f"@{module(entry['file'], library)}.{entry['theorem']}" for entry in group]
            lines += [f"Definition group{number} := ({', '.join(names)}).",
                      f'Redirect "{number}" Print Assumptions group{number}.']
        source = Path(directory) / "asked.v"
        source.write_text("\n".join(lines) + "\n", encoding="utf-8")
        paths = [word for folder, name in [(build, library), *required] for word in ("-R", folder.resolve(), name)]
        done = subprocess.run(["coqc", *paths, source], cwd=directory)
        if done.returncode != 0:
            sys.exit("Coq does not know a theorem")
        return [(Path(directory) / f"{number}.out").read_text(encoding="utf-8").strip()
                for number in range(len(groups))]


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
