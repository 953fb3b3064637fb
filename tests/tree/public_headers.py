#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails on a public header that includes CGAL: users would need it and wait a minute a file."""

import re

from sources import ROOT, cpp, report

CGAL = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"]CGAL/', re.MULTILINE)


def public_headers(root):
    """What is installed: see CMakeLists.txt."""
    return [path for path in cpp(root) if path.suffix == ".hpp"
            and path.relative_to(root).parts[0] in ("reference", "checked")
            and path.relative_to(root).parts[:2] != ("checked", "cli")]


def violations(root):
    return [f"{path.relative_to(root)}: includes CGAL" for path in public_headers(root)
            if CGAL.search(path.read_text(encoding="utf-8"))]


if __name__ == "__main__":
    report("public headers", len(public_headers(ROOT)), violations(ROOT))
