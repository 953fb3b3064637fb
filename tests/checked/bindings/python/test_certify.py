# SPDX-License-Identifier: GPL-3.0-or-later
"""Certificates, and the program that checks them."""

import subprocess
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings

import oplus
from tiles import small_tilings, tilings, union

CHECKER = Path(oplus.__file__).parents[2] / "bin/oplus-certified"
SQUARE = [[0, 0], [1, 0], [1, 1], [0, 1]]
FRAME = [[[0, 0], [4, 0], [4, 4], [0, 4]], [[1, 1], [1, 3], [3, 3], [3, 1]]]
SUM = [[[0, 0], [5, 0], [5, 5], [0, 5]], [[2, 2], [2, 3], [3, 3], [3, 2]]]
FILLED = [[0, 0], [5, 0], [5, 5], [0, 5]]


def checked(folder, p, q, given, certificate, kind="sum"):
    """Returns what oplus-certified prints."""
    texts = {"p": p.to_wkt(), "q": q.to_wkt(), "sum": given.to_wkt(), "certificate": certificate}
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8")
    ran = subprocess.run([CHECKER, kind, *texts], cwd=folder, capture_output=True, text=True, check=False)
    assert ran.returncode in (0, 1), ran.stderr
    return ran.stdout


@pytest.mark.skipif(not CHECKER.exists(), reason="oplus-certified is not built, for lack of Coq or OCaml")
@settings(max_examples=25, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(tilings(3), small_tilings)
def test_the_proved_checker_accepts_it(tmp_path, p_pieces, q_pieces):
    p, q = oplus.Region(union(p_pieces)), oplus.Region(union(q_pieces))
    found = oplus.minkowski_sum(p, q)
    certificate = oplus.certify(p, q, found)
    assert checked(tmp_path, p, q, found, certificate) == "certified: S is the Minkowski sum of P and Q\n"
    assert oplus.certify(p, q, found.region) == certificate
    larger = oplus.Region(found.region.scaled(2, 2))
    assert checked(tmp_path, p, q, larger, certificate).startswith("not certified: ")


@pytest.mark.skipif(not CHECKER.exists(), reason="oplus-certified is not built, for lack of Coq or OCaml")
def test_open_sums(tmp_path):
    frame, part = oplus.Region(FRAME), oplus.Region([[0, 0], [2, 0], [2, 2], [0, 2]])
    found = oplus.minkowski_sum(frame, part, boundary="open")
    assert len(found.isolated_vertices) == 1
    certificate = oplus.certify(frame, part, found)
    assert checked(tmp_path, frame, part, found, certificate, "open-sum").startswith("certified: ")
    assert oplus.certify(frame, part, found.__geo_interface__, boundary="open") == certificate


def test_sums_from_anywhere():
    assert oplus.certify(FRAME, SQUARE, SUM).startswith("oplus certificate 2\nclaim sum\nunit 1\nsummand p\n")
    touching = [SQUARE, [[2, 2], [3, 2], [3, 3], [2, 3]]]
    # One chain that touches itself, as other libraries return it.
    eight = [[0, 0], [2, 0], [2, 2], [4, 2], [4, 4], [2, 4], [2, 2], [0, 2]]
    assert oplus.certify([[ring] for ring in touching], SQUARE, eight).endswith("\nend\n")


@pytest.mark.parametrize("given, reason", [
    (FILLED, r"S: it is not the sum: missing hole: .*; at \(\S+, \S+\); expected the sum of P and Q"),
    ([[[0, 0], [0, 0], [5, 0], [5, 5], [0, 5]], SUM[1]], r"S: the vertex \(0, 0\) twice in a row; expected .*"),
    (oplus.minkowski_sum(SQUARE, SQUARE), "S: it is not the sum: .*")])
def test_what_is_not_the_sum(given, reason):
    with pytest.raises(oplus.InvalidInput, match="^" + reason + "$"):
        oplus.certify(FRAME, SQUARE, given)


def test_edges_and_points_of_a_claimed_sum_count():
    part, slot = [[0, 0], [2, 0], [2, 2], [0, 2]], [[1, 1], [1, 3], [4, 3], [4, 1]]
    for p, more in [(FRAME, "isolated_vertices"), ([[[0, 0], [5, 0], [5, 4], [0, 4]], slot], "dangling_edges")]:
        found = oplus.minkowski_sum(p, part, boundary="open")
        assert len(getattr(found, more)) == 1
        with pytest.raises(oplus.InvalidInput, match="S: it is not the sum: additional "):
            oplus.certify(p, part, found, boundary="closed")
        with pytest.raises(oplus.InvalidInput, match="S: it is not the sum: additional "):
            oplus.certify(p, part, found.__geo_interface__)
        assert oplus.certify(p, part, found.region)


def test_unbounded_regions():
    outside = oplus.complement(SQUARE)
    with pytest.raises(oplus.InvalidInput, match="a summand is unbounded"):
        oplus.certify(outside, SQUARE, outside)
    with pytest.raises(oplus.InvalidInput):
        oplus.certify(SQUARE, SQUARE, outside)
