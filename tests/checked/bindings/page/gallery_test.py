# SPDX-License-Identifier: GPL-3.0-or-later
"""What each example of the gallery says of itself is what the page shows of it."""

import re

import pytest
from selenium.webdriver.common.by import By


def count(page, what):
    return int(re.search(rf"(\d+) {what}", page.text("counts")).group(1))


def numbers(layer):
    """The lines of a path, as pairs of points."""
    points = [tuple(map(float, pair.split(","))) for pair in re.findall(r"-?[\d.]+,-?[\d.]+", layer.get_attribute("d"))]
    return list(zip(points[::2], points[1::2]))


def distance(point, line):
    (a, b), (c, d), (x, y) = *line, point
    length = (c - a) ** 2 + (d - b) ** 2
    t = max(0, min(1, ((x - a) * (c - a) + (y - b) * (d - b)) / length)) if length else 0
    return ((a + t * (c - a) - x) ** 2 + (b + t * (d - b) - y) ** 2) ** 0.5


def isolated_off(page, name):
    """How many isolated vertices are on no segment of a layer."""
    if not page.layer(name):
        page("layer-" + name).click()
    lines = numbers(page.layer(name)[0])
    dots = [tuple(float(one.get_attribute(c)) for c in ("cx", "cy")) for one in page.driver.find_elements(By.CSS_SELECTOR, "#sum .isolated")]
    assert len(dots) == 4
    return sum(min(distance(dot, line) for line in lines) > 1 for dot in dots)


def room(page):
    assert count(page, "dangling edges?") == 1
    assert "x = (3.5, 3) is" in page.text("placement")


def frame(page):
    assert count(page, "isolated vert") == 1
    assert "x = (3, 3) is on the boundary of the sum. The interiors of P and −Q + x do not meet." in page.text("placement")


def ten(page):
    assert "10 segments" in page.text("counts")
    assert [one.text for one in page("cycle").find_elements(By.TAG_NAME, "option")] == ["1 of 1: 10 segments"]


def off_reduced(page):
    assert count(page, "isolated vert") == 4
    assert isolated_off(page, "reduced") == 4 and isolated_off(page, "convolution") == 0


def crossing(page):
    assert "do not meet" in page.text("placement") and "x = (3, 3) is on the boundary of" in page.text("placement")


def begins(page):
    assert count(page, "holes?") == 1 and "3 0" in page.value("sum-wkt").split("), (")[1]


def fork(page):
    assert count(page, "holes?") == 9 and count(page, "outer chain") == 1


def fits(page):
    assert page.value("sum-wkt").endswith("LINESTRING (3 3, 6 3), POINT (9 0))")
    assert "Q + x is inside P." in page.text("placement")


def rounded(page):
    assert "/" not in page.value("sum-wkt") and page.layer("exact")
    assert set(re.findall(r"\.\d+", page.value("sum-wkt"))) <= {".5"}


def path(page):
    assert page.value("p-wkt").startswith("LINESTRING") and count(page, "outer chain") == 1


CLAIMS = {
    "Room and diamond": room, "Frame and square": frame, "One cycle of ten": ten,
    "Isolated vertices off the reduced convolution": off_reduced, "Sides cross, interiors do not meet": crossing,
    "A hole that begins where chains touch": begins, "The fork": fork, "Where a part fits in": fits, "Rounded outwards": rounded,
    "A tool on its path": path,
}


@pytest.mark.parametrize("title", CLAIMS)
def test_an_example_shows_what_it_says(page, title):
    page.pair()
    before = page.value("p-wkt")
    page.example(title)
    page.until(lambda: page.value("p-wkt") != before)
    assert len(page.text("example")) > 60 and page.text("error") == ""
    CLAIMS[title](page)


def test_there_are_ten(page):
    page.open()
    assert [one.text for one in page.driver.find_elements(By.CSS_SELECTOR, "#gallery span")] == list(CLAIMS)
    statements = [one.text for one in page.driver.find_elements(By.CSS_SELECTOR, "#gallery small")]
    assert len(statements) == 10 and all(statements)
