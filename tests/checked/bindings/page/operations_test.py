# SPDX-License-Identifier: GPL-3.0-or-later
"""No-fit and inner-fit polygons, erosion, rounding and line strings on the page; what is undone and done again."""

from urllib.parse import quote

import pytest
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select

from conftest import SQUARE, TRIANGLE

FRAME = "POLYGON ((0 0, 5 0, 5 5, 0 5, 0 0), (1 1, 1 4, 4 4, 4 1, 1 1))"
PART = "POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))"
SLOT = "POLYGON ((0 0, 6 0, 6 3, 9 3, 9 6, 0 6, 0 0))"
SPUR = "POLYGON ((0 0, 6 0, 6 3, 9 3, 9 5, 6 5, 6 6, 0 6, 0 0))"
RESULTS = {
    "nfp": (FRAME, "GEOMETRYCOLLECTION (POLYGON ((-3 -3, 5 -3, 5 5, -3 5, -3 -3)), POINT (1 1))", "P ⊕ −Q, the no-fit polygon"),
    "ifp": (SLOT, "GEOMETRYCOLLECTION (POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0)), LINESTRING (3 3, 6 3))", "The inner-fit polygon"),
    "erosion": (SLOT, "POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))", "The erosion of P by Q"),
    "opening": (SPUR, "POLYGON ((0 0, 6 0, 6 6, 0 6, 0 0))", "The opening of P by Q"),
    "closing": (FRAME, "POLYGON ((0 0, 5 0, 5 5, 0 5, 0 0))", "The closing of P by Q"),
}


@pytest.mark.parametrize("what", RESULTS)
def test_operations(page, what):
    p, result, caption = RESULTS[what]
    page.pair(p, PART)
    assert page.text("placed-caption") == "−Q + x" and page.text("word").startswith("−Q + x is Q turned")
    Select(page("what")).select_by_value(what)
    page.until(lambda: page.value("sum-wkt") == result)
    assert page.text("sum-caption") == caption
    assert page.text("placed-caption") == "Q + x" and page.text("word").startswith("Q + x is Q moved by x.")
    assert f"what={what}" in page.driver.current_url and not page("open").is_enabled()
    page.driver.refresh()
    page.until(lambda: page.text("status").startswith("P:"))
    assert page.value("sum-wkt") == result and page.value("what") == what


def test_where_q_is_inside_p(page):
    page.open(f"p={quote(SLOT)}&q={quote(PART)}&what=ifp&x=5,3&step=1")
    assert page.text("placement") == "x = (5, 3) is on the boundary of the result. Q + x is inside P."
    page.driver.find_element(By.CSS_SELECTOR, "#sum .handle").send_keys(Keys.ARROW_DOWN)
    page.until(lambda: page.text("placement") == "x = (5, 2) is outside the result. Q + x is not inside P.")


def test_where_q_overlaps_p(page):
    page.open(f"p={quote(FRAME)}&q={quote(PART)}&what=nfp&x=1,1&step=1&layers=convolution")
    assert "x = (1, 1) is on the boundary of the result. The interiors of P and Q + x do not meet." in page.text("placement")
    assert "of P + vertex" in page.text("segment") and "−Q" in page.text("segment")
    assert page.layer("convolution")
    page.driver.find_element(By.CSS_SELECTOR, "#sum .handle").send_keys(Keys.ARROW_DOWN)
    page.until(lambda: "x = (1, 0) is inside the result. The interiors of P and Q + x meet." in page.text("placement"))
    assert "Moved by (0, 1), whose squared length is 1, they only touch" in page.text("placement")


def test_rounding(page):
    page.pair("POLYGON((0 0,1/3 0,0 1/3,0 0))", SQUARE)
    page.type("grid", "1/2" + Keys.TAB)
    page.until(lambda: "4.5 0" in page.value("sum-wkt"))
    assert page.text("sum-caption") == "P ⊕ Q, rounded" and page.layer("exact")
    Select(page("side")).select_by_value("contained")
    page.until(lambda: page.value("sum-wkt") == "POLYGON ((0.5 0.5, 4 0.5, 4 4, 0.5 4, 0.5 0.5))")
    page.type("grid", "nothing" + Keys.TAB)
    page.until(lambda: "nothing" in page.text("error"))
    assert "13/3" in page.value("sum-wkt")  # as long as it was empty
    assert page.text("sum-caption") == "P ⊕ Q" and not page.layer("exact")


