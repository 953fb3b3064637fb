#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests oplus-certified: that it certifies sums, refuses wrong ones and damaged certificates, and answers as the
checker does that is extracted from Coq without any replacement.
Usage: certified.py PROGRAM BUILD OPLUS, the folder in which it was built and the program that makes certificates"""

import re
import sys
import tempfile
from pathlib import Path

from extracted_program import INVALID, INVALID_REGIONS, NUMBERS, ProgramTest, beside_plain, dat, run, square

CERTIFIED, NOT_CERTIFIED = 0, 1


def convex(*vertices):
    """The part of a certificate about a region that is one convex piece."""
    return f"points 0\npieces 1\n{' '.join(map(str, vertices or range(4)))}\n"


def certificate(p, q, s, unit=1, kind="sum"):
    return f"oplus certificate 2\nclaim {kind}\nunit {unit}\nsummand p\n{p}summand q\n{q}sum\n{s}end\n"


def open_certificate(p, q, s, seams="seams 0\n"):
    return certificate(p, q, s + seams, kind="open-sum")


def kind_of(text):
    return "open-sum" if "claim open-sum\n" in text else "sum"


ONE = convex() + "links 0\n"
UNIT = f"POLYGON({square(0, 0, 1)})"
L_SHAPE = "POLYGON((0 0,2 0,2 1,1 1,1 2,0 2,0 0))"
AROUND = f"POLYGON({square(0, 0, 4)},(1 1,1 3,3 3,3 1,1 1))"
RING = "points 0\npieces 4\n0 1 7 4\n1 2 6 7\n2 3 5 6\n3 0 4 5\n"
RING_SUM = "points 0\npieces 4\n0 1 7 4\nin 0 0\n1 2 6 7\nin 1 0\n2 3 5 6\nin 2 0\n3 0 4 5\nin 3 0\n"
TWO = f"MULTIPOLYGON(({square(0, 0, 1)}),({square(9, 0, 1)}))"
TWO_PIECES = "points 0\npieces 2\n0 1 2 3\n4 5 6 7\n"
NOTHING = "points 0\npieces 0\n"

# Open sums: two bars with an edge between them, over all of the sum or over half of it; a hole that Q just fits.
BARS = "MULTIPOLYGON(((0 0,1 0,1 2,0 2,0 0)),((2 0,3 0,3 2,2 2,2 0)))"
BETWEEN = "GEOMETRYCOLLECTION (POLYGON ((0 0, 4 0, 4 3, 0 3, 0 0)), LINESTRING (2 0, 2 3))"
U_SHAPE = "POLYGON((0 0,3 0,3 3,2 3,2 1,1 1,1 3,0 3,0 0))"
U_PIECES = "points 2\n1 3 1\n7 0 1\npieces 3\n0 1 8 4 5 9\n8 2 3 4\n9 5 6 7\nlinks 2\n0 1\n0 2\n"
U_SUM = convex() + "cut 1 0 -2 on 0 at 2 on 0 in 0 0\ncut 0 1 -1\nin 1 0\nin 0 0\ncut 0 1 -2 in 2 0\nin 2 0\nin 0 0\n"
HOLE_SUM = convex() + ("cut 1 -1 0 in 1 0 point 0 in 0 0\ncut 1 1 -6\nin 1 0\nin 0 0\n"
                       "cut 1 1 -6 in 3 0 at 2 in 3 0\nin 2 0\nin 3 0\n")
RING_LINKS = RING + "links 3\n0 1\n1 2\n2 3\n"


def u_sum(*others):
    return f"GEOMETRYCOLLECTION ({', '.join([f'POLYGON ({square(0, 0, 4)})', *others])})"


# Names, P, Q, S and certificates.
EXAMPLES = {
    "squares": (UNIT, f"POLYGON({square(0, 0, 2)})", f"POLYGON({square(0, 0, 3)})",
                certificate(ONE, ONE, convex() + "in 0 0\n")),
    "cut": (L_SHAPE, f"POLYGON((0 0,1/2 0,1/2 0.5,0 5e-1,0 0))",
            "POLYGON((0 0,2.5 0,5/2 3/2,3/2 3/2,3/2 5/2,0 5/2,0 0))",
            certificate("points 0\npieces 2\n0 1 2 3\n0 3 4 5\nlinks 1\n0 1\n", ONE,
                        "points 0\npieces 2\n0 1 2 3\ncut 1 0 -1\nin 0 0\nin 0 0\n0 3 4 5\nin 1 0\n", 2)),
    "points": (L_SHAPE, UNIT, "POLYGON((0 0,3 0,3 2,2 2,2 3,0 3,0 0))",
               certificate("points 1\n5 0 1\npieces 2\n0 1 2 3 6\n6 3 4 5\nlinks 1\n0 1\n", ONE,
                           "points 1\n5 0 2\npieces 2\n0 1 2 3 6\nin 0 0\n6 3 4 5\nin 1 0\n")),
    "hole": (AROUND, UNIT, f"POLYGON({square(0, 0, 5)},(2 2,2 3,3 3,3 2,2 2))",
             certificate(RING + "links 3\n0 1\n1 2\n2 3\n", ONE, RING_SUM)),
    "components": (TWO, UNIT, f"MULTIPOLYGON(({square(0, 0, 2)}),({square(9, 0, 2)}))",
                   certificate(TWO_PIECES + "links 0\n", ONE,
                               "points 0\npieces 2\n0 1 2 3\nin 0 0\n4 5 6 7\nin 1 0\n")),
    "empty": ("POLYGON EMPTY", UNIT, "multipolygon empty",
              certificate(NOTHING + "links 0\n", ONE, NOTHING)),
    "turned": ("POLYGON ((0 0, 0 1, 1 1, 1 0, 0 0))", UNIT, " polygon\r\n((0 0,0 2,2 2,2 0,0 0)) ",
               certificate(ONE, ONE, convex() + "in 0 0\n")),
    "open": (UNIT, UNIT, f"POLYGON({square(0, 0, 2)})", open_certificate(ONE, ONE, convex() + "in 0 0\n")),
    "edge": (BARS, UNIT, BETWEEN,
             open_certificate(TWO_PIECES + "links 0\n", ONE, convex() + "cut 1 0 -2 on 0\nin 1 0\nin 0 0\n")),
    "diagonal": (BARS, UNIT, BETWEEN,
                 open_certificate(TWO_PIECES + "links 0\n", ONE,
                                  "points 2\n0 2 0\n2 2 3\npieces 2\n0 4 5 3\nin 0 0\n4 1 2 5\nin 1 0\n",
                                  "seams 1\n4 5 on 0\n")),
    "half an edge": (U_SHAPE, UNIT, u_sum("LINESTRING (2 2, 2 4)"), open_certificate(U_PIECES, ONE, U_SUM)),
    "isolated": (AROUND, f"POLYGON({square(0, 0, 2)})",
                 f"GEOMETRYCOLLECTION (POLYGON ({square(0, 0, 6)}), POINT (3 3))",
                 open_certificate(RING_LINKS, ONE, HOLE_SUM)),
}

# Wrong sums, with certificates that are made for them, and what is said of them.
WRONG_SUMS = {
    "a component lost": (TWO, UNIT, f"POLYGON({square(0, 0, 2)})",
                         certificate(TWO_PIECES + "links 0\n", ONE, convex() + "in 0 0\n"), "is not in S"),
    "a component added": (UNIT, UNIT, f"MULTIPOLYGON(({square(0, 0, 2)}),({square(9, 0, 2)}))",
                          certificate(ONE, ONE, "points 0\npieces 2\n0 1 2 3\nin 0 0\n4 5 6 7\nin 0 0\n"),
                          "piece 1 of S, (9, 0) (11, 0) (11, 2) (9, 2),"),
    "a hole added": (f"POLYGON({square(0, 0, 4)})", UNIT, f"POLYGON({square(0, 0, 5)},(2 2,2 3,3 3,3 2,2 2))",
                     certificate(ONE, ONE, re.sub("in [123] 0", "in 0 0", RING_SUM)),
                     "edge 4 of S, from (2, 2) to (2, 3),"),
    "a hole filled": (AROUND, UNIT, f"POLYGON({square(0, 0, 5)})",
                      certificate(RING + "links 3\n0 1\n1 2\n2 3\n", ONE,
                                  convex() + "cut 1 0 -2\nin 1 0\nin 3 0\n"), "piece 0 of S"),
    "too small": (UNIT, UNIT, f"POLYGON({square(0, 0, 1.5)})",
                  certificate(ONE, ONE, convex() + "in 0 0\n"), "edge 1 of S, from (3/2, 0) to (3/2, 3/2),"),
    "too large": (UNIT, UNIT, f"POLYGON({square(0, 0, 3)})",
                  certificate(ONE, ONE, convex() + "in 0 0\n"), "piece 0 of S"),
    "a vertex moved by 1/1000000": (UNIT, UNIT, "POLYGON((0 0,2 0,2.000001 2,0 2,0 0))",
                                    certificate(ONE, ONE, convex() + "in 0 0\n"), "piece 0 of S"),
    "a vertex moved inwards": (UNIT, UNIT, "POLYGON((0 0,2 0,1.999999 2,0 2,0 0))",
                               certificate(ONE, ONE, convex() + "in 0 0\n"), "edge 1 of S"),
    "translated": (UNIT, UNIT, "POLYGON((1/777 0,1555/777 0,1555/777 2,1/777 2,1/777 0))",
                   certificate(ONE, ONE, convex() + "in 0 0\n"), "edge 3 of S"),
    "nothing given": (UNIT, UNIT, "POLYGON EMPTY", certificate(ONE, ONE, NOTHING), "is not in S"),
    "something of nothing": ("POLYGON EMPTY", UNIT, UNIT,
                             certificate(NOTHING + "links 0\n", ONE, convex() + "in 0 0\n"), "piece 0 of S"),
    "an edge left out": (U_SHAPE, UNIT, u_sum(), open_certificate(U_PIECES, ONE, U_SUM), "piece 0 of S"),
    "an edge too short": (U_SHAPE, UNIT, u_sum("LINESTRING (2 5/2, 2 4)"), open_certificate(U_PIECES, ONE, U_SUM),
                          "piece 0 of S"),
    "an edge too long": (U_SHAPE, UNIT, u_sum("LINESTRING (2 3/2, 2 4)"), open_certificate(U_PIECES, ONE, U_SUM),
                         "dangling edge 0 of S, from (2, 3/2) to (2, 4),"),
    "a point added": (U_SHAPE, UNIT, u_sum("LINESTRING (2 2, 2 4)", "POINT (1 1)"),
                      open_certificate(U_PIECES, ONE, U_SUM), "isolated point 0 of S, (1, 1),"),
    "a point moved": (AROUND, f"POLYGON({square(0, 0, 2)})",
                      f"GEOMETRYCOLLECTION (POLYGON ({square(0, 0, 6)}), POINT (3 2))",
                      open_certificate(RING_LINKS, ONE, HOLE_SUM), "isolated point 0 of S, (3, 2),"),
}

# Right as sets of points, but edges of one region cross or overlap.
HOLE = "(2 2,2 3,3 3,3 2,2 2)"
TWO_CELLS = "points 0\npieces 2\n0 1 2 3\nin 0 0\n4 5 6 7\nin 0 0\n"
TWICE = f"MULTIPOLYGON(({square(0, 0, 1)}),({square(0, 0, 1)}))"
OVERLAPS = {
    "a hole twice, and a chain that fills it": (
        AROUND, UNIT, f"MULTIPOLYGON(({square(0, 0, 5)},{HOLE},{HOLE}),({square(2, 2, 1)}))",
        certificate(RING_LINKS, ONE, RING_SUM), "edges of S"),
    "the same, with a vertex more": (
        AROUND, UNIT, f"MULTIPOLYGON(({square(0, 0, 5)},{HOLE},(2 2,2 2.5,2 3,3 3,3 2,2 2)),({square(2, 2, 1)}))",
        certificate(RING_LINKS, ONE, RING_SUM.replace("points 0", "points 2\n4 2 5/2\n16 2 5/2").replace("4 5\n", "4 17 5\n")),
        "edges of S"),
    "a component of S twice": (UNIT, UNIT, f"MULTIPOLYGON(({square(0, 0, 2)}),({square(0, 0, 2)}))",
                               certificate(ONE, ONE, TWO_CELLS), "edges of S"),
    "a component of P twice": (TWICE, UNIT, f"POLYGON({square(0, 0, 2)})",
                               certificate(TWO_PIECES + "links 0\n", ONE, convex() + "in 0 0\n"), "edges of P"),
    "a component of Q twice": (UNIT, TWICE, f"POLYGON({square(0, 0, 2)})",
                               certificate(ONE, TWO_PIECES + "links 0\n", convex() + "in 0 0\n"), "edges of Q"),
    "components that cross": (UNIT, f"MULTIPOLYGON(({square(0, 0, 2)}),({square(1, 1, 2)}))",
                              "POLYGON((0 0,3 0,3 1,4 1,4 4,1 4,1 3,0 3,0 0))",
                              certificate(ONE, TWO_PIECES + "links 0\n",
                                          "points 0\npieces 2\n0 1 2 6 7\nin 0 0\n2 3 4 5 6\nin 0 1\n"), "edges of Q"),
    "components with a common wall": (
        f"MULTIPOLYGON(({square(0, 0, 1)}),({square(2, 0, 1)}))", UNIT,
        f"MULTIPOLYGON(({square(0, 0, 2)}),((2 0,4 0,4 2,2 2,2 1,2 0)))",
        certificate(TWO_PIECES + "links 0\n", ONE, "points 0\npieces 2\n0 1 2 3\nin 0 0\n5 6 7 8 4\nin 1 0\n"), "edges of S"),
    "a slit": (f"MULTIPOLYGON(({square(0, 0, 1)}),({square(2, 0, 1)}))", UNIT, "POLYGON((0 0,4 0,4 2,2 2,2 1,2 2,0 2,0 0))",
               certificate(TWO_PIECES + "links 0\n", ONE,
                           "points 1\n0 2 0\npieces 2\n0 7 4 5 6\nin 0 0\n1 2 3 4 7\nin 1 0\n"), "edges of S"),
}

# What is changed, in which example, what stands there, what stands there instead, the exit code and what is said.
DAMAGES = [
    ("another summand", "hole", "in 1 0", "in 3 0", NOT_CERTIFIED, "piece 1 of S"),
    ("a summand that is not there", "hole", "in 1 0", "in 4 0", NOT_CERTIFIED, "piece 1 of S"),
    ("a huge summand", "hole", "in 1 0", f"in 1 {10 ** 30}", NOT_CERTIFIED, "piece 1 of S"),
    ("a negative summand", "hole", "in 1 0", "in -1 0", INVALID, "'-1'; expected a number that is not negative"),
    ("a line moved", "hole", "in 0 0", "cut 1 0 -3\nin 1 0\nin 0 0", NOT_CERTIFIED, "piece 0 of S"),
    ("a line that is none", "cut", "cut 1 0 -1", "cut 0 0 1", NOT_CERTIFIED, "piece 0 of S"),
    ("a line with the sides exchanged", "cut", "cut 1 0 -1", "cut 0 0 -1", NOT_CERTIFIED, "piece 0 of S"),
    ("a line of fractions", "cut", "cut 1 0 -1", "cut 1 0 -1/2", INVALID, "'-1/2'; expected an integer"),
    ("a tree cut short", "cut", "in 0 0\nin 0 0", "in 0 0", INVALID, "'0'; expected 'in', or 'cut'"),
    ("a tree too long", "cut", "in 0 0\nin 0 0", "in 0 0\nin 0 0\nin 0 0", INVALID, "'in'; expected"),
    ("no tree", "squares", "in 0 0\n", "", INVALID, "'end'; expected 'in', or 'cut'"),
    ("a piece left out of P", "hole", "pieces 4\n0 1 7 4\n1 2 6 7\n2 3 5 6\n3 0 4 5\nlinks 3\n0 1\n1 2\n2 3",
     "pieces 3\n0 1 7 4\n1 2 6 7\n2 3 5 6\nlinks 2\n0 1\n1 2", NOT_CERTIFIED, "pieces of P"),
    ("a piece of P twice", "hole", "pieces 4\n0 1 7 4\n1 2 6 7\n2 3 5 6\n3 0 4 5\nlinks",
     "pieces 5\n0 1 7 4\n1 2 6 7\n2 3 5 6\n3 0 4 5\n0 1 7 4\nlinks", NOT_CERTIFIED, "pieces of P"),
    ("a piece of S left out", "hole", "pieces 4\n0 1 7 4\nin 0 0\n", "pieces 3\n", NOT_CERTIFIED, "pieces of S"),
    ("a piece of S twice", "hole", "pieces 4\n0 1 7 4\nin 0 0\n", "pieces 5\n0 1 7 4\nin 0 0\n0 1 7 4\nin 0 0\n",
     NOT_CERTIFIED, "pieces of S"),
    ("a piece turned clockwise", "hole", "2 3 5 6\n3", "6 5 3 2\n3", NOT_CERTIFIED, "pieces of P"),
    ("a piece that is not convex", "cut", "pieces 2\n0 1 2 3\n0 3 4 5\nlinks 1\n0 1", "pieces 1\n0 1 2 3 4 5\nlinks 0",
     NOT_CERTIFIED, "pieces of P"),
    ("a piece that is not convex but has a fan", "cut", "pieces 2\n0 1 2 3\n0 3 4 5\nlinks 1\n0 1",
     "pieces 1\n3 4 5 0 1 2\nlinks 0", NOT_CERTIFIED, "pieces of P"),
    ("a piece that goes round twice", "squares", "summand q\npoints 0\npieces 1\n0 1 2 3",
     "summand q\npoints 0\npieces 1\n0 1 2 3 0 1 2 3", NOT_CERTIFIED, "pieces of Q"),
    ("a piece of two corners", "squares", "summand q\npoints 0\npieces 1\n0 1 2 3",
     "summand q\npoints 0\npieces 2\n0 1 2 3\n0 1", NOT_CERTIFIED, "pieces of Q"),
    ("a diagonal used once", "cut", "0 1 2 3\n0 3 4 5\nlinks", "0 1 2 3\n3 4 5\nlinks", NOT_CERTIFIED, "pieces of P"),
    ("a piece between a region's components", "components", "pieces 2\n0 1 2 3\n4 5 6 7\nlinks",
     "pieces 3\n0 1 2 3\n4 5 6 7\n1 4 7 2\nlinks", NOT_CERTIFIED, "pieces of P"),
    ("a vertex that is not there", "squares", "0 1 2 3\nin", "0 1 2 4\nin", INVALID, "there is no vertex 4"),
    ("a negative vertex", "squares", "0 1 2 3\nin", "0 1 2 -3\nin", INVALID, "'-3'; expected a number from 0"),
    ("a huge vertex", "squares", "0 1 2 3\nin", f"0 1 2 {10 ** 30}\nin", INVALID, "; expected a number from 0"),
    ("a link to a piece with no common corner", "hole", "1 2\n2 3", "1 2\n1 3", NOT_CERTIFIED, "links of P"),
    ("a link from a piece that is not reached", "hole", "0 1\n1 2\n2 3", "0 1\n2 3\n1 2", NOT_CERTIFIED, "links of P"),
    ("links in a circle", "hole", "0 1\n1 2\n2 3", "0 1\n3 2\n2 3", NOT_CERTIFIED, "links of P"),
    ("a link to a piece that reaches it", "hole", "links 3\n0 1\n1 2\n2 3", "links 3\n0 1\n1 2\n3 3", NOT_CERTIFIED,
     "links of P"),
    ("a link from a piece that is not there", "hole", "1 2\n2 3", "1 2\n7 3", NOT_CERTIFIED, "links of P"),
    ("a link of one number", "hole", "1 2\n2 3", "1 2\n3", INVALID, "the end of the line"),
    ("more links than there are", "hole", "links 3", "links 4", INVALID, "'summand'"),
    ("fewer links than there are", "hole", "links 3", "links 2", INVALID, "'2'; expected 'summand'"),
    ("a negative count", "hole", "links 3", "links -3", INVALID, "'-3'; expected a number from 0"),
    ("a huge count", "hole", "links 3", f"links {10 ** 9}", INVALID, "expected a number from 0"),
    ("a count larger than the file", "squares", "pieces 1\n0 1 2 3\nin 0 0\n", f"pieces {10 ** 8}\n0 1 2 3\nin 0 0\n", INVALID,
     "'end'; expected a number from 0"),
    ("a hexadecimal count", "hole", "links 3", "links 0x3", INVALID, "'0x3'; expected a number from 0"),
    ("a count with an underscore", "hole", "links 3", "links 3_", INVALID, "'3_'; expected a number from 0"),
    ("a count that is a fraction", "hole", "links 3", "links 3/1", INVALID, "'3/1'; expected a number from 0"),
    ("no count", "hole", "links 3", "links", INVALID, "the end of the line; expected a number from 0"),
    ("a point off its edge", "points", "5 0 1", "5 1/1000 1", NOT_CERTIFIED, "pieces of P"),
    ("a point beyond its edge", "points", "5 0 1", "5 0 3", NOT_CERTIFIED, "pieces of P"),
    ("a point in another edge", "points", "5 0 1", "4 0 1", NOT_CERTIFIED, "pieces of P"),
    ("a point in an edge that is not there", "points", "5 0 1", "6 0 1", INVALID, "there is no edge 6"),
    ("a point left out", "points", "points 1\n5 0 1", "points 0", INVALID, "there is no vertex 6"),
    ("a point twice", "points", "points 1\n5 0 1", "points 2\n5 0 1\n5 0 1", NOT_CERTIFIED, "pieces of P"),
    ("points in the wrong order", "points", "points 1\n5 0 1\npieces 2\n0 1 2 3 6\n6 3 4 5\n",
     "points 2\n5 0 1\n5 0 3/2\npieces 2\n0 1 2 3 6\n6 3 4 5 7\n", NOT_CERTIFIED, "pieces of P"),
    ("a zero denominator", "points", "5 0 1", "5 0/0 1", INVALID, "'0/0'; expected a fraction p/q with q > 0"),
    ("a word for a number", "points", "5 0 1", "5 0 one", INVALID, "'one'; expected an integer, a decimal"),
    ("infinity", "points", "5 0 1", "5 0 inf", INVALID, "'inf'; expected an integer, a decimal"),
    ("a huge exponent", "points", "5 0 1", "5 0 1e999999999", INVALID, "; expected an exponent from -4096 to 4096"),
    ("unit 0", "squares", "unit 1", "unit 0", INVALID, "the unit is 0"),
    ("a negative unit", "squares", "unit 1", "unit -1", INVALID, "'-1'; expected a number that is not negative"),
    ("no unit", "squares", "unit 1\n", "", INVALID, "'summand'; expected 'unit'"),
    ("another version", "squares", "certificate 2", "certificate 1", INVALID, ":1: '1'; expected '2'"),
    ("another kind", "squares", "claim sum", "claim ifp", INVALID, ":2: a certificate of the kind 'ifp'; expected 'sum'"),
    ("an open sum called closed", "edge", "claim open-sum", "claim sum", INVALID, "expected POLYGON, MULTIPOLYGON"),
    ("a closed sum called open", "squares", "claim sum", "claim open-sum", INVALID, "'end'; expected 'seams'"),
    ("a seam in a closed sum", "cut", "cut 1 0 -1", "cut 1 0 -1 in 0 0", INVALID, "'in'; expected the end of the line"),
    ("a seam on an edge that is not there", "edge", " on 0", " on 1", NOT_CERTIFIED, "piece 0 of S"),
    ("a seam along a side of its sum", "edge", " on 0", " in 0 0", NOT_CERTIFIED, "piece 0 of S"),
    ("a seam of a sum that is not there", "edge", " on 0", " in 2 0", NOT_CERTIFIED, "piece 0 of S"),
    ("a seam that is usual, left out", "edge", " on 0", "", NOT_CERTIFIED, "piece 0 of S"),
    ("a diagonal without its seam", "diagonal", "seams 1\n4 5 on 0", "seams 0", NOT_CERTIFIED,
     "between vertices 5 and 4 of S"),
    ("a seam in another direction", "diagonal", "4 5 on 0", "5 4 on 0", CERTIFIED, "certified"),
    ("a seam of another diagonal", "diagonal", "seams 1\n4 5 on 0", "seams 2\n0 2 in 0 0\n4 5 on 0", NOT_CERTIFIED,
     "between vertices 0 and 2 of S"),
    ("a seam of a vertex that is not there", "diagonal", "4 5 on 0", "4 6 on 0", INVALID, "there is no vertex 6"),
    ("a seam from a vertex to itself", "diagonal", "4 5 on 0", "4 4 on 0 at 1 on 0", INVALID, "the line of the seam is none"),
    ("a seam that begins with a point", "half an edge", "-2 on 0 at", "-2 at", INVALID, "'at'; expected 'in' or 'on'"),
    ("a point of a seam beside its edge", "half an edge", "at 2 on 0", "at 1 on 0", NOT_CERTIFIED, "piece 0 of S"),
    ("a point of a seam on its sum's border", "half an edge", "at 2 on 0", "at 2 in 0 0", NOT_CERTIFIED, "piece 0 of S"),
    ("a seam without its second interval", "half an edge", "at 2 on 0 in 0 0", "at 2 on 0", NOT_CERTIFIED, "piece 0 of S"),
    ("a seam in three parts", "half an edge", "-1\nin 1", "-1 in 0 0 at 3 in 0 0\nin 1", CERTIFIED, "certified"),
    ("a point of a seam where no sum is", "half an edge", "-1\nin 1", "-1 in 0 0 at 5 in 0 0\nin 1", NOT_CERTIFIED,
     "piece 0 of S"),
    ("an isolated point that is not there", "isolated", "point 0", "point 1", INVALID, "there is no point 1"),
    ("an isolated point that is passed over", "isolated", "in 1 0 point 0 in 0 0", "in 1 0", NOT_CERTIFIED, "piece 0 of S"),
    ("an isolated point that is a sum", "isolated", "point 0", "at 3 in 1 0", NOT_CERTIFIED, "piece 0 of S"),
    ("another file", "squares", "oplus certificate 2", UNIT, INVALID, "expected 'oplus'"),
    ("summands exchanged", "squares", "summand p", "summand q", INVALID, ":4: 'q'; expected 'p'"),
    ("an empty file", "squares", None, "", INVALID, ":1: the end of the text; expected 'oplus'"),
    ("no end", "squares", "end\n", "", INVALID, "the end of the text; expected 'end'"),
    ("a missing last newline", "squares", "end\n", "end", INVALID, "the end of the text; expected the end of the line"),
    ("more after the end", "squares", "end\n", "end\nend\n", INVALID, ":20: 'end'; expected the end of the text"),
    ("zero bytes", "squares", "unit 1", "unit 1\0", INVALID, r"'1\000'"),
]

ENDLESS = ["yes", "yes '('", "cat /dev/zero", "printf 'oplus certificate 2\\nclaim sum\\n'; yes unit", "tr '\\0' 1 </dev/zero",
           "printf 'POLYGON(('; tr '\\0' 1 </dev/zero"]


class Test(ProgramTest):
    def __init__(self, program, build, folder):
        super().__init__(program, folder)
        self.both = beside_plain("both_checkers", build, folder, "words.ml", "inputs.ml", "certificates.ml")

    def run_on(self, texts, *options):
        """What the program answers. Fails unless both checkers do so."""
        files = [self.folder / file for file in ("p", "q", "s", "certificate")]
        for file, text in zip(files, texts):
            file.write_text(text, encoding="utf-8", newline="")
        got, said = run([self.program, *options, kind_of(texts[3]), *files])
        if got != INVALID:
            both, answer = run([self.both, kind_of(texts[3]), *files])
            right = "certified\n" if got == CERTIFIED else "not certified\n"
            self.expect("answers of both checkers", texts[3], both == 0 and answer == right, answer)
        return got, said

    def answer(self, kind, name, texts, code, wanted):
        got, said = self.run_on(texts)
        of_kind = "open Minkowski sum" if kind_of(texts[3]) == "open-sum" else "Minkowski sum"
        certified = said == f"certified: S is the {of_kind} of P and Q\n"
        right = certified if got == CERTIFIED else not said.startswith("certified") and said.count("\n") == 1
        self.expect(kind, name, right and got == code and wanted in said, f"exit code {got}: {said}")

    def examples(self):
        for name, texts in EXAMPLES.items():
            self.answer("examples", name, texts, CERTIFIED, "certified")
            *regions, text = texts
            if "GEOMETRY" not in regions[-1]:
                self.answer("examples in .dat", name, [*map(dat, regions), text], CERTIFIED, "certified")
        for name, (*texts, wanted) in WRONG_SUMS.items():
            self.answer("wrong sums", name, texts, NOT_CERTIFIED, wanted)
        for name, (*texts, wanted) in OVERLAPS.items():
            self.answer("edges that cross or overlap", name, texts, NOT_CERTIFIED, wanted + " cross or overlap")
        for name, example, right, wrong, code, wanted in DAMAGES:
            *regions, text = EXAMPLES[example]
            count = 1 if right is None else text.count(right)
            damaged = wrong if right is None else text.replace(right, wrong, 1)
            self.expect("damages that can be made", name, count > 0 and damaged != text, f"{count} times in {example}")
            self.answer("damaged certificates", name, [*regions, damaged], code, wanted)
        for text, wanted in INVALID_REGIONS:
            _, q, s, given = EXAMPLES["squares"]
            self.answer("invalid regions", text[:30], [text, q, s, given], INVALID, wanted)

    def each_cut_short(self):
        """A certificate without its last bytes is no certificate."""
        for name in ("cut", "isolated"):
            *regions, text = EXAMPLES[name]
            for length in range(len(text)):
                self.answer("certificates cut short", f"{name}, {length} bytes", [*regions, text[:length]], INVALID, "")

    def each_number_changed(self):
        """Some are as good as before, since the sum is right; the checkers must agree."""
        certified = 0
        for name, (*regions, text) in EXAMPLES.items():
            for found in list(re.finditer(r"\d+", text))[1:]:
                changed = text[:found.start()] + str(int(found.group()) + 1) + text[found.end():]
                got, said = self.run_on([*regions, changed])
                self.expect("numbers changed", f"{name}, byte {found.start()}", got in (0, 1, 2), said)
                certified += got == CERTIFIED
        self.expect("numbers that matter", "most", certified < self.counted["numbers changed"] / 10, f"{certified} do not")

    def families(self, oplus):
        """Sums with the certificates that oplus makes for them."""
        _, listed = run([oplus, "gen", "--list"])
        for i, family in enumerate(line.split()[0] for line in listed.splitlines()):
            written = ("wkt", "dat")[i % 2]
            p, q, s, made = [self.folder / f"made.{name}" for name in ("p", "q", "s", "certificate")]
            for path, summand in ((p, "P"), (q, "Q")):
                run([oplus, "gen", family, "--n", "5", "--seed", "1", "--summand", summand, "-o", path, "--format", written])
            for form in (["--format", written], ["--format", "wkt", "--open"]):
                code, said = run([oplus, "sum", p, q, "-o", s, *form, "--quiet", "--certificate", made])
                self.expect("certificates made", family, code == 0, said)
                self.answer("families", family, [file.read_text() for file in (p, q, s, made)], CERTIFIED, "certified")

    def numbers(self):
        for written, read in NUMBERS:
            _, *others = EXAMPLES["squares"]
            _, said = self.run_on([f"POLYGON(({written} 0,1000 7,0 3,{written} 0))", *others], "--echo")
            self.expect("numbers", written, f"\n0: ({read}, 0)\n" in said, said)

    def chains(self):
        wanted = ("P has 3 chains\nchain of 4 vertices\n0: (1, 1)\n1: (9, 1)\n2: (9, 9)\n3: (1, 9)\n"
                  "chain of 3 vertices\n4: (3, 3)\n5: (4, 4)\n6: (4, 3)\n"
                  "chain of 3 vertices\n7: (20, 0)\n8: (21, 0)\n9: (20, 1)\n")
        p = "MULTIPOLYGON(((1 1,1 9,9 9,9 1,1 1),(3 3,4 3,4 4,3 3)),((20 0,21 0,20 1,20 0)))"
        _, *others = EXAMPLES["squares"]
        _, said = self.run_on([p, *others], "--echo")
        self.expect("chains", "turned", wanted in said, said)
        square = "4  0 0  0 1  1 1  1 0\n"
        of_square = "P has 1 chains\nchain of 4 vertices\n0: (0, 0)\n1: (1, 0)\n2: (1, 1)\n3: (0, 1)\n"
        for name, text, read in ((".dat", dat(p), wanted), ("empty .dat", " 0\n", "P has 0 chains\n"),
                                 (".dat without holes", square, of_square),
                                 (".dat with no holes", square + "0", of_square)):
            _, said = self.run_on([text, *others], "--echo")
            self.expect("chains", name, said.startswith(read + "Q has"), said)
        # One that touches itself in its leftmost vertex, where its other part turns the other way.
        bent = ["3 -2", "0 0", "3 2", "3 1", "4 1", "4 4", "0 0", "4 -4", "4 -1", "3 -1"]
        for name, ring in (("counterclockwise", bent), ("clockwise", [bent[0], *bent[:0:-1]])):
            for start in range(len(ring)):
                chain = ring[start:] + ring[:start]
                wanted = chain if name == "counterclockwise" else [chain[0], *chain[:0:-1]]
                _, said = self.run_on([f"POLYGON(({','.join([*chain, chain[0]])}))", *others], "--echo")
                lines = "".join(f"{i}: ({x.replace(' ', ', ')})\n" for i, x in enumerate(wanted))
                self.expect("chains", f"{name}, from {start}", "chain of 10 vertices\n" + lines in said, said)

    def endless(self):
        p, q, s, given = EXAMPLES["squares"]
        for i, text in enumerate((p, q, s, given)):
            (self.folder / str(i)).write_text(text, encoding="utf-8")
        for command in ENDLESS:
            for place in range(4):
                files = [f"<({command})" if i == place else str(self.folder / str(i)) for i in range(4)]
                code, said = run(["bash", "-c", f"{self.program} {' '.join(files)}"])
                self.expect("texts without an end", f"{command}, file {place}", code == INVALID and "expected" in said,
                            f"exit code {code}: {said}")

    def deep(self):
        """A tree as deep as allowed, which is more than an ordinary stack holds, let alone a small one."""
        p, q, s, given = EXAMPLES["squares"]
        cuts = given.replace("in 0 0\n", 100000 * "cut 1 0 5\n" + 100001 * "in 0 0\n")
        files = [self.folder / f"deep.{name}" for name in ("p", "q", "s", "certificate")]
        for file, text in zip(files, (p, q, s, cuts)):
            file.write_text(text, encoding="utf-8")
        for limit in ("", "ulimit -s 1024; "):
            code, said = run(["bash", "-c", f"{limit}{self.program} {' '.join(map(str, files))}"])
            self.expect("deep trees", limit, code == NOT_CERTIFIED and "piece 0 of S" in said, f"exit code {code}: {said}")

    def little_memory(self, oplus):
        """With less and less of it; without a limit the sum is certified."""
        p, q, s, made = files = [self.folder / f"large.{name}" for name in ("p", "q", "s", "certificate")]
        run([oplus, "gen", "comb", "--n", "8000", "--summand", "P", "-o", p, "--format", "wkt"])
        run([oplus, "gen", "comb", "--n", "8000", "--summand", "Q", "-o", q, "--format", "wkt"])
        run([oplus, "sum", p, q, "-o", s, "--format", "wkt", "--quiet", "--certificate", made])
        command = f"{self.program} {' '.join(map(str, files))}"
        code, said = run(["bash", "-c", command])
        self.expect("little memory", "no limit", code == CERTIFIED, said)
        for kilobytes in range(15000, 40000, 5000):
            self.one_line("little memory", f"{kilobytes} kB",
                          run(["bash", "-c", f"ulimit -c 0 -v {kilobytes}; {command}"]), "the memory is too small")

    def usage(self):
        for arguments, code, wanted in (
                (["--help"], 0, "Usage: oplus-certified"), (["-h"], 0, "Exit codes:"),
                (["--version"], 0, "oplus-certified 1."), ([], 2, "0 files; expected P Q S CERTIFICATE"),
                (5 * ["x"], 2, "5 files"), (["--fast"], 2, "the option '--fast' is not known"),
                (4 * ["/nowhere"], 2, "/nowhere: No such file"), (4 * ["/"], 2, "/:1: Is a directory")):
            got, said = run([self.program, *arguments])
            self.expect("usage", " ".join(arguments), got == code and wanted in said, f"exit code {got}: {said}")
        self.sources_told(run([self.program, "--trusted"])[1], "inputs.ml", "verdict.ml", "layout_verdict.ml",
                          "placement_verdict.ml", "main.ml")


def main():
    program, build, oplus = Path(sys.argv[1]).resolve(), Path(sys.argv[2]), Path(sys.argv[3])
    with tempfile.TemporaryDirectory() as directory:
        test = Test(program, build, Path(directory))
        for part in (test.examples, test.each_cut_short, test.each_number_changed, test.numbers, test.chains,
                     test.endless, test.deep, test.usage):
            part()
        test.outputs(dict(zip("pqsc", EXAMPLES["squares"])), "p q s c", "--echo p q s c")
        test.families(oplus)
        test.little_memory(oplus)
    sys.exit(test.summary())


if __name__ == "__main__":
    main()
