# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Places where a sweep meets itself, in words and numbers."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from math import floor, inf, log10

from ..declared.options import PREFIX
from .folds import TOLD

KINDS = ("local", "corner", "global", "ends")


@dataclass(frozen=True)
class Place:
    """One place where a sweep meets itself.

    Attributes
    ----------
    kind : str
        ``"local"``, where the contour reaches the centre of curvature; ``"corner"``, where a leg is shorter than its
        mitres; ``"global"``, where two stretches meet; ``"ends"``, where a face or a rim at an end meets a stretch.
    parameters : tuple of one or two (float, float)
        From which of the trajectory's parameters to which; where a stretch of a closed trajectory holds its start, the
        first is the larger one. An end is a stretch without length.
    point : (float, float, float)
        A point in space where it meets itself, in metres; of a local one the middle of the trajectory's stretch.
    sentence : str
        The place for people.
    cells : (k, 3) int array
        The faces that cross there, by their first and last ring and their column; none where a stretch folds.
    """

    kind: str
    parameters: tuple
    point: tuple
    sentence: str
    cells: object = field(default=(), compare=False, repr=False)

    def __str__(self):
        return self.sentence


class Places(Sequence):
    """All places where a sweep meets itself, in the order of their kinds and parameters; empty when it is clean.

    Parameters
    ----------
    places : iterable of Place, or callable
        A callable gives those of a sweep that is known to meet itself, and is called once, when they are asked for.
    largest : callable
        Gives the largest safe size; it is called once, when it is asked for.
    unit : str
        What the size is: ``"radius"``, that of the round contour in metres, or ``"scale"`` or ``"radii"``, a factor of
        all scales or radii.
    at_once : bool
        Whether the size is known already, and takes no search.

    Examples
    --------
    >>> from sweep_addon.core.contours import Circle
    >>> from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
    >>> from sweep_addon.core.trajectories import TorusKnot
    >>> knot = TorusKnot(2, 3, major=2.0, minor=0.8)
    >>> found = GeneralizedCylinder(Circle(0.79), knot).self_intersections()
    >>> len(found), round(found.largest_safe_size, 9)
    (0, 0.8)
    >>> print(GeneralizedCylinder(Circle(0.79), knot).self_intersections())
    No self-intersection.
    """

    def __init__(self, places, largest=lambda: inf, unit="scale", at_once=False):
        self.found, self.unit, self.largest, self.at_once = places, unit, largest, at_once

    @cached_property
    def places(self):
        """All of them: a tuple of Place."""
        found = self.found() if callable(self.found) else self.found
        return tuple(sorted(found, key=lambda place: (KINDS.index(place.kind), place.parameters)))

    @cached_property
    def largest_safe_size(self):
        """The size of the contour up to which the sweep is clean, infinite where it always is.

        Of a round contour it is the radius in metres, else the factor by which both scales may be multiplied.

        Examples
        --------
        >>> from sweep_addon.core.contours import Circle
        >>> from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
        >>> from sweep_addon.core.trajectories import Line
        >>> GeneralizedCylinder(Circle(0.5), Line()).self_intersections().largest_safe_size
        inf
        """
        return float(self.largest())

    @property
    def advice(self):
        """The largest safe size for people; empty where there is none."""
        size = self.largest_safe_size
        if not 0 < size < inf:
            none = "No radius is clear of it." if self.unit == "radii" else "No size of the contour is clear of it."
            return "" if size else none
        last = 10.0 ** (floor(log10(size)) - 3)
        safe = f"{floor(size / last * (1 + 1e-9)) * last:.4g}"  # rounded down: what is said is safe
        shown = {"radius": f"radius up to {safe} m", "radii": f"radius multiplied by up to {safe}"}
        shown = shown.get(self.unit, f"contour scaled by up to {safe}")
        return f"A {shown} is clear of it."

    @property
    def told(self):
        """The places as sentences for people, the first few of many, and the largest safe size."""
        shown = self.shown
        return (*shown, self.advice) if shown and self.advice else shown

    @property
    def told_at_once(self):
        """The same without the largest safe size, where that takes a search."""
        return self.told if self.at_once else self.shown

    @property
    def shown(self):
        """The places as sentences for people, the first few of many."""
        shown = tuple(f"{PREFIX}{place}" for place in self.places[:TOLD])
        more = len(self.places) - TOLD
        return (*shown, f"{PREFIX}{more} more places.") if more > 0 else shown

    def in_place_of(self, sentences):
        """What a mesh has told, with all places instead of the folds that it knows of: a tuple of sentences."""
        return (*(said for said in sentences if not said.startswith(PREFIX)), *self.told)

    def __bool__(self):
        return callable(self.found) or bool(self.places)

    def __len__(self):
        return len(self.places)

    def __getitem__(self, which):
        return self.places[which]

    def __repr__(self):
        return f"Places({list(self.places)!r})"

    def __str__(self):
        return "\n".join((*map(str, self.places), self.advice)).strip() if self.places else "No self-intersection."
