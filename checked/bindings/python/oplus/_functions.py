# SPDX-License-Identifier: MIT
"""Functions of one pair of sets, and of one set."""

from . import _oplus, _progress
from ._results import Reason, Rounded, Verdict
from ._sets import PlanarSet, Region


def minkowski_sum(p, q, *, boundary="closed", threads=1, with_origins=False, progress=None):
    """Returns the Minkowski sum, the set of all p + q, exactly.

    p, q: whatever Region or PlanarSet takes. boundary: 'closed', or 'open' for the sum of the
    interiors, which has dangling edges and isolated vertices. threads: 0 for all cores. with_origins: whether
    the result has origins. progress: called with the numbers of segments that are done and of all, ten times a
    second, on any thread; or a bar of tqdm. What it raises ends the sum.

    >>> print(oplus.minkowski_sum([[0, 0], [2, 0], [0, 2]], [[0, 0], [1, 0], [1, 1], [0, 1]]))
    POLYGON ((0 0, 3 0, 3 1, 1 3, 0 3, 0 0))
    """
    if progress is None:
        return _oplus.minkowski_sum(p, q, boundary, with_origins, threads, None)
    with _progress.reported(progress) as told:
        return _oplus.minkowski_sum(p, q, boundary, with_origins, threads, told)


def _operation(name, p, q, threads, progress):
    with _progress.reported(progress) as told:
        return _oplus.operation(name, p, q, threads, told)


def nfp(p, q, *, threads=1, progress=None):
    """Returns the no-fit polygon of p and q: where q + x overlaps p. It is an open set.
    On its boundary, with dangling edges and isolated vertices, the two only touch. p and q may also have line strings
    and points: then it is where one of them meets the interior of the other. Options are those of minkowski_sum.

    >>> square = [[0, 0], [1, 0], [1, 1], [0, 1]]
    >>> print(oplus.nfp(square, square))
    POLYGON ((-1 -1, 1 -1, 1 1, -1 1, -1 -1))
    >>> print(oplus.nfp(square, 'LINESTRING (0 0, 2 0)'))
    POLYGON ((-2 0, 1 0, 1 1, -2 1, -2 0))
    """
    return _operation("nfp", p, q, threads, progress)


def ifp(p, q, *, threads=1, progress=None):
    """Returns the inner-fit polygon of p and q: where q + x is inside p. It is a closed set.
    Where q fits exactly there are dangling edges and isolated vertices.

    >>> bin = [[0, 0], [100, 0], [100, 100], [0, 100]]
    >>> print(oplus.ifp(bin, bin))
    GEOMETRYCOLLECTION (POINT (0 0))
    """
    return _operation("ifp", p, q, threads, progress)


def erode(p, q, *, threads=1, progress=None):
    """Returns the erosion of p by q: ifp without edges and points.

    >>> square = [[0, 0], [1, 0], [1, 1], [0, 1]]
    >>> print(oplus.erode([[0, 0], [3, 0], [3, 2], [0, 2]], square))
    POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))
    """
    return _operation("erode", p, q, threads, progress)


def open(p, q, *, threads=1, progress=None):
    """Returns the opening of p by q: all q + x inside p, together.

    >>> square = [[0, 0], [1, 0], [1, 1], [0, 1]]
    >>> print(oplus.open([[0, 0], [3, 0], [3, '1/2'], [2, '1/2'], [2, 2], [0, 2]], square))
    POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))
    """
    return _operation("open", p, q, threads, progress)


def close(p, q, *, threads=1, progress=None):
    """Returns the closing of p by q: the erosion of their sum by q. It contains p.

    >>> square = [[0, 0], [1, 0], [1, 1], [0, 1]]
    >>> notched = [[0, 0], [3, 0], [3, 2], [2, 2], [2, 1], ['3/2', 1], ['3/2', 2], [0, 2]]
    >>> print(oplus.close(notched, square))
    POLYGON ((0 0, 3 0, 3 2, 0 2, 0 0))
    """
    return _operation("close", p, q, threads, progress)


