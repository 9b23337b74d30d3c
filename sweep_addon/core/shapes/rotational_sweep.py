# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The rotational sweep: a contour turned about an axis in its plane, all round or in part, or along a screw."""

from enum import Enum
from math import ceil, copysign, tau

import numpy as np

from ..contours import Fit, Outline, PlanarSet, all_fitted
from ..declared.options import Texture, solid_option
from ..declared.parameters import angle, declared, parameter, proven, require
from ..later import later
from ..rings.ends import Cap, Flat
from ..stations.sampling import Count, Sampling, Tolerance
from .operand import Operand

revolving = later("core.shapes.revolving")

ATTRIBUTES = "UVs and Attributes"
WHOLE = 1e-6  # of a turn: an angle so close to one closes
WIDEST = tau / 3  # of a step: two are no turn
MOST_TURNS = 10_000
PULLEY = ((0.25, -0.4), (1.0, -0.4), (0.7, 0.0), (1.0, 0.4), (0.25, 0.4))


class Crossing(Enum):
    REFUSE = "A contour on both sides of the axis is refused"
    KEEP = "It is swept as it is: the sweep passes through itself on the axis"
    SPLIT = "It is cut along the axis: each side makes a body of its own"
    MEET = "It is cut along the axis, and the two sides meet there: in singular points and non-manifold edges"


