# SPDX-License-Identifier: GPL-3.0-or-later
"""The proved programs on the page, in Chromium: the sum by one of them, and the certificate checked by the other."""

import json
import math
import re
from urllib.parse import quote

import pytest

from conftest import SQUARE, TRIANGLE

UNIT = "POLYGON((0 0,1 0,1 1,0 1,0 0))"
L_SHAPE = "POLYGON((0 0,2 0,2 1,1 1,1 2,0 2,0 0))"
AROUND = "POLYGON((0 0,4 0,4 4,0 4,0 0),(1 1,1 3,3 3,3 1,1 1))"
PAIRS = {
    "convex": (SQUARE, TRIANGLE),
    "a hole that stays": (AROUND, UNIT),
    "a hole into which Q fits exactly": (AROUND, "POLYGON((0 0,2 0,2 2,0 2,0 0))"),
    "a corridor of Q's width": ("POLYGON((0 0,9 0,9 4,0 4,0 3,7 3,7 2,0 2,0 0))", UNIT),
    "components in holes": ("MULTIPOLYGON(((0 0,9 0,9 9,0 9,0 0),(1 1,1 8,8 8,8 1,1 1)),((4 4,5 4,5 5,4 5,4 4)))", L_SHAPE),
    "components that touch": ("MULTIPOLYGON(((0 0,1 0,1 1,0 1,0 0)),((1 1,2 1,2 2,1 2,1 1)))", UNIT),
    "a hole that touches its chain": ("POLYGON((0 0,4 0,4 4,0 4,0 0),(0 0,1 3,3 1,0 0))", UNIT),
    "a vertex that touches an edge": ("MULTIPOLYGON(((0 0,4 0,4 4,0 4,0 0)),((4 2,6 1,6 3,4 2)))", L_SHAPE),
    "fractions": ("POLYGON((1/3 0,4 1/7,0 1e3,1/3 0))", "POLYGON((0.1 0,2 1,0 1/3,0.1 0))"),
    "both with a hole": (AROUND, AROUND),
}
COMPUTED = "The proved program has computed this sum in "
SLOW = 120  # seconds, for what takes two on a machine with nothing else to do


def star(vertices, seed):
    radii = [300 + (seed * 7919 * (i + 1) ** 2) % 701 for i in range(vertices)]
    turns = [2 * math.pi * i / vertices for i in range(vertices)]
    ring = [f"{round(r * math.cos(t))} {round(r * math.sin(t))}" for r, t in zip(radii, turns)]
    return f"POLYGON(({','.join([*ring, ring[0]])}))"


def open_pair(page, p, q, is_open=False, more=""):
    return page.open(f"p={quote(p)}&q={quote(q)}&step=1&x=1,1&open={int(is_open)}{more}")


def sent_instead(page, change):
    """What proved programs are sent from now on is changed by JavaScript about `data`, an array of texts; null is not sent."""
    page.driver.execute_script("""
        const post = Worker.prototype.postMessage;
        Worker.prototype.postMessage = function (data) {
            const changed = Array.isArray(data) ? ((data) => { %s; })(data) : data;
            if (changed) post.call(this, changed);
        };""" % change)


def proved(page, line=COMPUTED):
    page.until(lambda: page.text("proof").startswith(line), SLOW)


@pytest.mark.parametrize("name", PAIRS)
@pytest.mark.parametrize("is_open", [False, True])
def test_the_proved_sum_is_the_cores(page, name, is_open):
    open_pair(page, *PAIRS[name], is_open)
    wkt, counts = page.value("sum-wkt"), page.text("counts")
    assert page.text("proof") == "" and page.text("sum-caption") == "P ⊕ Q"
    page("proved").click()
    proved(page)
    page.until(lambda: page.text("sum-caption") == "P ⊕ Q, proved")
    assert page.text("proof").endswith("The core computes the same one.")
    if is_open:
        text = page.value("sum-wkt")
        page.type("s-wkt", text)
        page("verify").click()
        page.until(lambda: page.text("verdict") == "yes")
    else:
        assert page.value("sum-wkt") == wkt
    assert page.text("counts") == counts
    page("proved").click()
    page.until(lambda: page.text("sum-caption") == "P ⊕ Q" and page.text("proof") == "" and page.value("sum-wkt") == wkt)


def test_what_is_shown_is_what_the_proved_program_says(page):
    """It is told of another P, so its sum is another one."""
    open_pair(page, SQUARE, TRIANGLE)
    sent_instead(page, f"return [data[0], {json.dumps(TRIANGLE)}, data[2]]")
    page("proved").click()
    page.until(lambda: page.text("proof").endswith("The core computes another one."), SLOW)
    page.until(lambda: page.value("sum-wkt") == "POLYGON ((0 0, 4 0, 0 4, 0 0))")
    assert "Area 8;" in page.text("counts")


