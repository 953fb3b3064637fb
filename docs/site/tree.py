# SPDX-License-Identifier: GPL-3.0-or-later
"""What the site does beyond Sphinx, so that the pages of docs/ need not change: links to any file of the tree lead
to a page with that file, a page's table of contents is the pages of its folder that it links to, and drawings that
contain links can be clicked on."""

import html
import os
import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from docutils import nodes
from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.lexers import get_lexer_by_name, get_lexer_for_filename
from pygments.util import ClassNotFound
from sphinx import addnodes
from sphinx.transforms import SphinxTransform
from sphinx.util import logging
from sphinx.util.nodes import make_refnode

ROOT = Path(os.environ["OPLUS_ROOT"]).resolve()
SVG = "http://www.w3.org/2000/svg"
HREF = "{http://www.w3.org/1999/xlink}href"
TITLE = "{http://www.w3.org/1999/xlink}title"
logger = logging.getLogger(__name__)


def page_of_file(name):
    """The page that shows a file or folder of the tree."""
    return f"source/{name}/index" if (ROOT / name).is_dir() else f"source/{name}"


def line_that_defines(name, text):
    """The number of the line on which a theorem of Coq, a mutant or an SMT query of this name begins, or None."""
    name = re.escape(name)
    found = re.search(rf'^(?:Theorem|Lemma|Corollary) {name}\b|OPLUS_MUTANT\(\s*"{name}"|\.id = "{name}"', text, re.M)
    return text.count("\n", 0, found.start()) + 1 if found else None


class TreeLinks(SphinxTransform):
    """Links and pictures, from where the page is in the tree to where things are on the site."""

    default_priority = 100

    def apply(self):
        written = Path(self.env.doc2path(self.env.docname))
        # What make wrote itself has links from the root.
        self.folder = written.resolve().parent if written.resolve().is_relative_to(ROOT) else ROOT
        self.srcdir = Path(self.env.srcdir)
        for link in [*self.document.findall(addnodes.pending_xref), *self.document.findall(addnodes.download_reference)]:
            if link["reftype"] == "myst" and not link["reftarget"].startswith("#"):
                self.lead(link)
        for image in list(self.document.findall(nodes.image)):
            if "://" not in image["uri"]:
                self.show(image)

    def file(self, path):
        return (self.folder / path).resolve()

    def docname(self, file):
        if file == ROOT / "README.md":
            return "start"
        place = file.relative_to(ROOT / "docs") if file.is_relative_to(ROOT / "docs") else None
        return str(place.with_suffix("")) if place and place.suffix == ".md" else None

    def lead(self, link):
        path, _, anchor = link["reftarget"].partition("#")
        file = self.file(path)
        docname = self.docname(file)
        if not file.exists() or not file.is_relative_to(ROOT):
            logger.warning("no such file: %s", link["reftarget"], location=link)
        elif docname:
            link["reftarget"] = os.path.relpath(docname + ".md", os.path.dirname(self.env.docname))
            link["reftarget"] += "#" + anchor if anchor else ""
            # On the graph, the node from which one comes stands out.
            if self.env.docname.startswith("theorems/") and docname == "theorems/graph":
                self.refer(link, docname, os.path.basename(self.env.docname))
        else:
            name = file.relative_to(ROOT).as_posix()
            shown = self.env.oplus_files.setdefault(name, (set(), {}))
            shown[0].add(self.env.docname)
            self.refer(link, page_of_file(name), self.anchor_in_file(link, file, shown[1]))

    def anchor_in_file(self, link, file, anchors):
        """What the sentence or the row of the table is about, if the file defines it."""
        around = link
        while not isinstance(around, (nodes.row, nodes.paragraph, nodes.document)) or (
                isinstance(around.parent, nodes.entry)):
            around = around.parent
        if file.is_file():
            text = file.read_text(encoding="utf-8")
            for literal in around.findall(nodes.literal):
                line = line_that_defines(literal.astext(), text)
                if line:
                    anchors[line] = literal.astext()
                    return literal.astext()
        return None

    def refer(self, link, page, anchor=None):
        uri = self.app.builder.get_relative_uri(self.env.docname, page) + (f"#{anchor}" if anchor else "")
        link.replace_self(nodes.reference("", "", *link.children, refuri=uri, internal=True))

    def show(self, image):
        file = self.file(image["uri"])
        image["uri"] = "/" + file.relative_to(ROOT / "docs").as_posix()
        if file.suffix != ".svg" or not file.is_file():
            return
        drawing = ElementTree.parse(file).getroot()
        if drawing.find(f".//*[@{HREF}]") is not None and drawing.find(f".//{{{SVG}}}a") is not None:
            image.replace_self(nodes.raw("", self.clickable(drawing, file.parent), format="html"))
        else:
            # Sphinx makes a picture with a width a link to the picture alone, in which more can be seen.
            image["width"] = f"{float(drawing.get('viewBox').split()[2]):.0f}px"

    def clickable(self, drawing, folder):
        """The drawing as part of the page. Its nodes are named after the pages they lead to."""
        width, height = drawing.get("viewBox").split()[2:]
        drawing.set("width", width)
        drawing.set("height", height)
        for node in drawing.iter(f"{{{SVG}}}g"):
            link = node.find(f".//{{{SVG}}}a[@{HREF}]")
            if node.get("class") != "node" or link is None:
                continue
            docname = self.docname((folder / link.attrib.pop(HREF)).resolve())
            if docname not in self.env.found_docs:
                logger.warning("a drawing links to no page: %s", docname, location=self.env.docname)
                continue
            link.set("href", self.app.builder.get_relative_uri(self.env.docname, docname))
            node.set("id", os.path.basename(docname))
            node.find(f"{{{SVG}}}title").text = link.attrib.pop(TITLE)
        ElementTree.register_namespace("", SVG)
        return f'<div class="drawing">{ElementTree.tostring(drawing, encoding="unicode")}</div>'


