#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails on an include that the layout does not allow, and on folders that include each other."""

from includes import includes
from sources import ROOT, cpp, report

# The arrows of the design: a file includes what is in its own folder of a line, or before it. The longest
# folder of a line that holds a file is its folder there; one line that allows an include is enough.
LINES = (
    ("reference/definitions", "reference/arithmetic", "reference/chains", "reference/io",
     "reference/pictures", "reference/families", "checked", "checked/cli", "properties", "tests"),
    ("reference/definitions", "reference/oracle", "checked/cli", "properties", "tests"),
    ("docs/findings",),
    ("oplus", "docs/examples"),
)
# Ways to use what is checked: each includes its own folder and what is named here, whatever the lines say.
BINDINGS = {
    "checked/bindings/python": ("oplus", "checked/slide/parallel_for.hpp",
                                "checked/oplus/internal/named_operations.hpp"),
    "checked/bindings/c": ("checked/oplus", "checked/version.hpp", "checked/cycles", "checked/distance", "checked/verify",
                           "reference/definitions", "reference/io"),
}
OURS = ("reference", "checked", "properties", "tests", "docs", "oplus")


def holds(folder, path):
    return path.startswith(folder + "/")


def place(line, path):
    """The index of a path's folder on a line, or None."""
    folders = [folder for folder in line if holds(folder, path)]
    return line.index(max(folders, key=len)) if folders else None


def allowed(including, included):
    for folder, others in BINDINGS.items():
        if holds(folder, including):
            return any(other == included or holds(other, included) for other in (folder, *others))
        if holds(folder, included) and not holds("tests", including):
            return False
    for line in LINES:
        here, there = place(line, including), place(line, included)
        if None not in (here, there) and there <= here:
            return True
    return False


def folder_of(path):
    """checked/rca/face.cpp is in checked/rca, however deep, and a binding is a folder of its own."""
    return next((folder for folder in BINDINGS if holds(folder, path)), "/".join(path.split("/")[:2]))


def cycle(graph):
    """Returns the folders of one cycle, the first one repeated at the end, or an empty list."""
    done, path = set(), []

    def visit(folder):
        if folder in path:
            return path[path.index(folder):] + [folder]
        if folder in done:
            return []
        path.append(folder)
        for included in sorted(graph.get(folder, ())):
            found = visit(included)
            if found:
                return found
        path.pop()
        done.add(folder)
        return []

    for start in sorted(graph):
        found = visit(start)
        if found:
            return found
    return []


def sources(root):
    """The C++ of the layout, by its paths from the root."""
    for path in cpp(root):
        name = path.relative_to(root).as_posix()
        if not holds("tests/consumer", name):  # a project of its own
            yield name, path


def violations(root):
    found, graph = [], {}
    for name, path in sources(root):
        if all(place(line, name) is None for line in LINES):
            found.append(f"{name}: no rule says what this folder may include")
            continue
        for include in includes(path):
            where, included = f"{name}:{include.line}", include.path
            if included is None:
                found.append(f"{where}: an include that is computed can't be checked")
                continue
            if included.split("/")[0] not in OURS:
                if include.quoted:
                    found.append(f"{where}: {included} is not named from the repository root")
                continue
            if not allowed(name, included):
                found.append(f"{where}: {folder_of(name)} may not include {included}")
            if not holds("tests", name) and folder_of(name) != folder_of(included):
                graph.setdefault(folder_of(name), set()).add(folder_of(included))
    around = cycle(graph)
    if around:
        found.append("folders include each other: " + " -> ".join(around))
    return found


if __name__ == "__main__":
    report("layering", len(cpp(ROOT)), violations(ROOT))
