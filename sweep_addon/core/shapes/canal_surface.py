# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The canal surface: the envelope of balls of radius r(u) whose middles move along a trajectory."""

from enum import Enum

import numpy as np

from ..declared.options import Texture, solid_option
from ..declared.parameters import count, declared, parameter, require
from ..stations.frames import require_several
from ..stations.sampling import Sampling, Tolerance
from ..trajectories import Helix, Trajectory
from ..variation.laws import Constant, Law
from .operand import Operand

ATTRIBUTES = "UVs and Attributes"


class Generator(Enum):
    BALL = "A ball, which makes a surface and the solid within"
    DISC = "A disc in the plane of the trajectory, which makes a plane region"


class BallEnd(Enum):
    ROUND = "What is left of the last ball"
    FLAT = "A flat face in the circle where the last ball touches the surface"
    OPEN = "No face: the surface ends in that circle"


@declared
class CanalSurface(Operand):
    """A ball of changing radius that moves along a trajectory, or a disc in a plane

    The surface is the true envelope of all balls. The ball at t(u) of radius r touches it in the circle about
    t - r r'/|t'| T of radius r sqrt(1 - (r'/|t'|)^2), across the tangent T: no disc of radius r about t is as wide as
    the surface where the radius changes. Where it changes faster than the path goes on, each ball lies within a
    neighbour; the surface is then in several parts, which together enclose all balls.

    Source
    ------
    Monge: Application de l'analyse a la geometrie, 1807. The lecture's "sweeping by a 3D ball (or a disk in 2D space)
    moving along a curve".

    Examples
    --------
    Two balls and the cone that touches both: a frustum and two caps, whose volumes are known.

    >>> from math import pi
    >>> from sweep_addon.core.trajectories import Line
    >>> cone = CanalSurface(Line(), "0.2 + 0.5*t", points=512, samples=Tolerance(4e-6)).mesh()
    >>> low, high = 0.2 * (1 - 0.5), 0.7 * (1 + 0.5)  # how high the caps are
    >>> caps = pi / 3 * (low**2 * (3 * 0.2 - low) + high**2 * (3 * 0.7 - high))
    >>> frustum = pi / 3 * (1 - 0.5**2) ** 2 * (0.2**2 + 0.2 * 0.7 + 0.7**2)
    >>> round(cone.volume() / (caps + frustum), 4), cone.euler_characteristic()
    (1.0, 2)
    """

    trajectory: Trajectory = parameter(Helix(), "The path along which the middle moves", accepts=("CURVE",))
    radius: Law = parameter(0.1, "Radius of the ball", unit="length")
    generator: Generator = parameter(Generator.BALL, "What moves: a ball, or a disc in the trajectory's plane")
    points: int = count(64, "Points around each circle", minimum=3, maximum=4096, soft_maximum=128)
    samples: Sampling = parameter(Tolerance(), "How many circles there are along the trajectory")
    start: BallEnd = parameter(BallEnd.ROUND, "What closes the start", group="Ends")
    end: BallEnd = parameter(BallEnd.ROUND, "What closes the end", group="Ends")
    make_solid: bool = solid_option()
    texture: Texture = parameter(Texture.LENGTHS, "How texture coordinates are measured", group=ATTRIBUTES)
    attributes: bool = parameter(True, "Keep u, v and arc_length of each vertex for materials", group=ATTRIBUTES)

    def check(self):
        """Refuse a radius that is not more than 0 everywhere it is the same."""
        size = self.radius.value if isinstance(self.radius, Constant) else 1.0
        require(size > 0, "must be more than 0", size, "radius")

    @property
    def is_plane(self):
        """Whether discs move in a plane."""
        return self.generator is Generator.DISC

    @property
    def round_ends(self):
        return tuple(end is BallEnd.ROUND for end in (self.start, self.end))

    @property
    def flat_ends(self):
        return tuple(end is BallEnd.FLAT for end in (self.start, self.end))

    def mesh(self, dtype=np.float64):
        """The surface as a mesh: closed, manifold and outward unless an end is open; of discs, their plane region.

        Where it is to be a solid, it is what `solid` makes.

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
            Where the radius is less than 0, jumps or is not finite, where discs have a trajectory that lies in no
            plane, or where there would be too many vertices.

        Examples
        --------
        >>> mesh = CanalSurface(radius="0.1 + 0.05*sin(20*t)", points=16).mesh()
        >>> len(mesh.boundary_edges()), mesh.euler_characteristic()
        (0, 2)
        """
        if self.make_solid:
            return self.solid().astype(dtype)
        return self.surface(dtype)

    def surface(self, dtype=np.float64):
        """The envelope, also where it meets itself: a `Mesh`."""
        from ..envelopes.envelope import Envelope

        return Envelope(self).mesh(dtype)

    def self_intersections(self):
        """Where the surface meets itself, and up to which factor of the radius it does not.

        Returns
        -------
        Places
            A sequence of places, empty when the surface is clean, with ``largest_safe_size``: a factor of the radius,
            or of a tube of one radius that is closed or has no round ends the radius itself.

        Examples
        --------
        A ball grows by r'' = 4 while its radius is 0.3, so that its circles run backward:

        >>> from sweep_addon.core.trajectories import Line
        >>> found = CanalSurface(Line(), "0.3 + 2*(t - 0.5)^2").self_intersections()
        >>> [place.kind for place in found]
        ['local']
        """
        from ..self_intersection.canals import of_canal
        from ..self_intersection.places import Places

        return Places(()) if self.make_solid else of_canal(self)

    def solid(self, progress=None):
        """The boundary of all points that the balls visit, as one valid solid; of discs their region.

        Parameters
        ----------
        progress : callable, optional
            Is told which part is done, from 0 to 1; what it raises ends the work.

        Returns
        -------
        Mesh
            Closed, manifold and outward, in metres; of discs flat faces, whose boundary edges are that of the region.

        Raises
        ------
        ShapeError
            For an open surface, or where manifold3d is missing.

        Examples
        --------
        Discs of radius 0.5 on a circle of radius 0.3 visit a disc of radius 0.8:

        >>> from math import pi, tau
        >>> from sweep_addon.core.trajectories import Arc
        >>> round(CanalSurface(Arc(0.3, tau), 0.5, "disc", samples=Tolerance(1e-6)).solid().area() / (pi * 0.8**2), 4)
        1.0
        """
        from ..resolving.of_balls import of_balls  # asks manifold3d

        return of_balls(self, progress)

    def frames(self, most=100):
        """The frames and circles at places spread evenly along the trajectory.

        Parameters
        ----------
        most : int
            Of places.

        Returns
        -------
        Frames
            Of each ball the middle, the tangent, and the circle where it touches the surface, its axes e2 and e3.

        Examples
        --------
        >>> from sweep_addon.core.trajectories import Line
        >>> frames = CanalSurface(Line(end=(0, 0, 2))).frames(5)
        >>> frames.points[:, 2].tolist(), frames.e1[0].tolist(), frames.contours[0].shape
        ([0.0, 0.5, 1.0, 1.5, 2.0], [0.0, 0.0, 1.0], (5, 64, 3))
        """
        from ..envelopes.envelope import Envelope

        require_several(most)
        return Envelope(self).frames(most)