@declared
class RotationalSweep(Operand):
    """A contour that turns about an axis in its plane: a solid of revolution, or a screw

    It turns as a right hand does whose thumb shows along the axis. A point of the contour on the axis is one vertex, a
    pole; an edge along the axis leaves nothing. With a pitch the contour rises along the axis as it turns.

    Examples
    --------
    The volume is the area of the contour times the way of its centroid (Pappus), but for the chords of the turn.

    >>> from math import pi, sin, tau
    >>> from sweep_addon.core.stations.sampling import Count
    >>> ring = RotationalSweep(Outline([[(1, 0), (2, 0), (2, 1), (1, 1)]]), samples=Count(12)).mesh()
    >>> round(ring.volume() / (1.5 * tau * sin(tau / 12) / (tau / 12)), 12), ring.euler_characteristic()
    (1.0, 0)
    """

    contour: PlanarSet = parameter(proven(Outline, loops=[PULLEY]), "What turns", accepts=("CURVE", "FONT"))
    angle: float = angle(tau, "How far it turns; a whole turn closes", minimum=-MOST_TURNS * tau,
                         maximum=MOST_TURNS * tau)  # fmt: skip
    pitch: float = parameter(0.0, "How far it rises along the axis in a turn", unit="length")
    samples: Sampling = parameter(Tolerance(), "How many contours stand round the axis")
    axis_point: tuple[float, float] = parameter(
        (0.0, 0.0), "A point of the axis, in the contour's plane", unit="length", group="Axis"
    )
    axis_direction: tuple[float, float] = parameter((0.0, 1.0), "Where the axis runs", group="Axis")
    upright: bool = parameter(False, "Stand the contour's plane upright, its y axis along z", group="Axis")
    crossing: Crossing = parameter(Crossing.REFUSE, "What becomes of a contour that crosses the axis", group="Axis")
    start: Cap = parameter(Flat(), "What closes the start", group="Ends")
    end: Cap = parameter(Flat(), "What closes the end", group="Ends")
    texture: Texture = parameter(Texture.LENGTHS, "How texture coordinates are measured", group=ATTRIBUTES)
    attributes: bool = parameter(True, "Keep u, v and arc_length of each vertex for materials", group=ATTRIBUTES)
    fit: Fit = parameter(Fit.INSCRIBED, "How the mesh stands to the true shape: inscribed, or of the true volume")
    regularize: bool = parameter(False, "Keep only the parts that are solid, closed and manifold")
    make_solid: bool = solid_option()

    def check(self):
        """Refuse no angle or more than a turn without a pitch, an axis without a direction, and too few contours."""
        require(self.angle, "must not be 0", self.angle, "angle")
        once = self.pitch or abs(self.angle) <= tau * (1 + WHOLE)
        require(once, f"must be at most a turn, {tau:.6g}, without a pitch", self.angle, "angle")
        require(any(self.axis_direction), "must have a length", list(self.axis_direction), "axis_direction")
        boxed = self.fit is Fit.CIRCUMSCRIBED
        require(not boxed, "must be inscribed or area-true for a rotational sweep", "circumscribed", "fit")
        if isinstance(self.samples, Count):
            least = ceil(abs(self.turn) / WIDEST - WHOLE) + (not self.closed)
            told = self.samples.contours
            require(told >= least, f"must be at least {least} for this angle", told, "samples.contours")

    @classmethod
    def beside(cls, contour):
        """The sweep of a contour about the y axis or, where that would cross it, about a line along its left side.

        >>> from sweep_addon.core.contours import Circle
        >>> RotationalSweep.beside(Circle(0.5)).axis_point
        (-0.5, 0.0)
        """
        x = np.concatenate([section.points[:, 0] for section in all_fitted(contour, Fit.INSCRIBED)])
        crosses = x.min() < 0 < x.max()
        return cls(contour, axis_point=(float(x.min()), 0.0)) if crosses else cls(contour)

    @property
    def closed(self):
        """Whether the end is the start."""
        return not self.pitch and abs(self.angle) >= tau * (1 - WHOLE)

    @property
    def turn(self):
        """The angle, exactly a turn where it closes."""
        return copysign(tau, self.angle) if self.closed else self.angle

    def mesh(self, dtype=np.float64):
        """The surface as a mesh: closed, manifold and outward unless an end is open.

        Parameters
        ----------
        dtype : numpy dtype
            Of the vertices, which are in metres.

        Returns
        -------
        Mesh

        Raises
        ------
        ShapeError
            Where the contour crosses the axis and that is refused, where it runs along the axis and there is a pitch,
            where its sides are to meet there but sweep the same places, or where there would be too many vertices.

        Examples
        --------
        A ball is a half disc turned round: two poles, and rings of eight between them.

        >>> from sweep_addon.core.stations.sampling import Count
        >>> half = Outline([[(0, -1), (0, 1)]], bulges=[(1, 0)], tolerance=0.1)
        >>> len(half.section().points), RotationalSweep(half, samples=Count(8)).mesh().vertices.shape
        (7, (42, 3))
        """
        if self.make_solid:
            return self.solid().astype(dtype)
        return self.surface(dtype)

    def surface(self, dtype=np.float64):
        """The surface that the contour leaves, also where it meets itself: a `Mesh`."""
        return revolving.surface(self, dtype)

    def bodies(self, dtype=np.float64):
        """The meshes of the sections that turn, each on its own."""
        return revolving.bodies_of(self, dtype)

    def self_intersections(self):
        """Where the sweep meets itself, and up to which size it does not.

        Returns
        -------
        Places
            A sequence of places, empty when the sweep is clean or made a solid, with ``largest_safe_size``.

        Examples
        --------
        A screw whose thread is higher than its pitch, and one whose thread is as high as it is 0.8 times as large:

        >>> thread = Outline([[(1, 0), (2, 0), (2, 0.5), (1, 0.5)]])
        >>> screw = RotationalSweep(thread, angle=4 * tau, pitch=0.4)
        >>> places = screw.self_intersections()
        >>> {place.kind for place in places} <= {"global", "ends"}, round(places.largest_safe_size, 4)
        (True, 0.8)
        """
        from ..self_intersection.places import Places
        from ..self_intersection.screws import of_rotation

        return Places(()) if self.make_solid else of_rotation(self)

    def solid(self, progress=None):
        """The boundary of all points that the contour visits, as one valid solid: each place counts once.

        Parameters
        ----------
        progress : callable, optional
            Is told which part is done, from 0 to 1; what it raises ends the work.

        Returns
        -------
        Mesh
            Closed, manifold and outward, in metres; faces that nothing has cut are as they were. Where the sweep does
            not meet itself it is the surface.

        Raises
        ------
        ShapeError
            For an open surface, a contour that turns too much from sample to sample, or where manifold3d is missing.

        Examples
        --------
        >>> thread = Outline([[(1, 0), (2, 0), (2, 0.5), (1, 0.5)]])
        >>> screw = RotationalSweep(thread, angle=2 * tau, pitch=0.4)
        >>> screw.solid().volume() < screw.surface().volume()
        True
        """
        from ..resolving.of_shapes import about_an_axis  # asks manifold3d

        return about_an_axis(self, progress)

    def sections(self):
        """The sections that turn, x across the axis and y along it: one unless the contour is mixed or is split."""
        return revolving.sections_of(self)

    def frames(self, most=100):
        """The frames and contours at the stations, or at places spread evenly among them.

        Parameters
        ----------
        most : int
            Of places.

        Returns
        -------
        Frames
            The trajectory is that of the contour's centroid.

        Examples
        --------
        >>> from sweep_addon.core.stations.sampling import Count
        >>> frames = RotationalSweep(samples=Count(4)).frames()
        >>> frames.e1[0].tolist(), frames.contours[0].shape
        ([0.0, 0.0, -1.0], (4, 5, 3))
        """
        return revolving.frames(self, most)
