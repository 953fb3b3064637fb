# SPDX-License-Identifier: MIT
"""Sets as GeoJSON geometries, each coordinate the nearest double."""

from . import _oplus


def double(number):
    """The nearest one, an infinity beyond the largest."""
    try:
        return float(number)
    except OverflowError:
        return float("inf") if number > 0 else float("-inf")


def position(point):
    return tuple(map(double, point))


def polygons(region):
    """Rings as GeoJSON has them, each first point repeated. Raises InvalidInput where the region is unbounded."""
    arrays = [array.tolist() for array in _oplus.to_arrays([region])]
    points = list(map(tuple, arrays[0]))
    rings = [tuple(points[begin:end] + points[begin:begin + 1]) for begin, end in zip(arrays[1], arrays[1][1:])]
    return [tuple(rings[begin:end]) for begin, end in zip(arrays[2], arrays[2][1:])]


def interface(region, edges=(), points=()):
    """The geometry; a collection where there are several parts or none."""
    all_polygons = polygons(region)
    found = []
    if len(all_polygons) == 1:
        found.append({"type": "Polygon", "coordinates": all_polygons[0]})
    elif all_polygons:
        found.append({"type": "MultiPolygon", "coordinates": tuple(all_polygons)})
    found += [{"type": "LineString", "coordinates": tuple(map(position, edge))} for edge in edges]
    found += [{"type": "Point", "coordinates": position(point)} for point in points]
    return found[0] if len(found) == 1 else {"type": "GeometryCollection", "geometries": tuple(found)}
