# SPDX-License-Identifier: GPL-3.0-or-later
"""axe-core finds nothing to say against the page: OPLUS_AXE names its file."""

import os
from pathlib import Path

import pytest
from selenium.webdriver.common.by import By

AXE = Path(os.environ["OPLUS_AXE"]).read_text(encoding="utf-8")


def violations(page):
    page.driver.execute_script(AXE)
    found = page.driver.execute_async_script("axe.run().then(arguments[0], (error) => arguments[0](String(error)))")
    assert len(found["passes"]) > 20
    return [(one["id"], [node["html"][:150] for node in one["nodes"]]) for one in found["violations"]]


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [1280, 360])
def test_axe(page, scheme, width):
    page.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": scheme}]})
    try:
        page.open(width=width)
        assert violations(page) == []
        for example in range(10):
            page.driver.find_elements(By.CSS_SELECTOR, "#gallery button")[example].click()
            page.until(lambda: page.text("status").startswith("P:"))
        page.type("p-wkt", "POLYGON((0 0,1 0")
        page("use-p").click()
        page.until(lambda: page.text("error"))
        page.driver.execute_script("document.querySelector('details').open = true")
        page("play").click()
        page.until(lambda: page.driver.find_elements(By.CSS_SELECTOR, '[data-layer="swept"]'))
        assert violations(page) == []
    finally:
        page.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})
