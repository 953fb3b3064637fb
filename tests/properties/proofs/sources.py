# SPDX-License-Identifier: GPL-3.0-or-later
"""Coq sources as text: without comments, and words that they must not contain."""

import re

# Print Assumptions reports what a headline theorem rests on; these words are wrong anywhere.
UNPROVED = re.compile(r"\b(Admitted|admit|give_up|Abort|Axioms?|Parameters?|Conjectures?|Declare\s+Module"
                      r"|bypass_check|Unset\s+(Guard|Universe|Positivity)\s+Checking"
                      r"|Primitive)\b")
DEFINED = re.compile(r"^\s*(?:(?:Local|Global|Program|#\[[^\]]*\])\s+)*(?:(?:Co)?Fixpoint|Definition|Theorem|Lemma|Corollary|Proposition"
                     r"|Fact|Remark|Example|Instance|Ltac|(?:Co)?Inductive|Variant|Record|Structure|Class)\s+([\w']+)",
                     re.MULTILINE)
TYPE = re.compile(r"^\s*(?:(?:Co)?Inductive|Variant|Record|Structure|Class)\s(.*?)\.\s", re.MULTILINE | re.DOTALL)
CONSTRUCTOR, FIELD = re.compile(r"(?::=|\|)\s*([\w']+)"), re.compile(r"[{;]\s*([\w']+)\s*:")
MODULE = re.compile(r"^Module\s+(\w+)[^.]*\.\s.*?^End\s+\1\.", re.MULTILINE | re.DOTALL)
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


def module(path, library="Oplus"):
    """The name by which Coq knows a source of the library."""
    return f"{library}." + path.removesuffix(".v").replace("/", ".")


def unproved(name, text):
    """Where a source leaves something unproved."""
    return [f"{name}:{number}: {found.group(0)}"
            for number, line in enumerate(without_comments(text).splitlines(), 1)
            for found in UNPROVED.finditer(line)]


def defined(text):
    """The names that a source gives to what it defines and proves, to constructors and to fields."""
    text = MODULE.sub("", without_comments(text))
    types = TYPE.findall(text)
    return DEFINED.findall(text) + [name for kind in types for name in CONSTRUCTOR.findall(kind) + FIELD.findall(kind)]


def defined_twice(texts):
    """What is wrong with names, given the text of each source: each stands for one thing, and each source has its own."""
    places, files = {}, {}
    for path, text in texts.items():
        files.setdefault(path.rpartition("/")[2], []).append(path)
        for name in defined(text):
            places.setdefault(name, []).append(path)
    return [f"{name}: {' and '.join(found)}" for names in (files, places)
            for name, found in names.items() if len(found) > 1]
