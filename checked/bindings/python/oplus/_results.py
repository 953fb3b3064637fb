# SPDX-License-Identifier: MIT
"""Small values that functions return."""

from dataclasses import dataclass
from fractions import Fraction

from . import _geojson
from ._sets import PlanarSet


@dataclass(frozen=True)
class Rounded:
    """What rounded returns: `sum`, the PlanarSet on the grid; `is_exact`, whether nothing had to be rounded; `bound`,
    how far boundaries are from each other at most, in x and in y; `changes`, how many components and holes vanished,
    became one or came apart: those that are not zero, by name."""

    sum: PlanarSet
    is_exact: bool
    bound: Fraction
    changes: dict

    @property
    def __geo_interface__(self):
        return self.sum.__geo_interface__


@dataclass(frozen=True)
class Reason:
    """A difference between a set and the sum: its `kind` in words, such as 'missing hole'; `witness`, a point that
    shows it, whether it is `in_sum` and `in_given`; and `detail`, a line that says where."""

    kind: str
    witness: tuple
    in_sum: bool
    in_given: bool
    detail: str

    @property
    def __geo_interface__(self):
        return {"type": "Point", "coordinates": _geojson.position(self.witness)}

    def __repr__(self):
        return f"<oplus.Reason: {self.kind}>"


@dataclass(frozen=True)
class Verdict:
    """What verify returns. True where the set is the sum. `reasons`: why it is not, a list of Reason; `notes`: what is
    unusual and changes nothing."""

    reasons: list
    notes: list

    @property
    def is_sum(self):
        """Whether the given set is the sum."""
        return not self.reasons

    def __bool__(self):
        return self.is_sum

    @property
    def __geo_interface__(self):
        return {"type": "GeometryCollection", "geometries": tuple(one.__geo_interface__ for one in self.reasons)}

    def __repr__(self):
        count = len(self.reasons)
        return f"<oplus.Verdict: {count} reason{'s' * (count > 1)}>" if count else "<oplus.Verdict: it is the sum>"


for _class in (Rounded, Reason, Verdict):
    _class.__module__ = "oplus"
