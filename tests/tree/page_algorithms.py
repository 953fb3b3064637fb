#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails where the core uses an algorithm of std::ranges that neither Emscripten's C++ library has nor
checked/bindings/wasm/libcxx, since the page and the npm module are compiled by `--everything` only."""

import re

from licence_lines import CORE
from sources import ROOT, cpp, report

HEADER = "checked/bindings/wasm/libcxx/algorithm"
USED = re.compile(r"std::ranges::(\w+)\(")
HAS = {"begin", "end"}
# Not compiled for these two.
ELSEWHERE = ("reference/oracle", "reference/pictures", "checked/distance/point_location", "checked/layouts")


def violations(root):
    known = HAS | set(re.findall(r"^\w+ (\w+)\(", (root / HEADER).read_text(encoding="utf-8"), re.MULTILINE))
    for path in cpp(root):
        name = path.relative_to(root).as_posix()
        if name.rpartition("/")[0] not in CORE or name.startswith(ELSEWHERE):
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            for used in USED.findall(line):
                if used not in known:
                    yield f"{name}:{number}: {HEADER} has no {used}"


if __name__ == "__main__":
    report("algorithms of the page", len(cpp(ROOT)), list(violations(ROOT)))
