# SPDX-License-Identifier: MIT
"""What the classes of C++, Region and PlanarSet, have from Python."""

from . import _drawing, _geojson, _oplus
from ._errors import InvalidInput

Region, PlanarSet = _oplus.Region, _oplus.PlanarSet


def _added(members, *classes):
    """Adds the members of a class of Python to classes of C++."""
    for one in classes:
        for name, member in vars(members).items():
            if name not in ("__dict__", "__module__", "__weakref__"):
                setattr(one, name, member)
        one.__module__ = "oplus"


def _counted(count, one, many):
    return f"{count} {one if count == 1 else many}"


def _filled(rule, *regions):
    """What the chains of all enclose by a rule of repair: exactly."""
    return _oplus.repair({"type": "GeometryCollection", "geometries": regions}, rule)[0]


def _combined(a, b, is_in):
    """The closure of where is_in(in a, in b), of points inside of and outside of regions that may be unbounded."""
    a, b = Region(a), Region(b)
    flip_a, flip_b = a.is_unbounded, b.is_unbounded
    # Of bounded regions.
    inner_a, inner_b = (_oplus.complement(one) if one.is_unbounded else one for one in (a, b))
    flip = is_in(flip_a, flip_b)
    table = [is_in(in_a != flip_a, in_b != flip_b) != flip for in_a, in_b in ((1, 0), (0, 1), (1, 1))]
    chosen = [region for region, is_chosen in zip((inner_a, inner_b), table) if is_chosen]
    # Odd of a, b and their union together is whatever there is to have.
    if table[2] != (table[0] != table[1]):
        chosen = [one for one, is_other in zip((inner_a, inner_b), table) if not is_other]
        chosen.append(_filled("nonzero", inner_a, inner_b))
    result = _filled("even-odd", *chosen)
    return _oplus.complement(result) if flip else result


def _is_point(value):
    if isinstance(value, (list, tuple)):
        return len(value) == 2 and all(isinstance(number, str) or not hasattr(number, "__len__") for number in value)
    return getattr(value, "shape", None) == (2,)


