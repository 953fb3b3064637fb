#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""list_mutants.py ROOT FILE: writes the list of mutants (mutants.hpp) as C++ to FILE, from the places
of the source tree where they are: OPLUS_MUTANT("name", "what goes wrong"). A fault that is in several
places is described in one of them."""

import re
import sys
from pathlib import Path

QUOTED = r'"(?:[^"\\]|\\.)*"'
PLACE = re.compile(rf'\bOPLUS_MUTANT\(\s*({QUOTED})\s*(?:,\s*((?:{QUOTED}\s*)+))?\)')
MACRO = Path("reference/definitions/mutant.hpp")


def text(literals):
    return "".join(literal[1:-1] for literal in re.findall(QUOTED, literals or ""))


def places(root):
    """Yields name, description or "", and file of each fault; comments don't count."""
    for folder in ("reference", "checked", "properties"):
        for path in sorted((root / folder).rglob("*.[ch]pp")):
            file = path.relative_to(root)
            code = re.sub(r"^\s*//.*", "", path.read_text(encoding="utf-8"), flags=re.M)
            found = PLACE.findall(code)
            if file == MACRO:
                continue
            if len(found) != code.count("OPLUS_MUTANT("):
                raise ValueError(f"{file}: the name or description of a mutant is not a string")
            if found and folder == "properties":
                raise ValueError(f"{file}: mutants are in reference/ and checked/ only")
            for name, what in found:
                yield text(name), text(what), file.as_posix()


def mutants(root):
    """Returns (name, description, file) of each mutant, sorted. Throws ValueError."""
    described, named = {}, {}
    for name, what, file in places(root):
        named.setdefault(name, file)
        if what and described.setdefault(name, (what, file)) != (what, file):
            raise ValueError(f"{name}: described in {described[name][1]} and in {file}")
    for name, file in named.items():
        if name not in described:
            raise ValueError(f"{name}: {file} does not say what goes wrong")
    return sorted((name, *rest) for name, rest in described.items())


def source(all_mutants):
    entries = "".join(f'      {{"{name}",\n       "{what}",\n       "{file}"}},\n'
                      for name, what, file in all_mutants)
    return f"""// SPDX-License-Identifier: GPL-3.0-or-later
// Made by properties/mutants/list_mutants.py.
#include "properties/mutants/mutants.hpp"

namespace oplus {{

const std::vector<Mutant>& mutants() {{
  static const std::vector<Mutant> all = {{
{entries}  }};
  return all;
}}

}}  // namespace oplus
"""


if __name__ == "__main__":
    try:
        made = source(mutants(Path(sys.argv[1])))
    except ValueError as error:
        sys.exit(str(error))
    target = Path(sys.argv[2])
    if not target.exists() or target.read_text(encoding="utf-8") != made:
        target.write_text(made, encoding="utf-8")
