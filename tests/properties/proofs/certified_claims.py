#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests what oplus-certified answers about no-fits, inner fits and layouts: it certifies what oplus computes, and refuses
results that are damaged, layouts that are wrong, and certificates of another kind.
Usage: certified_claims.py PROGRAM OPLUS"""

import re
import sys
import tempfile
from pathlib import Path

from extracted_program import INVALID, ProgramTest, run, square

CERTIFIED, NOT_CERTIFIED = 0, 1

ROOM = f"POLYGON({square(0, 0, 6)},(1 1,1 3,3 3,3 1,1 1))"
L_SHAPE = "POLYGON((0 0,2 0,2 1,1 1,1 2,0 2,0 0))"
# A and B: placements with chains, with edges and points, of components, and none.
PAIRS = [
    (ROOM, f"POLYGON({square(0, 0, 2)})"),
    (ROOM, "POLYGON((0 0,3 0,0 3,0 0))"),
    (L_SHAPE, f"POLYGON({square(-0.5, 0, 1)})"),
    ("POLYGON((0 0,8 0,8 3,5 3,5 2,3 2,3 3,0 3,0 0))", f"POLYGON({square(0, 0, 2)})"),
    (f"MULTIPOLYGON(({square(0, 0, 2)}),({square(3, 0, 3)}))", f"POLYGON({square(1, 1, 2)})"),
    (L_SHAPE, ROOM),
]
# What is wrong in all results of a kind.
MORE = {"nfp": ["LINESTRING(0 0,1/7 5)", "POINT(1/7 3/11)", f"POLYGON({square(100, 100, 1)})"],
        "ifp": ["LINESTRING(0 0,1/7 5)", "POINT(2 1/7)", f"POLYGON({square(100, 100, 1)})"]}


def items_of(result):
    """A set's region, edges and points."""
    inside = re.fullmatch(r"GEOMETRYCOLLECTION \((.*)\)", result.strip())
    items = re.findall(r"[A-Z]+ \(.*?\)(?=, [A-Z]|$)", inside.group(1)) if inside else [result.strip()]
    return [item for item in items if item != "POLYGON EMPTY"]


def collection(items):
    return f"GEOMETRYCOLLECTION ({', '.join(items)})" if items else "POLYGON EMPTY"


def damaged(result, kind):
    """The set without an item, with one more, and with a coordinate of chains changed."""
    items = items_of(result)
    for i in range(len(items)):
        yield collection(items[:i] + items[i + 1:])
    for more in MORE[kind]:
        yield collection(items + [more])
    chains = result.split(", LINESTRING")[0] if "POLYGON" in result else ""
    for number in list(re.finditer(r"-?[\d./]+", chains))[2:]:
        # The first vertex of a ring is its last one, too, so that rings stay closed if others change.
        yield result[:number.start()] + number.group() + "7" + result[number.end():]


# Parts of a layout; which two overlap, or which one is not in the container.
CONTAINER = f"POLYGON({square(0, 0, 9)},(4 4,4 5,5 5,5 4,4 4))"
LAYOUTS = [
    ([L_SHAPE, f"POLYGON({square(1, 1, 3)})", f"MULTIPOLYGON(({square(5, 5, 4)}),({square(5, 0, 4)}))"], None),
    ([f"POLYGON({square(0, 0, 5)},(1 1,1 3,3 3,3 1,1 1))", f"POLYGON({square(1, 1, 2)})"], "part 0 is not"),
    ([f"POLYGON({square(0, 0, 2)})", f"POLYGON({square(5, 0, 2)})", "POLYGON((3/2 0,3 0,3 3,3/2 0))"], "part 0 and part 2"),
    ([f"POLYGON({square(7, 0, 3)})"], "part 0 is not"),
    ([f"POLYGON({square(0, 0, 1)})", f"POLYGON({square(-9, 0, 1)})"], "part 1 is not"),
]


