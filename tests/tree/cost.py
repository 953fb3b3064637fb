#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a run of tests/run cost, in seconds of processor time, from build/costs.

cost.py report: prints the costs; names each test of the default list above 60 s, fails on one above 180 s, and on
a line of tests/everything.txt that names no test.
cost.py append: adds what the last run cost to docs/cost.csv, as a row of the commit that is checked out, and writes
what its tests of the default list cost by kind, which is the first word of their names, to docs/tests.csv."""

import csv
import json
import re
import subprocess
import sys
from pathlib import Path

from sources import ROOT

NAMED, REFUSED = 60, 180


def read(path):
    """[(seconds, name)] of lines `USER SYSTEM NAME`; what a test that was killed left unfinished is no line."""
    lines = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
    matches = (re.fullmatch(r"([\d.]+) ([\d.]+) (.+)", line) for line in lines)
    return [(float(match[1]) + float(match[2]), match[3]) for match in matches if match]


def is_default(name, everything):
    return not any(re.fullmatch(pattern, name) for pattern in everything)


def report(builds, tests, everything):
    """Returns the lines to print, and whether no test is refused."""
    total = sum(seconds for seconds, _ in builds + tests)
    lines = ["processor time: " + ", ".join(f"{name} {seconds:.0f} s" for seconds, name in builds) +
             f", {len(tests)} tests {sum(seconds for seconds, _ in tests):.0f} s; in all {total / 60:.1f} min"]
    dearest = sorted(tests, reverse=True)
    lines.append("dearest tests: " + ", ".join(f"{name} {seconds:.0f} s" for seconds, name in dearest[:10]))
    too_dear = [(seconds, name) for seconds, name in dearest if seconds > NAMED and is_default(name, everything)]
    lines += [f"{name}: {seconds:.0f} s of processor time; a test of the default list should take {NAMED} s at most"
              + (f" and fails above {REFUSED} s (tests/everything.txt)" if seconds > REFUSED else "")
              for seconds, name in too_dear]
    return lines, all(seconds <= REFUSED for seconds, _ in too_dear)


def without_tests(everything, names):
    return [f"tests/everything.txt: {pattern} names no test" for pattern in everything
            if not any(re.fullmatch(pattern, name) for name in names)]


def output_of(*command):
    return subprocess.run(command, capture_output=True, check=True, text=True, cwd=ROOT).stdout


def git(*arguments):
    return output_of("git", *arguments)


def all_tests():
    listed = json.loads(output_of("ctest", "--test-dir", "build", "--show-only=json-v1"))
    return [test["name"] for test in listed["tests"]]


def found_in(pattern, *suffixes):
    """How often the pattern matches in the files with these ends of names."""
    names = [name for name in git("ls-files").split("\n") if name.endswith(suffixes)]
    return sum(len(re.findall(pattern, (ROOT / name).read_bytes())) for name in names)


def append(builds, tests, table):
    row = [git("log", "-1", "--format=%cs %h").strip(), found_in(b"\n", ".cpp", ".hpp"), found_in(b"\n", ".v"),
           *(round(seconds) for seconds, _ in builds), round(sum(seconds for seconds, _ in tests)), len(tests),
           found_in(rb"\nTEST(?:_F|_P)?\(", "_test.cpp"), found_in(rb"\n *def test_", ".py")]
    with table.open("a", encoding="utf-8", newline="") as file:
        csv.writer(file, lineterminator="\n").writerow(row)


def by_kind(tests, names, everything):
    """Rows of docs/tests.csv: of the tests that were run, those of the default list; of all names, the others."""
    default = [(seconds, name) for seconds, name in tests if is_default(name, everything)]
    others = [name for name in names if not is_default(name, everything)]
    kind_of = lambda name: re.match(r"\w+", name)[0]
    for kind in sorted({kind_of(name) for _, name in default} | {kind_of(name) for name in others}):
        costs = [seconds for seconds, name in default if kind_of(name) == kind]
        yield [kind, len(costs), round(sum(costs)), sum(kind_of(name) == kind for name in others)]


def write_kinds(rows, table):
    with table.open("w", encoding="utf-8", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([["kind", "default tests", "core-seconds", "other tests"], *rows])


def main():
    builds, tests = (read(ROOT / "build/costs" / name) for name in ("builds", "tests"))
    everything = [line for line in (ROOT / "tests/everything.txt").read_text(encoding="utf-8").splitlines()
                  if not line.startswith("#")]
    if sys.argv[1:] == ["append"]:
        append(builds, tests, ROOT / "docs/cost.csv")
        write_kinds(by_kind(tests, all_tests(), everything), ROOT / "docs/tests.csv")
    elif sys.argv[1:] == ["report"]:
        lines, accepted = report(builds, tests, everything)
        unknown = without_tests(everything, all_tests())
        print("\n".join(lines + unknown))
        sys.exit(bool(unknown) or not accepted)
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
