#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""api_in_examples.py XML: fails on a public function or class that no program of docs/examples/cpp uses. XML is
what docs/api/make writes."""

import re
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parents[2] / "docs/examples/cpp"
# Loops over ranges call these.
UNNAMED = {"begin", "end"}
OPERATORS = {"operator-": r"[ (,]-\w", "operator*": r"\) \* ", "operator()": r"\w\(\{", "operator==": r" == "}


def public(folder):
    """Names of the functions, with those of classes, and of the classes."""
    found = set()
    for file in sorted(Path(folder).glob("*.xml")):
        for compound in ElementTree.parse(file).getroot().iter("compounddef"):
            if compound.get("kind") not in ("class", "struct", "namespace"):
                continue
            name = re.sub(r"<.*", "", compound.findtext("compoundname")).strip().split("::")[-1]
            if compound.get("kind") != "namespace":
                found.add(name)
            for member in compound.iter("memberdef"):
                called = member.findtext("name")
                if member.get("kind") == "function" and member.get("prot") == "public":
                    found.add(called if called != name else name)
    return found


def shown(name, text):
    return re.search(OPERATORS.get(name, rf"\b{re.escape(name)}\b"), text) is not None


if __name__ == "__main__":
    names = public(sys.argv[1])
    lines = [line for path in sorted(EXAMPLES.glob("*.cpp"))
             for line in path.read_text(encoding="utf-8").splitlines()]
    text = "\n".join(re.sub(r"//.*", "", line) for line in lines)
    missing = sorted(name for name in names - UNNAMED if not shown(name, text))
    for name in missing:
        print(f"{name}: in no program of docs/examples/cpp")
    print(f"public functions and classes: {len(names)}, {len(missing)} in no example")
    sys.exit(1 if missing or len(names) < 20 else 0)
