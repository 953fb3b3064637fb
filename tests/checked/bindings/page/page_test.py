# SPDX-License-Identifier: GPL-3.0-or-later
"""The page in Chromium without a window, by Selenium: OPLUS_PAGE names its folder."""

import functools
import re
from urllib.parse import quote

import pytest
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

from conftest import SQUARE, TRIANGLE

FRAME = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 3, 3 3, 3 1, 1 1))"


def test_exact_sum_and_area(page):
    page.pair()
    assert page.value("sum-wkt") == "POLYGON ((0 0, 6 0, 6 4, 4 6, 0 6, 0 0))"
    assert "Area 34;" in page.text("counts")


def test_a_vertex_is_dragged(page):
    page.pair()
    before = page.value("p-wkt")
    page.drag(page.vertex(3), (60, -60))
    page.until(lambda: page.value("p-wkt") != before)
    assert re.search(r"vertex 3 of 4 at \((\d), \1\)", page.vertex(3).get_attribute("aria-label"))
    assert "4 4" not in page.value("p-wkt")


def test_a_polygon_is_dragged(page):
    page.pair()
    page.drag(page.driver.find_element(By.CSS_SELECTOR, '#summands path[data-of="p"]'), (0, 150))
    page.until(lambda: page.value("p-wkt") != SQUARE)
    ys = sorted({int(y) for y in re.findall(r" (-?\d+)[,)]", page.value("p-wkt"))})
    assert ys[1] - ys[0] == 4 and ys[0] < 0


def test_keys_move_add_and_remove(page):
    page.pair()
    page.vertex(1).send_keys(Keys.PAGE_DOWN)
    active = page.driver.switch_to.active_element
    assert "vertex 2 of 4" in active.get_attribute("aria-label")
    active.send_keys(Keys.ARROW_RIGHT)
    page.until(lambda: "at (5, 0)" in page.vertex(2).get_attribute("aria-label"))
    page.driver.switch_to.active_element.send_keys(Keys.INSERT)
    page.until(lambda: "vertex 3 of 5 at (4.5, 2)" in page.driver.switch_to.active_element.get_attribute("aria-label"))
    page.driver.switch_to.active_element.send_keys(Keys.DELETE)
    page.until(lambda: "P: 4 vertices" in page.text("status"))
    page.until(lambda: "vertex 3 of 4 at (4, 4)" in page.driver.switch_to.active_element.get_attribute("aria-label"))
    page.vertex(2).send_keys(Keys.ALT, Keys.ARROW_UP)
    page.until(lambda: "at (5, 1)" in page.vertex(2).get_attribute("aria-label"))
    assert "at (0, 1)" in page.vertex(1).get_attribute("aria-label")


def test_p_q_and_x_are_one_stop_each(page):
    page.pair()
    page.driver.execute_script("arguments[0].focus()", page("share"))
    for name in ("P, outer chain", "Q, outer chain", "play", "slide", "Point x", "format"):
        ActionChains(page.driver).send_keys(Keys.TAB).perform()
        stop = page.driver.switch_to.active_element
        assert (stop.get_attribute("aria-label") or stop.get_attribute("id")).startswith(name)


def test_focus_is_visible(page):
    page.pair()
    one = page.vertex(1)
    dot = one.find_elements(By.TAG_NAME, "circle")[1]
    before = [dot.value_of_css_property(name) for name in ("stroke-width", "fill", "r")]
    page.driver.execute_script("arguments[0].focus()", one)
    after = [dot.value_of_css_property(name) for name in ("stroke-width", "fill", "r")]
    assert all(a != b for a, b in zip(after, before))


@pytest.mark.parametrize("name", ["sum", "holes", "dangling", "convolution", "reduced", "cycle"])
def test_layers(page, name):
    page.pair(FRAME, SQUARE)
    is_on = bool(page.layer(name))
    assert is_on == (name == "sum")
    page("layer-" + name).click()
    assert bool(page.layer(name)) != is_on
    assert page("layer-" + name).is_selected() != is_on


