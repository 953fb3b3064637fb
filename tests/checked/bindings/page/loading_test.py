# SPDX-License-Identifier: GPL-3.0-or-later
"""What is loaded before the first sum, and the page without a network."""

import functools
import gzip
import hashlib
import http.server
import re
import threading
from urllib.parse import urlsplit

import pytest

from conftest import FOLDER, Page

AT_MOST = 500 * 1024


class Server(http.server.ThreadingHTTPServer):
    """Notes what it is asked for, in order."""

    def __init__(self):
        self.asked = []
        super().__init__(("127.0.0.1", 0), functools.partial(Noting, directory=str(FOLDER)))


class Noting(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass

    def do_GET(self):
        self.server.asked.append(urlsplit(self.path).path.lstrip("/") or "index.html")
        super().do_GET()


@pytest.fixture
def first_visit(driver):
    """A page, and its server, which no browser knows yet."""
    server = Server()
    threading.Thread(target=server.serve_forever, daemon=True).start()
    yield Page(driver, f"http://127.0.0.1:{server.server_address[1]}/"), server
    server.shutdown()
    server.server_close()


def as_sent(file):
    """The bytes that a server sends which packs text, as those of GitHub's pages do."""
    return file.stat().st_size if file.suffix == ".gz" else len(gzip.compress(file.read_bytes(), 6))


def test_little_is_loaded(first_visit):
    page, server = first_visit
    page.open()
    page.until(lambda: "offline.js" in server.asked)  # which is asked for when the first sum is there
    before = server.asked[:server.asked.index("offline.js")]
    assert {"index.html", "controls.js", "worker.js", "oplus/oplus.wasm.gz"} <= set(before) and len(before) == len(set(before))
    sizes = {name: as_sent(FOLDER / name) for name in before}
    print(sum(sizes.values()), "bytes before the first sum:", sizes)
    assert sum(sizes.values()) <= AT_MOST


def test_all_of_it_is_small():
    assert sum(file.stat().st_size for file in FOLDER.rglob("*") if file.is_file()) <= 1_000_000


def test_what_is_kept_is_what_is_there():
    there = sorted(f"./{file.relative_to(FOLDER)}" for file in FOLDER.rglob("*")
                   if file.is_file() and file.parent.name != "LICENSES" and file.name != "offline.js")
    sums = "".join(f"{hashlib.sha256((FOLDER / name).read_bytes()).hexdigest()}  {name}\n" for name in there)
    worker = (FOLDER / "offline.js").read_text(encoding="utf-8")
    assert re.findall(r'"(\./[^"]*)"', worker) == ["./", *there]
    assert f'version = "oplus-{hashlib.sha256(sums.encode()).hexdigest()[:16]}"' in worker


def test_without_a_network(first_visit):
    page, server = first_visit
    page.open()
    sum_there = page.value("sum-wkt")
    page.until(lambda: page.driver.execute_script("return Boolean(navigator.serviceWorker.controller)"), 30)
    server.shutdown()
    server.server_close()
    page.open()
    assert page.value("sum-wkt") == sum_there
    page.example("The fork")
    page.until(lambda: "9 holes" in page.text("counts"))
    page.pair()
    page("proved").click()
    page.until(lambda: page.text("proof").endswith("The core computes the same one."), 120)
    assert page.driver.execute_async_script("fetch('nowhere').then(() => arguments[0](true), () => arguments[0](false))") is False