class _Both:
    __array_ufunc__ = None  # so that numpy's arrays leave operators to us

    @property
    def components(self):
        """A list of pairs (outer ring, list of holes), rings as lists of pairs of Fractions, the outer
        ones counterclockwise, without a repeated point. One outer ring of an unbounded region is empty.

        >>> oplus.Region([[0, 0], ['1/3', 0], [0, 1]]).components
        [([(Fraction(0, 1), Fraction(0, 1)), (Fraction(1, 3), Fraction(0, 1)), (Fraction(0, 1), Fraction(1, 1))], [])]
        """
        return _oplus.components(self)

    @property
    def area(self):
        """The area, a Fraction; of an unbounded set, minus that of its complement.

        >>> oplus.Region([[0, 0], [1, 0], [0, 1]]).area
        Fraction(1, 2)
        """
        return _oplus.area(self)

    @property
    def is_unbounded(self):
        """Whether all points far enough away belong to it.

        >>> oplus.complement([[0, 0], [1, 0], [0, 1]]).is_unbounded
        True
        """
        return _oplus.is_unbounded(self)

    @property
    def is_empty(self):
        """Whether no point belongs to it. `bool(set)` is the contrary.

        >>> oplus.Region([]).is_empty, oplus.Region([[0, 0], [1, 0], [0, 1]]).is_empty
        (True, False)
        """
        return not self

    @property
    def bounds(self):
        """The least x and y and the greatest x and y, Fractions; None of an empty set. Raises InvalidInput where
        the set is unbounded.

        >>> oplus.Region([[0, 0], ['1/2', 0], [0, 1]]).bounds
        (Fraction(0, 1), Fraction(0, 1), Fraction(1, 2), Fraction(1, 1))
        """
        if self.is_unbounded:
            raise InvalidInput("region: it is unbounded; expected a bounded region", place="region",
                               wrong="it is unbounded", expected="a bounded region")
        found = _oplus.bounds(self)
        points = [point for edge in getattr(self, "dangling_edges", []) for point in edge]
        points += getattr(self, "isolated_vertices", [])
        points += [found[:2], found[2:]] if found else []
        if not points:
            return None
        x, y = zip(*points)
        return min(x), min(y), max(x), max(y)

    def locate(self, point):
        """Returns 'inside', 'boundary' or 'outside', exactly. Dangling edges and isolated vertices belong to
        the boundary.

        >>> oplus.Region([[0, 0], [1, 0], [0, 1]]).locate(('1/3', '2/3'))
        'boundary'
        """
        return _oplus.locate(self, point)

    def contains(self, value):
        """Whether a point belongs to the set, as `in` says; or all of a region does. Exact. Raises InvalidInput for a
        region where the set is open.

        >>> square = oplus.Region([[0, 0], [2, 0], [2, 2], [0, 2]])
        >>> square.contains((1, 2)), square.contains([[0, 0], [1, 0], [0, 2]]), square.contains([[0, 0], [3, 0], [0, 1]])
        (True, True, False)
        """
        if _is_point(value):
            return value in self
        if getattr(self, "boundary", "closed") == "open":
            raise InvalidInput("geometry: an open set; expected a closed one, such as its region", place="geometry",
                               wrong="an open set", expected="a closed one, such as its region")
        return not Region(value) - getattr(self, "region", self)

    def translated(self, x, y):
        """Returns the set, moved by a vector.

        >>> print(oplus.Region([[0, 0], [1, 0], [0, 1]]).translated('1/2', 2))
        POLYGON ((0.5 2, 1.5 2, 0.5 3, 0.5 2))
        """
        return _oplus.transformed(self, 1, 0, 0, 1, x, y)

    def scaled(self, x, y=None):
        """Returns the set with each x and each y multiplied by a factor, by default both by x; negative ones
        reflect it. Raises InvalidInput if one is zero.

        >>> print(oplus.Region([[0, 0], [1, 0], [0, 1]]).scaled(-1, 1))
        POLYGON ((0 0, 0 1, -1 0, 0 0))
        """
        return _oplus.scaled(self, x, x if y is None else y)

    def rotated(self, degrees, error="1/1000"):
        """Returns the set, rotated counterclockwise about the origin: exactly by multiples of 90 degrees, else
        by an angle with a rational sine and cosine that differs by at most `error` degrees; see rotation.

        >>> print(oplus.Region([[0, 0], [2, 0], [0, 1]]).rotated(90))
        POLYGON ((0 0, 0 2, -1 0, 0 0))
        """
        cosine, sine = _oplus.rotation(degrees, error)
        return _oplus.transformed(self, cosine, -sine, sine, cosine, 0, 0)

    def to_wkt(self, digits=None):
        """Returns WKT: exact, with fractions p/q where a decimal would not end; or rounded to that many
        decimal places, 0 to 4096, as rounded does, which all programs read. Dangling edges and isolated vertices
        are in a collection with the region. Raises ValueError where the set is unbounded.

        >>> oplus.Region([[0, 0], ['1/3', 0], [0, 1]]).to_wkt(digits=2)
        'POLYGON ((0 0, 0.33 0, 0 1, 0 0))'
        """
        return _oplus.to_wkt(self, digits)

    def to_geojson(self, digits=None):
        """Returns GeoJSON, as to_wkt does; fractions are strings.

        >>> oplus.Region([[0, 0], [1, 0], [0, 1]]).to_geojson()
        '{"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [0, 1], [0, 0]]]}'
        """
        return _oplus.to_geojson(self, digits)

    def to_wkb(self):
        """Returns WKB. Raises InvalidInput where a coordinate is not exactly a double, ValueError where the
        set is unbounded.

        >>> oplus.Region(oplus.Region([[0, 0], [1, 0], [0, 1]]).to_wkb()).area
        Fraction(1, 2)
        """
        return bytes.fromhex(_oplus.to_wkb(self))

    def to_dat(self):
        """Returns .dat, which holds unbounded regions, too; exactly. Raises ValueError where the set has dangling
        edges or isolated vertices.

        >>> oplus.complement([[0, 0], [1, 0], [0, 1]]).to_dat()
        '0\\n1\\n3\\n0 0\\n0 1\\n1 0\\n'
        """
        return _oplus.to_dat(self)

    @property
    def __geo_interface__(self):
        return _geojson.interface(getattr(self, "region", self), getattr(self, "dangling_edges", ()),
                                  getattr(self, "isolated_vertices", ()))

    def to_shapely(self):
        """Returns Shapely's geometry, each coordinate the nearest double, so that it may be invalid; that of
        rounded(region, 2**-20), say, is valid and exact. Dangling edges are line strings and isolated vertices
        points, in a collection where there are several parts. Raises InvalidInput where the set is unbounded.

        >>> oplus.ifp([[0, 0], [5, 0], [5, 1], [0, 1]], [[0, 0], [3, 0], [3, 1], [0, 1]]).to_shapely().length
        2.0
        """
        from shapely.geometry import shape
        return shape(self.__geo_interface__)

    def plot(self, ax=None, **options):
        """Draws it by matplotlib into `ax`, by default the current axes, and returns these. Options are those of a
        patch: color, alpha. Open boundaries are dashed, dangling edges and isolated vertices red. Raises
        InvalidInput where the set is unbounded.

        >>> import matplotlib; matplotlib.use('agg')
        >>> axes = oplus.Region([[0, 0], [2, 0], [0, 1]]).plot(color='green')
        >>> axes.patches[-1].get_alpha()
        0.6
        """
        return _drawing.plot(self, ax, options)

    def _repr_svg_(self):
        return _drawing.svg(self)

    def __iter__(self):
        return iter(_oplus.parts(self))

    def __copy__(self):
        return self  # it never changes

    def __deepcopy__(self, memo):
        return self

    def __add__(self, other):
        return _oplus.minkowski_sum(self, other, "closed", False, 1, None)

    __radd__ = __add__

    def __or__(self, other):
        return _combined(self, other, lambda a, b: a or b)

    def __and__(self, other):
        return _combined(self, other, lambda a, b: a and b)

    def __xor__(self, other):
        return _combined(self, other, lambda a, b: a != b)

    def __sub__(self, other):
        return _combined(self, other, lambda a, b: a and not b)

    def __rsub__(self, other):
        return Region(other) - self

    __ror__, __rand__, __rxor__ = __or__, __and__, __xor__


