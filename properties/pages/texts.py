# SPDX-License-Identifier: GPL-3.0-or-later
"""The texts of the statements, from the files statements.md below properties/statements/."""

import re
from dataclasses import dataclass


@dataclass
class Text:
    id: str
    title: str
    says: str = ""
    thesis: str = ""
    differs: str = ""
    why: str = ""
    hypotheses: tuple = ()
    rests_on: tuple = ()


def text_of(section):
    """Of "# ID: TITLE" and what follows, in paragraphs: what it says, "Thesis: ..." where the thesis says it
    otherwise, "Differs: ..." which says how and why, "Why: ...", "Hypotheses:" as a list, and "Rests on: ID, ..."."""
    heading, *paragraphs = re.split(r"\n\n+", section.strip())
    id, _, title = heading.partition(": ")
    text = Text(id, title)
    for paragraph in paragraphs:
        name, _, words = paragraph.partition(":")
        one_line = re.sub(r"\s*\n\s*", " ", words).strip()
        if name in ("Thesis", "Differs", "Why"):
            setattr(text, name.lower(), one_line)
        elif name == "Hypotheses":
            text.hypotheses = tuple(re.sub(r"\s*\n\s*", " ", item) for item in re.split(r"\n- ", words)[1:])
        elif name == "Rests on":
            text.rests_on = tuple(one_line.split(", "))
        else:
            text.says = re.sub(r"\s*\n\s*", " ", paragraph)
    return text


def texts(root):
    """All of them, file by file."""
    return [text_of(section) for file in sorted((root / "properties/statements").glob("*/statements.md"))
            for section in re.split(r"^# ", file.read_text(encoding="utf-8"), flags=re.M)[1:]]
