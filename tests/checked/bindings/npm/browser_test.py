#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""browser_test.py FOLDER: the module that is installed in a folder computes in Chromium, where a page imports it as it is,
in the page and in a worker of it."""

import sys
from pathlib import Path

from selenium.webdriver.support.ui import WebDriverWait

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from browser import chromium, served

COMPUTE = """
  let text = "";
  const told = minkowskiSum([[0, 0], [4, 0], ["13/3", 4n]], [[0, 0], [0.5, 0], [0, 1]], {open: true});
  text += told + " " + told.area + " " + told.coordinates().polygons[0][0].length;
  try { new PlanarSet("POLYGON((0 0))"); } catch (error) { text += " " + error.name + " " + error.code; }
"""
EXPECTED = "POLYGON ((0 0, 4.5 0, 29/6 4, 13/3 5, 0 1, 0 0)) 14.583333333333334 5 OplusError invalid"
PAGE = """<!doctype html><link rel="icon" href="data:,"><script type="importmap">{"imports": {"oplus": "./node_modules/oplus/web.js"}}</script>
<script type="module">
  import {minkowskiSum, PlanarSet} from "oplus";
""" + COMPUTE + """
  const worker = new Worker("worker.js", {type: "module"});
  worker.onmessage = ({data}) => { document.title = text + "|" + data; };
  worker.onerror = ({message}) => { document.title = text + "|" + message; };
</script>"""
WORKER = 'import {minkowskiSum, PlanarSet} from "./node_modules/oplus/web.js";' + COMPUTE + "postMessage(text);"


def main(folder):
    (folder / "index.html").write_text(PAGE, encoding="utf-8")
    (folder / "worker.js").write_text(WORKER, encoding="utf-8")
    with served(folder) as address, chromium() as driver:
        driver.get(address)
        try:
            WebDriverWait(driver, 30).until(lambda _: "|" in driver.title)
        except Exception:  # what the browser says is what is wrong
            sys.exit("\n".join(entry["message"] for entry in driver.get_log("browser")))
        if driver.title != f"{EXPECTED}|{EXPECTED}":
            sys.exit(f"expected, twice: {EXPECTED}\nfound: {driver.title}")
        if errors := driver.get_log("browser"):
            sys.exit(str(errors))
        print(driver.capabilities["browserName"], driver.capabilities["browserVersion"])


if __name__ == "__main__":
    main(Path(sys.argv[1]))
