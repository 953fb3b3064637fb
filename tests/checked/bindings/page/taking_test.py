# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that are opened and dropped, results that are copied and downloaded, and links that are shared."""

import json
import struct
import xml.etree.ElementTree as ElementTree

import pytest
from selenium.webdriver.support.ui import Select

from conftest import SQUARE, TRIANGLE

SUM = "POLYGON ((0 0, 6 0, 6 4, 4 6, 0 6, 0 0))"
FILES = {
    "a.wkt": b"POLYGON((0 0,3 0,0 1,0 0))",
    "a.geojson": b'{"type": "Polygon", "coordinates": [[[0, 0], [3, 0], [0, 1], [0, 0]]]}',
    "a.svg-path": b"M 0 0 H 3 L 0 1 Z",
    "a.wkb": struct.pack("<BIII8d", 1, 3, 1, 4, 0, 0, 3, 0, 0, 1, 0, 0),
}


@pytest.mark.parametrize("name", FILES)
def test_a_file_is_opened(page, tmp_path, name):
    (tmp_path / name).write_bytes(FILES[name])
    page.pair()
    page("q-file").send_keys(str(tmp_path / name))
    page.until(lambda: page.value("q-wkt") == "POLYGON ((0 0, 3 0, 0 1, 0 0))")
    assert page.value("p-wkt") == SQUARE
    page("p-file").send_keys(str(tmp_path / name))
    page.until(lambda: page.value("p-wkt") == "POLYGON ((0 0, 3 0, 0 1, 0 0))")


def test_a_bad_file_changes_nothing(page, tmp_path):
    (tmp_path / "a").write_text("<svg/>", encoding="utf-8")
    page.pair()
    page("p-file").send_keys(str(tmp_path / "a"))
    page.until(lambda: page.text("error").startswith("P:1:1: markup"))
    assert page.value("p-wkt") == SQUARE


def drop(page, where, *texts):
    page.driver.execute_script("""
        const data = new DataTransfer();
        for (const text of arguments[1]) data.items.add(new File([text], "dropped.wkt"));
        for (const type of ["dragover", "drop"])
          arguments[0].dispatchEvent(new DragEvent(type, {bubbles: true, cancelable: true, dataTransfer: data}));""",
        where, texts)


def test_files_are_dropped(page):
    small = "POLYGON ((0 0, 1 0, 0 1, 0 0))"
    page.pair()
    drop(page, page("sum"), small)
    page.until(lambda: page.value("p-wkt") == small)
    assert page.value("q-wkt") == TRIANGLE
    drop(page, page("q-wkt"), small)
    page.until(lambda: page.value("q-wkt") == small)
    drop(page, page("summands"), SQUARE, TRIANGLE)
    page.until(lambda: page.value("p-wkt") == SQUARE and page.value("q-wkt") == TRIANGLE)


def clipboard(page):
    return page.driver.execute_async_script("""
        const done = arguments[0];
        navigator.clipboard.read().then(async ([item]) => {
          const blob = await item.getType(item.types.at(-1));
          done([item.types.at(-1), blob.type === "text/plain" ? await blob.text() : (await createImageBitmap(blob)).width]);
        }, (error) => done([String(error)]));""")


@pytest.fixture
def copying(page):
    page.driver.execute_cdp_cmd("Browser.grantPermissions", {"permissions": ["clipboardReadWrite", "clipboardSanitizedWrite"]})
    page.pair()
    yield page
    page.driver.execute_cdp_cmd("Browser.resetPermissions", {})


def is_right(name, content):
    if name == "wkt":
        assert content == SUM
    elif name == "geojson":
        assert json.loads(content) == {"type": "Polygon",
                                       "coordinates": [[[0, 0], [6, 0], [6, 4], [4, 6], [0, 6], [0, 0]]]}
    else:
        root = ElementTree.fromstring(content)
        assert root.tag == "{http://www.w3.org/2000/svg}svg" and root.get("viewBox").startswith("0 0 ")
        paths = root.findall(".//{http://www.w3.org/2000/svg}path")
        assert len(paths) == 2  # the sum and the origin
        assert paths[0].get("d").count("L") == 4 and paths[0].get("fill").startswith("rgb(")
        assert paths[0].get("fill-rule") == "evenodd" and "class" not in content and "tabindex" not in content


@pytest.mark.parametrize("name", ["wkt", "geojson", "svg"])
def test_a_text_is_copied(copying, name):
    page = copying
    Select(page("format")).select_by_value(name)
    page("copy").click()
    page.until(lambda: page.text("saved") == "Copied.")
    kind, content = clipboard(page)
    assert kind == "text/plain"
    is_right(name, content)


def test_a_picture_is_copied(copying):
    page = copying
    Select(page("format")).select_by_value("png")
    page("copy").click()
    page.until(lambda: page.text("saved") == "Copied.")
    assert clipboard(page) == ["image/png", 2 * page.driver.execute_script("return arguments[0].clientWidth", page("sum"))]


@pytest.mark.parametrize("name", ["wkt", "geojson", "svg", "png"])
def test_a_result_is_downloaded(page, tmp_path, name):
    page.driver.execute_cdp_cmd("Browser.setDownloadBehavior", {"behavior": "allow", "downloadPath": str(tmp_path)})
    page.pair()
    Select(page("format")).select_by_value(name)
    page("download").click()
    file = tmp_path / f"sum.{name}"
    page.until(file.exists)
    if name == "png":
        page.until(lambda: file.read_bytes()[-8:-4] == b"IEND")
        content = file.read_bytes()
        assert content.startswith(b"\x89PNG\r\n")
        size = page.driver.execute_script("const {clientWidth: w, clientHeight: h} = arguments[0]; return [w, h]", page("sum"))
        assert list(struct.unpack(">II", content[16:24])) == [2 * side for side in size]
    else:
        is_right(name, file.read_text(encoding="utf-8"))


def test_a_link_is_shared(copying):
    page = copying
    page("share").click()
    page.until(lambda: page.text("shared").startswith("The link is copied"))
    assert clipboard(page) == ["text/plain", page.driver.current_url]
