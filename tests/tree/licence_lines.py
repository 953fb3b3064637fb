#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails on a source file or script whose first line, after a #! line, is not the SPDX line of its
folder's licence, on an include that takes GPL code into the core, on a missing licence, and on data of others that
tests/data/README.md does not name."""

from includes import includes
from sources import ROOT, cpp, files, report

MIT, GPL, MPL = "MIT", "GPL-3.0-or-later", "MPL-2.0"
# The library oplus_core; of `checked`, what is not in a folder. All else is over CGAL, or may be.
CORE = ("reference/definitions", "reference/arithmetic", "reference/chains", "reference/io",
        "reference/io/windows", "reference/io/windows/sys",
        "reference/oracle", "reference/pictures", "checked", "checked/arithmetic",
        "checked/bindings/c", "checked/boxes", "checked/certificates", "checked/collision", "checked/cycles", "checked/distance", "checked/layouts",
        "checked/operations", "checked/oplus", "checked/oplus/internal",
        "checked/pieces", "checked/repair", "checked/rounding", "checked/slide", "checked/verify")
# What users copy from.
EXAMPLES = ("docs/examples/c", "docs/examples/cpp", "docs/examples/nesting", "tests/consumer")
PYTHON = ("checked/bindings/python", "checked/bindings/python/oplus")
WEB = ("checked/bindings/npm", "checked/bindings/page", "checked/bindings/wasm")
INSTALL = ("checked/install", "checked/install/recipes", "checked/install/recipes/debian",
           "checked/install/recipes/vcpkg/oplus", "checked/install/recipes/conan")
# Only for those who have CGAL; of it, what is under the LGPL (tests/checked/oplus/cgal_licence).
ADAPTERS = ("checked/oplus/cgal.hpp",)
NOT_IN_CORE = ("CGAL", "tbb", "oneapi", "mpfr.h")
OURS = ("reference", "checked", "properties", "tests", "oplus")
LINE = "SPDX-License-Identifier: "
COMMENT = {".c": ("// ", ""), ".h": ("// ", ""), ".rs": ("// ", ""), ".lua": ("-- ", ""), ".ts": ("// ", ""),
           ".cpp": ("// ", ""), ".hpp": ("// ", ""), ".mjs": ("// ", ""), ".smt2": ("; ", ""),
           ".v": ("(* ", " *)"), ".ml": ("(* ", " *)"), ".mli": ("(* ", " *)")}
SCRIPTS = (".py", ".sh", ".cmake")


def is_source(path):
    if path.suffix in COMMENT or path.suffix in SCRIPTS or path.name == "CMakeLists.txt":
        return True
    with path.open("rb") as file:
        return file.read(2) == b"#!"


def licence(name):
    return MIT if name.rpartition("/")[0] in CORE + EXAMPLES + PYTHON + WEB + INSTALL else GPL


def wrong_includes(root):
    found = []
    for path in cpp(root):
        name = path.relative_to(root).as_posix()
        if name.rpartition("/")[0] not in CORE or name in ADAPTERS:
            continue
        for include in includes(path):
            first = (include.path or "").split("/")[0]
            if first in NOT_IN_CORE or first in OURS and licence(include.path) != MIT:
                found.append(f"{name}:{include.line}: the core may not include {include.path}")
    return found


def missing_licences(root):
    return [f"LICENSES/{one}.txt: missing" for one in (GPL, MIT, MPL)
            if not (root / "LICENSES" / f"{one}.txt").is_file()]


def unnamed_data(root):
    """Data of others, of which the table beside it does not say whose it is."""
    data = root / "tests/data"
    readme = data / "README.md"
    table = [line for line in readme.read_text(encoding="utf-8").splitlines() if line.startswith("|")]
    return [f"{path.relative_to(root)}: no row of {readme.relative_to(root)}" for path in files(root)
            if data in path.parents and path != readme
            and not any(f"`{path.relative_to(data)}`" in line for line in table)]


def violations(root, paths):
    found = []
    for path in paths:
        lines = path.read_text(encoding="utf-8").splitlines()
        if lines and lines[0].startswith("#!"):
            lines = lines[1:]
        opened, closed = COMMENT.get(path.suffix, ("# ", ""))
        expected = opened + LINE + licence(path.relative_to(root).as_posix()) + closed
        if not lines or lines[0] != expected:
            found.append(f"{path.relative_to(root)}: does not start with `{expected}`")
    return found


def sources(root):
    return [path for path in files(root) if is_source(path)]


if __name__ == "__main__":
    report("licences", len(sources(ROOT)),
           violations(ROOT, sources(ROOT)) + wrong_includes(ROOT) + missing_licences(ROOT) +
           unnamed_data(ROOT))
