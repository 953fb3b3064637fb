#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""cpp_reference.py XML: prints the page of the reference in C++ for Breathe, from what docs/api/make writes: the
declarations of each header in its order. Breathe's own list of a header sorts them by kind, and declares the
namespace once a header."""

import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

HEADERS = ("oplus.hpp", "engines.hpp", "number_types.hpp", "cgal.hpp", "boost_geometry.hpp")
DIRECTIVES = {"function": "doxygenfunction", "typedef": "doxygentypedef", "enum": "doxygenenum",
              "variable": "doxygenvariable", "class": "doxygenclass", "struct": "doxygenstruct"}


def declarations(folder):
    """(header, line, directive) of all that is public."""
    for file in folder.glob("*.xml"):
        for compound in ElementTree.parse(file).getroot().iter("compounddef"):
            kind, name = compound.get("kind"), compound.findtext("compoundname")
            is_namespace = kind == "namespace" and name == "oplus"
            found = compound.iter("memberdef") if is_namespace else [compound]
            for one in found if is_namespace or kind in DIRECTIVES and one_is_public(compound) else ():
                where, what = one.find("location"), one.get("kind")
                full = f"oplus::{one.findtext('name')}" if is_namespace else name
                if what == "function":
                    full += one.findtext("argsstring")
                members = "   :members:\n" if what in ("class", "struct") else ""
                yield where.get("file"), int(where.get("line")), f".. {DIRECTIVES[what]}:: {full}\n{members}\n"


def one_is_public(compound):
    return compound.get("prot") == "public"


if __name__ == "__main__":
    found = sorted(declarations(Path(sys.argv[1])))
    print("C++\n===\nPrograms that show each function: :doc:`/examples/README`. All names are in the namespace oplus.\n")
    for header in HEADERS:
        title = f"<oplus/{header}>"
        print(f".. _{header.replace('_', '__').replace('.', '_8')}:\n\n{title}\n{'-' * len(title)}\n"
              f".. doxygenfile:: {header}\n   :sections: briefdescription detaileddescription\n")
        print("".join(text for file, line, text in found if file == f"oplus/{header}"))
    others = {file for file, line, text in found} - {f"oplus/{header}" for header in HEADERS}
    sys.exit(f"headers that are not in the reference: {sorted(others)}" if others else 0)
