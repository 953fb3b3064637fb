#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""installed_headers.py ROOT OUT: writes the headers of this folder into OUT as they are installed. What a
header includes of ours is put into it, once, so that users see nothing else of ours and no path of ours can be
one of theirs; another header of this folder is included as <oplus/...>. A file that is up to date stays."""

import re
import sys
from pathlib import Path

PUBLIC = "checked/oplus/"
OURS = re.compile(r'#include "(.*)"')


def expanded(root, name, system, seen):
    """Returns the lines of a header without those that only a file of its own needs, and puts the other
    libraries' includes into `system`."""
    lines = []
    for line in (root / name).read_text(encoding="utf-8").splitlines():
        include = OURS.fullmatch(line)
        if include and include[1].startswith(PUBLIC):
            system.add(f"#include <oplus/{include[1].removeprefix(PUBLIC)}>")
        elif include and include[1] not in seen:
            seen.add(include[1])
            lines += expanded(root, include[1], system, seen)
        elif line.startswith("#include"):
            system.update([line] if not include else [])
        elif line != "#pragma once" and not line.startswith("// SPDX"):
            lines.append(line)
    return lines


def installed(root, name):
    system = set()
    lines = expanded(root, name, system, {name})
    first = (root / name).read_text(encoding="utf-8").splitlines()[0]
    body = re.sub(r"\n{3,}", "\n\n", "\n".join(lines))
    body = body.replace("}  // namespace oplus\n\nnamespace oplus {\n\n", "")
    includes = "\n".join(sorted(system)) + "\n\n" if system else ""
    return f"{first}\n#pragma once\n\n" + includes + body.strip() + "\n"


if __name__ == "__main__":
    root, out = map(Path, sys.argv[1:])
    out.mkdir(parents=True, exist_ok=True)
    for header in sorted((root / PUBLIC).glob("*.hpp")):
        text, written = installed(root, PUBLIC + header.name), out / header.name
        if not written.exists() or written.read_text(encoding="utf-8") != text:
            written.write_text(text, encoding="utf-8")