def test_open_sum_has_an_isolated_vertex(page):
    page.open(f"p={quote(FRAME)}&q={quote('POLYGON((0 0,2 0,2 2,0 2,0 0))')}&open=1")
    assert "1 isolated vertex" in page.text("counts")
    page("open").click()
    page.until(lambda: "0 isolated vertices" in page.text("counts"))


def test_the_point_x(page):
    page.pair()
    assert "(1, 1) is inside the sum" in page.text("placement")
    assert "Winding number 1, tangent count 1" in page.text("placement")
    for field in ("x0", "x1"):
        page.type(field, "13/2")
    page("move-x").click()
    page.until(lambda: "(6.5, 6.5) is outside the sum" in page.text("placement"))
    assert "do not meet" in page.text("placement")
    assert "Winding number 0, tangent count 0" in page.text("placement")
    page.driver.find_element(By.CSS_SELECTOR, "#sum .handle").send_keys(Keys.ARROW_LEFT)
    page.until(lambda: "(5.5, 6.5)" in page.text("placement"))


def test_steps_of_a_cycle(page):
    page.pair(more=",cycle")
    assert page.text("segment").startswith("Segment 1 of 7:")
    page("next").click()
    assert page.text("segment").startswith("Segment 2 of 7:")
    page("previous").click()
    page("previous").click()
    assert page.text("segment").startswith("Segment 7 of 7:")
    assert len(page.driver.find_elements(By.CSS_SELECTOR, "#sum .current")) == 1


def test_good_wkt(page):
    page.pair()
    page.type("q-wkt", "POLYGON((0 0,0.1 0,0 1/3,0 0))")
    page("use-q").click()
    page.until(lambda: "13/3" in page.value("sum-wkt"))
    assert page.text("error") == ""


def test_bad_wkt_changes_nothing(page):
    page.pair()
    page.type("p-wkt", "POLYGON((0 0,1 0")
    page("use-p").click()
    page.until(lambda: page.text("error").startswith("P:1:"))
    assert "\n" not in page.text("error")
    assert page.value("sum-wkt") == "POLYGON ((0 0, 6 0, 6 4, 4 6, 0 6, 0 0))"


def test_an_error_is_in_sight_and_moves_no_drawing(page):
    page.pair()
    top = page("summands").rect["y"]
    page.type("p-wkt", "POLYGON((0 0,1 0")
    page("use-p").click()
    page.until(lambda: page.text("error").startswith("P:1:"))
    assert page("summands").rect["y"] == top
    low, height = page.driver.execute_script(
        "return [document.getElementById('error').getBoundingClientRect().bottom, innerHeight]")
    assert 0 < low <= height


def test_an_invalid_polygon_leaves_the_last_valid_picture(page):
    page.pair()
    assert not page("stale").is_displayed()
    page.vertex(1).send_keys(Keys.SHIFT, Keys.ARROW_RIGHT)
    page.until(lambda: "cross" in page.text("error"))
    assert page("stale").is_displayed()
    assert page.layer("sum")[0].get_attribute("class") == "area stale"
    page.vertex(1).send_keys(Keys.SHIFT, Keys.ARROW_LEFT)
    page.until(lambda: not page("stale").is_displayed())
    assert page.text("error") == ""


def test_verify(page):
    page.pair()
    page.type("s-wkt", page.value("sum-wkt"))
    page("open").click() if page("open").is_selected() else None
    page("verify").click()
    page.until(lambda: page.text("verdict") == "yes")
    page.type("s-wkt", "POLYGON((0 0,6 0,6 6,0 6,0 0))")
    page("verify").click()
    page.until(lambda: page.text("verdict").startswith("no: given but not in the sum: "))
    assert "witness: (" in page.text("verdict")
    assert len(page.driver.find_elements(By.CSS_SELECTOR, "#sum .witness")) == 1
    for nothing, why in (("POLYGON((", "S:1:"), ("", "S:1:1: the input is empty; expected ")):
        page.type("s-wkt", nothing)
        page("verify").click()
        page.until(lambda: page.text("verdict").startswith(why))
    page("forget").click()
    page.until(lambda: page.text("verdict") == "")


