# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The PD curve sweep: a contour along a curve of position and direction, a constant cross-section solid."""

import numpy as np

from ..contours import Contour, Rectangle
from ..declared.options import Texture, solid_option
from ..declared.parameters import declared, parameter, proven
from ..later import later
from ..rings.limits import Flat, Limit, Plane
from ..stations.directions import Cubic, Direction, Tilt
from ..stations.sampling import Sampling, Tolerance
from ..trajectories import Bezier, Polyline, Trajectory
from ..variation.morph import AS_THICK
from .generalized_cylinder import ATTRIBUTES
from .operand import Operand

directing = later("core.shapes.directing")

SMOOTH = (proven(Polyline, corner="round"),)
AT_END = (Plane((0, 1, 1), (0, 1, 0)),)  # of the trajectory that there is by default


@declared
class PDCurveSweep(Operand):
    """A contour along a curve of position and direction, its cross-section constant, cut off by planes

    The trajectory is the position p(t) of the PD curve, the direction its d(t). At each place e1 is the unit tangent,
    e2 lies in the plane of the tangent and d, across the tangent and on the side of d, and e3 is across both; the
    contour's own x and y axes lie along e2 and e3. The trajectory must be smooth. What a Blender curve itself says of
    radius does not count, and of tilt only where the direction is ``tilt``.

    Source
    ------
    The lecture's "Constant cross-section objects with PD curves".

    Examples
    --------
    A straight solid between two planes has the volume of its cross-section times the length between them along the axis
    through its centroid.

    >>> from sweep_addon.core.stations.directions import Arrows
    >>> from sweep_addon.core.trajectories import Line
    >>> planes = Plane((0, 0, 0.5), (1, 0, 2)), Plane((0, 0, 3), (-1, 2, 3))
    >>> mesh = PDCurveSweep(Rectangle(0.4, 0.2), Line(end=(0, 0, 4)), Arrows(), *planes).mesh()
    >>> round(mesh.volume() / (0.4 * 0.2 * 2.5), 12), len(mesh.boundary_edges()), mesh.euler_characteristic()
    (1.0, 0, 2)
    """

    contour: Contour = parameter(
        Rectangle(0.3, 0.1), "What moves: a closed outline", others=AS_THICK, accepts=("CURVE", "FONT")
    )
    trajectory: Trajectory = parameter(
        proven(Bezier), "The position p(t): the path of the contour", others=SMOOTH, accepts=("CURVE",)
    )
    direction: Direction = parameter(
        Cubic(), "The direction d(t), to which the contour's x axis points", accepts=("CURVE", "EMPTY")
    )
    start: Limit = parameter(Flat(), "What limits the solid at the start", group="Limits", accepts=("EMPTY",))
    end: Limit = parameter(
        Flat(), "What limits the solid at the end", others=AT_END, group="Limits", accepts=("EMPTY",)
    )
    samples: Sampling = parameter(Tolerance(), "How many contours stand along the trajectory")
    texture: Texture = parameter(Texture.LENGTHS, "How texture coordinates are measured", group=ATTRIBUTES)
    attributes: bool = parameter(True, "Keep u, v and arc_length of each vertex for materials", group=ATTRIBUTES)
    make_solid: bool = solid_option()

    def mesh(self, dtype=np.float64):
        """The surface as a mesh: closed, manifold and outward unless an end is open.

        Parameters
        ----------
        dtype : numpy dtype
            Of the vertices, which are in metres; single precision is what Blender keeps.

        Returns
        -------
        Mesh

        Raises
        ------
        ShapeError
            Where the trajectory has a corner, where the direction is not defined and that is to be refused, where a
            plane does not cut the line of every point of the contour once, where planes cross within the solid, or
            where there would be too many vertices.

        Examples
        --------
        >>> from sweep_addon.core.stations.sampling import Count
        >>> mesh = PDCurveSweep(samples=Count(10)).mesh()
        >>> mesh.vertices.shape, mesh.vertices.dtype.name, len(mesh.boundary_edges())
        ((40, 3), 'float64', 0)
        """
        if self.make_solid:
            return self.solid().astype(dtype)
        return self.surface(dtype)

    def surface(self, dtype=np.float64):
        """The surface that the contour leaves, also where it meets itself: a `Mesh`."""
        return directing.surface(self, dtype)

    def self_intersections(self):
        """Where the solid meets itself, and up to which size it does not.

        Returns
        -------
        Places
            A sequence of places, empty when the sweep is clean or made a solid, with ``largest_safe_size``.

        Source
        ------
        As of a generalized cylinder; between limiting planes what they leave is looked at, on the faces of the mesh. A
        larger contour is measured with its faces at the planes scaled along.

        Examples
        --------
        >>> from sweep_addon.core.stations.directions import Arrows
        >>> from sweep_addon.core.trajectories import Arc
        >>> found = PDCurveSweep(Rectangle(0.2, 0.8), Arc(radius=0.3), Arrows([(0, 0, 0, 1)])).self_intersections()
        >>> [place.kind for place in found], round(found.largest_safe_size, 9)
        (['local'], 0.75)
        """
        from ..self_intersection.pd_curves import of_pd_curve
        from ..self_intersection.places import Places

        return Places(()) if self.make_solid else of_pd_curve(self)

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
        >>> from sweep_addon.core.stations.directions import Arrows
        >>> from sweep_addon.core.trajectories import Arc
        >>> sweep = PDCurveSweep(Rectangle(0.2, 0.8), Arc(radius=0.3), Arrows([(0, 0, 0, 1)]))
        >>> sweep.solid().volume() > sweep.surface().volume()
        True
        """
        from ..resolving.of_shapes import along_a_trajectory  # asks manifold3d

        return along_a_trajectory(self, progress)

    @classmethod
    def along_curve(cls):
        """The sweep that follows a drawn curve first, whose own tilt is the direction."""
        return cls(direction=Tilt())

    def bend(self, points):
        """Points of a straight model where the curved axis takes them: a nonlinear transformation of the model.

        Parameters
        ----------
        points : (n, 3) float array
            In metres: x along e2, y along e3 and z along the axis, from 0 at its start.

        Returns
        -------
        (n, 3) float array
            In metres. Before the start and after the end of the trajectory the axis goes on straight; a closed one
            begins again.

        Raises
        ------
        ShapeError
            Where points are no finite numbers, three in a row, and where the shape itself would be refused.

        Examples
        --------
        A straight solid that two planes have cut off, bent to a right angle:

        >>> from sweep_addon.core.stations.directions import Arrows
        >>> from sweep_addon.core.trajectories import Arc, Line
        >>> oblique = Plane((0, 0, 1.5), (1, 0, 1))
        >>> straight = PDCurveSweep(trajectory=Line(end=(0, 0, 2)), direction=Arrows(), end=oblique)
        >>> elbow = PDCurveSweep(trajectory=Arc(4 / np.pi, np.pi / 2), direction=Arrows([(0, 0, 0, 1)]))
        >>> elbow.bend(straight.mesh().vertices).shape, elbow.bend([(0, 0, 2)]).round(6).tolist()
        ((8, 3), [[0.0, 1.27324, 0.0]])
        """
        return directing.bend(self, points)

    def frames(self, most=100):
        """The frames and contours at places spread evenly along the trajectory, whatever limits the solid.

        Parameters
        ----------
        most : int
            Of places; where the trajectory is short they are no closer than the contour is large.

        Returns
        -------
        Frames

        Examples
        --------
        >>> from sweep_addon.core.stations.directions import Arrows
        >>> from sweep_addon.core.trajectories import Line
        >>> frames = PDCurveSweep(Rectangle(1, 1), Line(end=(0, 0, 2)), Arrows()).frames()
        >>> frames.points[:, 2].round(12).tolist(), frames.e2[0].tolist(), frames.contours[0].shape
        ([0.0, 1.0, 2.0], [1.0, 0.0, 0.0], (3, 4, 3))
        """
        return directing.frames(self, most)
