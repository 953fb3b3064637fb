# SPDX-License-Identifier: GPL-3.0-or-later
"""Coq sources as text: without comments, and words that they must not contain."""

import re

# Print Assumptions reports what a headline theorem rests on; these words are wrong anywhere.
UNPROVED = re.compile(r"\b(Admitted|admit|give_up|Abort|Axioms?|Parameters?|Conjectures?|Declare\s+Module"
                      r"|bypass_check|Unset\s+(Guard|Universe|Positivity)\s+Checking"
                      r"|Primitive)\b")
TOKEN = re.compile(r'\(\*|\*\)|"(?:[^"]|"")*"|.', re.DOTALL)


def without_comments(text):
    """The source, each comment replaced by blanks and line ends, so that line numbers stay."""
    depth, kept = 0, []
    for token in TOKEN.findall(text):
        if token == "(*":
            depth += 1
        said = token if depth == 0 else "".join("\n" if c == "\n" else " " for c in token)
        if token == "*)":
            depth -= 1
        kept.append(said)
    return "".join(kept)


def unproved(name, text):
    """Where a source leaves something unproved."""
    return [f"{name}:{number}: {found.group(0)}"
            for number, line in enumerate(without_comments(text).splitlines(), 1)
            for found in UNPROVED.finditer(line)]