class _Region:
    """A polygonal region with holes: a valid one.

    Region(value) takes an object with __geo_interface__, such a dictionary, text (WKT, GeoJSON and
    others), bytes of WKB, lists of coordinates, or an array of shape (n, 2). Lists are a ring, a list
    of rings (the outer one and the holes), or a list of these. A coordinate is an int, a float, a
    Fraction, a Decimal or text such as '1/3', taken for exactly what it is. Rings may be turned either
    way, and may or may not repeat their first point at the end. Raises InvalidInput where chains
    cross, overlap, or are not one inside the other. Cost: n log n for n vertices.

    A region never changes. It keeps what depends on it alone for the next sum with it. Regions with the same
    points are equal, and have the same hash. They are pickled exactly. `for part in region` yields a region for
    each component.

    `p + q` is the Minkowski sum and `-p` the reflection; `p | q`, `p & q`, `p - q` and `p ^ q` are the
    union, intersection, difference and symmetric difference, of regions alone: exact, and closed, so that
    edges and points in which regions only touch are not in `p & q`. In a notebook a region is a picture.

    >>> triangle = oplus.Region([[0, 0], [1, 0], [0.5, '1/3']])
    >>> triangle
    <oplus.Region: 1 component, 0 holes, 3 vertices>
    >>> print(triangle)
    POLYGON ((0 0, 1 0, 0.5 1/3, 0 0))
    >>> print(triangle + triangle - triangle.translated(0, -1))
    POLYGON ((0 0, 2 0, 1 2/3, 0 0))
    >>> oplus.Region([[0, 0], [2, 2], [2, 0], [0, 2]])
    Traceback (most recent call last):
        ...
    oplus.InvalidInput: region: two edges of outer chain of component 1 cross at (1, 1): edge 1 from (0, 0) to (2, 2) and edge 3 from (2, 0) to (0, 2); expected a simple chain
    """

    def __bool__(self):
        return _oplus.counts(self)[0] > 0

    def __hash__(self):
        return hash(PlanarSet(self))

    def __repr__(self):
        components, holes, vertices = _oplus.counts(self)
        return (f"<oplus.Region: {_counted(components, 'component', 'components')}, "
                f"{_counted(holes, 'hole', 'holes')}, {_counted(vertices, 'vertex', 'vertices')}>")

    def __str__(self):
        return self.to_dat() if self.is_unbounded else self.to_wkt()

    def __reduce__(self):
        return Region, (self.to_dat() if self else [],)


def _restored(region, edges, points, is_open):
    closed = _oplus.planar_set(region, edges, points)
    return _oplus.complement(closed) if is_open else closed


