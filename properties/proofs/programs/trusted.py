#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes what a user of an extracted program has to believe, as OCaml: extraction's settings as they stand in the sources,
and the numbers of lines of the sources that are not proved.
Usage: trusted.py FILE PROOFS COQ SOURCES..., COQ what `coqc -where` prints, SOURCES those in OCaml and C"""

import re
import sys
from pathlib import Path

SETTING = re.compile(r"^Extract (.*?)\.$", re.MULTILINE | re.DOTALL)
REQUIRED = re.compile(r"Require (?:Import |Export )?([^.]*)\.")
COMMENT = re.compile(r"\(\*.*?\*\)|/\*.*?\*/", re.DOTALL)


def without_comments(path):
    return COMMENT.sub("", path.read_text(encoding="utf-8"))


def described(path):
    """How many lines of code there are, and what the source says that it is, in its second comment's first sentence."""
    count = sum(bool(line.strip()) for line in without_comments(path).splitlines())
    about = re.sub(r"\s+", " ", COMMENT.findall(path.read_text(encoding="utf-8"))[1].strip("(*/ )"))
    return f"  {count:4}  {path.name}: {re.split(r'[.:] ', about + ' ')[0]}\n"


def settings(path, coq):
    """The settings of a source, those of the sources of Coq's that it requires first."""
    text, found = without_comments(path), []
    for names in REQUIRED.findall(text):
        for name in re.findall(r"ExtrOcaml\w+", names):
            found += settings(coq / f"theories/extraction/{name}.v", coq)
    return found + [re.sub(r"\s+", " ", setting) for setting in SETTING.findall(text)]


def main():
    target, proofs, coq = map(Path, sys.argv[1:4])
    replaced = [f"  {setting}\n" for setting in settings(proofs / "programs/zarith.v", coq)]
    counted = [described(path) for path in (proofs / "specification/specification.v", *map(Path, sys.argv[4:]))]
    text = (f"One has to believe, in lines without comments:\n{''.join(counted)}"
            "and Coq's kernel and extraction, OCaml's compiler and runtime, Zarith and GMP.\n"
            "There are no axioms.\n\n"
            f"Extraction replaces {len(replaced)} types and functions of Coq's by those of OCaml and Zarith, none of ours:\n"
            f"{''.join(replaced)}")
    target.write_text(f"let text = {{trusted|{text}|trusted}}\n", encoding="utf-8")


if __name__ == "__main__":
    main()
