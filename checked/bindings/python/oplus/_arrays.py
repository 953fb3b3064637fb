# SPDX-License-Identifier: MIT
"""Many regions in numpy arrays."""

from collections import namedtuple

Arrays = namedtuple("Arrays", "coordinates rings polygons regions", defaults=(None, None), module="oplus")
Arrays.__doc__ = """Many regions in numpy arrays.

Ring i has the points coordinates[rings[i]:rings[i + 1]]. Polygon i has the rings from
polygons[i] to polygons[i + 1], the outer one first; without `polygons` each ring is a polygon.
Region i has the polygons from regions[i] to regions[i + 1]; without `regions` each polygon is a
region. Rings may be turned either way, and may or may not repeat their first point at the end.

>>> import numpy
>>> squares = numpy.array([[0, 0], [1, 0], [1, 1], [0, 1], [5, 5], [7, 5], [7, 7], [5, 7]])
>>> both = oplus.Arrays(squares, [0, 4, 8])
>>> [float(region.area) for region in oplus.from_arrays(both)]
[1.0, 4.0]
"""
