# SPDX-License-Identifier: MIT
"""Pictures of sets: SVG for notebooks, and matplotlib's."""

import math

from . import _geojson


def parts(drawn):
    """Returns polygons, edges and points of a bounded set, in doubles."""
    points = [_geojson.position(point) for point in getattr(drawn, "isolated_vertices", [])]
    edges = [tuple(map(_geojson.position, edge)) for edge in getattr(drawn, "dangling_edges", [])]
    return _geojson.polygons(getattr(drawn, "region", drawn)), edges, points


def svg(drawn):
    """Returns a picture of at most 300 pixels; None of what is unbounded or empty, or too large for doubles."""
    if drawn.is_unbounded or drawn.is_empty:
        return None
    x_min, y_min, x_max, y_max = map(_geojson.double, drawn.bounds)
    size = max(x_max - x_min, y_max - y_min) or 1.0
    if not math.isfinite(size):
        return None
    polygons, edges, points = parts(drawn)
    unit = size / 280
    box = (x_min - 10 * unit, -y_max - 10 * unit, x_max - x_min + 20 * unit, y_max - y_min + 20 * unit)

    def path(points):
        return "M " + " L ".join(f"{x!r} {-y!r}" for x, y in points)

    dashed = "" if getattr(drawn, "boundary", "closed") == "closed" else f' stroke-dasharray="{4 * unit!r}"'
    filled = " ".join(path(ring[:-1]) + " Z" for rings in polygons for ring in rings)
    shapes = [f'<path d="{filled}" fill="#66ccff" fill-opacity="0.6" fill-rule="evenodd"{dashed}/>'] if filled else []
    shapes += [f'<path d="{path(edge)}" stroke="#c00000"/>' for edge in edges]
    shapes += [f'<circle cx="{x!r}" cy="{-y!r}" r="{3 * unit!r}" fill="#c00000" stroke="none"/>' for x, y in points]
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{box[2] / unit:.0f}" height="{box[3] / unit:.0f}" '
            f'viewBox="{" ".join(map(repr, box))}"><g fill="none" stroke="#333333" stroke-width="{1.5 * unit!r}">'
            f'{"".join(shapes)}</g></svg>')


def plot(drawn, ax, options):
    """Adds a set to axes of matplotlib, by default the current ones; returns them."""
    from matplotlib import pyplot
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    polygons, edges, points = parts(drawn)
    if ax is None:
        ax = pyplot.gca()
        ax.set_aspect("equal")
    style = {"alpha": 0.6, "linestyle": "-" if getattr(drawn, "boundary", "closed") == "closed" else "--", **options}
    rings = [Path(ring, closed=True) for of_one in polygons for ring in of_one]
    if rings:
        ax.add_patch(PathPatch(Path.make_compound_path(*rings), **style))
    for edge in edges:
        ax.plot(*zip(*edge), color="#c00000")
    if points:
        ax.plot(*zip(*points), "o", color="#c00000")
    ax.autoscale_view()
    return ax