def test_a_link_holds_the_state(page):
    page.pair(more=",cycle")
    page("next").click()
    page.vertex(2).send_keys(Keys.ARROW_RIGHT)
    page.until(lambda: "5+0" in page.driver.current_url)
    texts = [page.value("sum-wkt"), page.text("segment"), page.text("placement")]
    page.driver.refresh()
    page.until(lambda: page.text("status").startswith("P:"))
    assert texts == [page.value("sum-wkt"), page.text("segment"), page.text("placement")]
    assert page("layer-cycle").is_selected() and not page("layer-holes").is_selected()
    assert page.driver.execute_script("return localStorage.length + document.cookie.length") == 0


def test_nonsense_in_a_link(page):
    page.driver.get(page.server + "#p=nonsense&q=%00&x=a&step=-1&layers=all&cycle=-3&at=x")
    page.until(lambda: page.text("error") != "")
    assert "\n" not in page.text("error")


def test_a_bad_link_is_left(page):
    page.driver.get("about:blank")
    page.driver.get(page.server + "#p=nonsense&q=%00&x=a&step=-1")
    page.until(lambda: page.text("error") != "" and page.value("p-wkt") != "")
    page.example("One cycle of ten")
    page.until(lambda: page.text("status") == "P: 3 vertices. Q: 4 vertices.")
    assert page.text("error") == ""


def test_a_number_beyond_all_doubles(page):
    page.pair()
    page.type("x0", "1e400")
    page("move-x").click()
    page.until(lambda: "beyond all doubles" in page.text("error"))
    page.type("x0", "2")
    page("move-x").click()
    page.until(lambda: "(2, 1) is inside" in page.text("placement"))


def test_ground_and_wheel(page):
    page.pair()
    wkt = page.value("p-wkt")

    def middle(vertex):
        box = page.vertex(vertex).rect
        return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2

    near = functools.partial(pytest.approx, abs=1)
    before = middle(1), middle(3)
    svg = page("summands").rect
    corner = ActionChains(page.driver).move_to_element_with_offset(page("summands"), 8 - svg["width"] / 2, 8 - svg["height"] / 2)
    corner.click_and_hold().move_by_offset(40, 25).release().perform()
    dragged = middle(1), middle(3)
    assert dragged == tuple(near((x + 40, y + 25)) for x, y in before)
    page.driver.execute_script("""
        arguments[0].dispatchEvent(new WheelEvent("wheel",
          {deltaY: -1, clientX: arguments[1], clientY: arguments[2], cancelable: true}));""",
        page("summands"), *(c - page.driver.execute_script(f"return window.scroll{axis}") for c, axis in zip(dragged[0], "XY")))
    assert middle(1) == near(dragged[0])
    side = [b - a for a, b in zip(*dragged)]
    assert [b - a for a, b in zip(middle(1), middle(3))] == near([1.2 * c for c in side])
    assert page.value("p-wkt") == wkt


def test_what_was_typed_is_kept(page):
    page.pair()
    page.type("p-wkt", "POLYGON((0 0,2 0,0 1,0 0))")
    page.type("q-wkt", "POLYGON((0 0,3 0,0 1,0 0))")
    page("use-p").click()
    page.until(lambda: page.text("status").startswith("P: 3"))
    page("use-q").click()
    page.until(lambda: "3 0" in page.value("q-wkt") and "5 0" in page.value("sum-wkt"))


def test_a_click_moves_nothing(page):
    page.pair("POLYGON((1/3 1/3,4 0,4 4,1/3 1/3))")
    before = page.value("p-wkt")
    ActionChains(page.driver).click_and_hold(page.vertex(1)).move_by_offset(1, 0).release().perform()
    page.until(lambda: "vertex 1" in page.text("selected"))
    page("open").click()
    page.until(lambda: "open=0" in page.driver.current_url)
    assert page.value("p-wkt") == before