def test_line_strings(page):
    page.pair("LINESTRING(0 0,4 0,4 3)", TRIANGLE)
    assert page.value("p-wkt") == "LINESTRING (0 0, 4 0, 4 3)"
    end = page.handle("P, line 1, vertex 3 of 3 at (4, 3)")
    end.send_keys(Keys.INSERT)
    page.until(lambda: page.value("p-wkt") == "LINESTRING (0 0, 4 0, 4 3, 4 6)")
    page.handle("P, line 1, vertex 4 ").send_keys(Keys.ARROW_RIGHT)
    page.until(lambda: page.value("p-wkt") == "LINESTRING (0 0, 4 0, 4 3, 5 6)")
    page.until(lambda: "5 8" in page.value("sum-wkt"))
    page("proved").click()
    page.until(lambda: page.text("proof") == "Sums of regions only are proved, not rounded.")
    page.handle("P, line 1, vertex 1 ").send_keys(Keys.DELETE)
    page.until(lambda: page.value("p-wkt") == "LINESTRING (4 0, 4 3, 5 6)")
    Select(page("what")).select_by_value("erosion")
    page.until(lambda: "it has lines or points; expected a region" in page.text("error"))
    assert page.value("what") == "sum"


def test_two_lines_and_a_point(page):
    page.pair("GEOMETRYCOLLECTION(LINESTRING(0 0,1 0),LINESTRING(3 0,4 0),POINT(9 9))", TRIANGLE)
    assert "P: 5 vertices" in page.text("status")
    page.handle("P, point 1, vertex 1 of 1 at (9, 9)").send_keys(Keys.ARROW_UP)
    page.until(lambda: "POINT (9 10)" in page.value("p-wkt"))


def undone(page, step):
    page(step).click()


def by_keys(page, step):
    ActionChains(page.driver).key_down(Keys.CONTROL).send_keys("z" if step == "undo" else "y").key_up(Keys.CONTROL).perform()


@pytest.mark.parametrize("go", [undone, by_keys])
def test_undo_and_redo(page, go):
    page.pair()
    assert not page("redo").is_enabled()
    page.vertex(2).send_keys(Keys.ARROW_RIGHT)
    page.until(lambda: "5 0" in page.value("p-wkt"))
    page.vertex(3).send_keys(Keys.DELETE)
    page.until(lambda: page.text("status").startswith("P: 3"))
    page("layer-holes").click()  # is no step
    page("open").click()
    page.until(lambda: "open=0" in page.driver.current_url)
    for holds in (lambda: "open=1" in page.driver.current_url, lambda: page.text("status").startswith("P: 4"),
                  lambda: page.value("p-wkt") == SQUARE):
        page.driver.execute_script("document.activeElement.blur()")
        go(page, "undo")
        page.until(holds)
    for holds in (lambda: "5 0" in page.value("p-wkt"), lambda: page.text("status").startswith("P: 3")):
        go(page, "redo")
        page.until(holds)
    page.vertex(1).send_keys(Keys.ARROW_LEFT)
    page.until(lambda: "-1 0" in page.value("p-wkt"))
    assert not page("redo").is_enabled()


def test_a_drag_is_one_step(page):
    page.pair()
    page.drag(page.vertex(3), (60, -60))
    page.until(lambda: page.value("p-wkt") != SQUARE and "4+4" not in page.driver.current_url)
    undone(page, "undo")
    page.until(lambda: page.value("p-wkt") == SQUARE)


def test_undo_in_a_field_is_the_fields(page):
    page.pair()
    page.vertex(2).send_keys(Keys.ARROW_RIGHT)
    page.until(lambda: "5 0" in page.value("p-wkt"))
    page("q-wkt").send_keys("x", Keys.CONTROL, "z")
    page("fit").click()
    assert "5 0" in page.value("p-wkt") and page("undo").is_enabled()