class Test(ProgramTest):
    def file(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")
        return self.folder / name

    def placements(self, oplus, kind):
        for number, (a, b) in enumerate(PAIRS):
            files = [self.file("a", a), self.file("b", b)]
            result, made = self.folder / "result.wkt", self.folder / "made"
            run([oplus, kind, *files, "-o", result, "--certificate", made, "--quiet"])
            code, said = run([self.program, kind, *files, result, made])
            self.expect(f"{kind} certified", number, code == CERTIFIED and said.count("\n") == 1, f"exit code {code}: {said}")
            for wrong in damaged(result.read_text(encoding="utf-8"), kind):
                code, said = run([self.program, kind, *files, self.file("wrong", wrong), made])
                self.expect(f"damaged {kind}", f"{number}, {wrong}", code in (NOT_CERTIFIED, INVALID), said)
            code, said = run([self.program, kind, files[1], files[0], result, made])
            self.expect(f"{kind} of exchanged", number, code in (NOT_CERTIFIED, INVALID), said)
            for other in ("sum", "open-sum", "nfp", "ifp"):
                if other != kind and "COLLECTION" not in result.read_text(encoding="utf-8"):
                    self.one_line("another kind", f"{kind} as {other}", run([self.program, other, *files, result, made]),
                                  f"a certificate of the kind '{kind}'; expected '{other}'")

    def layouts(self, oplus):
        container, empty = self.file("container.wkt", CONTAINER), self.file("empty.wkt", "POLYGON EMPTY")
        given = self.file("given.wkt", "\n".join(LAYOUTS[0][0]))
        right = [self.folder / "right.wkt", self.folder / "made"]
        run([oplus, "layout", given, "--format", "wkt", "-o", right[0]])
        for inside in (container, empty):
            own = ["--container", inside] if inside == container else []
            run([oplus, "layout", given, *own, "--certificate", right[1]])
            code, said = run([self.program, "layout", inside, *right])
            self.expect("layouts certified", inside.name, code == CERTIFIED and "no two of 4 parts" in said, f"{code}: {said}")
            self.expect("layouts certified", inside.name, ("in the container" in said) == (inside == container), said)
        self.one_line("another kind", "layout", run([self.program, *[container] * 3, right[1]]), "expected 'sum'")
        for parts, wrong in LAYOUTS[1:]:
            # Certificates of the parts where they do not overlap, far apart and in a large container.
            pieces = self.layout_certificate(parts)
            code, said = run([self.program, "layout", container, self.file("wrong", "\n".join(parts)), pieces])
            self.expect("wrong layouts", wrong, code == NOT_CERTIFIED and wrong in said, f"exit code {code}: {said}")

    def layout_certificate(self, parts):
        """By hand: the container is a square with a square hole, the parts are convex but for a frame."""
        k = 2 * max(9, *(abs(float(n)) for n in re.findall(r"-?\d+(?=[ ,)])", " ".join(parts))))
        ring = "4\n0 1 7 4\n1 2 6 7\n2 3 5 6\n3 0 4 5\n"
        text = f"oplus certificate 2\nclaim layout\nunit 1\ncontainer\npoints 0\npieces 5\n{ring[2:]}8 9 10 11\n"
        for number, part in enumerate(parts):
            corners = len(re.search(r"\(\((.*?)\)", part).group(1).split(",")) - 1
            pieces = ring if part.count("(") > 2 else f"1\n{' '.join(map(str, range(corners)))}\n"
            text += f"part {number}\npoints 0\npieces {pieces}"
        return self.file(f"certificate.{k}", text + "end\n")

    def sets(self):
        for text, wanted in (("GEOMETRYCOLLECTION(LINESTRING(0 0))", "a line string of less than 2 vertices"),
                             ("GEOMETRYCOLLECTION(CIRCLE(0 0))", "'CIRCLE'; expected (MULTI)POLYGON"),
                             ("GEOMETRYCOLLECTION(POINT(0 0)", "the end of the text; expected ',' or ')'"),
                             ("GEOMETRYCOLLECTION(POINT(0 0)) 1", "'1'; expected the end of the text"),
                             ("GEOMETRYCOLLECTION(POINT(0 0),)", "')'; expected (MULTI)POLYGON"),
                             ("POINTS(0 0)", "'POINTS'; expected a (MULTI)POLYGON")):
            files = [self.file("a", ROOM), self.file("b", L_SHAPE), self.file("s", text), self.file("c", "")]
            self.one_line("no sets", text, run([self.program, "nfp", *files]), wanted)


def main():
    program, oplus = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as directory:
        test = Test(program, Path(directory))
        for kind in ("nfp", "ifp"):
            test.placements(oplus, kind)
        test.layouts(oplus)
        test.sets()
    sys.exit(test.summary())


if __name__ == "__main__":
    main()