class _PlanarSet:
    """A region, edges and points together, exact: what operations return.

    PlanarSet(value) takes what Region takes, and geometries and text with line strings and points, which
    may overlap. A set never changes. One without dangling edges and isolated vertices is taken wherever
    a region is; of others, `region` is. All closed ones are summands of minkowski_sum. Sets are equal, pickled,
    iterated over, combined by operators and drawn as regions are; pickled without statistics and origins.

    >>> path = oplus.PlanarSet('LINESTRING (0 0, 4 0, 4 3)')
    >>> print(path + [[0, 0], [1, 0], [1, 1], [0, 1]])
    POLYGON ((0 0, 5 0, 5 4, 4 4, 4 1, 0 1, 0 0))

    >>> room = [[[0, 0], [5, 0], [5, 5], [0, 5]], [[1, 1], [1, 4], [4, 4], [4, 1]]]
    >>> oplus.nfp(room, [[0, 0], [3, 0], [3, 1], [0, 1]])
    <oplus.PlanarSet: open, 1 component, 1 dangling edge, 0 isolated vertices>
    """

    @property
    def boundary(self):
        """'closed' or 'open'.

        >>> oplus.nfp([[0, 0], [1, 0], [0, 1]], [[0, 0], [1, 0], [0, 1]]).boundary
        'open'
        """
        return _oplus.boundary(self)

    @property
    def region(self):
        """Its Region, without dangling edges and isolated vertices.

        >>> square = [[0, 0], [1, 0], [1, 1], [0, 1]]
        >>> oplus.minkowski_sum(square, square).region.area
        Fraction(4, 1)
        """
        return _oplus.region(self)

    @property
    def dangling_edges(self):
        """Where one region just fits into the other and can be moved: pairs of points.

        Of an open sum they belong to its complement, of a closed set to the set.

        >>> oplus.ifp([[0, 0], [5, 0], [5, 1], [0, 1]], [[0, 0], [3, 0], [3, 1], [0, 1]]).dangling_edges
        [((Fraction(0, 1), Fraction(0, 1)), (Fraction(2, 1), Fraction(0, 1)))]
        """
        return _oplus.dangling_edges(self)

    @property
    def isolated_vertices(self):
        """Where one region just fits into the other and cannot be moved: points.

        >>> bin = [[0, 0], [100, 0], [100, 100], [0, 100]]
        >>> oplus.ifp(bin, bin).isolated_vertices
        [(Fraction(0, 1), Fraction(0, 1))]
        """
        return _oplus.isolated_vertices(self)

    @property
    def statistics(self):
        """What its computation took, by name: counts, times in seconds, exact values. Empty of what is no sum.

        >>> square = oplus.Region([[0, 0], [1, 0], [1, 1], [0, 1]])
        >>> (square + square).statistics['segments slid along']
        8
        """
        return _oplus.statistics(self)

    @property
    def origins(self):
        """Of a sum with_origins=True: for each edge, of the outer rings, of the holes, then the dangling ones, a
        list of what it is a sum of. ('p', (c, i), (d, j)) is the edge of p that leaves vertex i of its ring c,
        and vertex j of ring d of q; 'q' the reverse. Rings are counted from 0, component by component.

        >>> square = oplus.Region([[0, 0], [1, 0], [1, 1], [0, 1]])
        >>> oplus.minkowski_sum(square, square, with_origins=True).origins[0]
        [('p', (0, 0), (0, 0)), ('q', (0, 0), (0, 1))]
        """
        return _oplus.origins(self)

    def __bool__(self):
        return self != PlanarSet([])

    def __hash__(self):
        return hash((self.region.to_dat(), tuple(self.dangling_edges), tuple(self.isolated_vertices)))

    def __repr__(self):
        return (f"<oplus.PlanarSet: {self.boundary}, {_counted(_oplus.counts(self)[0], 'component', 'components')}, "
                f"{_counted(len(self.dangling_edges), 'dangling edge', 'dangling edges')}, "
                f"{_counted(len(self.isolated_vertices), 'isolated vertex', 'isolated vertices')}>")

    def __str__(self):
        if not self.is_unbounded:
            return self.to_wkt()
        # No format has all of these.
        return repr(self) if self.dangling_edges or self.isolated_vertices else self.to_dat()

    def __reduce__(self):
        is_open = self.boundary == "open"
        closed = _oplus.complement(self) if is_open else self
        return _restored, (closed.region, closed.dangling_edges, closed.isolated_vertices, is_open)


_added(_Both, Region, PlanarSet)
_added(_Region, Region)
_added(_PlanarSet, PlanarSet)
