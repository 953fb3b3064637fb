#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes what a user of an extracted program has to believe, as OCaml: extraction's settings as they stand in the sources,
the numbers of lines of the sources that are not proved, what made the program, and hashes.
Usage: trusted.py FILE PROOFS COQC OCAMLFIND EXTRACTION SOURCES..., the last ones in PROOFS, SOURCES those that are not proved"""

import hashlib
import re
import subprocess
import sys
from pathlib import Path

SETTING = re.compile(r"^Extract (.*?)\.$", re.MULTILINE | re.DOTALL)
REQUIRED = re.compile(r"Require (?:Import |Export )?([^.]*)\.")
COMMENT = re.compile(r"\(\*.*?\*\)|/\*.*?\*/|^//[^\n]*", re.DOTALL | re.MULTILINE)


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


def said(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.strip()


def main():
    target, proofs, coqc, ocamlfind = Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3], sys.argv[4]
    extraction, *believed = sys.argv[5:]
    coq = Path(said(coqc, "-where"))
    replaced = [f"  {setting}\n" for setting in settings(proofs / "programs/zarith.v", coq)]
    counted = [described(proofs / source) for source in believed]
    hashes = [f"  {hashlib.sha256((proofs / source).read_bytes()).hexdigest()}  properties/proofs/{source}\n"
              for source in (*believed, "programs/zarith.v", extraction)]
    made_by = (f"Coq {said(coqc, '-print-version').split()[0]}, OCaml {said(ocamlfind, 'ocamlopt', '-version')}, "
               f"Zarith {said(ocamlfind, 'query', '-format', '%v', 'zarith')}")
    text = (f"One has to believe, in lines without comments:\n{''.join(counted)}"
            "and Coq's kernel and extraction, OCaml's compiler and runtime, Zarith and GMP.\n"
            "There are no axioms.\n\n"
            f"Extraction replaces {len(replaced)} types and functions of Coq's by those of OCaml and Zarith, none of ours:\n"
            f"{''.join(replaced)}\n"
            f"The program was made by {made_by}, from these sources, of which `sha256sum` prints:\n{''.join(hashes)}")
    target.write_text(f"let text = {{trusted|{text}|trusted}}\n", encoding="utf-8")


if __name__ == "__main__":
    main()
