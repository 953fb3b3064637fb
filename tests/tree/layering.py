#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails on an include that the layout does not allow, and on folders that include each other."""

from includes import includes
from sources import ROOT, cpp, report

# Who may include what of ours: the table of the design. The longest folder that holds a file decides.
REFERENCE = {"reference/definitions", "reference/io", "reference/oracle", "reference/verify"}
GENERATORS = {"reference/definitions", "reference/io", "properties/generators"}
CHECKED = {"reference/definitions", "reference/io", "checked"}
PROPERTIES = REFERENCE | {"checked", "checked/cli", "properties", "properties/generators"}
MAY_INCLUDE = {
    "reference/definitions": {"reference/definitions"},
    "reference/io": {"reference/definitions", "reference/io"},
    "reference/oracle": {"reference/definitions", "reference/oracle"},
    # Cuts the plane into cells as the oracle does, and names its places as messages do.
    "reference/verify": REFERENCE,
    "checked": CHECKED,
    # Composes the program, so it alone of `checked` sees what decides by the definitions.
    "checked/cli": CHECKED | {"checked/cli", "reference/oracle", "reference/verify",
                              "properties/generators"},
    # `checked/cli` offers them, so they can't be above it.
    "properties/generators": GENERATORS,
    "properties": PROPERTIES,
    "tests": PROPERTIES | {"tests"},
    # Programs that show what is wrong with others, for others to compile.
    "docs/findings": set(),
}
OURS = ("reference", "checked", "properties", "tests", "docs", "oplus")


def holds(folder, path):
    return path.startswith(folder + "/")


def layer(path):
    """The entry of the table that decides about a path, or None."""
    return max((folder for folder in MAY_INCLUDE if holds(folder, path)), key=len, default=None)


def folder_of(path):
    """checked/rca/face.cpp is in checked/rca, however deep."""
    return "/".join(path.split("/")[:2])


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


def violations(root):
    found, graph = [], {}
    for path in cpp(root):
        name = path.relative_to(root).as_posix()
        if holds("tests/consumer", name):  # a project of its own
            continue
        including = layer(name)
        if including is None:
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
            if layer(included) not in MAY_INCLUDE[including]:
                found.append(f"{where}: {including} may not include {included}")
            if including != "tests" and folder_of(name) != folder_of(included):
                graph.setdefault(folder_of(name), set()).add(folder_of(included))
    around = cycle(graph)
    if around:
        found.append("folders include each other: " + " -> ".join(around))
    return found


if __name__ == "__main__":
    report("layering", len(cpp(ROOT)), violations(ROOT))
