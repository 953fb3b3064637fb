# SPDX-License-Identifier: MIT
"""A GeoSeries of GeoPandas for many regions."""

import sys

from ._sets import Region

_ANY = Region([[0, 0], [1, 0], [0, 1]])


def is_series(value):
    # One that is given was imported by somebody.
    geopandas = sys.modules.get("geopandas")
    return geopandas is not None and isinstance(value, geopandas.GeoSeries)


def batch_of(compute, p, q):
    """Calls compute(p, q) with lists for series, and returns a series of the results with the same index, missing where
    one of a pair was."""
    from geopandas import GeoSeries

    series = [one for one in (p, q) if is_series(one)]
    index, crs = series[0].index, next((one.crs for one in series if one.crs is not None), None)
    known = [True] * len(index)
    for one in series:
        if not one.index.equals(index):
            raise ValueError("two series with different indices; expected the same index")
        if one.crs is not None and one.crs != crs:
            raise ValueError(f"coordinates of {one.crs} and of {crs}; expected the same")
        known = [is_known and not is_missing for is_known, is_missing in zip(known, one.isna())]

    def regions(side):
        if not is_series(side) and not isinstance(side, (list, tuple)):
            return side
        if len(side) != len(index):
            raise ValueError(f"{len(side)} regions for a series of {len(index)}; expected one, or as many")
        # In place of what is missing anything valid, so that messages count pairs as the series does.
        return [one if is_known else _ANY for one, is_known in zip(side, known)]

    results = compute(regions(p), regions(q))
    return GeoSeries([result.to_shapely() if is_known else None for result, is_known in zip(results, known)],
                     index=index, crs=crs)
