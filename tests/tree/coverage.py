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
CODE, EXPANSION, SKIPPED, GAP = range(4)  # kinds of regions


def lines_run(regions):
    """By line of one instance: whether it is run. The innermost region around a line counts, and what begins in it."""
    around, begun = {}, defaultdict(list)
    for line, _, last, end, count, kind in sorted(regions, key=lambda region: (*region[:2], -region[2], -region[3])):
        # What is skipped, a comment or an empty line, has whole lines.
        for one in range(line + (kind != SKIPPED), last + (end > 1 or line == last)):
            around[one] = None if kind == SKIPPED else count
        if kind in (CODE, EXPANSION):
            begun[line].append(count)
    found = {line: count > 0 for line, count in around.items() if count is not None}
    return found | {line: max(*counts, around.get(line) or 0) > 0 for line, counts in begun.items()}


def lines_covered(instances):
    """By line of a file: whether any instance of the function runs it; of functions within each other, such as lambdas, of
    the innermost one."""
    functions = defaultdict(lambda: defaultdict(bool))
    for regions in instances:
        of_function = functions[tuple(regions[0][:4])]
        for line, is_run in lines_run(regions).items():
            of_function[line] |= is_run
    found = {}
    for (first, *_), of_function in sorted(functions.items(), key=lambda entry: (*entry[0][:2], -entry[0][2], -entry[0][3])):
        for line, is_run in of_function.items():
            found[line] = is_run or (line == first and found.get(line, False))
    return found


def by_file(functions):
    """By file, the regions of each instance of a function; and by span and outcome: whether a branch has it in any instance.
    A condition that the compiler decides is left out."""
    instances, branches = defaultdict(list), defaultdict(lambda: defaultdict(bool))
    for function in functions:
        regions = defaultdict(list)
        for *span, count, file, _, kind in function["regions"]:
            regions[function["filenames"][file]].append((*span, count, kind))
        for name, of_file in regions.items():
            instances[name].append(of_file)
        for *span, taken, not_taken, file, _, _ in function["branches"]:
            for outcome, count in ((True, taken), (False, not_taken)):
                branches[function["filenames"][file]][(*span, outcome)] |= count > 0
    return instances, branches


def of_mutant(text, line, column):
    """Whether the statement of a place, or one that contains it, has named a mutant before."""
    start = sum(len(one) + 1 for one in text.split("\n")[:line - 1]) + column - 1
    # Of containing statements; blocks and parentheses that ended before; whether another statement did.
    named, blocks, parentheses, ended = "", 0, 0, False
    for character in reversed(re.sub(r'"[^"\n]*"', lambda found: " " * len(found[0]), text)[:start]):
        parentheses += {")": 1, "(": -1}.get(character, 0)
        if character == "{" and not blocks:
            ended = False
        elif character in "{}":
            blocks += 1 if character == "}" else -1
            ended = True
        elif character == ";" and parentheses <= 0:
            ended |= not blocks
        elif not ended:
            named = character + named
    return "OPLUS_MUTANT(" in named


class File:
    def __init__(self, name, text, instances, branches):
        self.name, self.text = name, text
        # What is by default nobody wrote.
        written = [not line.endswith("= default;") for line in text.split("\n")]
        self.lines = {line: covered for line, covered in lines_covered(instances).items() if written[line - 1]}
        self.branches = {place: covered for place, covered in branches.items() if written[place[0] - 1]}

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
                if condition == ":":  # of a loop over a range
                    yield line, column, f"`{code[line - 1].strip()}` {'has no turn' if outcome else 'never ends'}"
                else:
                    yield line, column, f"`{condition}` is never {str(outcome).lower()}"


def files_of(exported, root):
    """The files of the core."""
    instances, branches = by_file(exported["data"][0]["functions"])
    for path, of_file in instances.items():
        # ccache makes it relative to the folder of the build, which may be another clone's.
        name = path.rpartition("/../")[2].removeprefix(f"{root}/")
        if CORE.fullmatch(name):
            yield File(name, (root / name).read_text(encoding="utf-8"), of_file, branches[path])


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
    """{reason: [line of the page]}, in their order; what has no reason has an empty one. Of lines that follow one another, the
    first is named. Then the places, FILE: PART, that are covered."""
    found = {reason: [] for reason in [*dict.fromkeys(reason for reason, _, _ in reasons), MUTANT, ""]}
    left = {(name, part) for _, name, part in reasons}
    for file in files:
        before = (0, "")
        for line, column, what in file.uncovered():
            named = [(reason, part) for reason, name, part in reasons if name == file.name and part in what]
            left -= {(file.name, part) for _, part in named}
            inherited = before[1] if before[0] == line - 1 else ""
            reason = MUTANT if of_mutant(file.text, line, column) else named[0][0] if named else inherited
            if " is never " not in what:
                before = (line, reason)
            found[reason].append(f"- {file.name}, line {line}: {what}")
    return {reason: lines for reason, lines in found.items() if lines}, sorted(map(": ".join, left))


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
    for reason, lines in found.items():
        yield f"\n**{reason or 'No reason is given.'}**\n"
        yield from lines


def violations(files, found):
    yield from (f"{REASONS}: no reason for {line[2:]}" for line in found.get("", []))
    if not files:
        yield "no file of the core was run"
    for (what, least), (covered, total) in zip(LEAST.items(), counts(files)):
        if covered * 100 < least * total:
            yield f"{share(covered, total)} of {what} are covered, fewer than {least} %"


def main(exported, root):
    files = sorted(files_of(exported, root), key=lambda file: file.name)
    reasons = read_reasons((root / REASONS).read_text(encoding="utf-8"))
    found, left = by_reason(files, reasons)
    (root / "docs/coverage.md").write_text("\n".join(page(files, found)) + "\n", encoding="utf-8")
    return list(violations(files, found)), left, counts(files)


if __name__ == "__main__":
    wrong, left, (lines, sides) = main(json.load(sys.stdin), ROOT)
    # Not wrong: a few depend on which thread comes first.
    print("\n".join([*wrong, *(f"{REASONS}: is covered: {place}" for place in left),
                     f"{share(*lines)} of {lines[1]} lines, {share(*sides)} of {sides[1]} sides of branches"]))
    sys.exit(bool(wrong))
