#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails where the core uses an algorithm of std::ranges that neither Emscripten's C++ library has nor
checked/bindings/wasm/libcxx with as many arguments, since the page and the npm module are compiled by `--everything` only."""

import re

from licence_lines import CORE
from sources import ROOT, cpp, report

HEADER = "checked/bindings/wasm/libcxx/algorithm"
USED = re.compile(r"std::ranges::(\w+)\(")
HAS = {("begin", 1), ("end", 1)}
# Not compiled for these two.
ELSEWHERE = ("reference/oracle", "reference/pictures", "checked/distance/point_location", "checked/layouts")


def arguments(text, start):
    """How many there are, of what begins behind the opening parenthesis, and how many of them have a default."""
    depth = 0
    count, defaults = 1, 0
    for sign in text[start:]:
        depth += (sign in "([{") - (sign in ")]}")
        if depth < 0:
            return count, defaults
        count += sign == "," and depth == 0
        defaults += sign == "=" and depth == 0


def known_algorithms(header):
    """Names, each with every number of arguments that it takes."""
    for found in re.finditer(r"^\w+ (\w+)\(", header, re.MULTILINE):
        most, defaults = arguments(header, found.end())
        yield from ((found[1], number) for number in range(most - defaults, most + 1))


def violations(root):
    header = (root / HEADER).read_text(encoding="utf-8")
    known = HAS | set(known_algorithms(header))
    for path in cpp(root):
        name = path.relative_to(root).as_posix()
        if name.rpartition("/")[0] not in CORE or name.startswith(ELSEWHERE):
            continue
        text = path.read_text(encoding="utf-8")
        for found in USED.finditer(text):
            used = (found[1], arguments(text, found.end())[0])
            if used not in known:
                yield f"{name}:{text.count(chr(10), 0, found.start()) + 1}: {HEADER} has no {used[0]} of {used[1]} arguments"


if __name__ == "__main__":
    report("algorithms of the page", len(cpp(ROOT)), list(violations(ROOT)))
