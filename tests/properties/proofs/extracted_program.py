#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the programs that are extracted from Coq have in common: regions, valid and not, numbers, and outputs
that cannot be written; and the programs without any replacement that they are compared with."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

from extracted import replaced

HERE = Path(__file__).parent
# The page on what has to be believed.
BELIEVED = HERE.parents[2] / "docs/believe.md"

INVALID = 2


def square(x, y, side):
    """A ring, counterclockwise."""
    return f"({x} {y},{x + side} {y},{x + side} {y + side},{x} {y + side},{x} {y})"


def dat(wkt):
    """The same region, without the closing vertices."""
    polygons = re.findall(r"\(\([^()]*\)(?:,\([^()]*\))*\)", wkt)
    text = "" if polygons else "0"
    for polygon in polygons:
        rings = [ring.split(",")[:-1] for ring in re.findall(r"\(([^()]+)\)", polygon)]
        outer, *holes = (f"{len(ring)} {'  '.join(ring)}\n" for ring in rings)
        text += f"{outer}{len(holes)}\n{''.join(holes)}"
    return text


# Texts that are no regions, and what is said of them.
INVALID_REGIONS = [
    ("", ":1: the end of the text; expected POLYGON, MULTIPOLYGON or a number of vertices"),
    ("\n\nPOINT(0 0)", ":3: 'POINT'; expected POLYGON, MULTIPOLYGON or a number of vertices"),
    ("{}", "'{}'; expected POLYGON"),
    ("4\n0 0\n1 0\n1 1\n0\n", "the end of the text; expected an integer"),
    ("4 0 0 1 0 1 1 0 1 1", "the end of the text; expected a number from 0"),
    ("4 0 0 1 0 1 1 0 1 1 2 0 0 1 1", "a chain of 2 vertices; expected at least 3"),
    ("4 0 0 1 0 1 1 0 1 1 0", "a chain of 0 vertices; expected at least 3"),
    ("4 0 0 1 0 1 1 0 1 0 3 5 5 6 5 5 6", "the end of the text; expected a number from 0"),
    ("4 0 0 1 0 1 1 0 1 -1", "'-1'; expected a number from 0"),
    ("4 0 0,1 0,1 1,0 1", "','; expected an integer"),
    ("\n0 1\n3 0 0 0 1 1 0", ":2: an outer chain of 0 vertices; expected a bounded region"),
    ("0 0", "an outer chain of 0 vertices; expected a bounded region"),
    ("\n2\n0 0 1 1", ":2: a chain of 2 vertices; expected at least 3"),
    (f"{10 ** 30} 0 0", "; expected a number from 0"),
    ("-4 0 0", "'-4'; expected POLYGON"),
    ("[[0,0],[1,0],[0,1]]", "'[[0'; expected POLYGON"),
    ("M 0 0 L 1 0 0 1 Z", "'M'; expected POLYGON"),
    ("0103000000010000000400000000000000000000000000000000000000", "; expected a number from 0"),
    ("POLYGON", "the end of the text; expected '('"),
    ("POLYGON()", "')'; expected '('"),
    ("POLYGON(())", "')'; expected an integer"),
    ("POLYGON Z((0 0,1 0,0 1,0 0))", "'Z'; expected '('"),
    ("POLYGON((0 0,1 0,0 1,0 0)", "the end of the text; expected ',' or ')'"),
    ("POLYGON((0 0,1 0,0 1,0 0)))", "')'; expected the end of the text"),
    ("POLYGON((0 0,1 0,0 1,0 0)) 7", "'7'; expected the end of the text"),
    ("POLYGON((0 0,1 0,0 1))", "a ring is not closed; expected its first vertex again"),
    ("POLYGON((0 0))", "a ring is not closed; expected its first vertex again"),
    ("POLYGON((0 0,1,0 1,0 0))", "','; expected an integer"),
    ("POLYGON((0 0,1 0 5,0 1,0 0))", "'5'; expected ',' or ')'"),
    ("POLYGON((0 0,1/0 0,0 1,0 0))", "'1/0'; expected a fraction p/q with q > 0"),
    ("POLYGON((0 0,1/-2 0,0 1,0 0))", "'1/-2'; expected an integer"),
    ("POLYGON((0 0,1.5/2 0,0 1,0 0))", "'1.5/2'; expected an integer"),
    ("POLYGON((0 0,--1 0,0 1,0 0))", "'--1'; expected an integer"),
    ("POLYGON((0 0,. 0,0 1,0 0))", "'.'; expected an integer"),
    ("POLYGON((0 0,1e 0,0 1,0 0))", "'1e'; expected an integer"),
    ("POLYGON((0 0,1e4097 0,0 1,0 0))", "'1e4097'; expected an exponent from"),
    ("POLYGON((0 0,0x1 0,0 1,0 0))", "'0x1'; expected an integer"),
    ("POLYGON((0 0,1_0 0,0 1,0 0))", "'1_0'; expected an integer"),
    ("POLYGON((0 0,nan 0,0 1,0 0))", "'nan'; expected an integer"),
    ("POLYGON((0 0,1\u00a00,0 1,0 0))", r"'1\194\1600'; expected an integer"),
    ("POLYGON((0 0,1 0,0 1,0 0))\0", r"'\000'; expected the end of the text"),
    ("POLYGON((" + 200000 * "1", "...'; expected words of at most 100000 bytes"),
    ("POLYGON((0 0,0 0))", "edges of a ring overlap at its leftmost vertex"),
    ("POLYGON((0 0,1 0,0 0))", "edges of a ring overlap at its leftmost vertex"),
    (f"POLYGON({square(0, 0, 9)},(1 5,2 5,3 6,3 4,2 5,1 5))", "edges of a ring overlap at its leftmost vertex"),
    ("MULTIPOLYGON((0 0,1 0,0 1,0 0))", "'0'; expected '('"),
    ("GEOMETRYCOLLECTION(POLYGON EMPTY)", "'GEOMETRYCOLLECTION'; expected POLYGON"),
]

