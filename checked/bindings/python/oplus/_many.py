# SPDX-License-Identifier: MIT
"""Functions of many pairs and regions."""

from . import _oplus, _progress, _series


def batch(operation, p, q, *, boundary="closed", threads=0, errors="raise", progress=None):
    """Returns the list of operation(p[i], q[i]), computed on all cores, or on that many threads.

    operation: 'sum' (or 'minkowski_sum'), 'nfp', 'ifp', 'erode', 'open' or 'close'. p, q: Arrays, or lists of
    whatever Region takes, as long as each other; or one region for all pairs (not as a list).
    Regions only: line strings and points are summands of the function minkowski_sum.
    boundary='open' is for 'sum' only. An invalid region raises InvalidInput, another type
    than Region takes TypeError, which name the first such pair; with errors='return' the exceptions
    are in the list and the other pairs are computed. progress: called with the numbers of pairs that are done and of
    all, twenty times a second, on this thread; or a bar of tqdm.

    Of a GeoSeries of GeoPandas it returns one with the same index, missing values where p or q is missing, each
    coordinate the nearest double; errors='return' is not for these.

    >>> bin = oplus.Region([[0, 0], [9, 0], [9, 9], [0, 9]])
    >>> parts = [[[0, 0], [w, 0], [w, 1], [0, 1]] for w in (3, 9, 10)]
    >>> for place in oplus.batch('ifp', bin, parts): print(place)
    POLYGON ((0 0, 6 0, 6 8, 0 8, 0 0))
    GEOMETRYCOLLECTION (LINESTRING (0 0, 0 8))
    POLYGON EMPTY
    """
    with _progress.reported(progress) as told:
        def compute(p, q):
            return _oplus.batch(operation, p, q, boundary, threads, errors, told)

        if not _series.is_series(p) and not _series.is_series(q):
            return compute(p, q)
        if errors != "raise":
            raise ValueError(f"errors {errors} of a series; expected raise")
        return _series.batch_of(compute, p, q)


def from_arrays(arrays, *, threads=0):
    """Returns the list of a Region for each region of Arrays, coordinates exactly. Checked on all cores,
    or on that many threads; coordinates of type float64 and int64 are not copied before. Raises
    InvalidInput where arrays don't fit together or a region is invalid.

    >>> import numpy
    >>> points = numpy.array([[0, 0], [4, 0], [4, 4], [0, 4], [1, 1], [2, 1], [1, 2]])
    >>> [ring] = oplus.from_arrays(oplus.Arrays(points, rings=[0, 4, 7], polygons=[0, 2]))
    >>> print(ring)
    POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 2, 2 1, 1 1))
    """
    return _oplus.from_arrays(arrays, threads)


def to_arrays(regions):
    """Returns Arrays of one or many regions or results, each coordinate the nearest double. Rings don't
    repeat their first point. Dangling edges and isolated vertices of results are left out.

    >>> arrays = oplus.to_arrays(oplus.Region([[0, 0], ['1/3', 0], [0, 1]]))
    >>> arrays.coordinates.tolist(), arrays.rings.tolist()
    ([[0.0, 0.0], [0.3333333333333333, 0.0], [0.0, 1.0]], [0, 3])
    """
    return _oplus.to_arrays(regions)
