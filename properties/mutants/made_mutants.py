#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""made_mutants.py COPY PATH...: writes to COPY the sources of this tree, with faults at places of PATH... that a fixed seed
chooses, as many in each file as there are: operators exchanged, conditions and results negated, numbers one more,
statements left out. All are in one build, switched off; the environment variable OPLUS_MADE is the number of the one
that is on. COPY/made.tsv lists them; try_made.py tries them. Those that do not compile, with all warnings, are to be left out by
--without.

Needs Debian's python3-clang-14, so /usr/bin/python3."""

import argparse
import random
import re
import subprocess
from pathlib import Path

from clang.cindex import CursorKind as Kind, Index, TranslationUnit, TypeKind

ROOT = Path(__file__).resolve().parents[2]
EXCHANGED = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==",
             "+": "-", "-": "+", "*": "+", "/": "*", "&&": "||", "||": "&&"}
HEADER = """#pragma once
#include <fcntl.h>
#include <sys/mman.h>
#include <cstdlib>
#include <type_traits>
// One byte per fault, in the file OPLUS_MADE_REACHED if there is one: whether a run came to its place.
inline char* oplus_made_reached() {
  static char nowhere[4096];
  static char* const bytes = [] {
    const char* file = std::getenv("OPLUS_MADE_REACHED");
    if (file == nullptr) return nowhere;
    return static_cast<char*>(mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_SHARED, open(file, O_RDWR), 0));
  }();
  return bytes;
}
constexpr bool oplus_made(int number) {
  if (std::is_constant_evaluated()) return false;
  static_cast<void>(oplus_made_reached()[number] = 1);
  return number == [] {
    static const char* const on = std::getenv("OPLUS_MADE");
    static const int is_on = on == nullptr ? -1 : std::atoi(on);
    return is_on;
  }();
}
"""


def places(file, code):
    """Yields the kind of a fault, where it begins and ends, the text that is put there, and what it changes."""
    unit = Index.create().parse(str(file), ["-std=c++20", f"-I{ROOT}", "-DOPLUS_CONTRACTS", "-DOPLUS_MUTANTS"],
                                options=TranslationUnit.PARSE_DETAILED_PROCESSING_RECORD)
    here = [c for c in unit.cursor.get_children() if c.location.file and c.location.file.name == str(file)]
    macros = [span(c) for c in here if c.kind == Kind.MACRO_INSTANTIATION]

    def text(begin, end):
        return code[begin:end].decode()

    def exchanged(cursor, kind, changed):
        begin, end = span(cursor)
        return kind, begin, end, f"(oplus_made(@) ? ({changed}) : ({text(begin, end)}))", f"{text(begin, end)} -> {changed}"

    def of(cursor, parent):
        children = list(cursor.get_children())
        if cursor.kind in (Kind.BINARY_OPERATOR, Kind.CALL_EXPR) and len(children) > 1:
            begin, end = children[0].extent.end.offset, children[-1].extent.start.offset
            operator = text(begin, end).strip()
            if operator in EXCHANGED and not any(first <= begin < last for first, last in macros):
                left, right = text(span(cursor)[0], begin), text(end, span(cursor)[1])
                yield exchanged(cursor, "operator", f"{left} {EXCHANGED[operator]} {right}")
        elif cursor.kind == Kind.INTEGER_LITERAL:
            kind, begin, end, put, what = exchanged(cursor, "number", text(*span(cursor)) + " + 1")
            yield kind, begin, end, put, what + ", in " + code.decode().split("\n")[cursor.location.line - 1].strip()
        elif cursor.kind in (Kind.IF_STMT, Kind.WHILE_STMT, Kind.CONDITIONAL_OPERATOR, Kind.RETURN_STMT) and children:
            condition = children[0]
            result = cursor.kind == Kind.RETURN_STMT
            if condition.kind.is_expression() and (not result or condition.type.kind == TypeKind.BOOL):
                yield exchanged(condition, "result" if result else "condition", f"!({text(*span(condition))})")
        begin, end = span(cursor)
        if parent.kind == Kind.COMPOUND_STMT and cursor.kind.is_expression() and ".reserve(" not in text(begin, end):
            yield "statement", begin, end, f"if (!oplus_made(@)) {text(begin, end)}", f"{text(begin, end)} -> left out"

    def walk(cursor, parent, in_function):
        if cursor.kind == Kind.STATIC_ASSERT or any(a <= span(cursor)[0] and span(cursor)[1] <= b for a, b in macros):
            return
        at_compile_time = text(*span(cursor)).startswith("if constexpr")
        if in_function and not at_compile_time:
            yield from of(cursor, parent)
        for child in list(cursor.get_children())[at_compile_time:]:
            yield from walk(child, cursor, in_function or child.kind == Kind.COMPOUND_STMT)

    for cursor in here:
        if cursor.kind != Kind.MACRO_INSTANTIATION:
            yield from walk(cursor, unit.cursor, False)


