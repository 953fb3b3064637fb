# SPDX-License-Identifier: MIT
"""Exact Minkowski sums of polygons with holes, and what is made of them.

Functions take regions of many types (Region says which), coordinates for exactly what they are, and
return exact results. Each may be called on any thread; Python's lock is released while they compute,
but not while values of Python are converted.

>>> print(oplus.minkowski_sum([[0, 0], [2, 0], [0, 2]], [[0, 0], [1, 0], [1, 1], [0, 1]]))
POLYGON ((0 0, 3 0, 3 1, 1 3, 0 3, 0 0))
"""

from ._arrays import Arrays
from ._errors import InvalidInput
from ._functions import (Placements, certify, close, complement, depth, disc, distance, erode, ifp, minkowski_sum, nfp,
                         open, read_file, read_set_file, repair, rotation, rounded, verify)
from ._many import batch, from_arrays, to_arrays
from ._oplus import __version__
from ._results import Reason, Rounded, Verdict
from ._sets import PlanarSet, Region, _Both  # which the stubs have too

__all__ = ["Arrays", "InvalidInput", "Placements", "PlanarSet", "Reason", "Region", "Rounded", "Verdict",
           "batch", "certify", "close", "complement", "depth", "disc", "distance", "erode", "from_arrays", "ifp",
           "minkowski_sum", "nfp", "open", "read_file", "read_set_file", "repair", "rotation", "rounded", "to_arrays", "verify"]

InvalidInput.__module__ = "oplus"
