# SPDX-License-Identifier: GPL-3.0-or-later
"""The include lines of a source, read as text."""

import posixpath
import re
from typing import NamedTuple, Optional

LINE = re.compile(r"^[ \t]*#[ \t]*include\b[ \t]*(.*?)[ \t]*$", re.MULTILINE)
NAMED = re.compile(r'^(?:"([^"]+)"|<([^>]+)>)')


class Include(NamedTuple):
    line: int
    path: Optional[str]  # normalised; None where a macro computes it
    quoted: bool


def includes(source):
    text = source.read_text(encoding="utf-8")
    for match in LINE.finditer(text):
        named = NAMED.match(match.group(1))
        path = posixpath.normpath(named.group(1) or named.group(2)) if named else None
        line = text.count("\n", 0, match.start()) + 1
        yield Include(line, path, bool(named and named.group(1)))
