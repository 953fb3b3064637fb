# SPDX-License-Identifier: GPL-3.0-or-later
"""The module does what tests/corpus/cases.json says."""

import json
from pathlib import Path

import pytest

import oplus

CASES = json.loads((Path(__file__).parents[3] / "corpus/cases.json").read_text(encoding="utf-8"))
HERE = [(case, operation) for case in CASES["cases"] for operation in case["run"]
        if "Python" in case.get("layers", CASES["layers"][operation])]
OF_TWO = {name: getattr(oplus, name) for name in ("nfp", "ifp", "erode", "open", "close")}


def transformed(case):
    region = oplus.Region(case["p"])
    for name, values in case["maps"]:
        numbers = values.split(",")
        method = {"translate": region.translated, "scale": region.scaled, "rotate": region.rotated}[name]
        region = method(*(numbers * 2)[:2] if name == "scale" else numbers)
    return oplus.PlanarSet(region)


def computed(case, operation):
    boundary = "open" if "open" in case else "closed"
    if operation in OF_TWO:
        return OF_TWO[operation](case["p"], case["q"])
    return {
        "read": lambda: oplus.Region(case["p"]),
        "read a set": lambda: oplus.PlanarSet(case["p"]),
        "sum": lambda: oplus.minkowski_sum(oplus.Region(case["p"]), oplus.Region(case["q"]), boundary=boundary),
        "sum of sets": lambda: oplus.minkowski_sum(case["p"], case["q"], boundary=boundary),
        "complement": lambda: oplus.complement(case["p"]),
        "reflect": lambda: -oplus.Region(case["p"]),
        "reflect a set": lambda: -oplus.PlanarSet(case["p"]),
        "transform": lambda: transformed(case),
        "disc": lambda: oplus.disc(case["radius"], case["disc"], case["error"]),
    }[operation]()


def found(case, operation):
    if operation == "verify":
        verdict = oplus.verify(case["p"], case["q"], case["s"], boundary="open" if "open" in case else "closed")
        return {"reasons": [f"{reason.kind}: {reason.detail}" for reason in verdict.reasons]}
    if operation == "repair":
        region, mends = oplus.repair(case["p"], case.get("fill"))
        return {"is": region.to_wkt(), "mends": mends}
    if operation in ("distance", "depth"):
        answer = getattr(oplus, operation)(case["p"], case["q"])
        if answer and operation == "depth":
            answer = [answer[1], answer[0], answer[2]]
        numbers = [answer[0], *answer[1], *answer[2]] if answer else []
        return {"answer": [str(number) for number in numbers][:len(case["answer"])]}
    value = computed(case, operation)
    if "complement is" in case:
        return {"complement is": oplus.complement(value).to_wkt()}
    if "grid" in case:
        value = oplus.rounded(value, case["grid"], case.get("side", "nearest")).sum
    if case.get("format") == "wkb":
        return {"is": value.to_wkb().hex().upper()}
    digits = int(case["digits"]) if "digits" in case else None
    return {"is": value.to_geojson(digits) if case.get("format") == "geojson" else value.to_wkt(digits)}


@pytest.mark.parametrize("case, operation", HERE, ids=lambda one: one if isinstance(one, str) else one["name"])
def test_a_case(case, operation):
    expected = {name: case[name] for name in ("is", "complement is", "reasons", "refused", "answer") if name in case}
    if "mends" in case:
        # Without the place, which a value from code has not.
        expected["mends"] = [mend.split(": ", 1)[1] for mend in case["mends"]]
    try:
        result = found(case, operation)
    except oplus.InvalidInput as refused:
        result = {"refused": str(refused).replace("text:", "file:", 1)}
    assert result == expected