# Numbers, and what they are.
NUMBERS = [("7", "7"), ("-007", "-7"), ("+1", "1"), ("2.50", "5/2"), (".5", "1/2"), ("5.", "5"), ("-0.0", "0"),
           ("1.5e-3", "3/2000"), ("1.5E+3", "1500"), ("6/4", "3/2"), ("-3/9", "-1/3"), ("0/5", "0"), ("1e2", "100"),
           ("123456789012345678901234567890/11", "123456789012345678901234567890/11")]


def run(command, **more):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=300, **more)
    return done.returncode, done.stdout


def beside_plain(name, build, folder, *in_ocaml):
    """Builds the program of that name, which asks both what is extracted to `build` and the same without any
    replacement. `in_ocaml`: its sources besides those that read regions."""
    for source in ("plain_extraction.v", "plain_values.ml", name + ".ml"):
        shutil.copyfile(HERE / source, folder / source)
    if replaced((folder / "plain_extraction.v").read_text(encoding="utf-8")):
        sys.exit("plain_extraction.v replaces what was proved")
    read = ["proved.mli", "proved.ml", "files.ml", "regions.ml", *in_ocaml]
    for source in read:
        shutil.copyfile(build / source, folder / source)
    for command in (["coqc", "-vok", "-R", build.resolve().parent / "coq", "Oplus", "plain_extraction.v"],
                    ["ocamlfind", "ocamlopt", "-w", "-a", "-package", "zarith", "-linkpkg", "-o", name,
                     "plain.mli", "plain.ml", *read, "plain_values.ml", name + ".ml"]):
        code, said = run(command, cwd=folder)
        if code != 0 or "axiom" in said.lower():
            sys.exit(f"{' '.join(map(str, command))}\n{said}")
    return folder / name


class ProgramTest:
    """Counts what was tested, by kind, and keeps what was wrong."""

    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        self.failures, self.counted = [], {}

    def expect(self, kind, name, condition, said):
        self.counted[kind] = self.counted.get(kind, 0) + 1
        if not condition:
            self.failures.append(f"{kind}, {name}: {said}")

    def one_line(self, kind, name, ran, wanted):
        """No verdict, exit code 2, and one line on standard error, which the bash script has with the rest."""
        code, said = ran
        self.expect(kind, name, code == INVALID and said.count("\n") == 1 and wanted in said, f"exit code {code}: {said}")

    def sources_told(self, said, *own):
        """What --trusted says has the sources that every program has and its own ones, as the page has them."""
        told = {name: lines for lines, name in re.findall(r"^ +(\d+)  ([\w.]+): \w", said, re.MULTILINE)}
        expected = {"specification.v", "region_reader.v", "region_printer.v", "files.ml", "regions.ml", "program.ml", "stack.c",
                    *own}
        self.expect("sources told", "all", set(told) == expected, said)
        page = BELIEVED.read_text(encoding="utf-8")
        for name, lines in told.items():
            self.expect("sources told", name, f"| `{name}` | {lines} |" in page, f"{lines} lines; not in {BELIEVED}")
            self.expect("sources told", name, re.search(rf"^  [0-9a-f]{{64}}  \S+/{re.escape(name)}$", said, re.MULTILINE), said)
        self.expect("sources told", "made by", re.search(r"by Coq [\d.]+, OCaml [\d.]+, Zarith [\d.]+,", said), said)

    def outputs(self, files, *commands):
        """With files of these texts, named by letters."""
        for place, text in files.items():
            (self.folder / place).write_text(text, encoding="utf-8")
        for arguments in (*commands, "--help", "--version"):
            for output, why in ((">/dev/full", "No space left"), (">&-", "Bad file"), ("| :", "Broken pipe")):
                # The reader of the pipe has ended before anything is written.
                wait = "sleep 0.2; " if output == "| :" else ""
                script = f"set -o pipefail; ( {wait}exec {self.program} {arguments} 2>&3 3>&- ) 3>&2 {output}"
                self.one_line("outputs that cannot be written", f"{arguments} {output}",
                              run(["bash", "-c", script], cwd=self.folder), f"cannot write standard output: {why}")

    def summary(self):
        """Writes it. Returns the exit code."""
        for failure in self.failures:
            print(failure)
        print(", ".join(f"{count} {kind}" for kind, count in self.counted.items()))
        return 1 if self.failures else 0
