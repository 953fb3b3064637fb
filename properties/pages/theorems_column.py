# SPDX-License-Identifier: GPL-3.0-or-later
"""The column "in Coq" of tables in pages of docs/ that are written by hand: of the statement that a row links to, the
theorems that prove the most of it."""

import re

from records import EXTENTS

HEAD = "| in Coq |"
STATEMENT = re.compile(r"\[([a-z]+-[0-9a-z.-]+)\]\(theorems/\1\.md\)")
# More are on the statement's page.
MOST = 3


def in_coq(statement, backing):
    for extent in EXTENTS:
        proved = [theorem for theorem in backing.theorems if (theorem["statement"], theorem["extent"]) == (statement, extent)]
        if proved:
            links = [f"[`{theorem['theorem']}`](../properties/proofs/{theorem['file']})" for theorem in proved[:MOST]]
            more = [f"{len(proved) - MOST} more"] if len(proved) > MOST else []
            return f"{extent}: {', '.join(links + more)}"
    return f"no; {backing.in_words(statement)}"


def with_theorems(page, backing):
    """The page with this column of its tables as it must be."""
    lines, in_table = page.split("\n"), False
    for i, line in enumerate(lines):
        in_table = line.startswith("|") and (in_table or line.endswith(HEAD))
        statement = STATEMENT.search(line)
        if in_table and statement:
            lines[i] = f"{line[:line.rindex(' | ')]} | {in_coq(statement[1], backing)} |"
    return "\n".join(lines)


def pages_with_theorems(docs, backing):
    """The pages that have such a table, by their paths from docs/."""
    texts = {path.name: path.read_text(encoding="utf-8") for path in sorted(docs.glob("*.md"))}
    return {name: with_theorems(text, backing) for name, text in texts.items() if f" {HEAD}\n" in text}
