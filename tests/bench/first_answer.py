#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""first_answer.py FOLDER: the time from asking for the page in FOLDER, which checked/bindings/page/make wrote, to its first answer: in
Chromium, from a server on this machine, in new processes without a cache. Needs Selenium and chromium-driver."""

import functools
import http.server
import statistics
import sys
import threading

from selenium import webdriver
from selenium.webdriver.support.ui import WebDriverWait

ROUNDS = 9
# When #status first tells about P, milliseconds since the page was asked for.
WATCH = """new MutationObserver((_, observer) => {
  if (!document.getElementById("status")?.textContent.startsWith("P:")) return;
  observer.disconnect();
  requestAnimationFrame(() => { window.answered = performance.now(); });
}).observe(document, {childList: true, subtree: true, characterData: true});"""


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


def milliseconds(address):
    options = webdriver.ChromeOptions()
    for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--disable-gpu"):
        options.add_argument(argument)
    with webdriver.Chrome(options=options,
                          service=webdriver.chrome.service.Service("/usr/bin/chromedriver")) as driver:
        driver.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": WATCH})
        driver.get(address)
        return WebDriverWait(driver, 30).until(lambda _: driver.execute_script("return window.answered"))


def main(folder):
    handler = functools.partial(Quiet, directory=folder)
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        took = [milliseconds(f"http://127.0.0.1:{server.server_address[1]}/") for _ in range(ROUNDS)]
        server.shutdown()
    print(f"first answer: {statistics.median(took):.0f} ms, {min(took):.0f} to {max(took):.0f} in {ROUNDS} rounds")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
