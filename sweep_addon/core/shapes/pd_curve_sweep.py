# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The PD curve sweep: a contour along a curve of position and direction, a constant cross-section solid."""

from dataclasses import replace
from functools import lru_cache
from math import radians

import numpy as np

from ..contours import Contour, Fit, Rectangle
from ..declared.options import Texture, solid_option
from ..declared.parameters import Array, ShapeError, at, declared, parameter, proven, require
from ..declared.wording import shown
from ..later import later
from ..rings.limits import Flat, Limit, Open, Plane
from ..stations.directions import Cubic, Direction, Tilt
from ..stations.frames import Frames, require_several, turn
from ..stations.sampling import Count, Sampling, Tolerance, place
from ..trajectories import Bezier, Polyline, Trajectory
from ..variation.morph import AS_THICK
from ..vectors import norms
from .generalized_cylinder import ATTRIBUTES
from .operand import Operand

caps, cells = later("core.rings.caps"), later("core.stations.cells")
Bending, Rings = later("core.stations.bending", "Bending", "Rings")
Chart, lengths_around = later("core.grids.chart", "Chart", "lengths_around")
affine, drawn = later("core.grids.drawn", "affine", "drawn")
Grid = later("core.grids.grid", "Grid")
Mesh, require_few = later("core.meshes.mesh", "Mesh", "require_few")
section_of = later("core.contours.section", "section_of")
folds_told, running_backward = later("core.self_intersection.folds", "folds_told", "running_backward")
told_backward = later("core.rings.steps", "told_backward")
arc_length = later("core.trajectories.arc_length", "arc_length")