def test_the_selection_follows_a_turned_chain(page):
    page.pair("POLYGON((0 0,4 0,2 1,0 0))")
    page.driver.execute_script("arguments[0].focus()", page.vertex(3))
    for y in (0, -1, -2):
        page.driver.switch_to.active_element.send_keys(Keys.ARROW_DOWN)
        page.until(lambda: f"at (2, {y})" in page.driver.switch_to.active_element.get_attribute("aria-label"))
        page.until(lambda: f"at (2, {y})" in page.text("selected"))


def test_the_nearest_of_close_vertices(page):
    page.pair("POLYGON((0 0,100 0,100 1,100 2,100 3,0 3,0 0))")
    for number in (2, 3, 4):
        ActionChains(page.driver).click(page.vertex(number)).perform()
        page.until(lambda: f"vertex {number} " in page.text("selected"))


def slow_once(page):
    """The next answer of the core takes a second and a half more."""
    page.driver.execute_script("""
        const post = Worker.prototype.postMessage;
        Worker.prototype.postMessage = function (data) {
            Worker.prototype.postMessage = post;
            setTimeout(() => this.postMessage(data), 1500);
        };""")


def test_requests_wait_for_a_slow_core(page):
    page.pair()
    slow_once(page)
    page("open").click()
    for name, wkt in (("p", "POLYGON((0 0,2 0,0 1,0 0))"), ("q", "POLYGON((0 0,3 0,0 1,0 0))")):
        page.type(name + "-wkt", wkt)
        page("use-" + name).click()
    page.until(lambda: page.text("status") == "Computing.")
    page.until(lambda: "5 0" in page.value("sum-wkt"))


def test_steps_of_keys_add_up_while_the_core_is_slow(page):
    page.pair()
    slow_once(page)
    corner = page.vertex(3)
    for keys in ((Keys.ARROW_RIGHT,), (Keys.ARROW_RIGHT,), (Keys.ARROW_UP,), (Keys.SHIFT, Keys.ARROW_UP)):
        corner.send_keys(*keys)
    page.vertex(2).send_keys(Keys.ARROW_RIGHT)
    page.until(lambda: page.text("status") == "Computing.")
    page.until(lambda: page.value("p-wkt") == "POLYGON ((0 0, 5 0, 6 15, 0 4, 0 0))")


def test_a_drag_ends_where_it_was_dropped(page):
    page.pair()
    at = "arguments[0].getBoundingClientRect()"
    x, y = page.driver.execute_script(f"const b = {at}; return [b.x + b.width / 2, b.y + b.height / 2]", page.vertex(3))
    page.driver.execute_script("""
        const post = Worker.prototype.postMessage;
        Worker.prototype.postMessage = function (data) { setTimeout(() => post.call(this, data), 300); };
        const [one, x, y] = arguments, svg = one.closest("svg");
        svg.setPointerCapture = () => {};
        const send = (type, by) => (type === "pointerdown" ? one : svg).dispatchEvent(
          new PointerEvent(type, {bubbles: true, isPrimary: true, clientX: x + by, clientY: y - by}));
        send("pointerdown", 0);
        for (let by = 10; by <= 100; by += 10) send("pointermove", by);
        send("pointerup", 100);""", page.vertex(3), x, y)
    page.until(lambda: re.search(r"at \([5-9]", page.vertex(3).get_attribute("aria-label")))
    page.until(lambda: "4+4" not in page.driver.current_url)


def test_a_finger_drags_vertices_and_scrolls_beside_them(page):
    cdp = page.driver.execute_cdp_cmd
    cdp("Emulation.setDeviceMetricsOverride", {"width": 360, "height": 740, "deviceScaleFactor": 1, "mobile": True})
    cdp("Emulation.setTouchEmulationEnabled", {"enabled": True})

    def swipe(what, x, y):
        box = what.rect
        at = [box["x"] + x, box["y"] + y]
        for step in range(8):
            points = [{"x": at[0], "y": at[1] - 20 * step}] if step < 7 else []
            cdp("Input.dispatchTouchEvent", {"type": "touchStart" if step == 0 else "touchMove" if points else "touchEnd",
                                             "touchPoints": points})

    scrolled = functools.partial(page.driver.execute_script, "return scrollY")
    try:
        page.pair()
        swipe(page.vertex(2), 13, 13)
        page.until(lambda: "4+0" not in page.driver.current_url)
        assert scrolled() == 0
        swipe(page("summands"), 5, 300)
        page.until(scrolled)
    finally:
        cdp("Emulation.setTouchEmulationEnabled", {"enabled": False})
        cdp("Emulation.clearDeviceMetricsOverride", {})


