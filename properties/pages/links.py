# SPDX-License-Identifier: GPL-3.0-or-later
"""Headings of pages, and links between pages."""

import re

FINDINGS = re.compile(r"docs/findings\.md(?:, on ([A-Z][a-z]+ [0-9](?:\.?[0-9])*))?")
LINK = re.compile(r"\]\(theorems/([^)#]+)\.md[)#]")
GENERATED = ("theorems", "mutants")


def anchor_of(heading):
    """The anchor that GitHub gives a heading: "Section 4.2.4: a `b`" has "section-424-a-b"."""
    kept = re.sub(r"[^ _\-0-9A-Za-z\u0080-\U0010ffff]", "", heading)
    return re.sub("[A-Z]", lambda letter: letter[0].lower(), kept).replace(" ", "-")


def headings_of(page):
    """The headings of a page, without those inside code."""
    headings, in_code = [], False
    for line in page.splitlines():
        in_code ^= line.startswith("```")
        if not in_code and (heading := re.match("#+ (.*)", line)):
            headings.append(heading[1])
    return headings


def citing_pages(docs):
    """The names of the pages of docs/ that link to a statement's page: by statement, sorted. Generated pages
    are left out."""
    citing = {}
    for page in sorted(docs.glob("*.md")):
        if page.stem not in GENERATED:
            for statement in sorted(set(LINK.findall(page.read_text(encoding="utf-8")))):
                citing.setdefault(statement, []).append(page.stem)
    return citing


def heading_with(name, headings):
    """The first heading that contains the name, not followed by another digit; or None."""
    return next((h for h in headings if re.search(re.escape(name) + r"(?![0-9])", h)), None)


def missing_findings(text, headings):
    """What a text names after "docs/findings.md, on " that is in no heading of that page."""
    return [name for name in FINDINGS.findall(text) if name and not heading_with(name, headings)]


def with_links_to_findings(text, headings):
    """The text for a statement's page: "docs/findings.md, on Theorem 2.3.2" becomes a link to the first of the
    headings of that page that names Theorem 2.3.2, "docs/findings.md" one to the page."""
    def link(mention):
        anchor = "#" + anchor_of(heading_with(mention[1], headings)) if mention[1] else ""
        return f"[{mention[0]}](../findings.md{anchor})"
    return FINDINGS.sub(link, text)