def test_the_proved_sum_follows_p_and_q(page):
    open_pair(page, SQUARE, TRIANGLE, more="&proved=1")
    proved(page)
    page.vertex(2).send_keys("\ue014")  # the right arrow
    page.until(lambda: "7 0" in page.value("sum-wkt") and "5+0" in page.driver.current_url)
    page.until(lambda: page.text("sum-caption") == "P ⊕ Q, proved")
    assert page.text("proof").endswith("The core computes the same one.")
    page.type("x0", "7")
    page("move-x").click()
    page.until(lambda: "x = (7, 1)" in page.text("placement"))
    assert page.text("sum-caption") == "P ⊕ Q, proved"
    assert "proved=1" in page.driver.current_url


def test_no_region(page):
    open_pair(page, SQUARE, TRIANGLE, more="&proved=1")
    proved(page)
    page.type("p-wkt", "POLYGON((0 0,2 2,2 0,0 2,0 0))")
    page("use-p").click()
    proved(page, "No proved sum: P: not a valid region: ")
    assert "\n" not in page.text("proof")


def test_as_large_as_it_can_be_and_larger(page):
    open_pair(page, star(40, 1), star(40, 2), more="&proved=1")
    page.until(lambda: page.text("proof").endswith("The core computes the same one."), SLOW)
    open_pair(page, star(150, 1), star(150, 2), more="&proved=1")
    proved(page, "No proved sum: P and Q are too large for this browser's stack")


def test_it_can_be_cancelled(page):
    open_pair(page, SQUARE, TRIANGLE)
    sent_instead(page, "return window.isAnswered ? data : null")
    assert not page("cancel").is_enabled()
    page("proved").click()
    page.until(lambda: page.text("proof") == "The proved program is computing.")
    page("cancel").click()
    page.until(lambda: page.text("proof") == "Cancelled.")
    assert not page("cancel").is_enabled()
    page.driver.execute_script("window.isAnswered = true")
    page.vertex(2).send_keys("\ue014")
    proved(page)


def test_a_page_without_the_programs(page):
    open_pair(page, SQUARE, TRIANGLE)
    page.driver.execute_script("""
        const Made = Worker;
        window.Worker = class extends Made { constructor(file) { super("no-" + file); } };""")
    page("proved").click()
    page.until(lambda: page.text("proof") == "No proved sum: this page was built without the program.")


def check(page, line):
    page("check").click()
    page.until(lambda: page.text("certified").startswith(line), SLOW)


@pytest.mark.parametrize("name", PAIRS)
def test_certificates_of_the_core_are_accepted(page, name):
    """Also beside the open sum, which has none of its own."""
    open_pair(page, *PAIRS[name])
    closed = page.value("sum-wkt")
    page("open").click()
    page.until(lambda: "open=1" in page.driver.current_url)
    check(page, "Accepted in ")
    assert page.text("certified").endswith(f" ms: {closed} is the closed sum of P and Q.")
    assert page.value("certificate").startswith("oplus certificate 2\n")


def test_false_certificates_are_refused(page):
    open_pair(page, L_SHAPE, UNIT)
    check(page, "Accepted")
    right = page.value("certificate")
    false = {
        right.replace("in 1 0", "in 0 0"): "Refused: not certified: piece 1 of S, ",
        right.replace("0 3 4 5", "0 1 4 5", 1): "Refused: not certified: the pieces of P are not convex, or are not P.",
        right.replace("unit 1\n", "unit 0\n", 1): "Refused: certificate:3: the unit is 0; expected a positive number.",
        right[:-4]: "Refused: certificate:",
        "nonsense": "Refused: certificate:1: 'nonsense'; expected 'oplus'.",
    }
    assert len(false) == 5 and right not in false
    for text, line in false.items():
        page.driver.execute_script("""
            document.getElementById("certificate").value = arguments[0];
            document.getElementById("certificate").dispatchEvent(new Event("input"));""", text)
        check(page, line)
        assert "\n" not in page.text("certified") and page("certified").get_attribute("class") == "wrong"
        assert page.value("certificate") == text
    page("certificate").clear()
    check(page, "Accepted")
    assert page.value("certificate") == right and page("certified").get_attribute("class") == ""


def test_false_sums_are_refused(page):
    """Of what the checker is sent, S is another region."""
    for s in ("POLYGON((0 0,6 0,6 6,0 6,0 0))", "POLYGON((0 0,6 0,6 4,4 6,0 5,0 0))"):
        open_pair(page, SQUARE, TRIANGLE)
        sent_instead(page, f"return [data[0], data[1], {json.dumps(s)}, data[3]]")
        check(page, "Refused: ")


def test_a_verdict_is_about_one_p_and_q(page):
    open_pair(page, SQUARE, TRIANGLE)
    check(page, "Accepted")
    page.vertex(2).send_keys("\ue014")
    page.until(lambda: page.text("certified") == "" and page.value("certificate") == "")
    check(page, "Accepted")
    assert re.search(r"\b7 0\b", page.text("certified"))
