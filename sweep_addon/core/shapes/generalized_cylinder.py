# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The generalized cylinder: G(u, v) = t(u) + (ox(u) + Sx(u) cx(v)) e2(u) + (oy(u) + Sy(u) cy(v)) e3(u)."""

import numpy as np

from ..contours import Circle, Contour, Fit
from ..declared.options import Texture, solid_option
from ..declared.parameters import angle, declared, parameter
from ..later import later
from ..rings.ends import End, Flat
from ..stations.frames import Frame, RotationMinimizing
from ..stations.sampling import Sampling, Tolerance
from ..trajectories import Helix, Trajectory
from ..variation.laws import Law
from ..variation.morph import AS_THICK, Blend, Match, Morph
from ..variation.rail import Guided, Rail
from .operand import Operand

carrying = later("core.shapes.carrying")

ATTRIBUTES = "UVs and Attributes"


@declared
class GeneralizedCylinder(Operand):
    """A contour that moves along a trajectory, scaled, turned and moved aside on the way

    The contour's own x and y axes lie along e2 and e3 of the trajectory's frame. Its origin, the reference point, is on
    the trajectory, or beside it by the offsets: they are measured along e2 and e3 as twist has turned them, and no
    scale stretches them. So a constant offset and an even twist carry the contour round the trajectory on a helix.

    Source
    ------
    The lecture's G(u, n) = t(u) + Sx(u) cx(n) e2(u) + Sy(u) cy(n) e3(u), where the offset is 0.

    Examples
    --------
    A tube's volume is the area of its contour times the length of its trajectory (Weyl's tube formula).

    >>> from sweep_addon.core.trajectories import Line
    >>> mesh = GeneralizedCylinder(Circle(0.5, points=64), Line(end=(0, 0, 2))).mesh()
    >>> round(mesh.volume() / (Circle(0.5, points=64).section().area * 2), 12)
    1.0
    >>> len(mesh.boundary_edges()), mesh.euler_characteristic()
    (0, 2)
    """

    contour: Contour = parameter(
        Circle(0.1), "What moves: a closed outline", others=AS_THICK, accepts=("CURVE", "FONT")
    )
    trajectory: Trajectory = parameter(Helix(), "The path along which it moves", accepts=("CURVE",))
    samples: Sampling = parameter(Tolerance(), "How many contours stand along the trajectory")
    frame: Frame = parameter(RotationMinimizing(), "The axes that carry the contour", group="Frame")
    scale_x: Law = parameter(1.0, "Scale along e2", group="Along the Path")
    scale_y: Law = parameter(1.0, "Scale along e3", group="Along the Path")
    twist: Law = angle(0.0, "Turn about the tangent", group="Along the Path")
    offset_x: Law = parameter(0.0, "Offset from the path along e2", unit="length", group="Along the Path")
    offset_y: Law = parameter(0.0, "Offset from the path along e3", unit="length", group="Along the Path")
    start: End = parameter(Flat(), "What closes the start", group="Ends")
    end: End = parameter(Flat(), "What closes the end", group="Ends")
    morph: tuple[Morph, ...] = parameter((), "What the contour becomes on the way", most=100, group="Morph")
    match: Match = parameter(Match.BY_ARC_LENGTH, "Which points of the contours belong together", group="Morph")
    blend: Blend = parameter(Blend.LINEAR, "How one contour becomes the next", group="Morph")
    rails: tuple[Rail, ...] = parameter((), "One turns the contour, two also set its width", most=2, group="Rails")
    guided: Guided = parameter(Guided.EVENLY, "How two rails scale the contour", group="Rails")
    texture: Texture = parameter(Texture.LENGTHS, "How texture coordinates are measured", group=ATTRIBUTES)
    attributes: bool = parameter(True, "Keep u, v and arc_length of each vertex for materials", group=ATTRIBUTES)
    fit: Fit = parameter(Fit.INSCRIBED, "How the mesh stands to the true shape")
    make_solid: bool = solid_option()

    def mesh(self, dtype=np.float64):
        """The surface as a mesh: closed, manifold and outward unless an end is open.

        Parameters
        ----------
        dtype : numpy dtype
            Of the vertices, which are in metres; single precision is what Blender keeps and takes half the time.

        Returns
        -------
        Mesh

        Raises
        ------
        ShapeError
            Where a law is not finite or leaves no area, or where there would be too many vertices.

        Examples
        --------
        >>> from sweep_addon.core.stations.sampling import Count
        >>> mesh = GeneralizedCylinder(Circle(0.1, points=16), samples=Count(10)).mesh()
        >>> mesh.vertices.shape, mesh.vertices.dtype.name, len(mesh.boundary_edges())
        ((160, 3), 'float64', 0)
        """
        if self.make_solid:
            return self.solid().astype(dtype)
        return self.surface(dtype)

    def surface(self, dtype=np.float64, empty=np.empty):
        """The surface that the contour leaves, also where it meets itself: a `Mesh`.

        Its vertices are drawn, when nothing can be refused any more, into what ``empty`` gives for a number of
        coordinates and a dtype.
        """
        return carrying.surface(self, dtype, empty)

    def self_intersections(self):
        """Where the sweep meets itself, and up to which size it does not.

        Returns
        -------
        Places
            A sequence of places, empty when the sweep is clean or made a solid, with ``largest_safe_size``.

        Source
        ------
        A round tube along a smooth trajectory is clean up to its reach (`sweep_addon.reach`), and what its ends leave
        of that: decided of the true shape, however coarse the mesh. Of other shapes the local test is that of the true
        shape, and the global one is decided on the faces of the mesh.

        Examples
        --------
        A pipe round a bend that is tighter than the pipe is thick:

        >>> from sweep_addon.core.trajectories import Arc
        >>> found = GeneralizedCylinder(Circle(0.5), Arc(radius=0.3)).self_intersections()
        >>> [place.kind for place in found], round(found.largest_safe_size, 9)
        (['local'], 0.3)
        """
        from ..self_intersection.cylinders import of_cylinder
        from ..self_intersection.places import Places

        return Places(()) if self.make_solid else of_cylinder(self)

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
        A disc turned about an axis inside it visits a spindle, and what both its sides visit once:

        >>> from math import pi
        >>> from sweep_addon.core.stations.sampling import Count
        >>> from sweep_addon.core.trajectories import Arc
        >>> spindle = GeneralizedCylinder(Circle(0.5, points=32), Arc(0.3, 2 * pi), Count(64))
        >>> round(spindle.solid().volume(), 3), spindle.solid().euler_characteristic()
        (1.525, 2)
        """
        from ..resolving.of_shapes import of_cylinder  # asks manifold3d

        return of_cylinder(self, progress)

    def swept(self, stations=None):
        """All that the mesh is drawn from: a `Swept`, with contours at its own stations or at others."""
        return carrying.swept(self, stations)

    def moving(self):
        """The section that starts the sweep, and how it changes: a `Changing`, or None."""
        return carrying.moving(self)

    def laid_out(self, section, change, ends):
        """The laws of the sweep, in how many turns they leave the section as it is, its reach, and what is to be told.

        The reach is that of the section's farthest point from the reference point, in metres, before any scale.
        """
        return carrying.laid_out(self, section, change, ends)

    def frames(self, most=100):
        """The frames and contours at places spread evenly along the trajectory.

        Parameters
        ----------
        most : int
            Of places; where the trajectory is short they are no closer than the contour is large.

        Returns
        -------
        Frames

        Examples
        --------
        >>> from sweep_addon.core.trajectories import Line
        >>> frames = GeneralizedCylinder(Circle(0.5), Line(end=(0, 0, 2))).frames()
        >>> frames.points[:, 2].tolist(), frames.e1[0].tolist(), frames.contours[0].shape
        ([0.0, 0.5, 1.0, 1.5, 2.0], [0.0, 0.0, 1.0], (5, 64, 3))
        """
        return carrying.frames(self, most)
