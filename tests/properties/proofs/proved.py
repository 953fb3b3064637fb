#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests oplus-proved: that it writes what oplus writes, as the same text; that it refuses what it
cannot read or write, in one line and with nothing half-written; and that it is what was extracted, and computes as
what is extracted from Coq without any replacement does.
Usage: proved.py PROGRAM BUILD OPLUS PROOFS, the folder in which it was built, the program that it is compared with, and
the sources of the proofs"""

import os
import re
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from extracted import replaced
from extracted_program import (BELIEVED, INVALID, INVALID_REGIONS, NUMBERS, ProgramTest, beside_plain, dat, run,
                               square)
from sources import DEFINED, without_comments

UNIT = f"POLYGON({square(0, 0, 1)})"
L_SHAPE = "POLYGON((0 0,2 0,2 1,1 1,1 2,0 2,0 0))"
AROUND = f"POLYGON({square(0, 0, 4)},(1 1,1 3,3 3,3 1,1 1))"
PLACES = ("erode", "open", "close")
COMMANDS = ("sum", "sum --open", "nfp", "ifp", *PLACES)
# Families of which these take seconds.
LARGE = ("fork", "dots", "touching", "islands", "components")

# Names, P and Q, for all commands.
EXAMPLES = {
    "squares": (UNIT, f"POLYGON({square(0, 0, 2)})"),
    "a hole that stays": (AROUND, UNIT),
    "a hole that is filled": (AROUND, f"POLYGON({square(0, 0, 3)})"),
    "a hole that is touched halfway along its first edge": (
        "POLYGON((-5 -8,5 -8,5 -1.7,1 -0.5,5 0.7,5 5,-5 5,-5 -8),(0 0,2 -1,1 -5,0 0))", UNIT),
    "a hole into which Q fits exactly": (AROUND, f"POLYGON({square(0, 0, 2)})"),
    "a corridor of Q's width": ("POLYGON((0 0,9 0,9 4,0 4,0 3,7 3,7 2,0 2,0 0))", UNIT),
    "components": (f"MULTIPOLYGON(({square(0, 0, 1)}),({square(9, 0, 1)}))", UNIT),
    "components in holes": (f"MULTIPOLYGON(({square(0, 0, 9)},(1 1,1 8,8 8,8 1,1 1)),({square(4, 4, 1)}))", UNIT),
    "components that touch": (f"MULTIPOLYGON(({square(0, 0, 1)}),({square(1, 1, 1)}))", UNIT),
    "a hole that touches its chain in a vertex": ("POLYGON((0 0,4 0,4 4,0 4,0 0),(0 0,1 3,3 1,0 0))", UNIT),
    "a vertex that touches an edge": ("MULTIPOLYGON(((0 0,4 0,4 4,0 4,0 0)),((4 2,6 1,6 3,4 2)))", L_SHAPE),
    "segments of equal direction": (L_SHAPE, L_SHAPE),
    "collinear vertices": ("POLYGON((0 0,1 0,2 0,2 2,0 2,0 1,0 0))", UNIT),
    "clockwise": ("POLYGON((0 0,0 1,1 1,1 0,0 0))", UNIT),
}

# Regions with two edges that cross, and the like; all are refused by oplus, too.
INVALID_CHAINS = {
    "crossing edges": "POLYGON((0 0,2 2,2 0,0 2,0 0))",
    "a spike": "POLYGON((0 0,4 0,4 4,2 4,2 6,2 4,0 4,0 0))",
    "a repeated vertex": "POLYGON((0 0,4 0,4 0,4 4,0 0))",
    "a hole outside": f"POLYGON({square(0, 0, 1)},(5 5,5 6,6 6,6 5,5 5))",
    "a hole that crosses its chain": f"POLYGON({square(0, 0, 2)},(1 1,1 3,3 3,3 1,1 1))",
    "holes that overlap": f"POLYGON({square(0, 0, 9)},(1 1,1 3,3 3,3 1,1 1),(2 2,2 4,4 4,4 2,2 2))",
    "components that overlap": f"MULTIPOLYGON(({square(0, 0, 2)}),({square(1, 1, 2)}))",
    "components that share an edge": f"MULTIPOLYGON(({square(0, 0, 1)}),({square(1, 0, 1)}))",
    "a component inside another": f"MULTIPOLYGON(({square(0, 0, 9)}),({square(1, 1, 1)}))",
    "a component twice": f"MULTIPOLYGON(({square(0, 0, 1)}),({square(0, 0, 1)}))",
}

# Without an outer chain.
INVALID_UNBOUNDED = [
    ("0 1", "the end of the text; expected a number"), ("0 1 2 0 0 1 1", "a chain of 2 vertices; expected at least 3"),
    ("0 0 3 0 0 1 0", "the end of the text; expected an integer"),
    ("0 1 4 0 0 2 2 2 0 0 2", "p: not a valid region"),
    ("0 2 4 0 0 0 2 2 2 2 0 4 1 1 1 3 3 3 3 1", "p: not a valid region"),
    ("0 2 4 0 0 0 4 4 4 4 0 4 1 1 1 3 3 3 3 1", "p: not a valid region"),
    ("0 1 4 0 0 0 2 2 2 2 0 4 5 5 6 5 6 6 5 6 0", "p: not a valid region"),
]

ENDLESS = ["yes", "cat /dev/zero", "tr '\\0' 1 </dev/zero", "printf 'POLYGON(('; tr '\\0' 1 </dev/zero"]


def numbers_of(text):
    return sorted(set(re.findall(r"[^\s(),]*\d[^\s(),]*", text)))


class Test(ProgramTest):
    def __init__(self, program, build, oplus, folder):
        super().__init__(program, folder)
        self.oplus = oplus
        self.both = beside_plain("both_programs", build, folder)

    def put(self, **texts):
        for name, text in texts.items():
            (self.folder / name).write_text(text, encoding="utf-8", newline="")

    def oplus_says(self, *arguments):
        return run([self.oplus, *arguments, "--quiet"], cwd=self.folder)

    def proved(self, arguments, **more):
        return run([self.program, *arguments.split()], cwd=self.folder, **more)

    def same_as_oplus(self, kind, name, commands=COMMANDS):
        """Of the files p and q."""
        for command in commands:
            code, said = self.oplus_says(*command.split(), "p", "q", "-o", "right.wkt")
            self.expect("sets of oplus", f"{name}, {command}", code == 0, said)
            code, said = self.proved(command + " p q -o given.wkt")
            self.expect(kind, f"{name}, {command}", code == 0 and said == "", said)
            if command in PLACES:
                equal, why = self.oplus_says("compare", "given.wkt", "right.wkt")
                self.expect(kind, f"{name}, {command}, as sets", equal == 0, why)
                continue
            right, given = ((self.folder / f"{file}.wkt").read_text() for file in ("right", "given"))
            self.expect(kind, f"{name}, {command}, as texts", given == right, f"{given}{right}")
        self.complements(kind, name)
        self.booleans(kind, name)

    def complements(self, kind, name):
        """As oplus writes them; the complement's complement is the region."""
        for file in "pq":
            code, right = self.oplus_says("complement", file, "--format", "dat")
            self.expect("sets of oplus", f"{name}, complement of {file}", code == 0, right)
            code, said = self.proved(f"complement {file}")
            self.expect(kind, f"{name}, complement of {file}", code == 0 and said == right, f"{said}{right}")
            self.put(outside=right)
            code, said = self.proved("complement outside -o again")
            self.expect(kind, f"{name}, complement of what is outside {file}", code == 0 and said == "", said)
            equal, why = self.oplus_says("compare", "again", file)
            self.expect(kind, f"{name}, complement of what is outside {file}, as sets", equal == 0, why)

    def booleans(self, kind, name):
        """The union is oplus's; with what is in both, what is in one only is all of that one."""
        parts = [text for text in (self.canonical(file) for file in "pq") if "EMPTY" not in text]
        self.put(both=f"GEOMETRYCOLLECTION({','.join(parts)})")
        for command in ("union p q -o all", "difference p q -o one", "difference q p -o other", "intersection p q -o common",
                        "union one common -o again", "intersection one other -o none"):
            code, said = self.proved(command)
            self.expect(kind, f"{name}, {command}", code == 0 and said == "", said)
        for one, other in (("all", "both"), ("again", "p")):
            right, given = self.canonical(other), (self.folder / one).read_text()
            self.expect(kind, f"{name}, {one}, as texts", given == right, f"{given}{right}")
        self.expect(kind, f"{name}, differences", (self.folder / "none").read_text() == "POLYGON EMPTY\n", "they overlap")
        # What is written is read, and is written as it was.
        for written in ("all", "one", "common"):
            code, said = self.proved(f"union {written} {written}")
            self.expect(kind, f"{name}, {written} again", (code, said) == (0, (self.folder / written).read_text()), said)

    def same_as_plain(self, name):
        """Of the files p and q: what the program's functions return, and the same without any replacement."""
        code, said = run([self.both, "p", "q"], cwd=self.folder)
        self.expect("pairs without replacements", name, code == 0 and said == "the same\n", said)

    def canonical(self, file):
        return self.oplus_says("transform", file, "--scale", "1", "--union")[1]

    def examples(self):
        for name, (p, q) in EXAMPLES.items():
            self.put(p=p, q=q)
            self.same_as_oplus("examples", name)
            self.same_as_plain(name)
            self.put(p=dat(p), q=dat(q))
            self.same_as_oplus("examples in .dat", name)

    def families(self):
        _, listed = run([self.oplus, "gen", "--list"])
        for i, family in enumerate(line.split()[0] for line in listed.splitlines()):
            for name, summand in (("p", "P"), ("q", "Q")):
                self.oplus_says("gen", family, "--n", "4", "--seed", "1", "--summand", summand, "-o", name, "--format",
                                ("wkt", "dat")[i % 2])
            self.same_as_oplus("families", family, COMMANDS[:-len(PLACES)] if family in LARGE else COMMANDS)

    def empty(self):
        self.put(p="POLYGON EMPTY", q=UNIT)
        for arguments in ("sum p q", "sum q p", "sum --open p q", "sum p p", "nfp p q", "nfp q p", "ifp p q", "erode p q", "open p q",
                          "close p q"):
            self.expect("empty", arguments, self.proved(arguments) == (0, "POLYGON EMPTY\n"), self.proved(arguments)[1])
        for command in ("ifp", *PLACES):
            self.one_line("empty", command, self.proved(f"{command} q p"), "Q is empty, and fits everywhere")
        self.put(plane="0\n0\n")
        for file, right in (("p", "0\n0\n"), ("plane", "POLYGON EMPTY\n")):
            self.expect("empty", f"complement of {file}", self.proved(f"complement {file}") == (0, right), right)

    def numbers(self):
        """Read and written exactly."""
        self.put(q="POLYGON((0 0,1 0,0 1,0 0))")
        for written, _ in NUMBERS:
            self.put(p=f"POLYGON(({written} 0,1000 7,0 3,{written} 0))")
            self.oplus_says("sum", "p", "q", "-o", "right.wkt")
            _, given = self.proved("sum p q")
            right = (self.folder / "right.wkt").read_text()
            self.expect("numbers", written, set(numbers_of(right)) <= set(numbers_of(given)), f"{given}{right}")

    def invalid(self):
        self.put(q=UNIT)
        for text, wanted in INVALID_REGIONS:
            self.put(p=text)
            self.one_line("invalid texts", text[:30], self.proved("sum p q"), wanted)
            self.one_line("invalid texts", text[:30], self.proved("sum q p"), wanted)
        for name, text in INVALID_CHAINS.items():
            self.put(p=text)
            self.expect("invalid chains of oplus", name, self.oplus_says("sum", "p", "q")[0] == INVALID, "oplus takes it")
            for command in COMMANDS:
                self.one_line("invalid chains", name, self.proved(command + " p q"), "p: not a valid region")
                self.one_line("invalid chains", name, self.proved(command + " q p"), "p: not a valid region")
            self.one_line("invalid chains", name, self.proved("complement p"), "p: not a valid region")
        for text, wanted in INVALID_UNBOUNDED:
            self.put(p=text)
            self.one_line("invalid unbounded regions", text, self.proved("complement p"), wanted)
            self.one_line("invalid unbounded regions", text, self.proved("sum p q"), "an outer chain of 0 vertices")

    def endless(self):
        self.put(p=UNIT)
        for command in ENDLESS:
            for files in (f"p <({command})", f"<({command}) p"):
                code, said = run(["bash", "-c", f"{self.program} sum {files}"], cwd=self.folder)
                self.expect("texts without an end", command, code == INVALID and "expected" in said, said)

    def standard_input(self):
        self.put(p=AROUND, q=UNIT)
        right = self.proved("sum p q")
        for arguments, file in (("sum - q", "p"), ("sum p -", "q")):
            with (self.folder / file).open() as text:
                self.expect("standard input", arguments, self.proved(arguments, stdin=text) == right, right)
        self.one_line("standard input", "twice", self.proved("sum - -", stdin=subprocess.DEVNULL), "standard input")
        with (self.folder / "p").open() as text:
            self.one_line("standard input", "twice", self.proved("sum - -", stdin=text), "can be read once only")

    def files(self):
        """What is written with -o, and what is left where it is not."""
        self.put(p=AROUND, q=UNIT, wrong="POLYGON((", old="old")
        _, right = self.proved("sum p q")
        here = set(os.listdir(self.folder))
        for arguments in ("sum p wrong -o old", "sum p nowhere -o old", "sum wrong q -o new", "ifp p -o new", "none p q -o new",
                          "sum p q -o old -o new"):
            code, said = self.proved(arguments)
            self.one_line("files that stay", arguments, (code, said), "oplus-proved: ")
            self.expect("files that stay", arguments, set(os.listdir(self.folder)) == here, os.listdir(self.folder))
        self.expect("files that stay", "old", (self.folder / "old").read_text() == "old", "it is written to")
        (self.folder / "old").chmod(0o640)
        (self.folder / "link").symlink_to("old")
        for name in ("new", "old", "link"):
            (self.folder / "old").write_text("old")
            for option in ("-o", "--output"):
                self.expect("files written", name, self.proved(f"sum p q {option} {name}") == (0, ""), name)
                self.expect("files written", name, (self.folder / name).read_text() == right, name)
        self.expect("files written", "mode", (self.folder / "old").stat().st_mode & 0o777 == 0o640, "it is another")
        self.expect("files written", "link", (self.folder / "link").is_symlink(), "it is a file")
        self.expect("files written", "-", self.proved("sum p q -o -") == (0, right), right)
        self.expect("files written", "/dev/stdout", self.proved("sum p q -o /dev/stdout") == (0, right), right)
        (self.folder / "folder").mkdir()
        for name, why in (("folder", "Is a directory"), ("nowhere/new", "No such file"), ("/dev/full", "No space left"),
                          ("/proc/new", "No such file")):
            self.one_line("files that cannot be written", name, self.proved(f"sum p q -o {name}"), f"cannot write {name}: {why}")
        left = set(os.listdir(self.folder)) - here
        self.expect("files that cannot be written", "left", left == {"new", "link", "folder"}, left)

    def interrupted(self):
        """Nothing is left, and the computation ends with the program."""
        for summand in ("P", "Q"):
            self.oplus_says("gen", "star", "--n", "400", "--summand", summand, "-o", "large." + summand, "--format", "wkt")
        for number in (signal.SIGTERM, signal.SIGINT):
            here = set(os.listdir(self.folder))
            process = subprocess.Popen([self.program, "sum", "large.P", "large.Q", "-o", "sum.wkt"], cwd=self.folder,
                                       stderr=subprocess.PIPE, text=True)
            deadline = time.monotonic() + 60
            while set(os.listdir(self.folder)) == here and time.monotonic() < deadline:
                time.sleep(0.05)
            began = set(os.listdir(self.folder)) - here
            self.expect("interrupts", number.name, len(began) == 1, began)
            process.send_signal(number)
            # Standard error ends with the process that computes.
            said = process.communicate(timeout=60)[1]
            self.expect("interrupts", number.name, (process.returncode, said) == (-number, ""), f"{process.returncode}, {said}")
            self.expect("interrupts", number.name, set(os.listdir(self.folder)) == here, os.listdir(self.folder))

    def little_memory(self):
        command = f"{self.program} sum large.P large.Q"
        for kilobytes in range(15000, 40000, 5000):
            self.one_line("little memory", f"{kilobytes} kB",
                          run(["bash", "-c", f"ulimit -c 0 -v {kilobytes}; {command}"], cwd=self.folder), "the memory is too small")

    def usage(self):
        for arguments, code, wanted in (
                ("--help", 0, "Usage: oplus-proved"), ("sum -h", 0, "Exit codes:"), ("--version", 0, "oplus-proved 1."),
                ("", 2, "no command; expected sum, nfp, ifp, erode"), ("add p q", 2, "the command 'add' is not known"),
                ("sum", 2, "0 files; expected P Q"), ("sum p", 2, "1 files; expected P Q"), ("nfp p q r", 2, "3 files"),
                ("complement", 2, "0 files; expected P (see"), ("complement p q", 2, "2 files; expected P (see"),
                ("complement /nowhere", 2, "/nowhere: No such file"), ("complement p --open", 2, "--open is an option of sum"),
                ("sum p q --fast", 2, "the option '--fast' is not known"), ("sum p q -o", 2, "-o takes the name of one file"),
                ("nfp p q --open", 2, "--open is an option of sum"), ("ifp p q --open", 2, "--open is an option of sum"),
                ("sum /nowhere p", 2, "/nowhere: No such file"), ("sum / p", 2, "/:1: Is a directory")):
            got, said = self.proved(arguments)
            self.expect("usage", arguments, got == code and wanted in said, f"exit code {got}: {said}")
            self.expect("usage", arguments, code == 0 or said.count("\n") == 1, said)

    def trusted(self, build, proofs):
        """What was extracted rests on no axiom and replaces nothing but what is said."""
        code, said = self.proved("--trusted")
        settings = (proofs / "programs/zarith.v").read_text(encoding="utf-8")
        for name in re.findall(r"Extract Constant ([\w.]+)", settings):
            self.expect("replacements told", name, code == 0 and f"  Constant {name} =>" in said, said)
        self.expect("replacements told", "Coq's own", "  Constant Z.add =>" in said and "  Inductive positive =>" in said, said)
        self.expect("replacements told", "all", len(re.findall(r"^  (Inlined )?(Constant|Inductive) ", said, re.M)) > 60, said)
        self.sources_told(said, "text.ml", "commands.ml", "output.ml", "main.ml")
        page = BELIEVED.read_text(encoding="utf-8")
        for name in DEFINED.findall(without_comments((proofs / "specification/specification.v").read_text(encoding="utf-8"))):
            self.expect("definitions explained", name, f"`{name}`" in page, page)
        extraction = (proofs / "proved/extraction.v").read_text(encoding="utf-8")
        self.expect("extraction", "replaces nothing", not replaced(extraction), replaced(extraction))
        self.expect("extraction", "no axioms", "AXIOM" not in (build / "proved.ml").read_text(encoding="utf-8"), "there is one")


def main():
    program, build, oplus, proofs = (Path(argument).resolve() for argument in sys.argv[1:5])
    with tempfile.TemporaryDirectory() as directory:
        test = Test(program, build, oplus, Path(directory))
        for part in (test.examples, test.families, test.empty, test.numbers, test.invalid, test.endless,
                     test.standard_input, test.files, test.interrupted, test.little_memory, test.usage):
            part()
        test.outputs({"p": AROUND, "q": UNIT}, "sum p q", "sum --open p q", "ifp p q", "--trusted")
        test.trusted(build, proofs)
        sys.exit(test.summary())


if __name__ == "__main__":
    main()