SMOOTH = (proven(Polyline, corner="round"),)
AT_END = (Plane((0, 1, 1), (0, 1, 0)),)  # of the trajectory that there is by default
COARSE, FINEST = 1e-3, 1e-6  # of the contour: how far from the cut the edge of a cap may be where samples do not say
CORNER = radians(1)  # a turn of less leaves the cross-section constant to a 25,000th


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
        >>> mesh = PDCurveSweep(samples=Count(10)).mesh()
        >>> mesh.vertices.shape, mesh.vertices.dtype.name, len(mesh.boundary_edges())
        ((40, 3), 'float64', 0)
        """
        if self.make_solid:
            return self.solid().astype(dtype)
        return self.surface(dtype)

    def surface(self, dtype=np.float64):
        """The surface that the contour leaves, also where it meets itself: a `Mesh`."""
        section, bending, stations, told = self.laid_out()
        rings = self.rings(section, bending, stations)
        section = rings.section
        grid = Grid(
            rings=len(rings.s),
            tips=(),
            closed=stations.closed,
            creases=(),
            offsets=tuple(section.offsets.tolist()),
            sharp=tuple(np.flatnonzero(section.sharp).tolist()),
            caps=tuple(
                caps.faces(end) if end.closed and not (stations.closed or isinstance(limit, Open)) else None
                for limit, end in zip((self.start, self.end), rings.ends, strict=True)
            ),
            gaps=tuple(section.gaps.tolist()),
        )
        vertices = drawn(grid, affine(section.points), rings.axes, dtype)
        flat, around = tuple(end.points for end in rings.ends), lengths_around(section, np.ones(2))
        chart = grid, rings.u, rings.s, stations.total, around, flat, self.texture, self.attributes
        if not any(rings.leaning):
            return Mesh(vertices, grid.topology(), Chart(*chart), told)
        from ..grids.leaning import Leaning, standing

        columns = vertices.reshape(len(section.points), -1, 3)
        for own, which in standing(rings.leaning, len(rings.s)):
            for axis in range(3):  # so NumPy goes along the rings, and not three numbers at a time
                columns[:, which, axis] = rings.lines[:, axis, own]
        return Mesh(vertices, grid.topology(), Leaning(*chart, rings.leaning, rings.heights, rings.lines[:, 3]), told)

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

    def laid_out(self):
        """The section, the bending of the axis, its stations, and what is to be told.

        Where the contour is beyond the centre of curvature everywhere, and so runs backward, it is seen in a mirror.
        """
        section, told = section_of(self.contour, Fit.INSCRIBED), ()
        with at("trajectory"):
            total = arc_length(self.trajectory).total
            require_smooth(self.trajectory)
        if self.trajectory.closed and any(isinstance(limit, Plane) for limit in (self.start, self.end)):
            told = ("Limits: a closed trajectory has no ends, so no plane cuts anything off.",)
        bending = Bending(self.trajectory, self.direction, total)
        reach = 0.0 if isinstance(self.samples, Count) else float(np.linalg.norm(section.points, axis=1).max())
        with at("direction"):
            stations = stand(self.samples, self.trajectory, self.direction, reach)
            axis = bending.placed(stations)
        rings = bending.axes(stations)
        backward = running_backward(stations, rings, section.centroid, False)
        told += told_backward(stations) + folds_told(
            stations, np.zeros_like(axis.points), axis.e2, axis.e3, section.support
        )
        told += axis.told
        if backward:
            section, bending = section.mirrored, replace(bending, mirrored=True)
        return section, bending, stations, told

    def rings(self, section, bending, stations):
        """The rings between the limits: `Rings`."""
        limits = self.start, self.end
        if stations.closed or not any(isinstance(limit, Plane) for limit in limits):
            require_few(len(section.points) * len(stations.s), "samples")
            return Rings(section, stations.u, stations.s, bending.axes(stations), (section, section))
        from ..rings.trimming import trimmed  # most sweeps have no plane, and Blender starts a little sooner without

        size = float(np.abs(section.points).max())
        chord = COARSE * size if isinstance(self.samples, Count) else self.samples.chord
        return trimmed(limits, bending, section, stations, max(chord, FINEST * size))

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
        try:
            points = Array(points).values
        except (TypeError, ValueError):
            raise ShapeError(f"must be rows of 3 numbers, got {shown(points)}", "points") from None
        require(points.ndim == 2 and points.shape[1] == 3, "must be (n, 3)", points.shape, "points")
        require(np.isfinite(points).all(), "must be finite", points[~np.isfinite(points)][:1].tolist(), "points")
        _, bending, _, _ = self.laid_out()
        return replace(bending, mirrored=False).bend(points)

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
        require_several(most)
        section, bending, _, _ = self.laid_out()
        steps = bending.total / float(np.linalg.norm(section.points, axis=1).max())
        stations = place(self.trajectory, Count(int(np.clip(steps + (not self.trajectory.closed), 2, most))))
        axis, rings = bending.placed(stations), bending.axes(stations)
        loops = tuple(np.split(np.einsum("mk,kni->nmi", affine(section.points), rings), section.offsets[1:-1], axis=1))
        return Frames(stations.u, stations.s, axis.points, axis.e1, axis.e2, axis.e3, loops)


@lru_cache(maxsize=16)
def require_smooth(trajectory):
    """Refuse corners that can be seen: handles in single precision are not quite in line."""
    corners = trajectory.corners()
    reached = np.where(corners == trajectory.domain[0], trajectory.domain[1], corners)
    turns = norms(trajectory.tangents(corners) - trajectory.tangents(reached, before=True))
    seen = corners[turns > CORNER]
    if len(seen):
        raise ShapeError(f"must be smooth, or its corners round, got a corner at u = {seen[0]:.6g}")


@lru_cache(maxsize=16)
def stand(samples, trajectory, direction, reach):
    """The stations of a sweep, close enough for the turning of its frame too; the same for contours of one reach."""

    def steps(s, u, chord):
        rate = np.gradient(np.interp(s, *turn(direction, trajectory)), s)
        return np.maximum(np.sqrt(reach * rate**2 / (8 * chord)), np.abs(rate) / cells.WIDEST_TURN)

    return place(trajectory, samples, (), steps)
