# SPDX-License-Identifier: GPL-3.0-or-later
"""The animation: Q slides along P, and what it sweeps is drawn."""

from urllib.parse import quote

from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select

from conftest import SQUARE

SMALL = "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"


def drawn(page, name):
    return page.driver.execute_script("return [...document.querySelectorAll(arguments[0])].map((one) => one.getAttribute('d'))",
                                      f'#summands [data-layer="{name}"]')


def test_it_slides_and_can_be_stopped(page):
    page.pair()
    assert not drawn(page, "slid") and not page("unslide").is_enabled()
    page("play").click()
    page.until(lambda: int(page.value("slide")) > 20 and drawn(page, "swept"))
    assert page.text("play") == "Pause" and page("play").get_attribute("aria-pressed") == "true"
    first = drawn(page, "slid")
    page.until(lambda: drawn(page, "slid") != first)
    page("play").click()
    page.until(lambda: page.text("play") == "Slide Q")
    page("unslide").click()
    page.until(lambda: not drawn(page, "swept") and page.value("slide") == "0")


def test_it_ends(page):
    page.pair()
    page.driver.execute_script("""
        const real = performance.now.bind(performance), start = real(), frame = window.requestAnimationFrame.bind(window);
        const quick = (time) => start + 40 * (time - start);
        performance.now = () => quick(real());
        window.requestAnimationFrame = (call) => frame((time) => call(quick(time)));""")
    page("play").click()
    page.until(lambda: page.value("slide") == "1000" and page.text("play") == "Slide Q")


def slid_to(page, part):
    page.driver.execute_script("arguments[0].value = arguments[1]; arguments[0].dispatchEvent(new Event('input'))", page("slide"), part)
    page.until(lambda: page.value("slide") == str(part) and drawn(page, "swept"))


def corners(page, name):
    [path] = drawn(page, name)
    return path.count("M"), path.count("L") + path.count("M")


def test_what_is_swept(page):
    """Of a square of side 4 and one of side 1: along one side a bar, along two an L, along all a frame."""
    page.pair(SQUARE, SMALL)
    for part, expected in ((250, (1, 4)), (500, (1, 6)), (1000, (2, 8))):
        slid_to(page, part)
        page.until(lambda: corners(page, "swept") == expected)
    assert corners(page, "slid") == (1, 4)
    assert page("slide").get_attribute("aria-valuetext") == "100 % of the way"


def test_by_the_keyboard(page):
    page.pair(SQUARE, SMALL)
    page("slide").send_keys(Keys.ARROW_RIGHT)
    page.until(lambda: page.value("slide") == "1" and drawn(page, "swept"))


def test_along_the_boundary_of_the_no_fit_polygon(page):
    page.open(f"p={quote(SQUARE)}&q={quote(SMALL)}&what=nfp&step=1&x=1,1")
    assert page.text("along") == "along the boundary of the result"
    slid_to(page, 1000)
    page.until(lambda: corners(page, "swept") == (2, 8))
    # It only touches P: what it has swept has P for its hole.
    hole = drawn(page, "swept")[0].split("Z")[1].strip("M").split("L")
    p = page.driver.find_element(By.CSS_SELECTOR, "#summands path.p").get_attribute("d").strip("MZ").split("L")
    near = [[round(float(c)) for c in point.split(",")] for point in [*hole, *p]]
    assert sorted(near[:4]) == sorted(near[4:])


def test_it_ends_with_p_and_q(page):
    page.pair(SQUARE, SMALL)
    slid_to(page, 300)
    page.vertex(2).send_keys(Keys.ARROW_RIGHT)
    page.until(lambda: "5 0" in page.value("p-wkt") and not drawn(page, "swept"))
    Select(page("what")).select_by_value("ifp")
    page.until(lambda: "what=ifp" in page.driver.current_url)
    slid_to(page, 500)
