# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the page have in common: a server, Chromium, and where the page has what."""

import os
import re
import sys
from pathlib import Path
from urllib.parse import quote

import pytest
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import WebDriverWait

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from browser import chromium, served

FOLDER = Path(os.environ["OPLUS_PAGE"])
SQUARE = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))"
TRIANGLE = "POLYGON ((0 0, 2 0, 0 2, 0 0))"


@pytest.fixture(scope="session")
def server():
    with served(FOLDER) as address:
        yield address


@pytest.fixture(scope="session")
def driver():
    with chromium() as driver:
        yield driver


class Page:
    def __init__(self, driver, server):
        self.driver, self.server = driver, server

    def open(self, fragment="", width=1280, height=1000):
        self.driver.set_window_size(width, height)
        self.driver.get("about:blank")
        self.driver.get(self.server + "#" + fragment)
        self.until(lambda: self.text("status").startswith("P"))
        return self

    def pair(self, p=SQUARE, q=TRIANGLE, more=""):
        return self.open(f"p={quote(p)}&q={quote(q)}&step=1&x=1,1&layers=sum{more}")

    def __call__(self, name):
        return self.driver.find_element(By.ID, name)

    def text(self, name):
        return self(name).text

    def value(self, name):
        return self(name).get_attribute("value")

    def until(self, holds, seconds=10):
        WebDriverWait(self.driver, seconds).until(lambda _: holds())

    def handle(self, label):
        return self.driver.find_element(By.CSS_SELECTOR, f'.handle[aria-label^="{label}"]')

    def vertex(self, number, of="P"):
        return self.handle(f"{of}, outer chain of component 1, vertex {number} ")

    def type(self, name, text):
        self(name).clear()
        self(name).send_keys(text)

    def drag(self, what, by):
        ActionChains(self.driver).drag_and_drop_by_offset(what, *by).perform()

    def example(self, title):
        """Chooses an example of the gallery."""
        [button] = [one for one in self.driver.find_elements(By.CSS_SELECTOR, "#gallery button")
                    if one.find_element(By.TAG_NAME, "span").text == title]
        button.click()
        self.until(lambda: self.text("status").startswith("P:"))

    def layer(self, name):
        return self.driver.find_elements(By.CSS_SELECTOR, f'#sum [data-layer="{name}"]')


@pytest.fixture
def page(driver, server):
    for log in ("browser", "performance"):
        driver.get_log(log)
    yield Page(driver, server)
    errors = [entry for entry in driver.get_log("browser") if entry["level"] == "SEVERE"]
    assert errors == []
    asked = re.findall(r'"url":"(https?://[^"]*)"', "".join(e["message"] for e in driver.get_log("performance")))
    assert asked and all(url.startswith(server) for url in asked)
