#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines and branches of the core that no unit test runs, from what `llvm-cov export` prints: reads its JSON from standard
input, and writes docs/coverage.md (bash docs/renew coverage). Fails below 98 % of lines or 95 % of branches, and where
tests/tree/coverage.txt does not say why something is not covered.

A line of a template, or a side of a branch of it, is covered if it is in one of its instances."""

import json
import re
import sys
from collections import defaultdict

from sources import ROOT

CORE = re.compile(r"(reference/definitions|checked(?!/(?:bindings|cli|install)/))/.*")
REASONS = "tests/tree/coverage.txt"
LEAST = {"lines": 98, "branches": 95}
MUTANT = "Only a fault that is put in leads here ([mutants](mutants.md)); this build has none."


def lines_covered(segments):
    """By line: whether it is run. Lines without code are left out."""
    found, at_end = {}, None  # the count with which the line before ends, if it has one
    for line in range(segments[0][0], segments[-1][0] + 1) if segments else ():
        here = [segment for segment in segments if segment[0] == line]
        entered = [count for _, _, count, has_count, is_entry, is_gap in here if has_count and is_entry and not is_gap]
        left_out = here and here[0][4] and not here[0][3]
        if not left_out and (at_end is not None or entered):
            found[line] = max([at_end or 0, *entered]) > 0
        if here:
            at_end = here[-1][2] if here[-1][3] else None
    return found


def branches_covered(functions):
    """By file, and by span and outcome: whether the branch has it. A condition that the compiler decides is left out."""
    found = defaultdict(lambda: defaultdict(bool))
    for function in functions:
        for branch in function["branches"]:
            for outcome, count in ((True, branch[4]), (False, branch[5])):
                found[function["filenames"][branch[6]]][(*branch[:4], outcome)] |= count > 0
    return found


def of_mutant(text, line, column):
    """Whether the statement of a place, or one that contains it, has named a mutant before."""
    start = sum(len(one) + 1 for one in text.split("\n")[:line - 1]) + column - 1
    named, blocks, ended = "", 0, False  # of containing statements; blocks that ended before; whether another statement did
    for character in reversed(re.sub(r'"[^"\n]*"', lambda found: " " * len(found[0]), text)[:start]):
        if character == "{" and not blocks:
            ended = False
        elif character in "{}":
            blocks += 1 if character == "}" else -1
            ended = True
        elif character == ";":
            ended |= not blocks
        elif not ended:
            named = character + named
    return "OPLUS_MUTANT(" in named


class File:
    def __init__(self, name, text, segments, branches):
        self.name, self.text = name, text
        self.lines, self.branches = lines_covered(segments), branches

    def uncovered(self):
        """(line, column, what is not covered) of each line, and of each side of a branch in a line that is."""
        code = self.text.split("\n")
        for line, covered in sorted(self.lines.items()):
            if not covered:
                yield line, len(code[line - 1]) - len(code[line - 1].lstrip()) + 1, f"`{code[line - 1].strip()}`"
        for (line, column, last, end, outcome), covered in sorted(self.branches.items()):
            if not covered and self.lines.get(line, True):
                parts = code[line - 1:last]
                parts[-1] = parts[-1][:end - 1]
                condition = " ".join(part.strip() for part in [parts[0][column - 1:], *parts[1:]])
                yield line, column, f"`{condition}` is never {str(outcome).lower()}"


def files_of(exported, root):
    """The files of the core."""
    data = exported["data"][0]
    branches = branches_covered(data["functions"])
    for entry in data["files"]:
        # ccache makes it relative to the folder of the build, which may be another clone's.
        name = entry["filename"].rpartition("/../")[2].removeprefix(f"{root}/")
        if CORE.fullmatch(name):
            yield File(name, (root / name).read_text(encoding="utf-8"), entry["segments"], branches[entry["filename"]])


def read_reasons(text):
    """[(reason, file, part of what is not covered)] of paragraphs: a reason, then lines `  FILE: PART`."""
    found, reason = [], ""
    for line in text.splitlines():
        if line.startswith("  "):
            found.append((reason, *line.strip().split(": ", 1)))
        elif line and not line.startswith("#"):
            reason = line
    return found


def by_reason(files, reasons):
    """{reason: [line of the page]}; what has no reason has an empty one."""
    found = defaultdict(list)
    for file in files:
        for line, column, what in file.uncovered():
            named = [reason for reason, name, part in reasons if name == file.name and part in what]
            reason = named[0] if named else MUTANT if of_mutant(file.text, line, column) else ""
            found[reason].append(f"- {file.name}, line {line}: {what}")
    return found


def share(covered, total):
    """Per cent, rounded down, so that 100 means all."""
    return f"{covered * 1000 // total / 10:.1f} %" if total else "-"


def counts(files):
    return [(sum(values), len(values)) for values in (
        [covered for file in files for covered in file.lines.values()],
        [covered for file in files for covered in file.branches.values()])]


def table(files):
    rows = defaultdict(list)
    for file in files:
        rows[file.name.rpartition("/")[0]].append(file)
    yield "| folder | lines | covered | | sides of branches | covered | |"
    yield "|---|--:|--:|--:|--:|--:|--:|"
    for name, below in [*((f"`{name}/`", rows[name]) for name in sorted(rows)), ("**all**", files)]:
        cells = [f"{total:,} | {covered:,} | {share(covered, total)}" for covered, total in counts(below)]
        yield f"| {name} | {' | '.join(cells)} |"


def page(files, found):
    lines, sides = (share(*count) for count in counts(files))
    yield "# Coverage"
    yield f"""The unit tests run {lines} of the lines of the core, and take {sides} of the sides of its branches. Recorded by

    bash docs/renew coverage

which builds the tests of the core with Clang's coverage, without contracts and without mutants, and runs them once. The core
is what words mean, `reference/definitions/`, and all of `checked/` but the command line, the bindings and what installs.
A line of a template is covered if it is run in one of its instances; each condition of `&&` and `||` is a branch of its own.
What no test names, such as a template without an instance, has no lines.
"""
    yield from table(files)
    yield "\n## What is not covered, and why"
    yield f"Lines, and sides of branches in lines that are covered. The reasons are kept in [coverage.txt](../{REASONS})."
    for reason in sorted(found):
        yield f"\n**{reason or 'No reason is given.'}**\n"
        yield from found[reason]


def violations(files, found):
    yield from (f"{REASONS}: no reason for {line[2:]}" for line in found.get("", []))
    for (what, least), (covered, total) in zip(LEAST.items(), counts(files)):
        if covered * 100 < least * total:
            yield f"{share(covered, total)} of {what} are covered, fewer than {least} %"
    if not files:
        yield "no file of the core was run"


def main(exported, root):
    files = sorted(files_of(exported, root), key=lambda file: file.name)
    reasons = read_reasons((root / REASONS).read_text(encoding="utf-8"))
    found = by_reason(files, reasons)
    (root / "docs/coverage.md").write_text("\n".join(page(files, found)) + "\n", encoding="utf-8")
    wrong = list(violations(files, found))
    wrong += [f"{REASONS}: {name} has no `{part}`" for _, name, part in reasons
              if not (root / name).is_file()]
    return wrong, counts(files)


if __name__ == "__main__":
    wrong, (lines, sides) = main(json.load(sys.stdin), ROOT)
    print("\n".join(wrong + [f"{share(*lines)} of {lines[1]} lines, {share(*sides)} of {sides[1]} sides of branches"]))
    sys.exit(bool(wrong))