def complement(value):
    """Returns the complement: of a region a Region, of a PlanarSet a PlanarSet, closed of an open one, and
    the reverse.

    >>> outside = oplus.complement([[0, 0], [1, 0], [0, 1]])
    >>> (5, 5) in outside
    True
    """
    return _oplus.complement(value if isinstance(value, PlanarSet) else Region(value))


def distance(p, q):
    """Returns (the squared distance, a point of p, a point of q): exact ones, as near to each other as any.
    The squared distance is 0 where p and q overlap or touch. Raises InvalidInput where one is empty.

    >>> square = [[0, 0], [1, 0], [1, 1], [0, 1]]
    >>> oplus.distance(square, oplus.Region(square).translated(3, '3/2'))
    (Fraction(17, 4), (Fraction(1, 1), Fraction(1, 1)), (Fraction(3, 1), Fraction(3, 2)))
    """
    return _oplus.distance(p, q)


def depth(p, q):
    """Returns (move, its squared length, contact): a shortest move of q after which it overlaps p no longer,
    and a point in which the two touch then; None where they don't overlap. Raises InvalidInput where they
    overlap wherever q is.

    >>> square = [[0, 0], [4, 0], [4, 4], [0, 4]]
    >>> oplus.depth(square, [[1, 3], [3, 3], [3, 6], [1, 6]])
    ((Fraction(0, 1), Fraction(1, 1)), Fraction(1, 1), (Fraction(1, 1), Fraction(4, 1)))
    """
    return _oplus.depth(p, q)


class Placements:
    """A pair of regions for many places of q.

    Placements(p, q) computes their no-fit polygon once; options are those of nfp. q + x is q moved by x.

    >>> square = [[0, 0], [1, 0], [1, 1], [0, 1]]
    >>> oplus.Placements(square, square).locate((3, 0))
    'outside'
    """

    __module__ = "oplus"

    def __init__(self, p, q, *, threads=1, progress=None):
        self._pair = Region(p), Region(q)
        with _progress.reported(progress) as told:
            self._at = _oplus.Placements(*self._pair, threads, told)

    def __reduce__(self):
        return Placements, self._pair

    @property
    def no_fit(self):
        """The no-fit polygon, as nfp returns it.

        >>> square = [[0, 0], [1, 0], [1, 1], [0, 1]]
        >>> print(oplus.Placements(square, square).no_fit)
        POLYGON ((-1 -1, 1 -1, 1 1, -1 1, -1 -1))
        """
        return self._at.no_fit()

    def locate(self, x):
        """Returns 'inside' where q + x overlaps p, 'boundary' where they only touch, else 'outside'.

        >>> square = [[0, 0], [1, 0], [1, 1], [0, 1]]
        >>> at = oplus.Placements(square, square)
        >>> at.locate((0, 0)), at.locate((1, '1/2')), at.locate((2, 0))
        ('inside', 'boundary', 'outside')
        """
        return self._at.locate(x)

    def depth(self, x):
        """Returns depth(p, q + x).

        >>> square = [[0, 0], [1, 0], [1, 1], [0, 1]]
        >>> move, squared_depth, contact = oplus.Placements(square, square).depth(('1/2', '1/4'))
        >>> move, squared_depth
        ((Fraction(1, 2), Fraction(0, 1)), Fraction(1, 4))
        """
        return self._at.depth(x)

    def distance(self, x):
        """Returns distance(p, q + x).

        >>> square = [[0, 0], [1, 0], [1, 1], [0, 1]]
        >>> oplus.Placements(square, square).distance((3, 2))
        (Fraction(5, 1), (Fraction(1, 1), Fraction(1, 1)), (Fraction(3, 1), Fraction(2, 1)))
        """
        return self._at.distance(x)

    @property
    def __geo_interface__(self):
        return self.no_fit.__geo_interface__