def add_contents(app, docname, source):
    """Below theorems.md are the pages of theorems/ that it links to, in that order; below an index.md, those beside it."""
    if docname == "index":
        return
    folder = re.escape(docname + "/") if not docname.endswith("/index") else "(?![./])"
    links = dict.fromkeys(re.findall(rf"\]\(({folder}[^)#]+)\.md[)#]", source[0]))
    if links:
        source[0] += "\n```{toctree}\n:hidden:\n\n" + "\n".join(links) + "\n```\n"


def lexer_of(file, text):
    if file.suffix == ".v":
        return get_lexer_by_name("coq")  # not Verilog
    if text.startswith("#!"):
        return get_lexer_by_name("python" if "python" in text.split("\n", 1)[0] else "bash")
    try:
        return get_lexer_for_filename(file.name)
    except ClassNotFound:
        return get_lexer_by_name("text")


def listing(file, anchors):
    text = file.read_text(encoding="utf-8")
    lines = highlight(text, lexer_of(file, text), HtmlFormatter(nowrap=True, stripnl=False)).split("\n")
    numbered = [f'<span class="line" id="{html.escape(anchors.get(number, f"L{number}"))}">{line}</span>'
                for number, line in enumerate(lines[:-1], 1)]
    return '<div class="highlight listing"><pre>' + "\n".join(numbered) + "</pre></div>"


def file_pages(app):
    """A page for each file or folder that a page links to, and for the files of these folders."""
    files = dict(app.env.oplus_files)
    for folder in [name for name in files if (ROOT / name).is_dir()]:
        for file in (ROOT / folder).iterdir():
            if file.is_file():
                files.setdefault(file.relative_to(ROOT).as_posix(), (set(), {}))
    for name, (docnames, anchors) in sorted(files.items()):
        page, path = page_of_file(name), ROOT / name
        link = lambda to, text: f'<a href="{app.builder.get_relative_uri(page, to)}">{html.escape(text)}</a>'
        if path.is_dir():
            shown = "".join(f"<li>{link(page_of_file(inner), Path(inner).name)}</li>"
                            for inner in sorted(files) if Path(inner).parent == Path(name))
            shown = f"<ul>{shown}</ul>"
        else:
            shown = listing(path, anchors)
        citing = ", ".join(link(docname, app.env.titles[docname].astext()) for docname in sorted(docnames))
        body = f"<h1>{html.escape(name)}</h1>" + (f"<p>Linked from: {citing}.</p>" if citing else "") + shown
        yield page, {"title": name, "body": body, "parents": []}, "page.html"


def share_navigation(app, page, template, context, doctree):
    """The navigation beside all files of one depth is the same, and to compute it took most of the time."""
    if page.startswith("source/"):
        toctree, depth = context["toctree"], page.count("/")
        context["toctree"] = lambda **options: (
            app.env.oplus_navigation.get(depth) or app.env.oplus_navigation.setdefault(depth, toctree(**options)))


def to_restructured_text(app, what, name, obj, options, lines):
    """Docstrings are plain text with sessions; what would be markup there is none."""
    in_session = False
    for number, line in enumerate(lines):
        in_session = bool(line) and (in_session or line.startswith(">>>"))
        if not in_session:
            lines[number] = re.sub(r"(`[^`]+`)|([\\*_|])", lambda m: f"`{m[1]}`" if m[1] else "\\" + m[2], line)


def lead_to_class(app, env, node, content):
    """Doxygen refers to a friend, which Breathe does not show, as to a member of its class."""
    member = re.fullmatch(r"(.*)_1a[0-9a-f]{32}", node["reftarget"])
    docname, label = env.get_domain("std").anonlabels.get(member[1], ("", "")) if member else ("", "")
    return make_refnode(app.builder, node["refdoc"], docname, label, content) if docname else None


def is_no_duplicate(record):
    """Breathe leaves constraints out, so that constructors which differ in nothing else look alike."""
    return "Duplicate C++ declaration" not in str(record.msg) or "Coordinates (const T &p)" not in record.getMessage()


def start(app):
    app.env.oplus_files = {}  # by name: the pages that link to it, and the names of lines
    app.env.oplus_navigation = {}  # by depth


def setup(app):
    logging.getLogger("sphinx.domains.cpp").logger.addFilter(is_no_duplicate)
    app.add_transform(TreeLinks)
    app.connect("builder-inited", start)
    app.connect("html-page-context", share_navigation, priority=400)  # before the theme asks for it
    app.connect("missing-reference", lead_to_class)
    app.connect("source-read", add_contents)
    app.connect("html-collect-pages", file_pages)
    app.connect("autodoc-process-docstring", to_restructured_text)
    return {"parallel_read_safe": False, "parallel_write_safe": False}
