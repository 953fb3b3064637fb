#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/architecture.dot and .svg: which folder includes which, by the include lines. Fails where they are not what the
sources say, or where docs/architecture.md has no row for a folder.

architecture.py --write: writes both; the drawing by Graphviz."""

import subprocess
import sys

from includes import includes
from layering import OURS, folder_of, sources
from sources import ROOT, report

sys.path.insert(0, str(ROOT / "properties/pages"))
from defects import defects_of_drawing

DRAWN = ("reference", "checked", "properties")
# What users include is installed in a folder of that name.
INSTALLED = "oplus/"


def included_folders(root):
    """By folder of what is drawn, the other folders that it includes."""
    graph = {}
    for name, path in sources(root):
        folder = folder_of(name)
        if name.partition("/")[0] not in DRAWN or "." in folder:
            continue
        below = graph.setdefault(folder, set())
        for include in includes(path):
            if include.path and include.path.partition("/")[0] in OURS:
                other = folder_of(("checked/" if include.path.startswith(INSTALLED) else "") + include.path)
                below |= {other} - {folder} if "." not in other else set()
    return graph


def reachable(graph, folder):
    found, left = set(), [folder]
    while left:
        new = graph.get(left.pop(), set()) - found
        found |= new
        left += new
    return found


def without_detours(graph):
    """The arrows that no other way replaces."""
    return sorted((folder, other) for folder, below in graph.items() for other in below
                  if not any(other in reachable(graph, between) for between in below - {other}))


def in_dot(graph):
    """What includes nothing is at the top; fixed widths, so that the drawing does not depend on the installed fonts."""
    number = {folder: i for i, folder in enumerate(sorted(graph))}
    text = ("digraph G {\nrankdir=BT; ranksep=0.3; nodesep=0.15; fontname=\"sans-serif\"; fontsize=11; color=\"#8898aa\";\n"
            'node [shape=box, style="filled,rounded", fontname="sans-serif", fontsize=10, fixedsize=true, '
            'width=1.15, height=0.28, color="#8898aa", fillcolor="#e8eef7"];\nedge [color="#8898aa", arrowsize=0.6];\n')
    for top in DRAWN:
        text += f'subgraph cluster_{top} {{\nlabel="{top}/";\n'
        text += "".join(f'{i}[label="{folder.partition("/")[2]}"];\n' for folder, i in number.items()
                        if folder.startswith(top + "/")) + "}\n"
    return text + "".join(f"{number[one]}->{number[other]} ;\n" for one, other in without_detours(graph)) + "}\n"


def violations(root):
    graph, docs = included_folders(root), root / "docs"
    read = lambda name: (docs / name).read_text(encoding="utf-8") if (docs / name).is_file() else ""
    dot = in_dot(graph)
    if read("architecture.dot") != dot:
        yield "docs/architecture.dot: out of date; python3 -B tests/tree/architecture.py --write"
    yield from ("docs/" + defect for defect in defects_of_drawing(dot, read("architecture.svg"), "architecture"))
    page = read("architecture.md")
    yield from (f"docs/architecture.md: has no row for {folder}/" for folder in sorted(graph) if f"`{folder}/`" not in page)


if __name__ == "__main__":
    if sys.argv[1:] == ["--write"]:
        drawing = ROOT / "docs/architecture.dot"
        drawing.write_text(in_dot(included_folders(ROOT)), encoding="utf-8")
        subprocess.run(["dot", "-Tsvg", drawing, "-o", drawing.with_suffix(".svg")], check=True)
    report("architecture", len(included_folders(ROOT)), list(violations(ROOT)))