def verify(p, q, given, *, boundary=None):
    """Decides whether `given` is the sum of p and q, by the definitions and by no engine. It is a PlanarSet or
    whatever Region takes, or what would be invalid: chains of geometries and lists may cross. boundary:
    'closed' or 'open'; None: that of a PlanarSet, closed for others. Raises InvalidInput where a region is
    unbounded.

    >>> square = [[0, 0], [1, 0], [1, 1], [0, 1]]
    >>> verdict = oplus.verify(square, square, [[0, 0], [2, 0], [2, 2], [1, 2], [0, 1]])
    >>> bool(verdict), verdict.reasons
    (False, [<oplus.Reason: in the sum but not given>])
    """
    reasons, notes = _oplus.verify(p, q, given, boundary)
    return Verdict([Reason(*one) for one in reasons], notes)


def certify(p, q, given, *, boundary=None):
    """Returns the text of a certificate that `given` is the sum of p and q, for the program
    oplus-certified, which is proved. It reads p, q and `given` as files, with chains and vertices in
    the same order: what to_wkt returns. `given` and `boundary` are whatever verify takes. Raises InvalidInput,
    with the first reason of verify, where it is not the sum.

    >>> square = oplus.Region([[0, 0], [1, 0], [1, 1], [0, 1]])
    >>> certificate = oplus.certify(square, square, oplus.minkowski_sum(square, square))
    >>> certificate.splitlines()[0]
    'oplus certificate 2'
    """
    return _oplus.certify(p, q, given, boundary)


def rounded(value, step, side="nearest"):
    """Returns a Rounded: a valid set whose coordinates are multiples of `step`, and how far it is from the
    exact one. value: a PlanarSet, or whatever Region takes. side: 'nearest', 'contain' for a set that
    contains it, 'contained' for one that is contained in it. Steps 2**-k give exact doubles.

    >>> third = oplus.rounded([[0, 0], ['1/3', 0], [0, 1]], '0.01')
    >>> print(third.sum, third.bound)
    POLYGON ((0 0, 0.33 0, 0 1, 0 0)) 1/200
    """
    return Rounded(*_oplus.rounded(value, step, side))


def repair(value, fill=None):
    """Returns (Region, list of what was done): repeated vertices, spikes and chains that enclose nothing
    are left out. Where chains still cross or overlap: what they enclose by the rule fill='even-odd' or
    'nonzero', else InvalidInput is raised. value: text, or whatever Region takes.

    >>> region, mends = oplus.repair([[0, 0], [2, 2], [2, 0], [0, 2]], fill='even-odd')
    >>> region.area
    Fraction(2, 1)
    """
    return _oplus.repair(value, fill)


def read_file(path):
    """Returns the Region in a file, in any format that oplus reads. Raises InvalidInput.

    >>> oplus.read_file('missing.wkt')
    Traceback (most recent call last):
        ...
    oplus.InvalidInput: missing.wkt: cannot be opened (No such file or directory); expected a file that can be read
    """
    return _oplus.read_file(path)


def read_set_file(path):
    """Returns the PlanarSet in a file, with its line strings and points. Raises InvalidInput.

    >>> oplus.read_set_file('missing.wkt')
    Traceback (most recent call last):
        ...
    oplus.InvalidInput: missing.wkt: cannot be opened (No such file or directory); expected a file that can be read
    """
    return _oplus.read_set_file(path)


def disc(radius, side, error):
    """Returns a convex polygon inside or around the disc about the origin, at most `error` away from it.
    side: 'inside' or 'outside'. Its sum with a region is an offset. Raises InvalidInput for an `error`
    that needs more than 1000000 vertices.

    >>> (1, 0) in oplus.disc(1, 'outside', '0.01')
    True
    """
    return _oplus.disc(radius, side, error)


def rotation(degrees, error="1/1000"):
    """Returns the exact cosine and sine that Region.rotated takes: Fractions. `error` is in degrees, and
    positive.

    >>> oplus.rotation(90)
    (Fraction(0, 1), Fraction(1, 1))
    >>> cosine, sine = oplus.rotation(30, 1)
    >>> cosine**2 + sine**2
    Fraction(1, 1)
    """
    return _oplus.rotation(degrees, error)
