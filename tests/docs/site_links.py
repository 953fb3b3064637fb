#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""site_links.py SITE: follows the links of what docs/site/make wrote: each leads to a file and an anchor that exist, and
from a node of the graph of statements one comes to its page, its theorem in Coq, its property, its mutants, and back."""

import os
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urldefrag, urlparse


class Page(HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.links, self.anchors, self.title, self.lines = [], set(), "", {}
        self.text, self._in_title, self._line = text, False, None
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.anchors.update(attributes[key] for key in ("id", "name") if attributes.get(key))
        self.links += [attributes[key] for key in ("href", "src", "xlink:href") if attributes.get(key)]
        self._in_title = tag == "title" and not self.title
        if attributes.get("class") == "line":
            self._line = attributes.get("id")

    def handle_endtag(self, tag):
        self._in_title = False

    def handle_data(self, data):
        if self._in_title:
            self.title += data
        if self._line:
            self.lines[self._line] = self.lines.get(self._line, "") + data


def read(site):
    return {path.relative_to(site).as_posix(): Page(path.read_text(encoding="utf-8"))
            for path in sorted(site.rglob("*.html"))
            if not path.relative_to(site).parts[0] in ("_static", "draw")}


def target(page, link):
    """The file a link of a page leads to, from the root of the site, and its anchor."""
    path, anchor = urldefrag(link)
    path = path.partition("?")[0]
    return (os.path.normpath(os.path.join(os.path.dirname(page), unquote(path))) if path else page), unquote(anchor)


def wrong_links(site, pages):
    for name, page in pages.items():
        if not page.title.strip():
            yield f"{name}: has no title"
        for link in page.links:
            parts = urlparse(link)
            if parts.scheme:
                if parts.scheme not in ("data", "mailto") and not (parts.scheme in ("http", "https") and parts.netloc):
                    yield f"{name}: {link} is not well-formed"
                continue
            file, anchor = target(name, link)
            if not (site / file).exists():
                yield f"{name}: {link} leads to no file"
            elif anchor and file in pages and anchor not in pages[file].anchors:
                yield f"{name}: {link} leads to no anchor"


# From a page to one that must be linked from it; an anchor is a line of a source, which contains what follows.
LEMMA, GRAPH = "theorems/lemma-4.1.4.html", "theorems/graph.html"
PROOF, PROPERTY = ("source/properties/proofs/cycles/in_out_degree.v.html",
                   "source/properties/statements/chapter4/section_4_1_convolution_graph.cpp.html")
CODE = "source/reference/definitions/cyclic_order.hpp.html"
WALK = ((GRAPH, LEMMA, "", ""), (LEMMA, PROOF, "in_out_degree", "Theorem in_out_degree "), (PROOF, LEMMA, "", ""),
        (LEMMA, PROPERTY, "", ""), (PROPERTY, LEMMA, "", ""),
        (LEMMA, CODE, "reflex-turns-clockwise", 'OPLUS_MUTANT("reflex-turns-clockwise"'), (CODE, LEMMA, "", ""),
        (LEMMA, GRAPH, "lemma-4.1.4", ""), ("index.html", GRAPH, "", ""), ("mutants.html", LEMMA, "", ""),
        ("index.html", "reference/cpp.html", "", ""), ("index.html", "reference/python.html", "", ""),
        ("index.html", "reference/command_line.html", "", ""))
WORDS = (("reference/cpp.html", 'id="_CPPv4N5oplus11ValidRegionE"'), ("reference/python.html", 'id="oplus.minkowski_sum"'),
         ("reference/command_line.html", "--certificate"), ("searchindex.js", "dangl"), ("searchindex.js", "lemma-4.1.4"),
         ("index.html", "--color-background-primary: #"), (GRAPH, 'id="lemma-4.1.4"'), (GRAPH, "<svg"))


def missing_steps(site, pages):
    for start, end, anchor, line in WALK:
        if start not in pages or (end, anchor) not in {target(start, link) for link in pages[start].links}:
            yield f"{start} has no link to {end}{'#' if anchor else ''}{anchor}"
        elif line and line not in pages[end].lines.get(anchor, ""):
            yield f"{end}#{anchor} is not the line of {line}"
    for file, words in WORDS:
        if words not in (site / file).read_text(encoding="utf-8"):
            yield f"{file} does not contain {words}"


if __name__ == "__main__":
    site = Path(sys.argv[1])
    pages = read(site)
    links = sum(len(page.links) for page in pages.values())
    wrong = [*wrong_links(site, pages), *missing_steps(site, pages)]
    for one in wrong:
        print(one)
    print(f"pages: {len(pages)}, links: {links}, {len(wrong)} wrong")
    sys.exit(1 if wrong or len(pages) < 200 else 0)
