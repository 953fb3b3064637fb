#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails where CGAL shows through a header to whoever uses the library: users would need CGAL, and wait a
minute a file. A header that needs CGAL, itself or through another, is for the headers of its own folder
and the sources of its own library only."""

from includes import includes
from sources import ROOT, cpp, report

LIBRARIES = ("reference", "checked")


def headers_over_cgal(root):
    """Names of the libraries' headers that include CGAL, or one of these."""
    included = {path.relative_to(root).as_posix(): {one.path for one in includes(path)}
                for path in cpp(root) if path.suffix == ".hpp"
                and path.relative_to(root).parts[0] in LIBRARIES}
    over = {name for name in included
            if any((path or "").startswith("CGAL/") for path in included[name])}
    while True:
        more = {name for name in included if name not in over and included[name] & over}
        if not more:
            return over
        over |= more


def may_include(name, header):
    if name.endswith(".cpp"):
        return name.split("/")[0] == header.split("/")[0]
    return name.rpartition("/")[0] == header.rpartition("/")[0]


def violations(root):
    over, found = headers_over_cgal(root), []
    for path in cpp(root):
        name = path.relative_to(root).as_posix()
        if name.startswith("tests/"):  # a test of a private header includes it
            continue
        for include in includes(path):
            if include.path in over and not may_include(name, include.path):
                found.append(f"{name}:{include.line}: {include.path} brings CGAL out of its folder")
    return found


if __name__ == "__main__":
    report("headers", sum(path.suffix == ".hpp" for path in cpp(ROOT)), violations(ROOT))