def test_a_narrow_screen(page):
    page.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                {"width": 360, "height": 740, "deviceScaleFactor": 1, "mobile": True})
    try:
        page.open()
        assert page.driver.execute_script("return innerWidth") == 360
        assert page.driver.execute_script("return document.documentElement.scrollWidth") <= 360
    finally:
        page.driver.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})


def test_every_control_has_a_name(page):
    page.open()
    controls = page.driver.find_elements(By.CSS_SELECTOR, "input, select, textarea, button, summary, svg:not([aria-hidden]), .handle")
    assert len(controls) > 30
    assert [one.get_attribute("outerHTML") for one in controls if not one.accessible_name] == []


def luminance(colour):
    parts = [int(c) / 255 for c in re.findall(r"\d+", colour)[:3]]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(a, b):
    high, low = sorted((luminance(a), luminance(b)), reverse=True)
    return (high + 0.05) / (low + 0.05)


# Of all text that is seen: its name, its colour, and the ground that is behind it.
TEXTS = """
    const parts = (colour) => colour.match(/[\\d.]+/g).map(Number);
    const over = ([r, g, b, a = 1], ground) => [r, g, b].map((c, i) => Math.round(a * c + (1 - a) * ground[i]));
    const upwards = (one) => one ? [one, ...upwards(one.parentElement)] : [];
    const ground = (one) => upwards(one).reverse()
      .reduce((below, each) => over(parts(getComputedStyle(each).backgroundColor), below), [255, 255, 255]);
    const seen = (one) => {
      const {color} = getComputedStyle(one), below = ground(one), [r, g, b, a = 1] = parts(color);
      const opacity = upwards(one).reduce((all, each) => all * getComputedStyle(each).opacity, a);
      return [one.id || one.tagName, `rgb(${over([r, g, b, opacity], below)})`, `rgb(${below})`];
    };
    const hasText = (one) => one.matches("input:not([type]), textarea, select, output") ||
      [...one.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.data.trim());
    return [...document.body.querySelectorAll("*")].filter((one) => one.getClientRects().length && hasText(one)).map(seen);"""


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_contrast(page, scheme):
    page.driver.execute_cdp_cmd("Emulation.setEmulatedMedia",
                                {"features": [{"name": "prefers-color-scheme", "value": scheme}]})
    try:
        page.pair(more=f"&s={quote(TRIANGLE)}")
        page.type("p-wkt", "POLYGON(")
        page("use-p").click()
        page.until(lambda: page.text("error") and page("verdict").get_attribute("class") == "wrong")
        page.driver.execute_script("""
            document.getElementById("stale").hidden = false;
            document.querySelector("details").open = true;""")
        texts = page.driver.execute_script(TEXTS)
        assert {"error", "verdict", "stale", "status", "word", "example", "what", "share", "sum-wkt", "x0", "cycle", "add", "P", "SUMMARY"} <= {t[0] for t in texts}
        assert [text for text in texts if contrast(*text[1:]) < 4.5] == []
        colour = functools.partial(page.driver.execute_script, """
            const probe = document.body.appendChild(document.createElement("i"));
            probe.style.color = `var(--${arguments[0]})`;
            const colour = getComputedStyle(probe).color;
            probe.remove();
            return colour;""")
        ground = colour("ground")
        assert (luminance(ground) > 0.5) == (scheme == "light")
        for name in ("line", "focus", "p", "q", "convolution", "reduced", "sum", "hole", "dangling", "cycle", "given", "x"):
            assert contrast(colour(name), ground) >= 3, name
    finally:
        page.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})
