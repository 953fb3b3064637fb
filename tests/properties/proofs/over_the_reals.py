#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compiles the theory a second time, over Coq's real numbers, then what says that both agree, and asks Coq which axioms
the theorems in theorems.json use there: those that a page lists, and no others.

Over the reals are all sources that _CoqProject names but those of over_the_reals/rational_only, which says why.
Usage: over_the_reals.py SOURCES BUILD REALS BOTH PAGE, BUILD made by compiled.py, REALS and BOTH the folders of what
is compiled here"""

import json
import re
import shutil
import sys
from pathlib import Path

from compiled import compile_in, named
from headlines import asked
from sources import unproved, without_comments

# Takes the place of the rational numbers.
NUMBERS, REAL_NUMBERS = "numbers/numbers.v", "real_numbers.v"
# Of these a file over the reals would not be about real numbers.
RATIONAL = re.compile(r"\b(?:Q(?:Arith|field|minmax|abs|reduction|round|reals|canon)\w*|Lqa)\b")
LISTED = re.compile(r"^- `([\w.]+)`", re.MULTILINE)


def rational_only(text):
    """What the list leaves out, and why."""
    lines = [line.partition(": ") for line in text.splitlines() if line and not line.startswith("#")]
    return {name: reason for name, _, reason in lines}


def is_left_out(name, left_out):
    return name in left_out or name.partition("/")[0] in left_out


def violations(project, left_out, texts):
    """What is wrong with the list, given the sources that _CoqProject names and their texts."""
    found = [f"{name}: no reason" for name, reason in left_out.items() if not reason]
    found += [f"{name}: no source is or is in it" for name in left_out
              if not any(is_left_out(one, {name}) for one in project)]
    return found + [f"{name}: requires {word}" for name in project if not is_left_out(name, left_out)
                    for line in without_comments(texts[name]).split(".\n") if "Require" in line
                    for word in RATIONAL.findall(line)]


def bring_up_to_date(sources, build, paths):
    """Copies what has changed, sources by their names in BUILD, and writes _CoqProject."""
    build.mkdir(parents=True, exist_ok=True)
    for old in build.rglob("*.v"):
        if str(old.relative_to(build)) not in sources:
            for made in old.parent.glob(old.stem + ".*"):
                made.unlink()
    for name, source in sources.items():
        copy = build / name
        if not copy.exists() or copy.read_bytes() != source.read_bytes():
            copy.parent.mkdir(exist_ok=True)
            shutil.copyfile(source, copy)
    lines = [f"-R {folder} {name}" for folder, name in paths] + list(sources)
    (build / "_CoqProject").write_text("\n".join(lines) + "\n", encoding="utf-8")


def axioms(said):
    """The names in what Print Assumptions prints."""
    return set(re.findall(r"^([\w.']+)\s*:", said.partition("Axioms:\n")[2], re.MULTILINE))


def main():
    folder, build, reals, both, page = (Path(word).resolve() for word in sys.argv[1:])
    own, project = folder / "over_the_reals", named(folder / "_CoqProject")
    left_out = rational_only((own / "rational_only").read_text(encoding="utf-8"))
    found = violations(project, left_out, {name: (folder / name).read_text(encoding="utf-8") for name in project})
    for source in sorted(own.glob("*.v")):
        found += unproved(source.name, source.read_text(encoding="utf-8"))
    if found:
        sys.exit("\n".join(found))
    sources = {name: folder / name for name in project if not is_left_out(name, left_out)}
    sources[NUMBERS] = own / REAL_NUMBERS
    bring_up_to_date(sources, reals, [(".", "Oplus.reals")])
    agreement = {source.name: source for source in own.glob("*.v") if source.name != REAL_NUMBERS}
    versions = [(build, "Oplus"), (reals, "Oplus.reals")]
    bring_up_to_date(agreement, both, [(".", "Oplus.both"), *versions])
    if not compile_in(reals) or not compile_in(both):
        sys.exit("Coq rejects the proofs over the real numbers")
    headlines = json.loads((folder / "theorems.json").read_text(encoding="utf-8"))
    theorems = [entry for entry in headlines if entry["file"] in sources]
    agreed = [{"file": name, "theorem": theorem} for name, source in agreement.items()
              for theorem in re.findall(r"^Theorem (\w+)", source.read_text(encoding="utf-8"), re.MULTILINE)]
    used = axioms(asked([theorems], reals, "Oplus.reals")[0])
    used |= axioms(asked([agreed], both, "Oplus.both", versions)[0])
    listed = set(LISTED.findall(page.read_text(encoding="utf-8")))
    print(f"{len(sources)} sources; {len(theorems)} of {len(headlines)} theorems, and {len(agreed)} that say that both"
          f" agree; axioms: {', '.join(sorted(used))}")
    if used != listed or not theorems or not agreed:
        sys.exit(f"{page} lists other axioms: {', '.join(sorted(listed))}")


if __name__ == "__main__":
    main()