def span(cursor):
    return cursor.extent.start.offset, cursor.extent.end.offset


def in_random_order(found, randomly):
    """One of each kind after the other, lest the kinds that are most frequent be nearly all."""
    kinds = {}
    for place in randomly.sample(found, len(found)):
        kinds.setdefault(place[0], []).append(place)
    while kinds:
        for kind in randomly.sample(sorted(kinds), len(kinds)):
            yield kinds[kind].pop()
            if not kinds[kind]:
                del kinds[kind]


def git(*arguments):
    return subprocess.run(["git", "-C", ROOT, *arguments], check=True, capture_output=True, text=True).stdout


def write(path, data):
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_bytes() != data:  # so that only what changed is compiled again
        path.write_bytes(data)


def main(copy, paths, number, without):
    randomly = random.Random(1)
    files = sorted(f for path in paths for f in ([ROOT / path] if (ROOT / path).is_file() else (ROOT / path).rglob("*.[ch]pp")))
    queues = {f: in_random_order(list(dict.fromkeys(places(f, f.read_bytes()))), randomly) for f in files}
    chosen = []
    while queues and len(chosen) < number:
        for file in randomly.sample(sorted(queues), len(queues)):
            taken = [(begin, end) for f, (_, begin, end, *_) in chosen if f == file]
            place = next((p for p in queues[file] if all(p[2] <= a or b <= p[1] for a, b in taken)), None)
            if place:
                chosen.append((file, place))
            else:
                del queues[file]
    chosen = chosen[:number]
    commit = git("rev-parse", "--short=8", "HEAD").strip()
    rows = [f"number\tfile\tline at {commit}\tchange\n"]
    changed = {}
    for n, (file, (_, begin, end, put, what)) in enumerate(chosen):
        line = file.read_bytes()[:begin].count(b"\n") + 1
        if n not in without:
            what = " ".join(what.split())
            what = what if len(what) <= 110 else what[:107] + "..."
            rows.append(f"{n}\t{file.relative_to(ROOT)}\t{line}\t{what}\n")
            changed.setdefault(file, []).append((begin, end, put.replace("@", str(n))))
    for name in git("ls-files").split("\n")[:-1]:
        data = (ROOT / name).read_bytes()
        for begin, end, put in sorted(changed.get(ROOT / name, ()), reverse=True):
            data = data[:begin] + put.encode() + data[end:]
        if ROOT / name in changed:
            data = b'#include "made.hpp"\n' + data
        write(copy / name, data)
    write(copy / "made.hpp", HEADER.encode())
    write(copy / "made.tsv", "".join(rows).encode())


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("copy", type=Path)
    parser.add_argument("paths", nargs="+")
    parser.add_argument("--number", type=int, default=300)
    parser.add_argument("--without", type=lambda t: set(map(int, t.split(","))), default=set(), metavar="N,N...",
                        help="leave these out")
    options = parser.parse_args()
    main(options.copy, options.paths, options.number, options.without)
